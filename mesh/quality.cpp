// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of tetrahedra.
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/blocks.h"

namespace octet {
namespace {

/// Tetrahedra a task.
constexpr std::size_t kBlock = 16384;

}  // namespace

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  // Outward normals of the faces opposite a, b, c, d.
  const Vec3 normal[4] = {bc.cross(bd), ad.cross(ac), ab.cross(ad), ac.cross(ab)};
  const double six_volumes = ab.cross(ac).dot(ad);
  if (!(six_volumes > 0.0)) return {0.0, std::numbers::pi};
  // |n_i x n_j| = 6 V |edge|, so the cotangent of an angle is -n_i n_j / (6 V |edge|), which stays accurate
  // for flat tetrahedra. It falls as the angle grows, and so does its square with its sign: the extremes are
  // found without roots and arcs.
  struct Angle {
    double cosine, squared_edge, order;
    [[nodiscard]] double of(double six_volumes) const {
      return std::atan2(six_volumes * std::sqrt(squared_edge), cosine);
    }
  };
  const auto angle = [&](int i, int j, const Vec3& edge) {
    const double cosine = -normal[i].dot(normal[j]), squared_edge = edge.squaredNorm();
    return Angle{cosine, squared_edge, cosine * std::abs(cosine) / squared_edge};
  };
  const Angle angles[6] = {angle(0, 1, d - c), angle(0, 2, bd), angle(0, 3, bc),
                           angle(1, 2, ad),    angle(1, 3, ac), angle(2, 3, ab)};
  const Angle *smallest = angles, *largest = angles;
  for (const Angle& x : angles) {
    if (x.order > smallest->order) smallest = &x;
    if (x.order < largest->order) largest = &x;
  }
  return {smallest->of(six_volumes), largest->of(six_volumes)};
}

double mean_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double squares = (b - a).squaredNorm() + (c - a).squaredNorm() + (d - a).squaredNorm() +
                         (c - b).squaredNorm() + (d - b).squaredNorm() + (d - c).squaredNorm();
  const double volume = signed_volume(a, b, c, d);
  if (!(squares > 0.0) || !(volume > 0.0)) return 0.0;
  const double root = std::cbrt(3.0 * volume);
  return 12.0 * root * root / squares;
}

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const double six_volumes = ab.cross(ac).dot(ad);
  if (!(six_volumes > 0.0)) return 0.0;
  // r = 3 V / area and R = sqrt(s (s - p) (s - q) (s - u)) / (6 V), where p, q, u are the products of
  // opposite edges and s is half their sum.
  const double area =
      0.5 * (ab.cross(ac).norm() + ab.cross(ad).norm() + ac.cross(ad).norm() + bc.cross(bd).norm());
  const double p = ab.norm() * cd.norm(), q = ac.norm() * bd.norm(), u = ad.norm() * bc.norm();
  const double s = 0.5 * (p + q + u);
  const double square = s * (s - p) * (s - q) * (s - u);
  return square > 0.0 ? 1.5 * six_volumes * six_volumes / (area * std::sqrt(square)) : 0.0;
}

double aspect(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const double six_volumes = ab.cross(ac).dot(ad);
  if (!(six_volumes > 0.0)) return 0.0;
  const double largest_face = std::sqrt(std::max({ab.cross(ac).squaredNorm(), ab.cross(ad).squaredNorm(),
                                                  ac.cross(ad).squaredNorm(), bc.cross(bd).squaredNorm()}));
  const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), ad.squaredNorm(),
                                             bc.squaredNorm(), bd.squaredNorm(), cd.squaredNorm()}));
  return std::sqrt(1.5) * six_volumes / (largest_face * longest);
}

QualitySummary quality_summary(const Mesh& mesh) {
  QualitySummary summary;
  summary.tets = mesh.tets.size();
  if (mesh.tets.empty()) return summary;
  std::vector<double> smallest(mesh.tets.size());
  summary.min_dihedral = std::numbers::pi;
  summary.min_mean_ratio = 1.0;
  double sum = 0.0;
  // The mean of a block's elements stands in its mean_mean_ratio as a sum.
  const auto of_block = [&](std::size_t first, std::size_t last) {
    QualitySummary block;
    block.min_dihedral = std::numbers::pi;
    block.min_mean_ratio = 1.0;
    for (std::size_t t = first; t < last; ++t) {
      const auto& v = mesh.tets[t];
      const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]],
                 &d = mesh.points[v[3]];
      const DihedralRange range = dihedral_range(a, b, c, d);
      const double ratio = mean_ratio(a, b, c, d);
      smallest[t] = range.smallest;
      if (range.smallest < block.min_dihedral) {
        block.min_dihedral = range.smallest;
        block.worst_tet = t;
      }
      block.max_dihedral = std::max(block.max_dihedral, range.largest);
      block.min_mean_ratio = std::min(block.min_mean_ratio, ratio);
      block.mean_mean_ratio += ratio;
    }
    return block;
  };
  for (const QualitySummary& block : map_blocks<QualitySummary>(mesh.tets.size(), kBlock, of_block)) {
    if (block.min_dihedral < summary.min_dihedral) {
      summary.min_dihedral = block.min_dihedral;
      summary.worst_tet = block.worst_tet;
    }
    summary.max_dihedral = std::max(summary.max_dihedral, block.max_dihedral);
    summary.min_mean_ratio = std::min(summary.min_mean_ratio, block.min_mean_ratio);
    sum += block.mean_mean_ratio;
  }
  summary.mean_mean_ratio = sum / static_cast<double>(mesh.tets.size());
  const auto percentile = smallest.begin() + static_cast<std::ptrdiff_t>(mesh.tets.size() / 100);
  std::nth_element(smallest.begin(), percentile, smallest.end());
  summary.p1_min_dihedral = *percentile;
  return summary;
}

}  // namespace octet
