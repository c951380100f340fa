// SPDX-License-Identifier: BSD-3-Clause
// A coarse lattice that answers "which region" at once where the boundary is far, and "which facets" where it
// is near.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "geom/facet_bvh.h"

namespace octet {

/// Cells that no grown facet meets, labelled by connected component; the others with the facets that meet
/// them.
///
/// Invariant: a labelled cell holds no boundary point, so all its points have the label's region.
/// Cost: one region query a component, 4 bytes a cell and 4 for each facet in a cell. Immutable, thread-safe.
class RegionGrid {
 public:
  RegionGrid() = default;
  /// `region_at` answers exactly; it is asked once for each component.
  RegionGrid(const FacetBvh& bvh, const Box3& box, const std::function<int(const Vec3&)>& region_at);

  static constexpr int kUnknown = -1;
  /// Region at p, or kUnknown near the boundary and outside the box.
  [[nodiscard]] int at(const Vec3& p) const;
  /// Calls visit(item) for the items of the hierarchy that meet the cells around the segment p..q: all that
  /// the segment can meet, some of them more than once. False, and nothing visited, where the cells are many.
  template <class Visit>
  bool visit_segment(const Vec3& p, const Vec3& q, const Visit& visit) const;

 private:
  using Cell = std::array<int, 3>;
  /// False outside the box.
  [[nodiscard]] bool find_cell(const Vec3& p, Cell& cell) const;
  [[nodiscard]] std::size_t index(const Cell& c) const {
    return (static_cast<std::size_t>(c[2]) * cells_[1] + c[1]) * cells_[0] + c[0];
  }
  [[nodiscard]] Box3 box_of(const Cell& lo, const Cell& hi) const;
  /// The first and the last of the cells around the box lo..hi; the outermost where that goes beyond them.
  void find_cells(const Vec3& lo, const Vec3& hi, Cell& first, Cell& last) const {
    for (int k = 0; k < 3; ++k) {
      const double most = cells_[k] - 1;
      first[k] = static_cast<int>(std::clamp((lo[k] - lo_[k]) / width_, 0.0, most));
      last[k] = static_cast<int>(std::clamp((hi[k] - lo_[k]) / width_, 0.0, most));
    }
  }
  /// An item of the hierarchy in a cell that it meets.
  struct Met {
    std::uint32_t cell, item;
  };
  /// Appends the cells from `lo` to below `hi` that the item meets.
  void find_met(const FacetBvh& bvh, std::uint32_t item, const Cell& lo, const Cell& hi,
                std::vector<Met>& met) const;
  /// Fills `label_` and `items_`.
  void sort_items(const FacetBvh& bvh);
  void flood(const Cell& start, int region);

  Vec3 lo_ = Vec3::Zero();
  double width_ = 0.0;
  Cell cells_{0, 0, 0};
  std::vector<std::int32_t> label_;      ///< region, or ~k for the k-th cell with items
  std::vector<std::uint32_t> items_;     ///< of the hierarchy, cell by cell
  std::vector<std::uint32_t> first_{0};  ///< per cell with items
};

template <class Visit>
bool RegionGrid::visit_segment(const Vec3& p, const Vec3& q, const Visit& visit) const {
  constexpr int kMostSteps = 8;
  if (label_.empty()) return false;
  // Beyond the box are no facets, but growth: what reaches out there meets the outermost cells, too.
  Cell a, b;
  find_cells(p.cwiseMin(q), p.cwiseMax(q), a, b);
  if (b[0] - a[0] + b[1] - a[1] + b[2] - a[2] > kMostSteps) return false;
  Cell c;
  for (c[2] = a[2]; c[2] <= b[2]; ++c[2])
    for (c[1] = a[1]; c[1] <= b[1]; ++c[1])
      for (c[0] = a[0]; c[0] <= b[0]; ++c[0]) {
        const std::int32_t label = label_[index(c)];
        if (label >= 0) continue;
        for (std::uint32_t i = first_[~label]; i < first_[~label + 1]; ++i) visit(items_[i]);
      }
  return true;
}

}  // namespace octet
