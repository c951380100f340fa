// SPDX-License-Identifier: BSD-3-Clause
// OCCT surfaces, curves and loops to ours: closed forms where there are any.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <memory>

#include "base/vec.h"
#include "geom/surface.h"

namespace octet {

[[nodiscard]] inline Vec3 to_vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
[[nodiscard]] inline Vec3 to_vec(const gp_Pnt& p) { return to_vec(p.XYZ()); }
[[nodiscard]] inline Vec3 to_vec(const gp_Vec& v) { return to_vec(v.XYZ()); }

/// The surface under a face, with OCCT's own (u,v); a periodic one reports (u,v) in the face's range.
/// ModelError: the face has no surface or no bounded range.
[[nodiscard]] std::shared_ptr<const Surface> make_surface(const TopoDS_Face& face, int tag);

/// The curve under an edge over its parameter range.
[[nodiscard]] std::shared_ptr<const Curve> make_curve(const TopoDS_Edge& edge);

}  // namespace octet
