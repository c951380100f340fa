// SPDX-License-Identifier: BSD-3-Clause
// A coarse lattice that answers "which region" at once where the boundary is far, and "which facets" where it
// is near.
#include "geom/region_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace octet {
namespace {

/// Cells in all, as cubes: a few milliseconds to build, and most of the inside of a compact part, or of a
/// plate of a twentieth of its length, is known.
constexpr double kCells = 1 << 17;
constexpr int kMostCells = 512;                                            ///< along one side
constexpr std::int32_t kEmpty = std::numeric_limits<std::int32_t>::max();  // not yet flooded

}  // namespace

RegionGrid::RegionGrid(const FacetBvh& bvh, const Box3& box,
                       const std::function<int(const Vec3&)>& region_at) {
  if (box.empty() || !(box.size().maxCoeff() > 0.0)) return;
  lo_ = box.lo;
  const Vec3 size = box.size().cwiseMax(box.size().maxCoeff() / kMostCells);
  width_ = std::max(std::cbrt(size.prod() / kCells), size.maxCoeff() / kMostCells);
  for (int k = 0; k < 3; ++k)
    cells_[k] = std::clamp(static_cast<int>(std::ceil(box.size()[k] / width_)), 1, kMostCells);
  label_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], kEmpty);
  std::vector<std::uint32_t> all(bvh.items());
  std::iota(all.begin(), all.end(), 0u);
  sort_items(bvh, {0, 0, 0}, cells_, all, all.size());
  Cell c;
  for (c[2] = 0; c[2] < cells_[2]; ++c[2])
    for (c[1] = 0; c[1] < cells_[1]; ++c[1])
      for (c[0] = 0; c[0] < cells_[0]; ++c[0])
        if (label_[index(c)] == kEmpty)
          flood(c, region_at(box_of(c, {c[0] + 1, c[1] + 1, c[2] + 1}).centre()));
}

Box3 RegionGrid::box_of(const Cell& lo, const Cell& hi) const {
  Box3 box;
  box.lo = lo_ + width_ * Vec3(lo[0], lo[1], lo[2]);
  box.hi = lo_ + width_ * Vec3(hi[0], hi[1], hi[2]);
  // Slightly larger, so that a point that rounding puts into the next cell is safe.
  return box.grown(1e-9 * width_);
}

/// Halves the block of cells until it is empty or one cell.
void RegionGrid::sort_items(const FacetBvh& bvh, const Cell& lo, const Cell& hi,
                            std::vector<std::uint32_t>& near, std::size_t count) {
  const FacetBvh::BoxProbe box(box_of(lo, hi));
  const std::size_t given = near.size() - count, kept = near.size();
  for (std::size_t i = given; i < kept; ++i)
    if (bvh.item_meets(near[i], box)) near.push_back(near[i]);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  if (near.size() > kept && hi[axis] - lo[axis] > 1) {
    Cell middle_hi = hi, middle_lo = lo;
    middle_hi[axis] = middle_lo[axis] = (lo[axis] + hi[axis]) / 2;
    sort_items(bvh, lo, middle_hi, near, near.size() - kept);
    sort_items(bvh, middle_lo, hi, near, near.size() - kept);
  } else if (near.size() > kept) {
    label_[index(lo)] = ~static_cast<std::int32_t>(first_.size() - 1);
    items_.insert(items_.end(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
    first_.push_back(static_cast<std::uint32_t>(items_.size()));
  }
  near.resize(kept);
}

void RegionGrid::flood(const Cell& start, int region) {
  std::vector<Cell> stack{start};
  label_[index(start)] = region;
  while (!stack.empty()) {
    const Cell c = stack.back();
    stack.pop_back();
    for (int k = 0; k < 3; ++k)
      for (const int step : {-1, 1}) {
        Cell next = c;
        next[k] += step;
        if (next[k] < 0 || next[k] >= cells_[k] || label_[index(next)] != kEmpty) continue;
        label_[index(next)] = region;
        stack.push_back(next);
      }
  }
}

bool RegionGrid::find_cell(const Vec3& p, Cell& cell) const {
  if (label_.empty()) return false;
  for (int k = 0; k < 3; ++k) {
    const double x = (p[k] - lo_[k]) / width_;
    if (!(x >= 0.0 && x < cells_[k])) return false;
    cell[k] = static_cast<int>(x);
  }
  return true;
}

int RegionGrid::at(const Vec3& p) const {
  Cell c;
  return find_cell(p, c) ? std::max(label_[index(c)], kUnknown) : kUnknown;
}

}  // namespace octet
