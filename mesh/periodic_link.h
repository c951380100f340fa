// SPDX-License-Identifier: BSD-3-Clause
// Nodes that are each other's images.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/model_ref.h"

namespace octet {

/// A model entity whose mesh is the image of another's.
struct PeriodicLink {
  ModelRef entity, source;
  std::array<double, 16> motion{};  ///< of `source` to `entity`, row by row, lengths in model units
  /// Nodes of the entity's closure and of its source's, ascending by the former: vertices of the mesh, and
  /// behind these, counted on, the nodes in the middles of its edges.
  std::vector<std::array<std::uint32_t, 2>> nodes;
};

}  // namespace octet
