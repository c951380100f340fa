// SPDX-License-Identifier: BSD-3-Clause
// Segments as an octree asks for.
#pragma once

#include <random>
#include <utility>

#include "geom/model.h"

namespace octet::test {

/// Axis-parallel, at general places near the surface; one in four crosses the whole part.
class LatticeSegments {
 public:
  explicit LatticeSegments(const Model& model, double whole_rows = 0.25)
      : model_(model), step_(model.diagonal() / 40.0), whole_rows_(whole_rows) {}

  std::pair<Vec3, Vec3> next() {
    const Facets& facets = model_.facets();
    const auto& nodes = facets.triangles[generator_() % facets.triangles.size()];
    const double a = unit(), b = unit() * (1.0 - a);
    Vec3 p = (1.0 - a - b) * facets.nodes[nodes[0]] + a * facets.nodes[nodes[1]] + b * facets.nodes[nodes[2]];
    for (int i = 0; i < 3; ++i) p[i] += (unit() - 0.5) * step_;
    const auto axis = static_cast<Eigen::Index>(generator_() % 3);
    Vec3 q = p;
    const double half = unit() < whole_rows_ ? 1.1 * model_.diagonal() : 0.5 * step_;
    p[axis] -= half;
    q[axis] += half;
    return {p, q};
  }

  double unit() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

 private:
  const Model& model_;
  double step_, whole_rows_;
  std::mt19937_64 generator_{20240229};
};

}  // namespace octet::test
