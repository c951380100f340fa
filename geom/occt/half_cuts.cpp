// SPDX-License-Identifier: BSD-3-Clause
// The directions from an edge into the faces of a solid, against the normal of the face that it lies in.
#include "geom/occt/half_cuts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <optional>

#include "geom/occt/canonical.h"

namespace octet {
namespace {

/// Directions nearer to the face than this sine run along it: they tell of no side.
constexpr double kLeastSine = 1e-3;

/// Unit normal of the face's surface in the middle of an edge of it; none where it has none.
std::optional<Vec3> normal_at_middle(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0.0, last = 0.0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return std::nullopt;
  const gp_Pnt2d uv = curve->Value(0.5 * (first + last));
  gp_Pnt point;
  gp_Vec du, dv;
  BRepAdaptor_Surface(face, false).D1(uv.X(), uv.Y(), point, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  if (!(normal.Magnitude() > 0.0)) return std::nullopt;
  return to_vec(normal).normalized();
}

/// Middle and unit tangent of an edge's curve.
struct Middle {
  Vec3 point = Vec3::Zero(), tangent = Vec3::Zero();
};
std::optional<Middle> middle_along(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return std::nullopt;
  const BRepAdaptor_Curve curve(edge);
  gp_Pnt point;
  gp_Vec tangent;
  curve.D1(0.5 * (curve.FirstParameter() + curve.LastParameter()), point, tangent);
  if (!(tangent.Magnitude() > 0.0)) return std::nullopt;
  return Middle{to_vec(point), to_vec(tangent).normalized()};
}

/// Whether the faces around the edge go on beyond both sides of a face with this normal.
bool goes_through(const TopoDS_Edge& edge, const Vec3& tangent, const Vec3& normal,
                  const TopTools_ListOfShape& faces) {
  bool above = false, below = false;
  for (const TopoDS_Shape& shape : faces) {
    const TopoDS_Face face = TopoDS::Face(shape.Oriented(TopAbs_FORWARD));
    const std::optional<Vec3> own = normal_at_middle(edge, face);
    if (!own) continue;
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopAbs_Orientation way = it.Current().Orientation();
      if (!it.Current().IsSame(edge) || (way != TopAbs_FORWARD && way != TopAbs_REVERSED)) continue;
      const Vec3 inward = (way == TopAbs_FORWARD ? 1.0 : -1.0) * own->cross(tangent);
      above = above || inward.dot(normal) > kLeastSine;
      below = below || inward.dot(normal) < -kLeastSine;
    }
  }
  return above && below;
}

/// The edges that lie inside of a face: its loops use them in neither direction, or in both with one curve.
std::vector<TopoDS_Edge> edges_inside(const TopoDS_Face& face) {
  TopTools_IndexedDataMapOfShapeListOfShape uses;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    const int index = uses.FindIndex(it.Current());
    TopTools_ListOfShape one;
    one.Append(it.Current());
    if (index > 0)
      uses(index).Append(it.Current());
    else
      uses.Add(it.Current(), one);
  }
  std::vector<TopoDS_Edge> inside;
  for (int i = 1; i <= uses.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(uses.FindKey(i).Oriented(TopAbs_FORWARD));
    const TopAbs_Orientation way = uses(i).First().Orientation();
    const bool along_no_loop = way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL;
    if (along_no_loop || (uses(i).Extent() > 1 && !BRep_Tool::IsClosed(edge, face))) inside.push_back(edge);
  }
  return inside;
}

}  // namespace

std::vector<HalfCut> half_cuts(const std::vector<std::vector<TopoDS_Shape>>& images) {
  std::vector<TopTools_IndexedDataMapOfShapeListOfShape> faces_of(images.size());
  for (std::size_t i = 0; i < images.size(); ++i)
    for (const TopoDS_Shape& image : images[i])
      TopExp::MapShapesAndUniqueAncestors(image, TopAbs_EDGE, TopAbs_FACE, faces_of[i]);
  std::vector<HalfCut> found;
  for (std::size_t i = 0; i < images.size(); ++i)
    for (const TopoDS_Shape& image : images[i])
      for (TopExp_Explorer it(image, TopAbs_FACE); it.More(); it.Next()) {
        const TopoDS_Face face = TopoDS::Face(it.Current());
        for (const TopoDS_Edge& edge : edges_inside(face)) {
          const std::optional<Vec3> normal = normal_at_middle(edge, face);
          const std::optional<Middle> middle = middle_along(edge);
          if (!normal || !middle) continue;
          for (std::size_t j = 0; j < images.size(); ++j)
            if (j != i && faces_of[j].Contains(edge) &&
                goes_through(edge, middle->tangent, *normal, faces_of[j].FindFromKey(edge)))
              found.push_back({{i, j}, middle->point});
        }
      }
  return found;
}

}  // namespace octet
