// SPDX-License-Identifier: BSD-3-Clause
// The loops of a B-rep face.
#include "geom/occt/face_trim.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "geom/axes3.h"
#include "geom/loop_trim.h"
#include "geom/occt/canonical.h"
#include "geom/uv_trims.h"

namespace octet {
namespace {

/// For faces whose loops do not close. FClass2d::Perform is const, but walks an NCollection_Sequence, whose
/// cursor is mutable: two threads at one classifier crash. So each call borrows one of the idle ones, and
/// there are as many as threads have met here.
class OcctTrim final : public Trim {
 public:
  OcctTrim(const TopoDS_Face& face, double uv_tolerance) : face_(face), uv_tolerance_(uv_tolerance) {
    give_back(make());
  }

  TrimSide side(const Vec2& uv) const override {
    std::unique_ptr<BRepTopAdaptor_FClass2d> classifier = borrow();
    const TopAbs_State state = classifier->Perform(gp_Pnt2d(uv.x(), uv.y()), true);
    give_back(std::move(classifier));
    return state == TopAbs_IN ? TrimSide::kIn : state == TopAbs_ON ? TrimSide::kOn : TrimSide::kOut;
  }

 private:
  using Classifier = std::unique_ptr<BRepTopAdaptor_FClass2d>;

  [[nodiscard]] Classifier make() const {
    return std::make_unique<BRepTopAdaptor_FClass2d>(face_, uv_tolerance_);
  }
  [[nodiscard]] Classifier borrow() const {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return make();
    Classifier last = std::move(idle_.back());
    idle_.pop_back();
    return last;
  }
  void give_back(Classifier classifier) const {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(classifier));
  }

  TopoDS_Face face_;
  double uv_tolerance_;
  mutable std::mutex mutex_;
  mutable std::vector<Classifier> idle_;
};

/// Ends of the range and the curve's knots between.
std::vector<double> breaks_of(Handle(Geom2d_Curve) curve, double first, double last) {
  std::vector<double> breaks = {first, last};
  while (true) {
    if (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
      curve = trimmed->BasisCurve();
    else if (const auto offset = Handle(Geom2d_OffsetCurve)::DownCast(curve); !offset.IsNull())
      curve = offset->BasisCurve();
    else
      break;
  }
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return breaks;
  const double nearly = 1e-9 * (last - first);
  const double period = spline->IsPeriodic() ? spline->Period() : 0.0;
  for (int i = 1; i <= spline->NbKnots(); ++i) {
    double knot = spline->Knot(i);
    if (period > 0.0) knot += period * std::ceil((first - knot) / period);
    for (; knot < last - nearly; knot += period) {
      if (knot > first + nearly) breaks.push_back(knot);
      if (period <= 0.0) break;
    }
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end(), [&](double a, double b) { return b - a < nearly; }),
               breaks.end());
  return breaks;
}

bool is_straight(Handle(Geom2d_Curve) curve) {
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (!Handle(Geom2d_Line)::DownCast(curve).IsNull()) return true;
  const auto bezier = Handle(Geom2d_BezierCurve)::DownCast(curve);
  if (!bezier.IsNull()) return bezier->Degree() == 1;
  const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve);
  return !spline.IsNull() && spline->Degree() == 1;
}

/// Null where an edge has no curve in (u,v) or no ends.
std::optional<std::vector<TrimCurve>> border_curves(const TopoDS_Face& face, const Surface& surface) {
  std::vector<TrimCurve> curves;
  TopTools_IndexedMapOfShape vertices, edges;
  const auto to_ours = from_occt_uv(surface);
  const bool same = !is_recognised(surface);
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    TopoDS_Vertex start, end;
    TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), start, end);
    if (curve.IsNull() || start.IsNull() || end.IsNull() || !(first < last)) return std::nullopt;
    TrimCurve border;
    border.at = [curve, to_ours](double t) {
      const gp_Pnt2d p = curve->Value(t);
      return to_ours({p.X(), p.Y()});
    };
    border.breaks = breaks_of(curve, first, last);
    border.straight = same && is_straight(curve);
    border.vertex = {vertices.Add(start), vertices.Add(end)};
    border.edge = edges.Add(edge);
    curves.push_back(std::move(border));
  }
  return curves;
}

Vec2 periods(const TopoDS_Face& face, const Surface& surface) {
  if (is_recognised(surface)) {
    const std::string_view kind = surface.kind();
    return {kind == "plane" ? 0.0 : kTwoPi, kind == "torus" ? kTwoPi : 0.0};
  }
  const Handle(Geom_Surface) occt = BRep_Tool::Surface(face);
  return {occt->IsUPeriodic() ? occt->UPeriod() : 0.0, occt->IsVPeriodic() ? occt->VPeriod() : 0.0};
}

/// Half a width of the band in which a point is on the border: rounding in space, or OCCT's own floor.
Vec2 band(const std::vector<TrimCurve>& curves, const Surface& surface) {
  Vec2 steepest = Vec2::Zero();
  Box3 box;
  constexpr int kSamples = 8;
  for (const TrimCurve& curve : curves)
    for (int i = 0; i <= kSamples; ++i) {
      const double t = curve.breaks.front() + i * (curve.breaks.back() - curve.breaks.front()) / kSamples;
      const SurfaceJet jet = surface.evaluate(curve.at(t), 1);
      steepest = steepest.cwiseMax(Vec2(jet.du.norm(), jet.dv.norm()));
      box.add(jet.p);
    }
  const double width = std::min(1e-7, 1e-9 * box.diagonal());
  return {width / std::max(steepest.x(), 1e-300), width / std::max(steepest.y(), 1e-300)};
}

}  // namespace

std::shared_ptr<const Trim> make_trim(const TopoDS_Face& face, const Surface& surface) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  auto curves = border_curves(forward, surface);
  if (curves && curves->empty()) return make_whole_trim();
  LoopTrimOptions options;
  if (curves) {
    options.tolerance = band(*curves, surface);
    options.period = periods(forward, surface);
    if (auto trim = make_loop_trim(std::move(*curves), options)) return trim;
  }
  constexpr double kOcctTolerance = 1e-9;
  return std::make_shared<OcctTrim>(forward, kOcctTolerance);
}

}  // namespace octet
