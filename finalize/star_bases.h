// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra around a vertex, each as the base opposite to it, measured four at once.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/lane_vec.h"
#include "finalize/mean_shape.h"

namespace octet {

/// What a star comes to with its vertex at one place.
struct StarMeasure {
  double worst = 1.0;  ///< least shape (finalize/shape.h)
  double distortion =
      0.0;  ///< sum of the distortions (finalize/mean_shape.h); means nothing unless worst > 0
};

/// Bases (x, y, z) such that (x, y, z, place) is positive. What depends on the base alone is found once, and
/// four tetrahedra are evaluated at once, by the same operations in the same order on every machine, in
/// registers as wide as the machine has: smoothing spends nearly all of its time here.
class StarBases {
 public:
  /// To be followed by `set` for each number below `count`, and then by `close`, before anything is asked.
  void resize(std::size_t count) {
    count_ = count;
    if (blocks_.size() * kLanes < count) grow();
  }
  void set(std::size_t number, const Vec3& x, const Vec3& y, const Vec3& z) {
    const std::size_t lane = number % kLanes;
    Block& block = blocks_[number / kLanes];
    block.x.set(lane, x);
    block.y.set(lane, y);
    block.z.set(lane, z);
  }
  void close();
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::array<Vec3, 3> operator[](std::size_t i) const;
  /// Of a base, towards the vertex, twice as long as its area: what a step of the vertex adds to six volumes.
  [[nodiscard]] Vec3 normal(std::size_t i) const { return lane_of(blocks_[i / kLanes].normal, i % kLanes); }

  /// With the vertex at `place`. Stops at a worst shape not above `floor`; the sum and the shapes are whole
  /// where worst > floor.
  StarMeasure measure(const Vec3& place, double floor = -std::numeric_limits<double>::infinity());
  /// The shape of each as measured last; whole where that did not stop early.
  [[nodiscard]] const double* shapes() const { return shapes_.data(); }

  /// Adds the sum of the distortions and its derivatives; false, and nothing of use added, where a volume is
  /// not positive.
  [[nodiscard]] bool differentiate(const Vec3& place, Distortion& sum) const;
  /// Root of the mean squared distance between the place and the corners of the bases.
  [[nodiscard]] double mean_length(const Vec3& place) const;

  /// Four bases; what is left over repeats the first, with no weight in sums.
  struct Block {
    LaneVec3 x, y, z, xy, xz, yz, normal;  ///< normal: xy cross xz
    Lanes lxy, lxz, lyz, normal2;         ///< squared lengths
    Lanes weight;
  };

 private:
  void grow();
  static Vec3 lane_of(const LaneVec3& v, std::size_t lane) { return {v[0][lane], v[1][lane], v[2][lane]}; }
  [[nodiscard]] std::span<Block> blocks() { return {blocks_.data(), (count_ + kLanes - 1) / kLanes}; }
  [[nodiscard]] std::span<const Block> blocks() const {
    return {blocks_.data(), (count_ + kLanes - 1) / kLanes};
  }

  std::size_t count_ = 0;
  std::vector<Block> blocks_;   ///< grows only; of use are the first ceil(count / 4)
  std::vector<double> shapes_;  ///< one per lane
};

}  // namespace octet
