// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of tetrahedra.
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace octet {

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  // Outward normals of the faces opposite a, b, c, d.
  const Vec3 normal[4] = {bc.cross(bd), ad.cross(ac), ab.cross(ad), ac.cross(ab)};
  const double six_volumes = ab.cross(ac).dot(ad);
  if (!(six_volumes > 0.0)) return {0.0, std::numbers::pi};
  const Vec3 edge[4][4] = {{Vec3::Zero(), d - c, bd, bc}, {{}, Vec3::Zero(), ad, ac}, {{}, {}, {}, ab}, {}};
  DihedralRange range{std::numbers::pi, 0.0};
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      // |n_i x n_j| = 6 V |edge|: the tangent stays accurate for flat tetrahedra.
      const double angle = std::atan2(six_volumes * edge[i][j].norm(), -normal[i].dot(normal[j]));
      range.smallest = std::min(range.smallest, angle);
      range.largest = std::max(range.largest, angle);
    }
  }
  return range;
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
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    const DihedralRange range = dihedral_range(a, b, c, d);
    const double ratio = mean_ratio(a, b, c, d);
    smallest[t] = range.smallest;
    if (range.smallest < summary.min_dihedral) {
      summary.min_dihedral = range.smallest;
      summary.worst_tet = t;
    }
    summary.max_dihedral = std::max(summary.max_dihedral, range.largest);
    summary.min_mean_ratio = std::min(summary.min_mean_ratio, ratio);
    sum += ratio;
  }
  summary.mean_mean_ratio = sum / static_cast<double>(mesh.tets.size());
  const auto percentile = smallest.begin() + static_cast<std::ptrdiff_t>(mesh.tets.size() / 100);
  std::nth_element(smallest.begin(), percentile, smallest.end());
  summary.p1_min_dihedral = *percentile;
  return summary;
}

}  // namespace octet
