// SPDX-License-Identifier: BSD-3-Clause
// Tests the invariants that a Model states.
#pragma once

#include <string>

#include "geom/model.h"

namespace octet {

/// Empty when all hold, else one line on the first that does not:
///  1. adjacency agrees in both directions (vertex-edge, edge-face, face-region), lists ascending;
///  2. vertices lie on the ends of their edges' curves, edges on their faces, within the stated tolerances;
///  3. facet nodes lie on their faces within the stated deviation, facets are oriented as the face;
///  4. every face has facets, and those of every region are closed: each side is used as often in either
///  direction.
/// Cost: some samples on each edge and one projection per facet.
[[nodiscard]] std::string check_model(const Model& model);

}  // namespace octet
