// SPDX-License-Identifier: BSD-3-Clause
// Which faces a mesh must have at each model edge and vertex.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geom/model.h"

namespace octet {

/// What the model's faces make of its edges and vertices, for all of them at once. Faces outside of all
/// regions are no part of a mesh, and left out.
///
/// Cost: that of the faces' sides and vertices, once.
class ExpectedFaces {
 public:
  explicit ExpectedFaces(const Model& model);

  /// Faces that must meet at a piece of the edge, ascending, a face twice when it lies on both sides.
  [[nodiscard]] std::span<const int> at_edge(int edge) const;

  /// In how many faces' closure the vertex lies although none of its real edges bounds them.
  [[nodiscard]] int edgeless_at(int vertex) const { return edgeless_[static_cast<std::size_t>(vertex)]; }

 private:
  std::vector<std::size_t> end_;  ///< per edge tag: where its faces end, and those of the next begin
  std::vector<int> faces_;
  std::vector<int> edgeless_;  ///< per vertex tag
};

}  // namespace octet
