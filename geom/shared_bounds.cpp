// SPDX-License-Identifier: BSD-3-Clause
// By tags, and by the chord that a ball cuts out of a segment.
#include "geom/shared_bounds.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace octet {

bool have_common_edge(const ModelFace& a, const ModelFace& b) {
  return std::any_of(a.boundary.begin(), a.boundary.end(), [&](const FaceBoundary& side) {
    return std::any_of(b.boundary.begin(), b.boundary.end(),
                       [&](const FaceBoundary& other) { return other.edge == side.edge; });
  });
}

std::vector<Ball> about_common_vertices(const Model& model, const std::array<int, 2>& face) {
  constexpr double kShare = 1e-3, kTolerances = 2.0;  // the share is of the diagonal
  std::vector<int> tags;
  const std::vector<int>&a = model.face(face[0]).vertices, &b = model.face(face[1]).vertices;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(tags));
  std::vector<Ball> balls;
  for (const int v : tags) {
    const ModelVertex& vertex = model.vertex(v);
    balls.push_back({vertex.point, kShare * model.diagonal() + kTolerances * vertex.tolerance});
  }
  return balls;
}

Stretches outside_of(const std::vector<Ball>& balls, const Vec3& from, const Vec3& to) {
  Stretches left{{0.0, 1.0}};
  const Vec3 way = to - from;
  const double length2 = way.squaredNorm();
  for (const auto& [centre, radius] : balls) {
    const double middle = length2 > 0.0 ? (centre - from).dot(way) / length2 : 0.0;
    const double off2 = (from + middle * way - centre).squaredNorm();
    if (off2 >= radius * radius) continue;
    const double half = length2 > 0.0 ? std::sqrt((radius * radius - off2) / length2) : 1.0;
    Stretches rest;
    for (const auto& [begin, end] : left) {
      if (begin < std::min(end, middle - half)) rest.push_back({begin, std::min(end, middle - half)});
      if (std::max(begin, middle + half) < end) rest.push_back({std::max(begin, middle + half), end});
    }
    left = rest;
  }
  return left;
}

}  // namespace octet
