// SPDX-License-Identifier: BSD-3-Clause
// Where a segment meets the model, found the slow way: every surface asked, without facets.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet::test {

/// The events of a segment with every face, by surfaces and trims alone: no facets, no culling.
inline std::vector<double> events_without_facets(const Model& model, const Vec3& p, const Vec3& q) {
  std::vector<double> all;
  std::vector<SurfaceRoot> roots;
  for (int tag = 1; tag <= model.count(2); ++tag) {
    roots.clear();
    model.surface(tag).intersect(p, q, roots);
    for (const SurfaceRoot& root : roots)
      if (model.face_side(tag, root.uv) != TrimSide::kOut) all.push_back(root.t);
  }
  return all;
}

}  // namespace octet::test
