// SPDX-License-Identifier: BSD-3-Clause
// The loops of a B-rep face as polygons in (u,v), through given points of its edges.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/face_facets.h"
#include "geom/model.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Per edge tag, ascending parameters of all its points, ends included; of a degenerate edge too.
using EdgeChains = std::vector<std::vector<double>>;

/// An edge as a wire runs along it; points and parameters in the direction of the edge's curve.
struct HalfEdgePoints {
  int edge = 0;
  bool forward = true;                ///< the wire runs as the curve does
  std::vector<std::uint32_t> points;  ///< indices into FaceLoops::uv
  std::vector<double> parameters;
};

struct FacePolygons {
  FaceLoops loops;
  std::vector<HalfEdgePoints> half_edges;
};

/// Edges of each wire in the order in which they join: by their vertices, and by (u,v) where a vertex leaves
/// a choice (seams, poles). Pieces that were left a period apart are moved. ModelError (face, edge, place): a
/// wire that does not close, an edge without a curve on the face, an edge inside the face that is not part of
/// a loop.
[[nodiscard]] FacePolygons face_polygons(const Numbering& numbering, int face, const EdgeChains& chains,
                                         const ModelParts& parts);

}  // namespace octet
