// SPDX-License-Identifier: BSD-3-Clause
// A general fuse of the faces alone; its pieces take their places in the solid.
#include "geom/occt/imprint.h"

#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <array>
#include <optional>

#include "geom/occt/contact_circle.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/face_fuse.h"
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
    TopTools_IndexedMapOfShape faces;
    std::vector<TopoDS_Edge> circles;
    for (const auto& pair : touching) {
      for (const TopoDS_Face& face : pair) faces.Add(face.Oriented(TopAbs_FORWARD));
      const std::vector<TopoDS_Edge> more = contact_circles(pair[0], pair[1], contact);
      circles.insert(circles.end(), more.begin(), more.end());
    }
    fuse_.emplace(faces, circles, tolerance);
    if (fuse_->failed()) return;
    for (const auto& pair : touching) joined_ += are_joined(pair) ? 1 : 0;
    if (joined_ > 0) rebuild();
  }

  [[nodiscard]] std::size_t joined() const { return joined_; }
  [[nodiscard]] Imprinted result() const { return {solids_, history_, joined_, doubles_.Extent()}; }

 private:
  /// Whether they have more vertices or edges in common than before.
  bool are_joined(const std::array<TopoDS_Face, 2>& pair) {
    for (const TopAbs_ShapeEnum type : {TopAbs_VERTEX, TopAbs_EDGE}) {
      TopTools_IndexedMapOfShape one, other;
      for (const TopoDS_Shape& image : fuse_->images_of(pair[0])) TopExp::MapShapes(image, type, one);
      for (const TopoDS_Shape& image : fuse_->images_of(pair[1])) TopExp::MapShapes(image, type, other);
      if (in_both(one, other) > in_both(sub_shapes(pair[0], type), sub_shapes(pair[1], type))) return true;
    }
    return false;
  }

  static int in_both(const TopTools_IndexedMapOfShape& one, const TopTools_IndexedMapOfShape& other) {
    int count = 0;
    for (int i = 1; i <= one.Extent(); ++i) count += other.Contains(one(i)) ? 1 : 0;
    return count;
  }

  void rebuild() {
    for (TopoDS_Shape& solid : solids_) {
      const TopoDS_Shape made = without_doubles(fuse_->apply(solid));
      if (made.IsSame(solid)) continue;
      const bool was_closed = edge_uses(solid).first(&Uses::open) == 0;
      const bool is_solid = made.ShapeType() == TopAbs_SOLID;
      if (!is_solid || (was_closed && edge_uses(made).first(&Uses::open) != 0)) joined_ = 0;
      own_.AddModified(solid, made);
      solid = made;
    }
    history_->Merge(fuse_->history());
    history_->Merge(own_);
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
  TopTools_IndexedMapOfShape doubles_;
  std::optional<FaceFuse> fuse_;
  BRep_Builder brep_;
  Handle(BRepTools_History) history_ = new BRepTools_History;
  BRepTools_History own_;  ///< of the solids, and of doubles: after those of the fuse
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
