// SPDX-License-Identifier: BSD-3-Clause
// A coarse lattice that answers "which region" at once where the boundary is far.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geom/facet_bvh.h"

namespace octet {

/// Cells that no grown facet meets, labelled by connected component.
///
/// Invariant: a labelled cell holds no boundary point, so all its points have the label's region.
/// Cost: one region query a component, about 4 bytes a cell. Immutable, thread-safe.
class RegionGrid {
 public:
  RegionGrid() = default;
  /// `region_at` answers exactly; it is asked once for each component.
  RegionGrid(const FacetBvh& bvh, const Box3& box, const std::function<int(const Vec3&)>& region_at);

  static constexpr int kUnknown = -1;
  /// Region at p, or kUnknown near the boundary and outside the box.
  [[nodiscard]] int at(const Vec3& p) const;
  /// Whether the segment p..q runs through few cells and all are labelled: no boundary is on it. False
  /// decides nothing.
  [[nodiscard]] bool is_clear(const Vec3& p, const Vec3& q) const;

 private:
  using Cell = std::array<int, 3>;
  /// False outside the box.
  [[nodiscard]] bool find_cell(const Vec3& p, Cell& cell) const;
  [[nodiscard]] std::size_t index(const Cell& c) const {
    return (static_cast<std::size_t>(c[2]) * cells_[1] + c[1]) * cells_[0] + c[0];
  }
  [[nodiscard]] Box3 box_of(const Cell& lo, const Cell& hi) const;
  void mark_empty(const FacetBvh& bvh, const Cell& lo, const Cell& hi);
  void flood(const Cell& start, int region);

  Vec3 lo_ = Vec3::Zero();
  double width_ = 0.0;
  Cell cells_{0, 0, 0};
  std::vector<std::int32_t> label_;
};

}  // namespace octet
