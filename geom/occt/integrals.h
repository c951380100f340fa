// SPDX-License-Identifier: BSD-3-Clause
// Area of a face and its share of a solid's volume, integrated on the exact surface.
#pragma once

#include <TopoDS_Face.hxx>

#include "geom/surface.h"

namespace octet {

struct FaceIntegrals {
  double area = 0.0;
  double volume = 0.0;  ///< integral of (x - origin) . n / 3, n = the face's normal as oriented
};

/// Requires a triangulation of the face: its (u,v) triangles, and the slivers between their chords and the
/// loops, are the domain of integration. Refined where the integrand varies within a triangle.
/// About 1e-7 relative; BRepGProp needs up to minutes for that, or is wrong by percents where it is fast.
[[nodiscard]] FaceIntegrals integrate_face(const TopoDS_Face& face, const Surface& surface,
                                           const Vec3& origin);

}  // namespace octet
