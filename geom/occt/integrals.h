// SPDX-License-Identifier: BSD-3-Clause
// Area of a face and its share of a solid's volume, integrated on the exact surface.
#pragma once

#include <TopoDS_Face.hxx>

#include "geom/surface.h"

namespace octet {

/// n is the face's normal as oriented.
struct FaceIntegrals {
  double area = 0.0;
  Vec3 vector = Vec3::Zero();  ///< integral of n
  Vec3 origin = Vec3::Zero();  ///< a point of the face
  double moment = 0.0;         ///< integral of (x - origin) . n / 3

  /// The face's share of a solid's volume, as seen from a point in or near the solid: loops that leave gaps
  /// let a share of volume through that grows with the distance.
  [[nodiscard]] double volume(const Vec3& from) const { return moment + (origin - from).dot(vector) / 3.0; }
};

/// Requires a triangulation of the face: its (u,v) triangles, and the slivers between their chords and the
/// loops, are the domain of integration. Cut where the surface is not smooth, and refined where the integrand
/// varies within a triangle. A plane's (u,v) may be folded: its area is that of the integral of n.
/// Within 1e-7 relative; BRepGProp needs up to minutes for that, or is wrong by percents where it is fast.
[[nodiscard]] FaceIntegrals integrate_face(const TopoDS_Face& face, const Surface& surface);

}  // namespace octet
