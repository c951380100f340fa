// SPDX-License-Identifier: BSD-3-Clause
// Lengths by chords, many to a piece.
#include "octree/equal_parts.h"

#include <cstddef>

namespace octet {

std::vector<double> equal_parts(const Model& model, int edge, int n) {
  constexpr int kChordsAPiece = 64;
  const ModelEdge& whole = model.edge(edge);
  const int chords = kChordsAPiece * n;
  const auto parameter = [&](int i) { return whole.t0 + (whole.t1 - whole.t0) * i / chords; };
  std::vector<double> length{0.0};
  Vec3 last = model.edge_point(edge, whole.t0);
  for (int i = 1; i <= chords; ++i) {
    const Vec3 p = model.edge_point(edge, parameter(i));
    length.push_back(length.back() + (p - last).norm());
    last = p;
  }
  std::vector<double> parts;
  std::size_t i = 1;
  for (int k = 1; k < n; ++k) {
    const double wanted = length.back() * k / n;
    while (i + 1 < length.size() && length[i] < wanted) ++i;
    const double step = length[i] - length[i - 1];
    const double share = step > 0.0 ? (wanted - length[i - 1]) / step : 0.0;
    const double from = parameter(static_cast<int>(i) - 1), to = parameter(static_cast<int>(i));
    parts.push_back(from + share * (to - from));
  }
  return parts;
}

}  // namespace octet
