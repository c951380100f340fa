// SPDX-License-Identifier: BSD-3-Clause
// Boxes first, then the point's foot on the curve.
#include "geom/occt/touched_edges.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Extrema_ExtPC.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <optional>

#include "geom/occt/edge_cuts.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// A foot nearer to an end of the edge than so many tolerances belongs to the end.
constexpr double kClearOfEnds = 10.0;

/// Where the vertex touches the edge between its ends.
std::optional<Cut> touch_of(const TopoDS_Vertex& vertex, const TopoDS_Edge& edge, double tolerance) {
  const gp_Pnt point = BRep_Tool::Pnt(vertex);
  for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
    if (BRep_Tool::Pnt(end).Distance(point) <= kClearOfEnds * std::max(tolerance, BRep_Tool::Tolerance(end)))
      return {};
  std::optional<Cut> nearest;
  try {
    const BRepAdaptor_Curve curve(edge);
    const Extrema_ExtPC feet(point, curve);
    if (!feet.IsDone()) return {};
    for (int i = 1; i <= feet.NbExt(); ++i) {
      const double distance = std::sqrt(feet.SquareDistance(i));
      if (feet.IsMin(i) && distance <= tolerance && (!nearest || distance < nearest->distance))
        nearest = Cut{feet.Point(i).Parameter(), distance, vertex};
    }
  } catch (const Standard_Failure&) {  // OCCT cannot tell: no touch
    return {};
  }
  return nearest;
}

/// The touches of each edge of the solid by the vertices of its faces.
class TouchSearch {
 public:
  TouchSearch(const TopoDS_Shape& solid, double width)
      : width_(width), edges_(sub_shapes(solid, TopAbs_EDGE)), boxes_(boxes()) {
    const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
    for (int i = 1; i <= faces.Extent(); ++i) look_at(faces(i));
  }

  EdgeCuts cuts;  ///< by index in edges()
  [[nodiscard]] const TopTools_IndexedMapOfShape& edges() const { return edges_; }

 private:
  [[nodiscard]] std::vector<Bnd_Box> boxes() const {
    std::vector<Bnd_Box> all(static_cast<std::size_t>(edges_.Extent()) + 1);
    for (int i = 1; i <= edges_.Extent(); ++i) all[static_cast<std::size_t>(i)] = box_of(edges_(i));
    return all;
  }

  void look_at(const TopoDS_Shape& face) {
    const TopTools_IndexedMapOfShape vertices = sub_shapes(face, TopAbs_VERTEX);
    const TopTools_IndexedMapOfShape edges = sub_shapes(face, TopAbs_EDGE);
    for (int e = 1; e <= edges.Extent(); ++e) {
      const TopoDS_Edge edge = TopoDS::Edge(edges(e).Oriented(TopAbs_FORWARD));
      if (BRep_Tool::Degenerated(edge)) continue;
      const int index = edges_.FindIndex(edge);
      for (int v = 1; v <= vertices.Extent(); ++v) {
        const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices(v));
        const double own = std::max(BRep_Tool::Tolerance(vertex), BRep_Tool::Tolerance(edge));
        Bnd_Box ball;
        ball.Add(BRep_Tool::Pnt(vertex));
        ball.Enlarge(std::max(own, width_));
        if (ball.IsOut(boxes_[static_cast<std::size_t>(index)])) continue;
        auto touch = touch_of(vertex, edge, own);
        // What is beside a seam is no nearer to an edge of the mesh.
        if (!touch && width_ > own && !BRep_Tool::IsClosed(edge, TopoDS::Face(face)))
          touch = touch_of(vertex, edge, width_);
        if (touch) cuts.add(index, *touch);
      }
    }
  }

  double width_;
  TopTools_IndexedMapOfShape edges_;
  std::vector<Bnd_Box> boxes_;
};

}  // namespace

Repair split_touched_edges(const TopoDS_Shape& solid, double width) {
  const TouchSearch search(solid, width);
  return search.cuts.apply(solid, search.edges());
}

}  // namespace octet
