// SPDX-License-Identifier: BSD-3-Clause
// Faces of revolution that lost their pole.
#pragma once

#include <TopoDS_Face.hxx>

#include "geom/occt/repair.h"

namespace octet {

/// A face of revolution whose only loop goes once around the axis gets the pole that lies on the face's side
/// of the loop, where its meridian meets the axis, and a seam from there to the loop. OCCT's reader looks for
/// poles at the ends of a surface's range alone; the meridian of an ogive is a whole circle, which goes on
/// beyond the axis, and of its face the reader leaves the loop. `entities`: the faces.
[[nodiscard]] Repair add_missing_poles(const TopoDS_Shape& solid);

/// A FORWARD face whose only loop goes once around, carried on to the pole at v = `pole`, with a seam from
/// the start of its first edge, along u; null where its loop does not go once around.
[[nodiscard]] TopoDS_Face carried_to_pole(const TopoDS_Face& face, double pole);

}  // namespace octet
