// SPDX-License-Identifier: BSD-3-Clause
// Curves on faces that OCCT's conversion to splines makes amiss.
#pragma once

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <TopoDS_Shape.hxx>

namespace octet {

/// Fits curves on the faces that were made of a solid's anew, in place, where they run more than `noise` (mm)
/// beside their edges: those that OCCT begins on one side of a seam and goes on with from the other, as the
/// curves on the old faces lie, whose parameters are about the same.
void mend_conversion(const TopoDS_Shape& solid, BRepBuilderAPI_NurbsConvert& convert, double noise);

/// Gives edges of a solid no more tolerance than `allowed` (mm): OCCT may give one the size of its face,
/// whatever its curves are. False, and nothing is done, where a curve on a face is farther off its edge.
[[nodiscard]] bool lower_tolerances_to(const TopoDS_Shape& solid, double allowed);

}  // namespace octet
