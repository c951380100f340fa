// SPDX-License-Identifier: BSD-3-Clause
// A coarse lattice that answers "which region" at once where the boundary is far.
#include "geom/region_grid.h"

#include <algorithm>
#include <cmath>

namespace octet {
namespace {

/// Cells in all, as cubes: a few milliseconds to build, and most of the inside of a compact part, or of a
/// plate of a twentieth of its length, is known.
constexpr double kCells = 1 << 17;
constexpr int kMostCells = 512;  ///< along one side
constexpr std::int32_t kBoundary = RegionGrid::kUnknown;
constexpr std::int32_t kEmpty = -2;  // not yet flooded

}  // namespace

RegionGrid::RegionGrid(const FacetBvh& bvh, const Box3& box,
                       const std::function<int(const Vec3&)>& region_at) {
  if (box.empty() || !(box.size().maxCoeff() > 0.0)) return;
  lo_ = box.lo;
  const Vec3 size = box.size().cwiseMax(box.size().maxCoeff() / kMostCells);
  width_ = std::max(std::cbrt(size.prod() / kCells), size.maxCoeff() / kMostCells);
  for (int k = 0; k < 3; ++k)
    cells_[k] = std::clamp(static_cast<int>(std::ceil(box.size()[k] / width_)), 1, kMostCells);
  label_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], kBoundary);
  mark_empty(bvh, {0, 0, 0}, cells_);
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
void RegionGrid::mark_empty(const FacetBvh& bvh, const Cell& lo, const Cell& hi) {
  if (!bvh.meets(box_of(lo, hi))) {
    Cell c;
    for (c[2] = lo[2]; c[2] < hi[2]; ++c[2])
      for (c[1] = lo[1]; c[1] < hi[1]; ++c[1])
        for (c[0] = lo[0]; c[0] < hi[0]; ++c[0]) label_[index(c)] = kEmpty;
    return;
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  if (hi[axis] - lo[axis] == 1) return;
  Cell middle_hi = hi, middle_lo = lo;
  middle_hi[axis] = middle_lo[axis] = (lo[axis] + hi[axis]) / 2;
  mark_empty(bvh, lo, middle_hi);
  mark_empty(bvh, middle_lo, hi);
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
  return find_cell(p, c) ? label_[index(c)] : kUnknown;
}

bool RegionGrid::is_clear(const Vec3& p, const Vec3& q) const {
  constexpr int kMostSteps = 8;
  Cell a, b;
  if (!find_cell(p.cwiseMin(q), a) || !find_cell(p.cwiseMax(q), b)) return false;
  if (b[0] - a[0] + b[1] - a[1] + b[2] - a[2] > kMostSteps) return false;
  Cell c;
  for (c[2] = a[2]; c[2] <= b[2]; ++c[2])
    for (c[1] = a[1]; c[1] <= b[1]; ++c[1])
      for (c[0] = a[0]; c[0] <= b[0]; ++c[0])
        if (label_[index(c)] == kBoundary) return false;
  return true;
}

}  // namespace octet
