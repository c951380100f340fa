// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces that are of another place than their edge in space.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

struct CurveRenewed {
  TopoDS_Edge edge;
  TopoDS_Face face;
  double gap = 0.0;  ///< between edge and old curve on the face, at equal parameter
};

struct CurvesRenewed {
  std::vector<CurveRenewed> curves;
  std::vector<TopoDS_Face> joined;  ///< faces of loops whose curves were whole periods apart
};

/// Makes those curves on faces anew, in place, that lie a tenth of their edge's length or more off it, though
/// the edge itself lies on the face: files without such curves get them while they are read, and on surfaces
/// of revolution they may come out at another angle. What a new curve does not better tenfold stays; seams
/// and degenerate edges stay. Tolerances that were to cover the gap go down with it. Then curves of a loop
/// that lie whole periods from where the one before ends are moved there.
[[nodiscard]] CurvesRenewed renew_misplaced_curves(const TopoDS_Shape& solid);

}  // namespace octet
