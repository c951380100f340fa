// SPDX-License-Identifier: BSD-3-Clause
// Two faces on one sphere that fold at an edge prove that one is wrong; its loop is parted at the poles.
#include "geom/occt/sphere_sides.h"

#include <BRepTools_ReShape.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Sphere.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/constants.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

std::optional<gp_Sphere> sphere_of(const TopoDS_Face& face) {
  const auto surface = Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(face));
  if (surface.IsNull()) return {};
  return surface->Sphere();
}

/// Which way the face's normal points on its sphere.
bool points_outward(const TopoDS_Face& face, const gp_Sphere& sphere) {
  return (face.Orientation() == TopAbs_FORWARD) == sphere.Direct();
}

/// Whether two faces, which agree along an edge, lie on one sphere on the same side of that edge.
bool fold(const TopoDS_Face& a, const TopoDS_Face& b) {
  const auto one = sphere_of(a), other = sphere_of(b);
  if (!one || !other || a.IsSame(b)) return false;
  const double tolerance =
      std::max({BRep_Tool::Tolerance(a), BRep_Tool::Tolerance(b), Precision::Confusion()});
  return one->Location().Distance(other->Location()) <= tolerance &&
         std::abs(one->Radius() - other->Radius()) <= tolerance &&
         points_outward(a, *one) != points_outward(b, *other);
}

/// A side of a loop with its curve in (u,v), as the edge runs.
struct BallSide {
  TopoDS_Edge edge;
  Handle(Geom2d_Curve) curve;
  double first = 0.0, last = 0.0;

  [[nodiscard]] bool is_pole() const { return BRep_Tool::Degenerated(edge); }
  [[nodiscard]] bool runs_forward() const { return edge.Orientation() == TopAbs_FORWARD; }
  [[nodiscard]] gp_Pnt2d start() const { return curve->Value(runs_forward() ? first : last); }
  [[nodiscard]] gp_Pnt2d end() const { return curve->Value(runs_forward() ? last : first); }
};

/// The sides of the face's one loop, from behind a pole on; empty where it does not run through two, or has a
/// seam.
std::vector<BallSide> loop_through_poles(const TopoDS_Face& face) {
  std::vector<BallSide> loop;
  if (sub_shapes(face, TopAbs_WIRE).Extent() != 1) return loop;
  const TopoDS_Wire wire = TopoDS::Wire(TopExp_Explorer(face, TopAbs_WIRE).Current());
  for (BRepTools_WireExplorer it(wire, face); it.More(); it.Next()) {
    BallSide side{it.Current(), {}, 0.0, 0.0};
    side.curve = BRep_Tool::CurveOnSurface(side.edge, face, side.first, side.last);
    if (side.curve.IsNull() || BRep_Tool::IsClosed(side.edge, face)) return {};
    loop.push_back(side);
  }
  const auto is_pole = [](const BallSide& side) { return side.is_pole(); };
  if (loop.size() != static_cast<std::size_t>(sub_shapes(face, TopAbs_EDGE).Extent()) ||
      std::count_if(loop.begin(), loop.end(), is_pole) != 2)
    return {};
  std::rotate(loop.begin(), std::find_if(loop.begin(), loop.end(), is_pole) + 1, loop.end());
  return loop;
}

/// The face with the other side of its loop, which then runs the other way round; null where it has none.
/// `face` is FORWARD, the result REVERSED: along its edges it is used as before.
TopoDS_Face other_side_of(const TopoDS_Face& face) {
  std::vector<BallSide> loop = loop_through_poles(face);
  if (loop.empty()) return {};
  const auto pole =
      std::find_if(loop.begin(), loop.end(), [](const BallSide& side) { return side.is_pole(); });
  // What is before the first pole in the list goes once around, so that the way over the poles is the other.
  const double way = pole->end().X() - pole->start().X();
  const gp_Vec2d shift(std::copysign(kTurn, way), 0.0);
  for (auto side = loop.begin(); side != pole; ++side)
    side->curve = Handle(Geom2d_Curve)::DownCast(side->curve->Translated(shift));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    BallSide& side = loop[i];
    if (!side.is_pole()) continue;
    gp_Pnt2d from = loop[(i + loop.size() - 1) % loop.size()].end(), to = loop[(i + 1) % loop.size()].start();
    if (!side.runs_forward()) std::swap(from, to);
    if (from.Distance(to) <= Precision::PConfusion()) return {};
    side.curve = new Geom2d_Line(from, gp_Dir2d(gp_Vec2d(from, to)));
    side.first = 0.0;
    side.last = from.Distance(to);
  }
  // On a surface of its own: others may have the same edges on the old one.
  TopLoc_Location location;
  const auto surface = Handle(Geom_Surface)::DownCast(BRep_Tool::Surface(face, location)->Copy());
  const BRep_Builder builder;
  TopoDS_Face made;
  builder.MakeFace(made, surface, location, BRep_Tool::Tolerance(face));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const BallSide& side : loop) {
    builder.UpdateEdge(side.edge, side.curve, surface, location, Precision::Confusion());
    builder.Range(side.edge, surface, location, side.first, side.last);
    builder.Add(wire, side.edge);
  }
  builder.Add(made, wire.Reversed());
  return TopoDS::Face(made.Oriented(TopAbs_REVERSED));
}

/// Larger one of the first two faces that fold, of those not looked at yet; null: none.
TopoDS_Face first_wrong(const TopoDS_Shape& solid, TopTools_MapOfShape& seen) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int e = 1; e <= faces_of.Extent(); ++e) {
    if (faces_of(e).Extent() != 2) continue;
    const TopoDS_Face a = TopoDS::Face(faces_of(e).First()), b = TopoDS::Face(faces_of(e).Last());
    if (!fold(a, b)) continue;
    const TopoDS_Face larger = area_of(a) > area_of(b) ? a : b;
    if (seen.Add(larger)) return larger;
  }
  return {};
}

}  // namespace

Repair choose_sphere_sides(const TopoDS_Shape& solid) {
  Repair result = no_repair(solid);
  TopTools_MapOfShape seen;
  for (;;) {
    const TopoDS_Face wrong = first_wrong(result.solid, seen);
    if (wrong.IsNull()) return result;
    const TopoDS_Face right = other_side_of(TopoDS::Face(wrong.Oriented(TopAbs_FORWARD)));
    if (right.IsNull()) continue;
    const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
    changes->Replace(wrong.Oriented(TopAbs_FORWARD), right);
    result.solid = changes->Apply(result.solid);
    result.history->Merge(changes->History());
    result.entities.push_back(wrong);
    seen.Add(right);
  }
}

}  // namespace octet
