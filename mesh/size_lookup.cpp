// SPDX-License-Identifier: BSD-3-Clause
// The size of a mesh's elements at any place: that of the nearest vertex.
#include "mesh/size_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace octet {

SizeLookup::SizeLookup(const std::vector<Vec3>& points, std::vector<double> size)
    : points_(points), size_(std::move(size)) {
  OCTET_CHECK(!points_.empty() && points_.size() == size_.size());
  for (const Vec3& p : points_) box_.add(p);
  const Vec3 extent = box_.size();
  const double longest = extent.maxCoeff();
  // A flat or long box has few cells across: its width comes from the sides it has.
  double volume = 1.0;
  int sides = 0;
  for (int i = 0; i < 3; ++i) {
    if (extent[i] <= 1e-3 * longest) continue;
    volume *= extent[i];
    ++sides;
  }
  if (sides > 0) width_ = std::pow(2.0 * volume / static_cast<double>(points_.size()), 1.0 / sides);
  for (int i = 0; i < 3; ++i) count_[i] = 1 + static_cast<int>(std::min(extent[i] / width_, 1000.0));
  first_.assign(index_of({count_[0] - 1, count_[1] - 1, count_[2] - 1}) + 2, 0);
  for (const Vec3& p : points_) ++first_[index_of(cell_of(p)) + 1];
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  in_cell_.resize(points_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t v = 0; v < points_.size(); ++v) in_cell_[next[index_of(cell_of(points_[v]))]++] = v;
}

SizeLookup::Cell SizeLookup::cell_of(const Vec3& p) const {
  Cell cell;
  for (int i = 0; i < 3; ++i) {
    const double at = std::floor((p[i] - box_.lo[i]) / width_);
    cell[i] = static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count_[i] - 1)));
  }
  return cell;
}

std::size_t SizeLookup::index_of(const Cell& c) const {
  return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(count_[1]) +
          static_cast<std::size_t>(c[1])) *
             static_cast<std::size_t>(count_[0]) +
         static_cast<std::size_t>(c[0]);
}

double SizeLookup::at(const Vec3& p) const {
  const Cell middle = cell_of(p);
  double nearest = std::numeric_limits<double>::infinity(), size = 0.0;
  std::uint32_t vertex = 0;
  const auto look = [&](const Cell& c) {
    const std::size_t cell = index_of(c);
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const std::uint32_t v = in_cell_[i];
      const double distance = (points_[v] - p).squaredNorm();
      if (distance > nearest || (distance == nearest && v > vertex)) continue;
      nearest = distance;
      vertex = v;
      size = size_[v];
    }
  };
  const double outside = std::sqrt(box_.squared_distance(p));
  const int rings = *std::max_element(count_.begin(), count_.end());
  for (int r = 0; r <= rings; ++r) {
    // What lies in ring r is at least r - 1 widths from p's place in the box.
    const double least = std::max(outside, (r - 1) * width_);
    if (least * least > nearest) break;
    for (int z = std::max(0, middle[2] - r); z <= std::min(count_[2] - 1, middle[2] + r); ++z)
      for (int y = std::max(0, middle[1] - r); y <= std::min(count_[1] - 1, middle[1] + r); ++y)
        for (int x = std::max(0, middle[0] - r); x <= std::min(count_[0] - 1, middle[0] + r); ++x) {
          const int ring =
              std::max({std::abs(x - middle[0]), std::abs(y - middle[1]), std::abs(z - middle[2])});
          if (ring == r) look({x, y, z});
        }
  }
  return size;
}

}  // namespace octet
