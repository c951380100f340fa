// SPDX-License-Identifier: BSD-3-Clause
// Swept hyperbolas, which OCCT would follow to infinity.
#pragma once

#include <TopoDS_Shape.hxx>

namespace octet {

/// A hyperbola that is drawn out or turned about an axis to a surface is cut off beyond what its faces have
/// of it, in place: OCCT's algorithms ask such a surface at its bounds, where its coordinates exceed all
/// numbers, and fail. Nothing else about the surface changes; faces, edges and their curves stay as they are.
void bound_swept_hyperbolas(const TopoDS_Shape& shape);

}  // namespace octet
