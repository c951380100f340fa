// SPDX-License-Identifier: BSD-3-Clause
// A general fuse of the faces alone; its pieces take their places in the solid.
#include "geom/occt/imprint.h"

#include <BOPAlgo_Builder.hxx>
#include <BOPTools_AlgoTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IntTools_Context.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>

#include "geom/occt/contact_circle.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Tolerances, as shares of the diagonal.
constexpr std::array<double, 3> kTolerances{0.0, 1e-7, 1e-6};

using FacePairs = std::vector<std::array<TopoDS_Face, 2>>;

class Imprint {
 public:
  /// `contact`: how far surfaces may be apart where they touch.
  Imprint(const std::vector<TopoDS_Shape>& solids, const FacePairs& touching, double contact,
          double tolerance)
      : solids_(solids) {
    for (const auto& pair : touching)
      for (const TopoDS_Face& face : pair) faces_.Add(face.Oriented(TopAbs_FORWARD));
    for (int i = 1; i <= faces_.Extent(); ++i) builder_.AddArgument(faces_(i));
    for (const auto& pair : touching)
      for (const TopoDS_Edge& circle : contact_circles(pair[0], pair[1], contact))
        builder_.AddArgument(circle);
    builder_.SetNonDestructive(true);
    builder_.SetRunParallel(false);
    if (tolerance > 0.0) builder_.SetFuzzyValue(tolerance);
    builder_.Perform();
    if (builder_.HasErrors()) return;
    for (const auto& pair : touching) joined_ += are_joined(pair) ? 1 : 0;
    if (joined_ > 0) rebuild();
  }

  [[nodiscard]] std::size_t joined() const { return joined_; }
  [[nodiscard]] Imprinted result() const { return {solids_, history_, joined_, doubles_.Extent()}; }

 private:
  [[nodiscard]] TopTools_ListOfShape images_of(const TopoDS_Shape& shape) {
    const TopTools_ListOfShape& images = builder_.Modified(shape);
    if (!images.IsEmpty() || builder_.IsDeleted(shape)) return images;
    TopTools_ListOfShape same;
    same.Append(shape);
    return same;
  }

  bool are_joined(const std::array<TopoDS_Face, 2>& pair) {
    TopTools_IndexedMapOfShape vertices;
    for (const TopoDS_Shape& image : images_of(pair[0])) TopExp::MapShapes(image, TopAbs_VERTEX, vertices);
    for (const TopoDS_Shape& image : images_of(pair[1])) {
      const TopTools_IndexedMapOfShape others = sub_shapes(image, TopAbs_VERTEX);
      for (int i = 1; i <= others.Extent(); ++i)
        if (vertices.Contains(others(i))) return true;
    }
    return false;
  }

  /// Of the faces' own vertices, edges and then faces, what became of each.
  void rebuild() {
    for (const TopAbs_ShapeEnum type : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE})
      for (int f = 1; f <= faces_.Extent(); ++f) {
        const TopTools_IndexedMapOfShape parts = sub_shapes(faces_(f), type);
        for (int i = 1; i <= parts.Extent(); ++i) exchange(parts(i).Oriented(TopAbs_FORWARD));
      }
    for (TopoDS_Shape& solid : solids_) {
      const TopoDS_Shape made = without_doubles(changes_->Apply(solid));
      if (made.IsSame(solid)) continue;
      const bool was_closed = edge_uses(solid).first(&Uses::open) == 0;
      const bool is_solid = made.ShapeType() == TopAbs_SOLID;
      if (!is_solid || (was_closed && edge_uses(made).first(&Uses::open) != 0)) joined_ = 0;
      own_.AddModified(solid, made);
      solid = made;
    }
    history_->Merge(changes_->History());
    history_->Merge(own_);
  }

  void exchange(const TopoDS_Shape& shape) {
    if (changes_->IsRecorded(shape)) return;
    TopTools_ListOfShape images = images_of(shape);
    if (images.Extent() == 1 && images.First().IsSame(shape)) return;
    if (shape.ShapeType() == TopAbs_VERTEX) {
      if (!images.IsEmpty()) changes_->Replace(shape, images.First().Oriented(TopAbs_FORWARD));
      return;
    }
    TopoDS_Shape pieces;
    if (shape.ShapeType() == TopAbs_EDGE) {
      TopoDS_Wire wire;
      brep_.MakeWire(wire);
      pieces = wire;
    } else {
      TopoDS_Shell shell;
      brep_.MakeShell(shell);
      pieces = shell;
    }
    for (TopoDS_Shape image : in_order(images)) {
      image.Orientation(turned(image, shape) ? TopAbs_REVERSED : TopAbs_FORWARD);
      if (images.Extent() == 1) {
        changes_->Replace(shape, image);
        return;
      }
      brep_.Add(pieces, image);
    }
    changes_->Replace(shape, pieces);
  }

  /// Pieces of an edge along it.
  static std::vector<TopoDS_Shape> in_order(const TopTools_ListOfShape& images) {
    std::vector<TopoDS_Shape> sorted(images.begin(), images.end());
    const auto start = [](const TopoDS_Shape& edge) {
      double first = 0.0, last = 0.0;
      BRep_Tool::Range(TopoDS::Edge(edge), first, last);
      return first;
    };
    if (sorted.front().ShapeType() == TopAbs_EDGE)
      std::stable_sort(sorted.begin(), sorted.end(),
                       [&](const auto& a, const auto& b) { return start(a) < start(b); });
    return sorted;
  }

  bool turned(TopoDS_Shape image, const TopoDS_Shape& shape) {
    image.Orientation(TopAbs_FORWARD);
    return BOPTools_AlgoTools::IsSplitToReverse(image, shape, context_);
  }

  /// Without the faces that a solid has with both orientations.
  TopoDS_Shape without_doubles(const TopoDS_Shape& solid) {
    TopTools_IndexedMapOfShape once, twice;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
      (once.Contains(it.Current()) ? twice : once).Add(it.Current());
    if (twice.IsEmpty()) return solid;
    TopoDS_Solid made;
    brep_.MakeSolid(made);
    TopoDS_Shell shell;
    brep_.MakeShell(shell);
    for (TopExp_Explorer it(solid.Oriented(TopAbs_FORWARD), TopAbs_FACE); it.More(); it.Next())
      if (!twice.Contains(it.Current())) brep_.Add(shell, it.Current());
    brep_.Add(made, shell);
    for (int i = 1; i <= twice.Extent(); ++i)
      if (doubles_.Add(twice(i)) == doubles_.Extent()) own_.Remove(twice(i));
    return made.Oriented(solid.Orientation());
  }

  std::vector<TopoDS_Shape> solids_;
  TopTools_IndexedMapOfShape faces_, doubles_;
  BOPAlgo_Builder builder_;
  BRep_Builder brep_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
  Handle(BRepTools_ReShape) changes_ = new BRepTools_ReShape;
  Handle(BRepTools_History) history_ = new BRepTools_History;
  BRepTools_History own_;  ///< of the solids, and of doubles: after changes_
  std::size_t joined_ = 0;
};

}  // namespace

Imprinted imprint_faces(const std::vector<TopoDS_Shape>& solids, const FacePairs& touching) {
  Imprinted best{solids, new BRepTools_History, 0, 0};
  Bnd_Box box;
  for (const TopoDS_Shape& solid : solids) box.Add(box_of(solid));
  for (const double share : kTolerances) {
    try {
      const Imprint imprint(solids, touching, kContactShare * diagonal_of(box), share * diagonal_of(box));
      if (imprint.joined() > best.joined) best = imprint.result();
    } catch (const Standard_Failure&) {  // with this tolerance OCCT cannot do it
    }
    if (best.joined == touching.size()) break;
  }
  return best;
}

}  // namespace octet
