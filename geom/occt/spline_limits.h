// SPDX-License-Identifier: BSD-3-Clause
// What may be turned into splines to be fused, faces and solids alike.
#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

namespace octet {

/// No more faces: a fuse of splines takes some ten times as long as one of planes and cylinders.
inline constexpr int kMostSplineFaces = 600;
/// Edges may have a tolerance this many times as wide as before.
inline constexpr double kWiderAsSplines = 2.0;

/// Whether the face's surface as a spline is the same surface.
[[nodiscard]] inline bool converts_exactly(const TopoDS_Face& face) {
  const GeomAbs_SurfaceType type = BRepAdaptor_Surface(face, false).GetType();
  return type != GeomAbs_OffsetSurface && type != GeomAbs_OtherSurface;
}

}  // namespace octet
