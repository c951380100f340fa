// SPDX-License-Identifier: BSD-3-Clause
// What is no larger than the gaps around it is named, and does not keep a part from being read.
#include "geom/tiny_features.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {
namespace {

constexpr double kWidth = 1e-3;

TopoDS_Vertex fat_vertex(const gp_Pnt& p) {
  TopoDS_Vertex v;
  BRep_Builder().MakeVertex(v, p, kWidth);
  return v;
}

TopoDS_Face face_of(std::initializer_list<TopoDS_Edge> edges) {
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Edge& edge : edges) wire.Add(edge);
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

/// A box of side 1 whose edge along z is two straight edges, kWidth apart, between the same two fat vertices,
/// with a face of two sides between them.
TopoDS_Shape box_with_a_strip() {
  const gp_Pnt corner[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<TopoDS_Vertex> low, high;
  for (const gp_Pnt& p : corner) {
    low.push_back(fat_vertex(p));
    high.push_back(fat_vertex(p.Translated(gp_Vec(0, 0, 1))));
  }
  const BRep_Builder builder;
  const auto line = [&](const gp_Pnt& p, const gp_Pnt& q, const TopoDS_Vertex& v, const TopoDS_Vertex& w) {
    TopoDS_Edge edge;
    builder.MakeEdge(edge, new Geom_Line(p, gp_Vec(p, q)), 1e-7);
    builder.Range(edge, 0.0, p.Distance(q));
    builder.Add(edge, v.Oriented(TopAbs_FORWARD));
    builder.Add(edge, w.Oriented(TopAbs_REVERSED));
    return edge;
  };
  const auto between = [&](const TopoDS_Vertex& v, const TopoDS_Vertex& w) {
    return line(BRep_Tool::Pnt(v), BRep_Tool::Pnt(w), v, w);
  };
  std::vector<TopoDS_Edge> bottom, top, up;
  for (int i = 0; i < 4; ++i) {
    bottom.push_back(between(low[i], low[(i + 1) % 4]));
    top.push_back(between(high[i], high[(i + 1) % 4]));
    up.push_back(between(low[i], high[i]));
  }
  const TopoDS_Edge second = line(gp_Pnt(kWidth, 0, 0), gp_Pnt(kWidth, 0, 1), low[0], high[0]);
  const std::vector<TopoDS_Face> faces = {face_of({bottom[0], up[1], top[0], second}),
                                          face_of({bottom[1], up[2], top[1], up[1]}),
                                          face_of({bottom[2], up[3], top[2], up[2]}),
                                          face_of({bottom[3], up[0], top[3], up[3]}),
                                          face_of({bottom[0], bottom[1], bottom[2], bottom[3]}),
                                          face_of({top[0], top[1], top[2], top[3]}),
                                          face_of({up[0], second})};
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Face& face : faces) builder.Add(shell, face);
  return BRepBuilderAPI_MakeSolid(shell).Solid();
}

TEST(TinyFeatures, EdgesAndFacesWithinALengthAreCounted) {
  const Model plate = model_from_shape(BRepPrimAPI_MakeBox(10.0, 5.0, 0.1).Shape());
  EXPECT_EQ(features_within(plate, 0.09), 0u);
  EXPECT_EQ(features_within(plate, 0.11), 8u);  // four edges across, four faces beside
  EXPECT_EQ(features_within(plate, 10.1), 18u);
}

TEST(TinyFeatures, AnOrdinaryPartHasNone) {
  EXPECT_TRUE(tiny_features(model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape())).empty());
}

TEST(TinyFeatures, AStripNoWiderThanItsVerticesAreFatIsReadAndNamed) {
  const Model model = model_from_shape(box_with_a_strip());
  EXPECT_EQ(model.count(2), 7);
  EXPECT_NEAR(model.region(1).volume, 1.0, 2e-3);
  const std::vector<TinyFeature> tiny = tiny_features(model);
  ASSERT_EQ(tiny.size(), 1u);
  EXPECT_EQ(tiny[0].entity.dim, 2);
  EXPECT_EQ(model.face(tiny[0].entity.tag).boundary.size(), 2u);
  EXPECT_LE(tiny[0].size, 2.0 * kWidth);
  EXPECT_TRUE(is_sliver(model, tiny[0].entity.tag));
}

TEST(TinyFeatures, AnEdgeShorterThanTheGapsAtItsEndsIsNamed) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(1, 1, 0), gp_Pnt(0.5, 1, 0),
                          gp_Pnt(0.5 - 5e-6, 1, 0), gp_Pnt(0, 1, 0)})
    outline.Add(p);
  outline.Close();
  const TopoDS_Shape prism =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 1)).Shape();
  const TopTools_IndexedMapOfShape vertices = sub_shapes(prism, TopAbs_VERTEX);
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices(i));
    const gp_Pnt at = BRep_Tool::Pnt(vertex);
    if (std::abs(at.X() - 0.5) < 1e-3)
      BRep_Builder().UpdateVertex(vertex, at.Translated(gp_Vec(0.0, 2e-5, 0.0)), 3e-5);
  }
  int edges = 0, faces = 0;
  for (const TinyFeature& feature : tiny_features(model_from_shape(prism))) {
    edges += feature.entity.dim == 1;
    faces += feature.entity.dim == 2;
  }
  EXPECT_EQ(edges, 2);
  EXPECT_EQ(faces, 1);
}

}  // namespace
}  // namespace octet::test
