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
#include "base/constants.h"
#include "base/lane_vec.h"

namespace octet {
namespace {

/// Tetrahedra a task.
constexpr std::size_t kBlock = 16384;

// For Vec3 and double, or for four tetrahedra at once: the same operations in the same order.
template <class Vec>
OCTET_LANEWISE auto six_volumes(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  return dot(cross(Vec(b - a), Vec(c - a)), Vec(d - a));
}

/// `least` and `largest` squared cotangent; they mean nothing unless the volume is positive.
template <class Vec, class Real>
OCTET_LANEWISE void find_cotangents(const Vec& a, const Vec& b, const Vec& c, const Vec& d,
                                    const Real& volumes, Real& lowest, Real& highest) {
  const Vec ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  // Outward normals of the faces opposite a, b, c, d.
  const Vec na = cross(bc, bd), nb = cross(ad, ac), nc = cross(ab, ad), nd = cross(ac, ab);
  // |n_i x n_j| = 6 V |edge|, so the cotangent of an angle is -n_i n_j / (6 V |edge|), which stays accurate
  // for flat tetrahedra.
  const Real x[6] = {-dot(na, nb) / volumes, -dot(na, nc) / volumes, -dot(na, nd) / volumes,
                     -dot(nb, nc) / volumes, -dot(nb, nd) / volumes, -dot(nc, nd) / volumes};
  const Real squares[6] = {dot(cd, cd), dot(bd, bd), dot(bc, bc), dot(ad, ad), dot(ac, ac), dot(ab, ab)};
  lowest = highest = x[0] * magnitude(x[0]) / squares[0];
  for (int i = 1; i < 6; ++i) {
    const Real square = x[i] * magnitude(x[i]) / squares[i];
    lowest = least(lowest, square);
    highest = most(highest, square);
  }
}

}  // namespace

double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return six_volumes(a, b, c, d) / 6.0;
}

DihedralCotangents dihedral_cotangents(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volumes = six_volumes(a, b, c, d);
  DihedralCotangents result;
  if (volumes > 0.0) find_cotangents(a, b, c, d, volumes, result.largest, result.smallest);
  return result;
}

double angle_of_cotangent(double squared_cotangent) {
  return std::atan2(1.0, std::copysign(std::sqrt(std::abs(squared_cotangent)), squared_cotangent));
}

double squared_cotangent(double angle) {
  const double cotangent = std::cos(angle) / std::sin(angle);
  return cotangent * std::abs(cotangent);
}

DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const DihedralCotangents range = dihedral_cotangents(a, b, c, d);
  return {angle_of_cotangent(range.smallest), angle_of_cotangent(range.largest)};
}

namespace {

double root_guess(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2a9f'7893'7800'0000u);
}
OCTET_LANEWISE Lanes root_guess(const Lanes& x) {
  return Lanes{root_guess(x[0]), root_guess(x[1]), root_guess(x[2]), root_guess(x[3])};
}

/// Of a positive number: the library's costs a third of the summary of a large mesh. A guess within 4 per
/// cent from a third of the exponent, and three steps of Halley's, which take its error to the third power
/// each.
template <class Real>
OCTET_LANEWISE Real cube_root(const Real& x) {
  Real y = root_guess(x);
  for (int step = 0; step < 3; ++step) {
    const Real cube = y * y * y;
    y *= (cube + 2.0 * x) / (2.0 * cube + x);
  }
  return y;
}

/// Sum of the squared lengths of the edges.
template <class Vec>
OCTET_LANEWISE auto squared_edges(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
  const Vec ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  return dot(ab, ab) + dot(ac, ac) + dot(ad, ad) + dot(bc, bc) + dot(bd, bd) + dot(cd, cd);
}

/// Of a positive volume.
template <class Real>
OCTET_LANEWISE Real mean_ratio_of(const Real& volume, const Real& squares) {
  const Real root = cube_root(Real(3.0 * volume));
  return 12.0 * root * root / squares;
}

}  // namespace

double mean_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double squares = squared_edges(a, b, c, d), volume = signed_volume(a, b, c, d);
  return squares > 0.0 && volume > 0.0 ? mean_ratio_of(volume, squares) : 0.0;
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

namespace quality_lanes {

/// What the summary asks of four tetrahedra.
struct Shapes {
  Lanes smallest, largest;  ///< cotangents of the dihedral angles, see DihedralCotangents
  Lanes ratio, volume;
};

OCTET_LANEWISE void gather(const Mesh& mesh, const std::array<Mesh::Index, 4>* const (&tets)[kLanes],
                           LaneVec3 (&p)[4]) {
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (std::size_t k = 0; k < 4; ++k) p[k].set(lane, mesh.points[(*tets[lane])[k]]);
}

/// Infinite as DihedralCotangents are.
OCTET_LANEWISE void find_cotangents(const LaneVec3 (&p)[4], const Lanes& volumes, Lanes& smallest,
                                    Lanes& largest) {
  Lanes lowest, highest;
  octet::find_cotangents(p[0], p[1], p[2], p[3], volumes, lowest, highest);
  smallest = volumes > 0.0 ? highest : Lanes{} + kInfinity;
  largest = volumes > 0.0 ? lowest : Lanes{} - kInfinity;
}

OCTET_WIDE_CLONES void cotangents(const Mesh& mesh, const std::array<Mesh::Index, 4>* const (&tets)[kLanes],
                                  Lanes& smallest, Lanes& largest) {
  LaneVec3 p[4];
  gather(mesh, tets, p);
  find_cotangents(p, six_volumes(p[0], p[1], p[2], p[3]), smallest, largest);
}

OCTET_WIDE_CLONES void measure(const Mesh& mesh, const std::array<Mesh::Index, 4>* const (&tets)[kLanes],
                               Shapes& shapes) {
  LaneVec3 p[4];
  gather(mesh, tets, p);
  const Lanes volumes = six_volumes(p[0], p[1], p[2], p[3]), volume = volumes / 6.0;
  find_cotangents(p, volumes, shapes.smallest, shapes.largest);
  const Lanes squares = squared_edges(p[0], p[1], p[2], p[3]), ratio = mean_ratio_of(volume, squares);
  shapes.ratio = volume > 0.0 ? ratio : Lanes{};
  shapes.volume = volume;
}

}  // namespace quality_lanes

namespace {

/// Calls visit(first, used, tets) for lanes of tetrahedra first..first + used - 1; lanes beyond the last
/// tetrahedron repeat it, and are not to be looked at.
template <class Visit>
void for_each_lanes(const Mesh& mesh, std::size_t first, std::size_t last, const Visit& visit) {
  for (std::size_t t = first; t < last; t += kLanes) {
    const std::size_t used = std::min(kLanes, last - t);
    const std::array<Mesh::Index, 4>* tets[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) tets[lane] = &mesh.tets[t + std::min(lane, used - 1)];
    visit(t, used, tets);
  }
}

}  // namespace

DihedralExtremes dihedral_extremes(const Mesh& mesh, double target) {
  struct Block {
    DihedralCotangents range{0.0, 0.0};
    std::size_t below = 0;
  };
  const double of_target = squared_cotangent(target);
  const auto of_block = [&](std::size_t first, std::size_t last) {
    Block block;
    for_each_lanes(mesh, first, last, [&](std::size_t, std::size_t used, const auto& tets) {
      Lanes smallest, largest;
      quality_lanes::cotangents(mesh, tets, smallest, largest);
      for (std::size_t lane = 0; lane < used; ++lane) {
        block.range.smallest = std::max(block.range.smallest, smallest[lane]);
        block.range.largest = std::min(block.range.largest, largest[lane]);
        block.below += smallest[lane] > of_target ? 1 : 0;
      }
    });
    return block;
  };
  Block whole;
  for (const Block& block : map_blocks<Block>(mesh.tets.size(), kBlock, of_block)) {
    whole.range = {std::max(whole.range.smallest, block.range.smallest),
                   std::min(whole.range.largest, block.range.largest)};
    whole.below += block.below;
  }
  return {{angle_of_cotangent(whole.range.smallest), angle_of_cotangent(whole.range.largest)}, whole.below};
}

QualitySummary quality_summary(const Mesh& mesh) {
  QualitySummary summary;
  summary.tets = mesh.tets.size();
  if (mesh.tets.empty()) return summary;
  const auto smallest = std::make_unique_for_overwrite<double[]>(mesh.tets.size());  // angles' cotangents
  struct Block {
    DihedralCotangents range{-std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
    double least_ratio = 1.0, sum_of_ratios = 0.0, volume = 0.0;
    std::size_t worst = 0;

    void add(const Block& other) {
      if (other.range.smallest > range.smallest) worst = other.worst;
      range.smallest = std::max(range.smallest, other.range.smallest);
      range.largest = std::min(range.largest, other.range.largest);
      least_ratio = std::min(least_ratio, other.least_ratio);
      sum_of_ratios += other.sum_of_ratios;
      volume += other.volume;
    }
  };
  const auto of_block = [&](std::size_t first, std::size_t last) {
    Block block;
    quality_lanes::Shapes shapes;
    for_each_lanes(mesh, first, last, [&](std::size_t t, std::size_t used, const auto& tets) {
      quality_lanes::measure(mesh, tets, shapes);
      for (std::size_t lane = 0; lane < used; ++lane) {
        smallest[t + lane] = shapes.smallest[lane];
        block.add({{shapes.smallest[lane], shapes.largest[lane]},
                   shapes.ratio[lane],
                   shapes.ratio[lane],
                   shapes.volume[lane],
                   t + lane});
      }
    });
    return block;
  };
  Block whole;
  for (const Block& block : map_blocks<Block>(mesh.tets.size(), kBlock, of_block)) whole.add(block);
  summary.min_dihedral = angle_of_cotangent(whole.range.smallest);
  summary.max_dihedral = angle_of_cotangent(whole.range.largest);
  summary.worst_tet = whole.worst;
  summary.min_mean_ratio = whole.least_ratio;
  summary.mean_mean_ratio = whole.sum_of_ratios / static_cast<double>(mesh.tets.size());
  summary.volume = whole.volume;
  summary.p1_min_dihedral =
      angle_of_cotangent(nth_largest({smallest.get(), mesh.tets.size()}, mesh.tets.size() / 100));
  return summary;
}

}  // namespace octet
