// SPDX-License-Identifier: BSD-3-Clause
// Folds are found by normals across edges, and proved by points of the face on its neighbour.
#include "geom/occt/folds.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <optional>

namespace octet {
namespace {

/// Most cosine between the normals of sheets that lie on one another.
constexpr double kOpposite = -0.99;

/// Outward normal of the face, zero where it has none.
gp_Vec normal_at(const TopoDS_Face& face, const gp_Pnt2d& uv) {
  gp_Pnt point;
  gp_Vec du, dv;
  BRepAdaptor_Surface(face, false).D1(uv.X(), uv.Y(), point, du, dv);
  gp_Vec normal = du.Crossed(dv);
  if (normal.Magnitude() < 1e-300) return {};
  normal.Normalize();
  return face.Orientation() == TopAbs_REVERSED ? -normal : normal;
}

/// How far the edge lies from where the face has it; its own tolerance where it says more.
double gap_of(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int kPieces = 8;
  double first = 0.0, last = 0.0, gap = BRep_Tool::Tolerance(edge);
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const Handle(Geom2d_Curve) on_face = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull() || on_face.IsNull()) return gap;
  const BRepAdaptor_Surface surface(face, false);
  for (int i = 0; i <= kPieces; ++i) {
    const double t = first + (last - first) * i / kPieces;
    const gp_Pnt2d uv = on_face->Value(t);
    gap = std::max(gap, curve->Value(t).Distance(surface.Value(uv.X(), uv.Y())));
  }
  return gap;
}

class FoldFinder {
 public:
  explicit FoldFinder(const TopoDS_Shape& solid) : solid_(solid) {
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_);
  }

  Repair run() {
    Repair result = no_repair(solid_);
    for (TopExp_Explorer it(solid_, TopAbs_FACE); it.More(); it.Next())
      if (take_away(TopoDS::Face(it.Current()))) result.entities.push_back(it.Current());
    if (result.entities.empty()) return result;
    result.solid = changes_->Apply(solid_);
    for (const auto& [face, edge] : new_borders_)
      ShapeFix_Edge().FixAddPCurve(edge, TopoDS::Face(changes_->Apply(face)), false, Precision::Confusion());
    result.history = changes_->History();
    return result;
  }

 private:
  struct NewBorder {
    TopoDS_Face face;
    TopoDS_Edge edge;
  };

  /// The one face beyond an edge; a null face where there is none, or several.
  [[nodiscard]] TopoDS_Face beyond(const TopoDS_Edge& edge, const TopoDS_Face& face) const {
    const TopTools_ListOfShape& faces = faces_of_.FindFromKey(edge);
    if (faces.Extent() != 2) return {};
    const TopoDS_Shape& other = faces.First().IsSame(face) ? faces.Last() : faces.First();
    return other.IsSame(face) ? TopoDS_Face() : TopoDS::Face(other);
  }

  /// Whether a side goes from a vertex back to it and no other face has it: it parts the face from nothing.
  [[nodiscard]] bool is_speck(const TopoDS_Edge& edge) const {
    return faces_of_.FindFromKey(edge).Extent() == 1 &&
           TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge));
  }

  /// Whether the boundary turns back at the middle of an edge.
  static bool turns_back(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& other) {
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) a = BRep_Tool::CurveOnSurface(edge, face, first, last);
    const double middle = 0.5 * (first + last);
    const Handle(Geom2d_Curve) b = BRep_Tool::CurveOnSurface(edge, other, first, last);
    if (a.IsNull() || b.IsNull()) return false;
    return normal_at(face, a->Value(middle)).Dot(normal_at(other, b->Value(middle))) < kOpposite;
  }

  bool take_away(const TopoDS_Face& face) {
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      const TopoDS_Face other = beyond(edge, face);
      if (other.IsNull() || touched_.Contains(other) || touched_.Contains(face) ||
          !turns_back(edge, face, other) || !lies_on(face, other))
        continue;
      if (replace(edge, face, other)) return true;
    }
    return false;
  }

  /// Whether all of the face lies on the other, within the gaps at its edges.
  [[nodiscard]] bool lies_on(const TopoDS_Face& face, const TopoDS_Face& other) const {
    constexpr int kGrid = 9;
    double allowed = 0.0;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      for (const TopoDS_Shape& user : faces_of_.FindFromKey(edge))
        if (!BRep_Tool::Degenerated(edge)) allowed = std::max(allowed, gap_of(edge, TopoDS::Face(user)));
    }
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const BRepTopAdaptor_FClass2d in_face(face, Precision::PConfusion()),
        in_other(other, Precision::PConfusion());
    const Handle(ShapeAnalysis_Surface) beneath = new ShapeAnalysis_Surface(BRep_Tool::Surface(other));
    bool any = false;
    for (int i = 0; i < kGrid * kGrid; ++i) {
      const gp_Pnt2d uv(u0 + (u1 - u0) * (i % kGrid + 0.5) / kGrid,
                        v0 + (v1 - v0) * (i / kGrid + 0.5) / kGrid);
      if (in_face.Perform(uv) != TopAbs_IN) continue;
      const gp_Pnt point = BRepAdaptor_Surface(face, false).Value(uv.X(), uv.Y());
      const gp_Pnt2d foot = beneath->ValueOfUV(point, Precision::Confusion());
      if (beneath->Value(foot).Distance(point) > allowed || in_other.Perform(foot) == TopAbs_OUT ||
          normal_at(face, uv).Dot(normal_at(other, foot)) > kOpposite)
        return false;
      any = true;
    }
    return any;
  }

  /// The other sides of the face take the place of `edge` in the border of `other`.
  bool replace(const TopoDS_Edge& edge, const TopoDS_Face& face, const TopoDS_Face& other) {
    const std::optional<std::vector<TopoDS_Edge>> rest = rest_of_loop(edge, face);
    if (!rest) return false;
    const BRep_Builder builder;
    TopoDS_Wire border;
    builder.MakeWire(border);
    for (const TopoDS_Edge& side : *rest) {
      if (!BRep_Tool::Degenerated(side)) new_borders_.push_back({other, side});
      builder.Add(border, side);
    }
    changes_->Replace(edge.Oriented(TopAbs_FORWARD), border);
    changes_->Remove(face);
    touched_.Add(face);
    touched_.Add(other);
    return true;
  }

  /// The sides of the face but for `edge` and specks, from the start of that to its end; none where the face
  /// has several loops, or another of its sides borders the same face.
  [[nodiscard]] std::optional<std::vector<TopoDS_Edge>> rest_of_loop(const TopoDS_Edge& edge,
                                                                     const TopoDS_Face& face) const {
    TopTools_IndexedMapOfShape wires;
    TopExp::MapShapes(face, TopAbs_WIRE, wires);
    if (wires.Extent() != 1) return std::nullopt;
    std::vector<TopoDS_Edge> loop;
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    for (BRepTools_WireExplorer it(TopoDS::Wire(TopExp_Explorer(forward, TopAbs_WIRE).Current()), forward);
         it.More(); it.Next())
      loop.push_back(it.Current());
    const auto at =
        std::find_if(loop.begin(), loop.end(), [&](const TopoDS_Edge& side) { return side.IsSame(edge); });
    if (at == loop.end() || loop.size() < 2) return std::nullopt;
    std::rotate(loop.begin(), at, loop.end());
    const bool along = loop.front().Orientation() == TopAbs_FORWARD;
    loop.erase(loop.begin());
    std::erase_if(loop, [&](const TopoDS_Edge& side) { return is_speck(side); });
    const TopoDS_Face other = beyond(edge, face);
    for (TopoDS_Edge& side : loop) {
      const TopoDS_Face user = beyond(side, face);
      if (user.IsNull() || user.IsSame(other)) return std::nullopt;
      if (along) side.Reverse();
    }
    if (along) std::reverse(loop.begin(), loop.end());
    return loop;
  }

  const TopoDS_Shape& solid_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_;
  Handle(ShapeBuild_ReShape) changes_ = new ShapeBuild_ReShape;
  TopTools_IndexedMapOfShape touched_;  ///< faces that are gone or whose border changes
  std::vector<NewBorder> new_borders_;
};

}  // namespace

Repair remove_folds(const TopoDS_Shape& solid) { return FoldFinder(solid).run(); }

}  // namespace octet
