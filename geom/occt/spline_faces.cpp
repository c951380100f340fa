// SPDX-License-Identifier: BSD-3-Clause
// Surfaces by OCCT's conversion, where it is exact, and curves on them fitted to the edges as they are.
#include "geom/occt/spline_faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

#include "geom/occt/converted_curves.h"
#include "geom/occt/curve_gaps.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/spline_limits.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

bool is_spline(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face, false).GetType() == GeomAbs_BSplineSurface;
}

struct BoxedFace {
  TopoDS_Face face;  ///< forward
  Bnd_Box box;
};

std::vector<BoxedFace> boxed_faces(const TopoDS_Shape& solid, double near) {
  std::vector<BoxedFace> boxed;
  const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    boxed.push_back({TopoDS::Face(faces(i).Oriented(TopAbs_FORWARD)), box_of(faces(i))});
    boxed.back().box.Enlarge(near);
  }
  return boxed;
}

/// Faces of the last solid whose boxes meet those of faces of others, and these.
std::vector<TopoDS_Face> faces_about_last(const std::vector<TopoDS_Shape>& solids, double near) {
  std::vector<TopoDS_Face> found;
  const std::vector<BoxedFace> of_last = boxed_faces(solids.back(), near);
  std::vector<bool> meets(of_last.size(), false);
  for (std::size_t i = 0; i + 1 < solids.size(); ++i)
    for (const BoxedFace& other : boxed_faces(solids[i], near)) {
      bool any = false;
      for (std::size_t k = 0; k < of_last.size(); ++k) {
        if (other.box.IsOut(of_last[k].box)) continue;
        any = true;
        meets[k] = true;
      }
      if (any) found.push_back(other.face);
    }
  for (std::size_t k = 0; k < of_last.size(); ++k)
    if (meets[k]) found.push_back(of_last[k].face);
  return found;
}

/// A face, forward, between its own edges on a spline, which has about the same parameters.
TopoDS_Face on_spline(const TopoDS_Face& face) {
  BRepBuilderAPI_NurbsConvert convert(face, true);
  const BRep_Builder builder;
  TopoDS_Face made;
  builder.MakeFace(made, BRep_Tool::Surface(TopoDS::Face(convert.Shape())), BRep_Tool::Tolerance(face));
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) builder.Add(made, wire.Value());
  return made;
}

/// Faces are added until one cannot be.
class Converter {
 public:
  Converter() : result_{{}, new BRepTools_History()} {}

  void add(const TopoDS_Face& face, double noise) {
    if (made_.IsBound(face)) return;
    if (result_.faces++ >= kMostSplineFaces) throw Standard_Failure("more faces than a fuse has time for");
    const TopoDS_Face made = on_spline(face);
    const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(i).Oriented(TopAbs_FORWARD));
      result_.curves.emplace_back(edge, made);
      carry_curve(edge, face, edge, made);
      if (BRep_Tool::Degenerated(edge)) continue;
      const double gap = curve_gap(edge, made);
      if (gap > std::max(noise, kWiderAsSplines * BRep_Tool::Tolerance(edge)))
        throw Standard_Failure("a curve on a spline runs beside its edge");
      gaps_.emplace_back(edge, gap);
    }
    made_.Bind(face, made);
    result_.history->AddModified(face, made);
  }

  [[nodiscard]] std::optional<SplineFaces> solids(const std::vector<TopoDS_Shape>& before) {
    const BRep_Builder builder;
    for (const auto& [edge, gap] : gaps_) {
      result_.tolerances.emplace_back(edge, BRep_Tool::Tolerance(edge));
      builder.UpdateEdge(edge, gap);
      for (TopoDS_Iterator it(edge); it.More(); it.Next()) {
        const TopoDS_Vertex vertex = TopoDS::Vertex(it.Value());
        result_.tolerances.emplace_back(vertex, BRep_Tool::Tolerance(vertex));
        builder.UpdateVertex(vertex, BRep_Tool::Tolerance(edge));
      }
    }
    for (const TopoDS_Shape& solid : before) {
      result_.solids.push_back(rebuilt(solid));
      if (!result_.solids.back().IsSame(solid)) result_.history->AddModified(solid, result_.solids.back());
    }
    return result_;
  }

  void give_up() const { take_back(result_); }

 private:
  /// The solid with the new faces, where it has any. It may be placed, which OCCT's replacement of parts of a
  /// shape does not see.
  [[nodiscard]] TopoDS_Shape rebuilt(const TopoDS_Shape& solid) const {
    const BRep_Builder builder;
    TopoDS_Solid now;
    builder.MakeSolid(now);
    bool changed = false;
    for (TopoDS_Iterator part(solid); part.More(); part.Next()) {
      if (part.Value().ShapeType() != TopAbs_SHELL) {
        builder.Add(now, part.Value());
        continue;
      }
      TopoDS_Shell shell;
      builder.MakeShell(shell);
      for (TopoDS_Iterator it(part.Value()); it.More(); it.Next()) {
        const TopoDS_Shape* made = made_.Seek(it.Value());
        changed = changed || made != nullptr;
        builder.Add(shell, made != nullptr ? made->Oriented(it.Value().Orientation()) : it.Value());
      }
      shell.Closed(part.Value().Closed());
      builder.Add(now, shell);
    }
    return changed ? TopoDS_Shape(now) : solid;
  }

  SplineFaces result_;
  TopTools_DataMapOfShapeShape made_;
  std::vector<std::pair<TopoDS_Edge, double>> gaps_;
};

}  // namespace

std::optional<SplineFaces> with_spline_faces_about_last(const std::vector<TopoDS_Shape>& solids) {
  const double noise = kRoundingShare * diagonal_of_all(solids);
  Converter converter;
  try {
    for (const TopoDS_Face& face : faces_about_last(solids, noise))
      if (converts_exactly(face) && !is_spline(face)) converter.add(face, noise);
    return converter.solids(solids);
  } catch (const Standard_Failure&) {
    converter.give_up();
    return std::nullopt;
  }
}

void take_back(const SplineFaces& splines) {
  const BRep_Builder builder;
  const Handle(Geom2d_Curve) none;
  for (const auto& [edge, face] : splines.curves) builder.UpdateEdge(edge, none, face, 0.0);
  // Backwards: of what was widened twice the first is what it was.
  const ShapeFix_ShapeTolerance tolerance;
  for (auto it = splines.tolerances.rbegin(); it != splines.tolerances.rend(); ++it)
    tolerance.SetTolerance(it->first, it->second, it->first.ShapeType());
}

}  // namespace octet
