// SPDX-License-Identifier: BSD-3-Clause
// Points by place: which lie in a box?
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace octet {

/// A uniform grid of cells over the points, some eight points a cell. Borrows the points: they must outlive
/// it and not change. Thread-safe for reading. Cost: 4 bytes a point, 4 a cell.
class PointIndex {
 public:
  explicit PointIndex(std::span<const Vec3> points);

  [[nodiscard]] std::span<const Vec3> points() const { return points_; }
  [[nodiscard]] const Box3& bounds() const { return bounds_; }
  /// Numbers of all points in the closed box, ascending.
  void gather(const Box3& box, std::vector<std::uint32_t>& found) const;

 private:
  [[nodiscard]] std::array<std::size_t, 3> cell_of(const Vec3& p) const;

  std::span<const Vec3> points_;
  Box3 bounds_;
  double cell_ = 1.0;
  std::array<std::size_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> first_;   ///< per cell: where its points begin in `sorted_`; one more at the end
  std::vector<std::uint32_t> sorted_;  ///< point numbers by cell
};

}  // namespace octet
