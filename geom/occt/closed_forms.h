// SPDX-License-Identifier: BSD-3-Clause
// Faces whose splines are planes, cylinders or cones, on planes, cylinders and cones.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// Puts faces whose splines, extrusions and so on are planes, cylinders or cones (geom/recognise) on these,
/// in place, and gives their edges curves on them: OCCT intersects these by formulas, and splines by marching
/// along what they have in common, which takes many times as long and fails for some. (Spheres and tori: an
/// assembly took twice as long with them as with their splines.) Edges stay as they are in space. A face
/// stays a spline where a new curve, or on planes an edge, would be farther off than the edge's tolerance
/// allows. Returns how many changed.
int give_closed_forms(const std::vector<TopoDS_Shape>& solids);

}  // namespace octet
