// SPDX-License-Identifier: BSD-3-Clause
// Plane faces over the openings of shells.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "base/vec.h"
#include "geom/occt/edge_loops.h"

namespace octet {

class EntityNames;

/// A plane face over an opening.
struct Cap {
  TopoDS_Face face;  ///< of the free edges themselves
  EdgeLoop edges;    ///< of all its loops
  double area = 0.0;
  Vec3 place = Vec3::Zero();  ///< its centre
  double off = 0.0;           ///< how far its edges lie off its plane
};

/// A face over each loop of free edges of `shape` that lies in a plane, to `tolerance` (mm) and those of its
/// edges. Of loops in one plane that lie in each other the inner ones are holes of the outer ones, and so on
/// by turns. None over loops that cross, or that are no wider than the tolerance; none that would lie on a
/// face of the shape that has its edges (a plane sheet is no opening). The shape is not changed; faces may be
/// turned either way.
[[nodiscard]] std::vector<Cap> planar_caps(const TopoDS_Shape& shape, double tolerance);

/// What the model calls a cap, counted from 1.
[[nodiscard]] std::string cap_name(std::size_t number);

/// What the notes say of caps, of which there were `before` in the part.
[[nodiscard]] std::string caps_note(const std::vector<Cap>& caps, std::size_t before,
                                    const EntityNames& names);

}  // namespace octet
