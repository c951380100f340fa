// SPDX-License-Identifier: BSD-3-Clause
// OCCT surfaces, curves and loops to ours: closed forms where there are any.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
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
[[nodiscard]] inline gp_Pnt to_pnt(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The surface under a face; a periodic one reports (u,v) in the face's range. Its (u,v) are OCCT's own but
/// where a closed form was recognised in a surface of another kind: from_occt_uv() leads to ours.
/// ModelError: the face has no surface or no bounded range.
[[nodiscard]] std::shared_ptr<const Surface> make_surface(const TopoDS_Face& face, int tag);

/// From OCCT's (u,v) of a face to those of the surface that make_surface() made for it, which must outlive
/// the result. Thread-safe.
[[nodiscard]] std::function<Vec2(const Vec2&)> from_occt_uv(const Surface& surface);

/// Points and derivatives in OCCT's (u,v) of a face, as the file gives them; the surface must outlive the
/// result. Thread-safe.
[[nodiscard]] std::function<SurfaceJet(const Vec2&, int)> occt_jets(const Surface& surface);

/// Whether the surface is a closed form that was recognised in a surface of another kind.
[[nodiscard]] bool is_recognised(const Surface& surface);

/// The curve under an edge over its parameter range.
[[nodiscard]] std::shared_ptr<const Curve> make_curve(const TopoDS_Edge& edge);

}  // namespace octet
