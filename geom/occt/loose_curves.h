// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces that run beside their edges.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

#include "geom/occt/misplaced_curves.h"

namespace octet {

/// Fits an edge's curve on a face anew, in place, through the points of the face nearest to the edge; true
/// where the new one is nearer by far, else the old one stays, as do degenerate edges and such without
/// curves. Both curves of a seam are as far apart afterwards as before.
bool fit_curve(const TopoDS_Edge& edge, const TopoDS_Face& face);

/// Fits those curves anew, but of seams, that run more than `apart` (mm) beside their edge, though the edge
/// itself lies on the face: where a file has no curves on faces OCCT's reader projects the edges, and on
/// splines, tori and cones what it takes for good may be hundredths of a millimetre off; such a gap is then
/// covered by the edge's tolerance, and what the curve cuts off the face is not the face. Tolerances go down
/// with the gaps. Curves of a face that is hardly wider than they are off stay as they are: it is a strip,
/// and becomes an edge by their tolerance (geom/occt/strips).
[[nodiscard]] std::vector<CurveRenewed> fit_loose_curves(const TopoDS_Shape& solid, double apart);

}  // namespace octet
