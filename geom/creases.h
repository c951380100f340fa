// SPDX-License-Identifier: BSD-3-Clause
// Faces that meet themselves in an edge.
#pragma once

#include <set>

#include "geom/model.h"

namespace octet {

/// Whether the face is on both sides of a real edge, as that of an airfoil is whose surface runs from its
/// trailing edge around to the same: near the edge it is two sheets.
[[nodiscard]] inline bool meets_itself(const Model& model, int face) {
  std::set<int> edges;
  for (const FaceBoundary& side : model.face(face).boundary)
    if (!edges.insert(side.edge).second && model.edge(side.edge).use == EdgeUse::kReal) return true;
  return false;
}

}  // namespace octet
