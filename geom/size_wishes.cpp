// SPDX-License-Identifier: BSD-3-Clause
// Lattices of samples: one sample in every octant of the size wished, or in a neighbour.
#include "geom/size_wishes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace octet {

void wish_on_edge(const Model& model, int edge, double t0, double t1, double size, const Wisher& who,
                  Wishes& wishes) {
  if (!wishes.counts(size)) return;
  constexpr int kMost = 100'000;
  const double length = model.edge_length(edge, t0, t1);
  const int pieces = std::clamp(static_cast<int>(std::ceil(length / wishes.floored(size))), 1, kMost);
  for (int k = 0; k <= pieces; ++k)
    wishes.add(model.edge_point(edge, t0 + (t1 - t0) * k / pieces), size, who);
}

void wish_on_triangle(const std::array<Vec3, 3>& corners, double size, const Wisher& who, Wishes& wishes) {
  if (!wishes.counts(size)) return;
  const auto& [a, b, c] = corners;
  constexpr int kMost = 4096;
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / wishes.floored(size))), 1, kMost);
  if (n == 1) {
    wishes.add((a + b + c) / 3.0, size, who);
    return;
  }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) wishes.add(a + (b - a) * i / n + (c - a) * j / n, size, who);
}

}  // namespace octet
