// SPDX-License-Identifier: BSD-3-Clause
// How far a face's border goes from where the hyperbola is, and what parameter that is at most.
#include "geom/occt/bounded_sweeps.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <map>

namespace octet {
namespace {

Handle(Geom_SweptSurface) swept(Handle(Geom_Surface) surface) {
  if (const auto part = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !part.IsNull())
    surface = part->BasisSurface();
  return Handle(Geom_SweptSurface)::DownCast(surface);
}

/// The farthest that the face's border is from a place, in its surface's own frame.
double reach_of(const TopoDS_Face& face, const TopLoc_Location& where, const gp_Pnt& from) {
  constexpr int kPieces = 8;
  const gp_Trsf own = where.Transformation().Inverted();
  double reach = 0.0;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    double first = 0.0, last = 0.0;
    if (BRep_Tool::Degenerated(edge) || BRep_Tool::Curve(edge, first, last).IsNull()) continue;
    const BRepAdaptor_Curve curve(edge);
    for (int i = 0; i <= kPieces; ++i) {
      const gp_Pnt p = curve.Value(first + (last - first) * i / kPieces).Transformed(own);
      reach = std::max(reach, p.Distance(from));
    }
  }
  return reach;
}

/// The most that a point of the curve is from the hyperbola's centre, where what becomes of it is `reach`
/// away.
double reach_on_curve(const Geom_SweptSurface& surface, const Geom_Hyperbola& hyperbola, double reach) {
  if (const auto* turned = dynamic_cast<const Geom_SurfaceOfRevolution*>(&surface)) {
    // About the axis a point keeps its distance from any place on it.
    return reach + 2.0 * hyperbola.Hypr().Location().Distance(turned->Axis().Location());
  }
  // Along the direction it keeps its distance across.
  const double rise = std::abs(surface.Direction().Dot(hyperbola.Hypr().Axis().Direction()));
  return reach / std::max(rise, 1e-3);
}

}  // namespace

void bound_swept_hyperbolas(const TopoDS_Shape& shape) {
  std::map<Handle(Geom_SweptSurface), double> most;  // parameters, by surface: several faces may be on one
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    TopLoc_Location where;
    const Handle(Geom_SweptSurface) surface = swept(BRep_Tool::Surface(face, where));
    if (surface.IsNull()) continue;
    const auto hyperbola = Handle(Geom_Hyperbola)::DownCast(surface->BasisCurve());
    if (hyperbola.IsNull()) continue;
    const double reach =
        reach_on_curve(*surface, *hyperbola, reach_of(face, where, hyperbola->Hypr().Location()));
    most[surface] = std::max(most[surface], 1.0 + std::asinh(2.0 * reach / hyperbola->MinorRadius()));
  }
  for (const auto& [surface, parameter] : most) {
    const Handle(Geom_TrimmedCurve) part =
        new Geom_TrimmedCurve(surface->BasisCurve(), -parameter, parameter);
    if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !turned.IsNull())
      turned->SetBasisCurve(part);
    else if (const auto drawn = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !drawn.IsNull())
      drawn->SetBasisCurve(part);
  }
}

}  // namespace octet
