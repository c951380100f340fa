// SPDX-License-Identifier: BSD-3-Clause
// Triangulations of all faces by our own means, in the place where OCCT's mesher leaves its own.
#pragma once

#include <vector>

#include "geom/model.h"
#include "geom/occt/child_process.h"
#include "geom/occt/numbering.h"

namespace octet {

/// Gives every face a triangulation with (u,v), and every edge its polygons on the faces with parameters.
/// Edges are divided until chords and tangents follow the curve, and further where the loops of a face would
/// cross in (u,v). All faces of an edge share its points, and every piece of an edge is a side of a triangle
/// even where loops cross: what is closed in the B-rep is closed here. Needs the topology, curves and
/// surfaces of `parts`. `deflection` is by face tag; an edge has the least of its faces'. ModelError: as
/// face_polygons(); a face with nothing inside its loops.
void triangulate_boundary(const Numbering& numbering, const ModelParts& parts,
                          const std::vector<double>& deflection, const StageLog& log);

}  // namespace octet
