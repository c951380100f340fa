// SPDX-License-Identifier: BSD-3-Clause
// Lattices of samples: one sample in every octant of the size wished, or in a neighbour.
#include "geom/size_wishes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace octet {
namespace {

/// How many pieces no longer than the size a length has, at most so many: clamped before it is a whole
/// number, which a length over a size far too small is not.
int pieces(double length, double size, int most) {
  return static_cast<int>(std::clamp(std::ceil(length / size), 1.0, static_cast<double>(most)));
}

}  // namespace

void wish_on_edge(const Model& model, int edge, double t0, double t1, double size, const Wisher& who,
                  Wishes& wishes) {
  if (!wishes.counts(size)) return;
  constexpr int kMost = 100'000;
  const double length = model.edge_length(edge, t0, t1);
  const int n = pieces(length, wishes.floored(size), kMost);
  for (int k = 0; k <= n; ++k) wishes.add(model.edge_point(edge, t0 + (t1 - t0) * k / n), size, who);
}

void wish_on_triangle(const std::array<Vec3, 3>& corners, double size, const Wisher& who, Wishes& wishes) {
  if (!wishes.counts(size)) return;
  // Rows along the longest side: a long thin facet has no more samples than its area asks for.
  std::size_t apex = 0;
  const auto side = [&](std::size_t k) { return (corners[(k + 2) % 3] - corners[(k + 1) % 3]).norm(); };
  for (std::size_t k = 1; k < 3; ++k)
    if (side(k) > side(apex)) apex = k;
  const Vec3 &a = corners[(apex + 1) % 3], &b = corners[(apex + 2) % 3], &c = corners[apex];
  const double longest = side(apex);
  const auto pieces_of = [&](double length) {
    constexpr int kMost = 4096;
    return pieces(length, wishes.floored(size), kMost);
  };
  if (pieces_of(longest) == 1) {
    wishes.add((a + b + c) / 3.0, size, who);
    return;
  }
  const int rows = pieces_of((b - a).cross(c - a).norm() / longest);
  for (int i = 0; i <= rows; ++i) {
    const Vec3 from = a + (c - a) * i / rows, along = (b - a) * (rows - i) / rows;
    const int n = pieces_of(along.norm());
    for (int j = 0; j <= n; ++j) wishes.add(from + along * j / n, size, who);
  }
}

}  // namespace octet
