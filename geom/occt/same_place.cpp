// SPDX-License-Identifier: BSD-3-Clause
// Points at like parameters of edges; places of faces, and their feet on the other.
#include "geom/occt/same_place.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BSplCLib.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/canonical.h"
#include "geom/occt/face_samples.h"

namespace octet {
namespace {

/// Whether points of the edges at like shares of their ranges, counted from the end of the other for
/// `along` = false, are within `near`.
bool runs_with(const BRepAdaptor_Curve& one, const BRepAdaptor_Curve& other, bool along, double near) {
  constexpr int kPieces = 16;
  const auto at = [](const BRepAdaptor_Curve& curve, double share) {
    return curve.Value((1.0 - share) * curve.FirstParameter() + share * curve.LastParameter());
  };
  for (int i = 0; i <= kPieces; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    if (at(one, share).Distance(at(other, along ? share : 1.0 - share)) > near) return false;
  }
  return true;
}

/// Whether the samples of one face lie on the other, and its normals there look their way; none where they
/// do not lie there, or look both ways.
std::optional<bool> samples_lie_on(const std::vector<FaceSample>& samples, const TopoDS_Face& other,
                                   double near) {
  const Handle(ShapeAnalysis_Surface) feet = new ShapeAnalysis_Surface(BRep_Tool::Surface(other));
  const BRepAdaptor_Surface surface(other, false);
  BRepTopAdaptor_FClass2d inside(other, Precision::PConfusion());
  std::size_t with = 0;
  for (const FaceSample& sample : samples) {
    const gp_Pnt point(sample.point.x(), sample.point.y(), sample.point.z());
    const gp_Pnt2d uv = feet->ValueOfUV(point, near);
    gp_Pnt foot;
    gp_Vec du, dv;
    surface.D1(uv.X(), uv.Y(), foot, du, dv);
    if (foot.Distance(point) > near || inside.Perform(uv) == TopAbs_OUT) return std::nullopt;
    const gp_Vec normal = du.Crossed(dv);
    const double turned = other.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
    with += turned * to_vec(normal).dot(sample.normal) > 0.0 ? 1 : 0;
  }
  if (samples.empty() || (with != 0 && with != samples.size())) return std::nullopt;
  return with != 0;
}

/// The curve as it runs over [first, last] now, or the other way, over [new_first, new_last].
Handle(Geom2d_Curve) moved(const Handle(Geom2d_Curve) & curve, double first, double last, bool along,
                           double new_first, double new_last) {
  const double rounding = 1e-12 * std::max({1.0, std::abs(first), std::abs(last)});
  if (along && std::abs(first - new_first) <= rounding && std::abs(last - new_last) <= rounding) return curve;
  const Handle(Geom2d_BSplineCurve) spline =
      Geom2dConvert::CurveToBSplineCurve(new Geom2d_TrimmedCurve(curve, first, last));
  if (!along) spline->Reverse();
  TColStd_Array1OfReal knots(1, spline->NbKnots());
  spline->Knots(knots);
  BSplCLib::Reparametrize(new_first, new_last, knots);
  spline->SetKnots(knots);
  return Handle(Geom2d_Curve)(spline);
}

}  // namespace

std::optional<bool> same_way(const TopoDS_Edge& one, const TopoDS_Edge& other, double near) {
  double first = 0.0, last = 0.0;
  if (BRep_Tool::Curve(one, first, last).IsNull() || BRep_Tool::Curve(other, first, last).IsNull())
    return std::nullopt;
  const BRepAdaptor_Curve a(one), b(other);
  for (const bool along : {true, false})
    if (runs_with(a, b, along, near)) return along;
  return std::nullopt;
}

std::optional<bool> same_side(const TopoDS_Face& one, const TopoDS_Face& other, double near) {
  constexpr std::size_t kSamples = 9;
  try {
    const std::optional<bool> there = samples_lie_on(face_samples(one, kSamples), other, near);
    if (!there) return std::nullopt;
    const std::optional<bool> back = samples_lie_on(face_samples(other, kSamples), one, near);
    return back == there ? there : std::nullopt;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

void take_curve(const TopoDS_Edge& from, const TopoDS_Face& face, const TopoDS_Edge& to, bool along) {
  const TopoDS_Edge forward = TopoDS::Edge(from.Oriented(TopAbs_FORWARD)),
                    backward = TopoDS::Edge(from.Oriented(TopAbs_REVERSED));
  TopLoc_Location place;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, place);
  double first = 0.0, last = 0.0, new_first = 0.0, new_last = 0.0;
  BRep_Tool::Range(to, new_first, new_last);
  Standard_Boolean stored = false;
  const auto curve_of = [&](const TopoDS_Edge& edge) {
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, surface, place, first, last, &stored);
    return curve.IsNull() || !stored ? Handle(Geom2d_Curve)()
                                     : moved(curve, first, last, along, new_first, new_last);
  };
  const Handle(Geom2d_Curve) curve = curve_of(forward);
  if (curve.IsNull()) return;
  const BRep_Builder builder;
  const double tolerance = BRep_Tool::Tolerance(to);
  if (!BRep_Tool::IsClosed(from, surface, place)) {
    builder.UpdateEdge(to, curve, surface, place, tolerance);
    return;
  }
  const Handle(Geom2d_Curve) other = curve_of(backward);
  builder.UpdateEdge(to, along ? curve : other, along ? other : curve, surface, place, tolerance);
}

}  // namespace octet
