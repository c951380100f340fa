// SPDX-License-Identifier: BSD-3-Clause
// Samples of wished sizes, dense enough for the octree, on edges and triangles.
#pragma once

#include <array>
#include <vector>

#include "base/size_sample.h"
#include "geom/model.h"

namespace octet {

/// Who wishes, and why.
struct Wisher {
  ModelRef on;
  SizeReason why = SizeReason::kAttribute;
};

/// Gathers the wishes below the size asked for, none below the smallest.
class Wishes {
 public:
  Wishes(double size, double min_size) : size_(size), min_size_(min_size) {}
  [[nodiscard]] double floored(double size) const { return size > min_size_ ? size : min_size_; }
  [[nodiscard]] bool counts(double size) const { return floored(size) < size_; }
  void add(const Vec3& place, double size, const Wisher& who, bool at_most = false) {
    if (counts(size)) samples_.push_back({place, floored(size), who.on, who.why, at_most});
  }
  std::vector<SizeSample> take() { return std::move(samples_); }

 private:
  double size_, min_size_;
  std::vector<SizeSample> samples_;
};

/// Samples of the edge from t0 to t1, no farther apart than the size wished.
void wish_on_edge(const Model& model, int edge, double t0, double t1, double size, const Wisher& who,
                  Wishes& wishes);
/// Samples of the triangle, no farther apart than the size wished; its centroid alone where it is smaller.
void wish_on_triangle(const std::array<Vec3, 3>& corners, double size, const Wisher& who, Wishes& wishes);

}  // namespace octet
