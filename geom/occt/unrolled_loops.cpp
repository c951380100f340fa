// SPDX-License-Identifier: BSD-3-Clause
// Curves in (u,v) for edges on surfaces whose parameters are known in closed form.
#include "geom/occt/unrolled_loops.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/constants.h"
#include "geom/occt/canonical.h"

namespace octet {
namespace {

constexpr int kPieces = 48;  // of an edge

/// A curve through the places, which are in the order of the edge as it is turned.
void add_curve(const Unrolling& on, const TopoDS_Edge& edge, const gp_Pnt2d* places) {
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, kPieces + 1);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, kPieces + 1);
  for (int i = 0; i <= kPieces; ++i) {
    points->SetValue(i + 1, places[edge.Orientation() == TopAbs_FORWARD ? i : kPieces - i]);
    parameters->SetValue(i + 1, first + (last - first) * i / kPieces);
  }
  Geom2dAPI_Interpolate fit(points, parameters, false, Precision::PConfusion());
  fit.Perform();
  if (!fit.IsDone()) throw Standard_Failure("the curve of an edge on its surface cannot be interpolated");
  const BRep_Builder builder;
  builder.UpdateEdge(edge, fit.Curve(), on.surface, TopLoc_Location(), Precision::Confusion());
  builder.Range(edge, on.surface, TopLoc_Location(), first, last);
}

}  // namespace

std::vector<Vec3> places_along(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  std::vector<Vec3> at;
  for (int i = 0; i <= kPieces; ++i) at.push_back(to_vec(curve.Value(first + (last - first) * i / kPieces)));
  if (edge.Orientation() == TopAbs_REVERSED) std::reverse(at.begin(), at.end());
  return at;
}

std::vector<gp_Pnt2d> unrolled(const Unrolling& on, const std::vector<TopoDS_Edge>& loop, gp_Pnt2d beside) {
  std::vector<gp_Pnt2d> places;
  for (const TopoDS_Edge& edge : loop)
    for (const Vec3& p : places_along(edge)) {
      gp_Pnt2d place = on.at(gp_Pnt(p.x(), p.y(), p.z()));
      place.SetX(beside.X() + std::remainder(place.X() - beside.X(), kTurn));
      if (on.v_turns) place.SetY(beside.Y() + std::remainder(place.Y() - beside.Y(), kTurn));
      places.push_back(place);
      beside = place;
    }
  return places;
}

TopoDS_Wire unrolled_wire(const Unrolling& on, const std::vector<TopoDS_Edge>& loop, const gp_Pnt2d& beside) {
  const std::vector<gp_Pnt2d> places = unrolled(on, loop, beside);
  const BRep_Builder builder;
  TopoDS_Wire made;
  builder.MakeWire(made);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    add_curve(on, loop[i], &places[i * (kPieces + 1)]);
    builder.Add(made, loop[i]);
  }
  made.Closed(true);
  return made;
}

}  // namespace octet
