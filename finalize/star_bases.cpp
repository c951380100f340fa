// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra around a vertex, each as the base opposite to it, measured four at once.
#include "finalize/star_bases.h"

#include <algorithm>
#include <cmath>

#include "finalize/shape.h"

namespace octet {
namespace {

using Block = StarBases::Block;

/// Squared length of the cross product.
OCTET_LANEWISE Lanes cross_squared(const LaneVec3& p, const LaneVec3& q) {
  const LaneVec3 c = cross(p, q);
  return dot(c, c);
}
OCTET_LANEWISE double least_lane(const Lanes& p) {
  return std::min(std::min(p[0], p[1]), std::min(p[2], p[3]));
}
OCTET_LANEWISE double sum_of(const Lanes& p) { return (p[0] + p[1]) + (p[2] + p[3]); }

}  // namespace

// The work of the members below, on the blocks alone.
namespace star_lanes {

OCTET_WIDE_CLONES void close(Block& b) {
  b.xy = b.y - b.x;
  b.xz = b.z - b.x;
  b.yz = b.z - b.y;
  b.normal = cross(b.xy, b.xz);
  b.lxy = dot(b.xy, b.xy);
  b.lxz = dot(b.xz, b.xz);
  b.lyz = dot(b.yz, b.yz);
  b.normal2 = dot(b.normal, b.normal);
}

OCTET_WIDE_CLONES void measure(std::span<const Block> blocks, const Vec3& place, double floor, double* shapes,
                               StarMeasure& result) {
  // The same as `shape` and `distortion`, with one quotient for the angles: the sine at an edge is
  // 6 V |e| / (|n| |m|), so over the common denominator of all four faces each edge has its other two faces.
  constexpr double kTiny = std::numeric_limits<double>::min();  // where faces have no area, nor volume
  constexpr double kRatio = kRatioWeight * 432.0;
  Lanes total{};
  for (const Block& b : blocks) {
    const LaneVec3 px = place - b.x, py = place - b.y, pz = place - b.z;
    const Lanes lpx = dot(px, px), lpy = dot(py, py), lpz = dot(pz, pz), volume = dot(b.normal, px);
    const Lanes nx = cross_squared(b.yz, py), ny = cross_squared(b.xz, px), nz = cross_squared(b.xy, px);
    const Lanes xy = nx * ny, pz_faces = nz * b.normal2;
    const Lanes at_px = least(b.lyz * ny, b.lxz * nx), at_py = least(lpx * nx, lpy * ny);
    const Lanes angles = least(least(b.lxy * xy, lpz * pz_faces), least(at_px * nz, at_py * b.normal2));
    const Lanes squares = b.lxy + b.lxz + b.lyz + lpx + lpy + lpz, cube = squares * squares * squares;
    const Lanes merit = least(angles / (xy * pz_faces + kTiny), kRatio / (cube + kTiny));
    const Lanes shape = volume * (volume < 0.0 ? -volume : volume) * merit;
    for (std::size_t lane = 0; lane < kLanes; ++lane) shapes[lane] = shape[lane];
    shapes += kLanes;
    result.worst = std::min(result.worst, least_lane(shape));
    if (result.worst <= floor) return;
    total += b.weight * (root(cube) / volume);
  }
  result.distortion = kDistortionUnit * sum_of(total);
}

OCTET_WIDE_CLONES bool differentiate(std::span<const Block> blocks, const Vec3& place, Distortion& sum) {
  LaneVec3 gradient{};
  Lanes hessian[6] = {};
  Lanes total{};
  for (const Block& b : blocks) {
    const LaneVec3 px = place - b.x, py = place - b.y, pz = place - b.z;
    const Lanes volume = dot(b.normal, px);
    if (!(least_lane(volume) > 0.0)) return false;
    const Lanes squares = b.lxy + b.lxz + b.lyz + dot(px, px) + dot(py, py) + dot(pz, pz);
    const Lanes value = b.weight * (squares * root(squares) / volume);
    // As in add_distortion: with s the squares and v the volume, the logarithm's slope is 1.5 s'/s - v'/v.
    const Lanes over_squares = 1.0 / squares, over_volume = 1.0 / volume;
    LaneVec3 s, v, slope;
    for (std::size_t k = 0; k < 3; ++k) {
      s[k] = (2.0 * over_squares) * (px[k] + py[k] + pz[k]);
      v[k] = b.normal[k] * over_volume;
      slope[k] = 1.5 * s[k] - v[k];
      gradient[k] += value * slope[k];
    }
    total += value;
    std::size_t entry = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Lanes c = value * slope[k], d = -1.5 * value * s[k], e = value * v[k];
      hessian[entry] += 9.0 * over_squares * value;
      for (std::size_t l = k; l < 3; ++l) hessian[entry++] += c * slope[l] + d * s[l] + e * v[l];
    }
  }
  sum.value += kDistortionUnit * sum_of(total);
  std::size_t entry = 0;
  for (int k = 0; k < 3; ++k) {
    sum.gradient[k] += kDistortionUnit * sum_of(gradient[static_cast<std::size_t>(k)]);
    for (int l = k; l < 3; ++l) sum.hessian(k, l) += kDistortionUnit * sum_of(hessian[entry++]);
  }
  return true;
}

OCTET_WIDE_CLONES double squared_lengths(std::span<const Block> blocks, const Vec3& place) {
  Lanes total{};
  for (const Block& b : blocks) {
    const LaneVec3 px = place - b.x, py = place - b.y, pz = place - b.z;
    total += b.weight * (dot(px, px) + dot(py, py) + dot(pz, pz));
  }
  return sum_of(total);
}

}  // namespace star_lanes

void StarBases::grow() {
  blocks_.resize((count_ + kLanes - 1) / kLanes);
  shapes_.resize(kLanes * blocks_.size());
}

void StarBases::close() {
  for (Block& b : blocks()) {
    const std::size_t used =
        std::min(kLanes, count_ - kLanes * static_cast<std::size_t>(&b - blocks_.data()));
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      b.weight[lane] = lane < used ? 1.0 : 0.0;
      if (lane < used) continue;
      for (LaneVec3* corner : {&b.x, &b.y, &b.z}) {
        for (Lanes& row : corner->row) row[lane] = row[0];
      }
    }
    star_lanes::close(b);
  }
}

std::array<Vec3, 3> StarBases::operator[](std::size_t i) const {
  const Block& block = blocks_[i / kLanes];
  const std::size_t lane = i % kLanes;
  return {lane_of(block.x, lane), lane_of(block.y, lane), lane_of(block.z, lane)};
}

StarMeasure StarBases::measure(const Vec3& place, double floor) {
  StarMeasure result;
  star_lanes::measure(blocks(), place, floor, shapes_.data(), result);
  return result;
}

bool StarBases::differentiate(const Vec3& place, Distortion& sum) const {
  return star_lanes::differentiate(blocks(), place, sum);
}

double StarBases::mean_length(const Vec3& place) const {
  return std::sqrt(star_lanes::squared_lengths(blocks(), place) / (3.0 * static_cast<double>(count_)));
}

}  // namespace octet
