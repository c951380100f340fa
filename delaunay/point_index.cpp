// SPDX-License-Identifier: BSD-3-Clause
// Counting sort of points into cells.
#include "delaunay/point_index.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace octet {

PointIndex::PointIndex(std::span<const Vec3> points) : points_(points) {
  OCTET_CHECK(!points.empty());
  for (const Vec3& p : points) bounds_.add(p);
  constexpr double kPointsPerCell = 8;
  constexpr double kMostCells = 1024;  // along an axis
  const double extent = bounds_.size().maxCoeff();
  if (extent > 0) {
    const double along = std::clamp(std::cbrt(points.size() / kPointsPerCell), 1.0, kMostCells);
    cell_ = extent / along;
  }
  for (int k = 0; k < 3; ++k) cells_[k] = static_cast<std::size_t>(bounds_.size()[k] / cell_) + 1;

  const auto number = [&](const Vec3& p) {
    const auto c = cell_of(p);
    return c[0] + cells_[0] * (c[1] + cells_[1] * c[2]);
  };
  first_.assign(cells_[0] * cells_[1] * cells_[2] + 1, 0);
  for (const Vec3& p : points) ++first_[number(p) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  sorted_.resize(points.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    sorted_[next[number(points[i])]++] = static_cast<std::uint32_t>(i);
  }
}

std::array<std::size_t, 3> PointIndex::cell_of(const Vec3& p) const {
  std::array<std::size_t, 3> c{};
  for (int k = 0; k < 3; ++k) {
    const double at = (p[k] - bounds_.lo[k]) / cell_;
    c[k] = at > 0 ? static_cast<std::size_t>(std::min(at, static_cast<double>(cells_[k] - 1))) : 0;
  }
  return c;
}

void PointIndex::gather(const Box3& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  const auto lo = cell_of(box.lo), hi = cell_of(box.hi);
  for (std::size_t z = lo[2]; z <= hi[2]; ++z) {
    for (std::size_t y = lo[1]; y <= hi[1]; ++y) {
      const std::size_t row = cells_[0] * (y + cells_[1] * z);
      for (std::uint32_t n = first_[row + lo[0]]; n < first_[row + hi[0] + 1]; ++n) {
        if (box.contains(points_[sorted_[n]])) found.push_back(sorted_[n]);
      }
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace octet
