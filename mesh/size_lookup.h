// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at any place: that of the nearest vertex.
#pragma once

#include <array>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Points in the cells of a regular grid, about two in each. May be asked by many threads at once.
class SizeLookup {
 public:
  /// `points` (at least one) with the size at each (mesh/local_size.h).
  SizeLookup(const std::vector<Vec3>& points, std::vector<double> size);
  /// Size at the point nearest to p; of equally near ones, the first.
  [[nodiscard]] double at(const Vec3& p) const;

 private:
  using Cell = std::array<int, 3>;
  [[nodiscard]] Cell cell_of(const Vec3& p) const;
  [[nodiscard]] std::size_t index_of(const Cell& c) const;

  std::vector<Vec3> points_;
  std::vector<double> size_;
  Box3 box_;
  double width_ = 1.0;
  Cell count_{1, 1, 1};
  std::vector<std::uint32_t> first_, in_cell_;  ///< points by cell
};

}  // namespace octet
