// SPDX-License-Identifier: BSD-3-Clause
// A coarse lattice that answers "which region" at once where the boundary is far, and "which facets" where it
// is near.
#include "geom/region_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bucket_sort.h"

namespace octet {
namespace {

/// Cells in all, as cubes: a few milliseconds to build, and most of the inside of a compact part, or of a
/// plate of a twentieth of its length, is known. Where facets are few, fewer cells for each: a question among
/// a handful of facets costs no more in a large cell, and a box of twelve would wait for its lattice the
/// tenth part of its run.
constexpr double kMostCells = 1 << 17, kFewestCells = 1 << 13, kCellsAFacet = 32;
constexpr int kMostAlong = 512;                                            ///< along one side
constexpr std::int32_t kEmpty = std::numeric_limits<std::int32_t>::max();  // not yet flooded

}  // namespace

RegionGrid::RegionGrid(const FacetBvh& bvh, const Box3& box,
                       const std::function<int(const Vec3&)>& region_at) {
  if (box.empty() || !(box.size().maxCoeff() > 0.0)) return;
  lo_ = box.lo;
  const Vec3 size = box.size().cwiseMax(box.size().maxCoeff() / kMostAlong);
  const double cells = std::clamp(kCellsAFacet * bvh.items(), kFewestCells, kMostCells);
  width_ = std::max(std::cbrt(size.prod() / cells), size.maxCoeff() / kMostAlong);
  for (int k = 0; k < 3; ++k)
    cells_[k] = std::clamp(static_cast<int>(std::ceil(box.size()[k] / width_)), 1, kMostAlong);
  label_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], kEmpty);
  sort_items(bvh);
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

/// Halves the block of cells, where the item meets it, until it is one cell.
void RegionGrid::find_met(const FacetBvh& bvh, std::uint32_t item, const Cell& lo, const Cell& hi,
                          std::vector<Met>& met) const {
  if (!bvh.item_meets(item, box_of(lo, hi))) return;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  if (hi[axis] - lo[axis] == 1) {
    met.push_back({static_cast<std::uint32_t>(index(lo)), item});
    return;
  }
  Cell middle_hi = hi, middle_lo = lo;
  middle_hi[axis] = middle_lo[axis] = (lo[axis] + hi[axis]) / 2;
  find_met(bvh, item, lo, middle_hi, met);
  find_met(bvh, item, middle_lo, hi, met);
}

void RegionGrid::sort_items(const FacetBvh& bvh) {
  const Vec3 slack = Vec3::Constant(1e-6 * width_);  // more than cells are grown
  std::vector<Met> met;
  for (std::uint32_t item = 0; item < bvh.items(); ++item) {
    const FloatBox& box = bvh.box_of(item);
    Cell first, last;
    find_cells(Vec3(box.lo[0], box.lo[1], box.lo[2]) - slack, Vec3(box.hi[0], box.hi[1], box.hi[2]) + slack,
               first, last);
    find_met(bvh, item, first, {last[0] + 1, last[1] + 1, last[2] + 1}, met);
  }
  // By one thread: others may be waiting for the lattice.
  bucket_sort(
      met, label_.size(), [](const Met& m) { return m.cell; },
      [](const Met& m, const Met& n) { return m.item < n.item; }, Sorting::kOneThread);
  for (std::size_t i = 0; i < met.size(); ++i) {
    items_.push_back(met[i].item);
    if (i + 1 < met.size() && met[i + 1].cell == met[i].cell) continue;
    label_[met[i].cell] = ~static_cast<std::int32_t>(first_.size() - 1);
    first_.push_back(static_cast<std::uint32_t>(items_.size()));
  }
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
