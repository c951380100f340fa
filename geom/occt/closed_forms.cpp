// SPDX-License-Identifier: BSD-3-Clause
// Surfaces from a place and derivatives of the closed form, curves on them through places on the old curves.
#include "geom/occt/closed_forms.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Pln.hxx>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "geom/occt/canonical.h"
#include "geom/occt/curve_pieces.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

using Map = std::function<Vec2(const Vec2&)>;

gp_Dir to_direction(const Vec3& d) { return {d.x(), d.y(), d.z()}; }

/// OCCT's plane, cylinder or cone of the same places at the same (u,v); null for other surfaces.
Handle(Geom_Surface) closed_form(const Surface& surface) {
  const std::string_view kind = surface.kind();
  const SurfaceJet jet = surface.evaluate(Vec2::Zero(), 2);
  if (kind == "plane")
    return new Geom_Plane(gp_Ax3(to_pnt(jet.p), to_direction(jet.du.cross(jet.dv)), to_direction(jet.du)));
  if (kind != "cylinder" && kind != "cone") return {};
  // Both turn about z, from x on.
  const double radius = jet.du.norm();
  const Vec3 x = -jet.duu.normalized();
  const double rise = jet.dv.dot(x);
  const Vec3 z = (jet.dv - rise * x).normalized();
  gp_Ax3 axes(to_pnt(jet.p - radius * x), to_direction(z), to_direction(x));
  if (jet.du.dot(to_vec(gp_Vec(axes.YDirection()))) < 0.0) axes.YReverse();
  if (kind == "cylinder") return new Geom_CylindricalSurface(axes, radius);
  return new Geom_ConicalSurface(axes, std::asin(rise), radius);
}

/// A line in the plane from one place to another, with these parameters there.
Handle(Geom2d_Curve) straight(const Vec2& a, const Vec2& b, double t0, double t1) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = {a.x(), a.y()};
  poles(2) = {b.x(), b.y()};
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = t0;
  knots(2) = t1;
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

/// Places that `map` leads to along a curve.
class Mapped {
 public:
  Mapped(Handle(Geom2d_Curve) curve, const Map& map) : curve_(std::move(curve)), map_(map) {}

  [[nodiscard]] Vec2 at(double t) const {
    const gp_Pnt2d uv = curve_->Value(t);
    return map_({uv.X(), uv.Y()});
  }
  /// By differences to one side of t, of third order.
  [[nodiscard]] gp_Vec2d slope(double t, double step) const {
    const Vec2 d =
        (-11.0 * at(t) + 18.0 * at(t + step) - 9.0 * at(t + 2.0 * step) + 2.0 * at(t + 3.0 * step)) /
        (6.0 * step);
    return {d.x(), d.y()};
  }

 private:
  Handle(Geom2d_Curve) curve_;
  const Map& map_;
};

/// The curve through the places at so many even parameters between each two breaks, over which it may bend.
/// Standard_Failure: there is none.
Handle(Geom2d_Curve) curve_through(const Mapped& places, const std::vector<double>& breaks, int between) {
  constexpr double kStep = 1e-4;  // of the first and last piece
  const double t0 = breaks.front(), t1 = breaks.back();
  const Vec2 first = places.at(t0), last = places.at(t1);
  double bend = 0.0;
  CurvePieces pieces;
  for (std::size_t b = 1; b < breaks.size(); ++b) {
    const double low = breaks[b - 1], high = breaks[b], step = (high - low) / between;
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, between + 1);
    const Handle(TColStd_HArray1OfReal) at = new TColStd_HArray1OfReal(1, between + 1);
    for (int i = 0; i <= between; ++i) {
      const double t = i == between ? high : low + step * i;
      const Vec2 place = places.at(t);
      points->SetValue(i + 1, {place.x(), place.y()});
      at->SetValue(i + 1, t);
      bend = std::max(bend, (place - first - (t - t0) / (t1 - t0) * (last - first)).norm());
    }
    Geom2dAPI_Interpolate fit(points, at, false, Precision::PConfusion());
    fit.Load(places.slope(low, kStep * step), places.slope(high, -kStep * step), false);
    fit.Perform();
    if (!fit.IsDone()) throw Standard_Failure("no curve goes through the places");
    pieces.add(*fit.Curve());
  }
  if (bend <= 1e-12 * ((last - first).norm() + 1.0)) return straight(first, last, t0, t1);
  const Handle(Geom2d_BSplineCurve) curve = pieces.curve();
  for (int k = curve->NbKnots() - 1; k > 1; --k)
    if (curve->Multiplicity(k) > 2) static_cast<void>(curve->RemoveKnot(k, 2, Precision::PConfusion()));
  return Handle(Geom2d_Curve)(curve);
}

std::vector<CurveOnFace> curves_on(const TopoDS_Face& face) {
  std::vector<CurveOnFace> curves;
  const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i) {
    CurveOnFace on{TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD)), {}, {}};
    on.curve = BRep_Tool::CurveOnSurface(on.edge, face, on.t0, on.t1);
    if (on.curve.IsNull()) throw Standard_Failure("an edge has no curve on its face");
    if (BRep_Tool::IsClosed(on.edge, face))
      on.back = BRep_Tool::CurveOnSurface(TopoDS::Edge(on.edge.Reversed()), face, on.t0, on.t1);
    curves.push_back(on);
  }
  return curves;
}

/// Where an edge is in space, by its parameter: a degenerate one is its vertex.
class InSpace {
 public:
  /// Null where it has no curve, or one of another range than that on the face.
  explicit InSpace(const CurveOnFace& on) {
    if (BRep_Tool::Degenerated(on.edge)) {
      const TopoDS_Vertex vertex = TopExp::FirstVertex(on.edge);
      pole_ = BRep_Tool::Pnt(vertex);
      allowed_ = BRep_Tool::Tolerance(vertex);
      return;
    }
    double t0 = 0.0, t1 = 0.0;
    curve_ = BRep_Tool::Curve(on.edge, t0, t1);
    is_null_ = curve_.IsNull() || t0 != on.t0 || t1 != on.t1;
    allowed_ = std::max(BRep_Tool::Tolerance(on.edge), Precision::Confusion());
  }

  [[nodiscard]] bool is_null() const { return is_null_; }
  [[nodiscard]] double allowed() const { return allowed_; }  ///< off it, for curves on faces
  [[nodiscard]] const Handle(Geom_Curve) & curve() const { return curve_; }
  [[nodiscard]] gp_Pnt at(double t) const { return curve_.IsNull() ? pole_ : curve_->Value(t); }

 private:
  Handle(Geom_Curve) curve_;
  gp_Pnt pole_;
  double allowed_ = 0.0;
  bool is_null_ = false;
};

/// The largest of a distance along the edge.
template <class Distance>
double widest(const CurveOnFace& on, const Distance& distance) {
  constexpr int kSamples = 101;
  double result = 0.0;
  for (int i = 0; i <= kSamples; ++i)
    result = std::max(result, distance(on.t0 + (on.t1 - on.t0) * i / kSamples));
  return result;
}

/// Appends where a continuous function takes a value between t0 and t1.
template <class Function>
void add_crossings(const Function& of, double value, double t0, double t1, std::vector<double>& found) {
  constexpr int kSteps = 32, kHalvings = 50;
  const auto at = [&](int i) { return t0 + (t1 - t0) * i / kSteps; };
  for (int i = 0; i < kSteps; ++i) {
    double low = at(i), high = at(i + 1);
    const bool below = of(low) < value;
    if ((of(high) < value) == below) continue;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = 0.5 * (low + high);
      ((of(middle) < value) == below ? low : high) = middle;
    }
    found.push_back(high);
  }
}

/// Parameters from t0 to t1 at which a curve, its edge in space (may be null) or the surface below it may
/// bend.
std::vector<double> breaks_of(const Handle(Geom2d_Curve) & curve, const Handle(Geom_Curve) & in_space,
                              const Handle(Geom_Surface) & surface, double t0, double t1) {
  std::vector<double> breaks{t0, t1};
  const auto add_knots = [&](const auto& spline) {
    if (spline.IsNull()) return;
    for (int k = 1; k <= spline->NbKnots(); ++k)
      if (spline->Knot(k) > t0 && spline->Knot(k) < t1) breaks.push_back(spline->Knot(k));
  };
  add_knots(Handle(Geom2d_BSplineCurve)::DownCast(curve));
  add_knots(Handle(Geom_BSplineCurve)::DownCast(in_space));
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull()) {
    const auto u = [&](double t) { return curve->Value(t).X(); };
    const auto v = [&](double t) { return curve->Value(t).Y(); };
    for (int k = 2; k < spline->NbUKnots(); ++k) add_crossings(u, spline->UKnot(k), t0, t1, breaks);
    for (int k = 2; k < spline->NbVKnots(); ++k) add_crossings(v, spline->VKnot(k), t0, t1, breaks);
  }
  std::sort(breaks.begin(), breaks.end());
  const auto same = [&](double a, double b) { return b - a < 1e-9 * (t1 - t0); };
  breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
  breaks.back() = t1;
  return breaks;
}

/// The curve that is wanted on a face that is put on `surface` in place of `was`; null where none is near
/// enough to the edge.
Handle(Geom2d_Curve)
    new_curve(const Geom_Surface& surface, const Map& map, const Handle(Geom2d_Curve) & before,
              const Handle(Geom_Surface) & was, const CurveOnFace& on, const InSpace& in_space) {
  const std::vector<double> breaks = breaks_of(before, in_space.curve(), was, on.t0, on.t1);
  for (const int between : {16, 64, 160}) {
    const Handle(Geom2d_Curve) curve = curve_through(Mapped(before, map), breaks, between);
    const auto off = [&](double t) {
      const gp_Pnt2d uv = curve->Value(t);
      return surface.Value(uv.X(), uv.Y()).Distance(in_space.at(t));
    };
    if (widest(on, off) <= in_space.allowed()) return curve;
  }
  return {};
}

/// The curves on a face that is put on `surface` in place of `was`: none for a plane, on which OCCT projects
/// the edges. False where an edge is too far off it, or its curve would be.
bool move_curves(const Handle(Geom_Surface) & was, const Handle(Geom_Surface) & surface, const Map& map,
                 std::vector<CurveOnFace>& curves) {
  const Handle(Geom_Plane) plane = Handle(Geom_Plane)::DownCast(surface);
  for (CurveOnFace& on : curves) {
    const InSpace in_space(on);
    if (in_space.is_null()) return false;
    if (!plane.IsNull()) {
      const auto off = [&](double t) { return plane->Pln().Distance(in_space.at(t)); };
      if (BRep_Tool::Degenerated(on.edge) || widest(on, off) > in_space.allowed()) return false;
      on.curve.Nullify();
      on.back.Nullify();
      continue;
    }
    for (Handle(Geom2d_Curve) * curve : {&on.curve, &on.back}) {
      if (curve->IsNull()) continue;
      *curve = new_curve(*surface, map, *curve, was, on, in_space);
      if (curve->IsNull()) return false;
    }
  }
  return true;
}

/// Takes the curves that a face's edges have on one surface, and the face, to another.
void put_on(const TopoDS_Face& face, const ClosedForm::Side& from, const ClosedForm::Side& to) {
  const BRep_Builder builder;
  const auto set = [&](const CurveOnFace& on, const ClosedForm::Side& side, bool is_seam) {
    const double tolerance = BRep_Tool::Tolerance(on.edge);
    if (is_seam)
      builder.UpdateEdge(on.edge, on.curve, on.back, side.surface, side.place, tolerance);
    else
      builder.UpdateEdge(on.edge, on.curve, side.surface, side.place, tolerance);
  };
  for (const CurveOnFace& on : from.curves)
    if (!on.curve.IsNull()) set({on.edge, {}, {}}, from, !on.back.IsNull());
  builder.UpdateFace(face, to.surface, to.place, BRep_Tool::Tolerance(face));
  for (const CurveOnFace& on : to.curves) {
    if (on.curve.IsNull()) continue;
    set(on, to, !on.back.IsNull());
    builder.Range(on.edge, face, on.t0, on.t1);
  }
}

/// Puts a face on its closed form. Standard_Failure or none, and nothing is done, where that cannot be.
std::optional<ClosedForm> give_closed_form(const TopoDS_Face& face) {
  const std::shared_ptr<const Surface> surface = make_surface(face, 0);
  if (!is_recognised(*surface)) return std::nullopt;
  const Handle(Geom_Surface) closed = closed_form(*surface);
  if (closed.IsNull()) return std::nullopt;
  ClosedForm form{face, {}, {}};
  form.was.surface = BRep_Tool::Surface(face, form.was.place);
  form.was.curves = form.is.curves = curves_on(face);
  if (!move_curves(BRep_Tool::Surface(face), closed, from_occt_uv(*surface), form.is.curves))
    return std::nullopt;
  form.is.place = face.Location();
  form.is.surface =
      Handle(Geom_Surface)::DownCast(closed->Transformed(face.Location().Transformation().Inverted()));
  put_on(face, form.was, form.is);
  return form;
}

}  // namespace

std::vector<ClosedForm> give_closed_forms(const std::vector<TopoDS_Shape>& solids) {
  TopTools_IndexedMapOfShape faces;
  for (const TopoDS_Shape& solid : solids) TopExp::MapShapes(solid, TopAbs_FACE, faces);
  std::vector<ClosedForm> forms;
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Face face = TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD));
    if (BRep_Tool::Surface(face)->IsKind(STANDARD_TYPE(Geom_ElementarySurface))) continue;
    try {
      if (std::optional<ClosedForm> form = give_closed_form(face)) forms.push_back(*std::move(form));
    } catch (const ModelError&) {        // it has no surface: told where it is needed
    } catch (const Standard_Failure&) {  // it stays as it is
    }
  }
  return forms;
}

void take_back(const std::vector<ClosedForm>& forms) {
  for (const ClosedForm& form : forms) put_on(form.face, form.is, form.was);
}

}  // namespace octet
