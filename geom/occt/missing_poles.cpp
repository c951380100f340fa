// SPDX-License-Identifier: BSD-3-Clause
// Where a meridian meets the axis beyond a loop, and the seam and the pole from the loop to there.
#include "geom/occt/missing_poles.h"

#include <BRepTools_ReShape.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Dir2d.hxx>
#include <gp_Lin.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <limits>
#include <optional>
#include <vector>

#include "base/constants.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// A loop once around the axis, in (u,v).
struct Ring {
  std::vector<TopoDS_Edge> edges;  ///< in the order of the loop
  TopoDS_Vertex start;             ///< where the first one begins
  gp_Pnt2d first, last;            ///< the same place before and after the turn
  double least_v = std::numeric_limits<double>::infinity();
  double most_v = -std::numeric_limits<double>::infinity();

  /// A face lies to the left of its loops.
  [[nodiscard]] bool face_is_above() const { return last.X() > first.X(); }
};

/// The loop of a FORWARD face, if it is its only one and such a ring.
std::optional<Ring> ring_of(const TopoDS_Face& face) {
  if (sub_shapes(face, TopAbs_WIRE).Extent() != 1) return {};
  Ring ring;
  const TopoDS_Wire wire = TopoDS::Wire(TopExp_Explorer(face, TopAbs_WIRE).Current());
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
    const TopoDS_Edge edge = it.Current();
    double a = 0.0, b = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, a, b);
    if (curve.IsNull() || BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) return {};
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(a, b);
    if (ring.edges.empty()) {
      ring.first = curve->Value(a);
      ring.start = TopExp::FirstVertex(edge, true);
    }
    ring.last = curve->Value(b);
    constexpr int kSamples = 16;
    for (int i = 0; i <= kSamples; ++i) {
      const double v = curve->Value(a + (b - a) * i / kSamples).Y();
      ring.least_v = std::min(ring.least_v, v);
      ring.most_v = std::max(ring.most_v, v);
    }
    ring.edges.push_back(edge);
  }
  constexpr double kSame = 1e-6;
  const bool turns = std::abs(std::abs(ring.last.X() - ring.first.X()) - kTurn) < kSame &&
                     std::abs(ring.last.Y() - ring.first.Y()) < kSame;
  if (!turns || static_cast<int>(ring.edges.size()) != sub_shapes(face, TopAbs_EDGE).Extent()) return {};
  return ring;
}

/// The first place on the face's side of the ring where the meridian meets the axis.
std::optional<double> pole_beyond(const Ring& ring, const Geom_SurfaceOfRevolution& surface) {
  const Handle(Geom_Curve) meridian = surface.UIso(ring.first.X());
  const gp_Lin axis(surface.Axis());
  const double v0 = ring.face_is_above() ? ring.most_v : ring.least_v;
  const double end = meridian->IsPeriodic() ? v0 + (ring.face_is_above() ? 1.0 : -1.0) * meridian->Period()
                     : ring.face_is_above() ? meridian->LastParameter()
                                            : meridian->FirstParameter();
  if (Precision::IsInfinite(end)) return {};
  gp_Vec out(axis.Location(), meridian->Value(v0));
  out -= out.Dot(gp_Vec(axis.Direction())) * gp_Vec(axis.Direction());
  if (out.Magnitude() <= Precision::Confusion()) return {};
  const auto side = [&](double v) { return gp_Vec(axis.Location(), meridian->Value(v)).Dot(out); };
  constexpr int kSteps = 256, kHalvings = 60;
  for (int i = 1; i <= kSteps; ++i) {
    double near = v0 + (end - v0) * (i - 1) / kSteps, far = v0 + (end - v0) * i / kSteps;
    if (side(far) > 0.0) continue;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = 0.5 * (near + far);
      (side(middle) > 0.0 ? near : far) = middle;
    }
    if (axis.Distance(meridian->Value(far)) > Precision::Confusion()) return {};
    return far;
  }
  return {};
}

/// The face between the ring and the pole.
TopoDS_Face with_pole(const TopoDS_Face& face, const Ring& ring, const Handle(Geom_Surface) & surface,
                      const TopLoc_Location& location, double pole) {
  const BRep_Builder builder;
  const double exact = Precision::Confusion();
  const double u_first = ring.first.X(), u_last = ring.last.X(), v = ring.first.Y();
  TopoDS_Vertex apex;
  builder.MakeVertex(apex, surface->Value(u_first, pole).Transformed(location.Transformation()), exact);
  TopoDS_Edge seam;
  builder.MakeEdge(seam, surface->UIso(u_first), location, exact);
  const auto up = [](double u) { return new Geom2d_Line(gp_Pnt2d(u, 0.0), gp_Dir2d(0.0, 1.0)); };
  const bool above = ring.face_is_above();
  // Up the last side of the loop, down the first one; or the other way where the pole is below.
  builder.UpdateEdge(seam, up(above ? u_last : u_first), up(above ? u_first : u_last), surface, location,
                     exact);
  builder.Range(seam, std::min(v, pole), std::max(v, pole));
  builder.Add(seam, (above ? ring.start : apex).Oriented(TopAbs_FORWARD));
  builder.Add(seam, (above ? apex : ring.start).Oriented(TopAbs_REVERSED));
  TopoDS_Edge point;
  builder.MakeEdge(point);
  builder.UpdateEdge(point, new Geom2d_Line(gp_Pnt2d(std::min(u_first, u_last), pole), gp_Dir2d(1.0, 0.0)),
                     surface, location, exact);
  builder.Range(point, 0.0, kTurn);
  builder.Degenerated(point, true);
  builder.Add(point, apex.Oriented(TopAbs_FORWARD));
  builder.Add(point, apex.Oriented(TopAbs_REVERSED));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : ring.edges) builder.Add(wire, edge);
  builder.Add(wire, seam.Oriented(above ? TopAbs_FORWARD : TopAbs_REVERSED));
  builder.Add(wire, point.Oriented(above ? TopAbs_REVERSED : TopAbs_FORWARD));
  builder.Add(wire, seam.Oriented(above ? TopAbs_REVERSED : TopAbs_FORWARD));
  TopoDS_Face made;
  builder.MakeFace(made, surface, location, BRep_Tool::Tolerance(face));
  builder.Add(made, wire);
  return made;
}

/// Null where the face lacks no pole. `face` is FORWARD, and so is the result.
TopoDS_Face mended(const TopoDS_Face& face) {
  TopLoc_Location location;
  const auto surface = Handle(Geom_SurfaceOfRevolution)::DownCast(BRep_Tool::Surface(face, location));
  if (surface.IsNull()) return {};
  const std::optional<Ring> ring = ring_of(face);
  if (!ring) return {};
  const std::optional<double> pole = pole_beyond(*ring, *surface);
  return pole ? with_pole(face, *ring, surface, location, *pole) : TopoDS_Face();
}

}  // namespace

TopoDS_Face carried_to_pole(const TopoDS_Face& face, double pole) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  const std::optional<Ring> ring = ring_of(face);
  return ring ? with_pole(face, *ring, surface, location, pole) : TopoDS_Face();
}

Repair add_missing_poles(const TopoDS_Shape& solid) {
  Repair result = no_repair(solid);
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  const auto faces = sub_shapes(solid, TopAbs_FACE);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const TopoDS_Face face = TopoDS::Face(faces(f).Oriented(TopAbs_FORWARD));
    const TopoDS_Face made = mended(face);
    if (made.IsNull()) continue;
    changes->Replace(face, made);
    result.entities.push_back(faces(f));
  }
  if (result.entities.empty()) return result;
  result.solid = changes->Apply(solid);
  result.history->Merge(changes->History());
  return result;
}

}  // namespace octet
