// SPDX-License-Identifier: BSD-3-Clause
// Shape measures of tetrahedra.
#include "mesh/quality.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/blocks.h"

namespace octet {
namespace {

/// Tetrahedra a task.
constexpr std::size_t kBlock = 16384;

/// Squared cotangents with their signs, of the smallest and of the largest dihedral angle: they fall as the
/// angle grows, so that angles are compared without roots and arcs.
struct Cotangents {
  double smallest = std::numeric_limits<double>::infinity(),
         largest = -std::numeric_limits<double>::infinity();
};

double angle_of(double squared_cotangent) {
  return std::atan2(1.0, std::copysign(std::sqrt(std::abs(squared_cotangent)), squared_cotangent));
}

Cotangents cotangents(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  // Outward normals of the faces opposite a, b, c, d.
  const Vec3 normal[4] = {bc.cross(bd), ad.cross(ac), ab.cross(ad), ac.cross(ab)};
  const double six_volumes = ab.cross(ac).dot(ad);
  if (!(six_volumes > 0.0)) return {};
  // |n_i x n_j| = 6 V |edge|, so the cotangent of an angle is -n_i n_j / (6 V |edge|), which stays accurate
  // for flat tetrahedra.
  const auto square = [&](int i, int j, const Vec3& edge) {
    const double x = -normal[i].dot(normal[j]) / six_volumes;
    return x * std::abs(x) / edge.squaredNorm();
  };
  const auto [least, most] = std::minmax({square(0, 1, d - c), square(0, 2, bd), square(0, 3, bc),
                                          square(1, 2, ad), square(1, 3, ac), square(2, 3, ab)});
  return {most, least};
}

}  // namespace

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a) / 6.0;
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Cotangents range = cotangents(a, b, c, d);
  return {angle_of(range.smallest), angle_of(range.largest)};
}

namespace {

/// Of a positive number: the library's costs a third of the summary of a large mesh. A guess within 4 per
/// cent from a third of the exponent, and three steps of Halley's, which take its error to the third power
/// each.
double cube_root(double x) {
  double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2a9f'7893'7800'0000u);
  for (int step = 0; step < 3; ++step) {
    const double cube = y * y * y;
    y *= (cube + 2.0 * x) / (2.0 * cube + x);
  }
  return y;
}

}  // namespace

double mean_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double squares = (b - a).squaredNorm() + (c - a).squaredNorm() + (d - a).squaredNorm() +
                         (c - b).squaredNorm() + (d - b).squaredNorm() + (d - c).squaredNorm();
  const double volume = signed_volume(a, b, c, d);
  if (!(squares > 0.0) || !(volume > 0.0)) return 0.0;
  const double root = cube_root(3.0 * volume);
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

namespace {

/// The value with n larger ones. Of a long list only those are sorted out that a sample says are in question.
double nth_largest(std::span<const double> values, std::size_t n) {
  constexpr std::size_t kStride = 64;
  std::vector<double> left;
  const auto pick = [&left](std::size_t k) {
    const auto at = left.begin() + static_cast<std::ptrdiff_t>(k);
    std::nth_element(left.begin(), at, left.end(), std::greater<>());
    return *at;
  };
  for (std::size_t i = 0; i < values.size(); i += kStride) left.push_back(values[i]);
  const double bound = pick(std::min(left.size() - 1, 2 * (n / kStride) + 16));
  left = collect<double>(values.size(), [&](std::size_t i, std::vector<double>& found) {
    if (values[i] >= bound) found.push_back(values[i]);
  });
  if (left.size() <= n) left.assign(values.begin(), values.end());
  return pick(n);
}

}  // namespace

QualitySummary quality_summary(const Mesh& mesh) {
  QualitySummary summary;
  summary.tets = mesh.tets.size();
  if (mesh.tets.empty()) return summary;
  const auto smallest = std::make_unique_for_overwrite<double[]>(mesh.tets.size());  // angles' cotangents
  struct Block {
    Cotangents range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    double least_ratio = 1.0, sum_of_ratios = 0.0;
    std::size_t worst = 0;

    void add(const Block& other) {
      if (other.range.smallest > range.smallest) worst = other.worst;
      range.smallest = std::max(range.smallest, other.range.smallest);
      range.largest = std::min(range.largest, other.range.largest);
      least_ratio = std::min(least_ratio, other.least_ratio);
      sum_of_ratios += other.sum_of_ratios;
    }
  };
  const auto of_block = [&](std::size_t first, std::size_t last) {
    Block block;
    for (std::size_t t = first; t < last; ++t) {
      const auto& v = mesh.tets[t];
      const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]],
                 &d = mesh.points[v[3]];
      const double ratio = mean_ratio(a, b, c, d);
      const Block one{cotangents(a, b, c, d), ratio, ratio, t};
      smallest[t] = one.range.smallest;
      block.add(one);
    }
    return block;
  };
  Block whole;
  for (const Block& block : map_blocks<Block>(mesh.tets.size(), kBlock, of_block)) whole.add(block);
  summary.min_dihedral = angle_of(whole.range.smallest);
  summary.max_dihedral = angle_of(whole.range.largest);
  summary.worst_tet = whole.worst;
  summary.min_mean_ratio = whole.least_ratio;
  summary.mean_mean_ratio = whole.sum_of_ratios / static_cast<double>(mesh.tets.size());
  summary.p1_min_dihedral = angle_of(nth_largest({smallest.get(), mesh.tets.size()}, mesh.tets.size() / 100));
  return summary;
}

}  // namespace octet
