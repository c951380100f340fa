// SPDX-License-Identifier: BSD-3-Clause
// Edges and faces that rounding left are taken away; those that are merely small stay.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>
#include <map>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

/// A solid of planar polygons that share their edges.
TopoDS_Shape polyhedron(const std::vector<gp_Pnt>& points,
                        const std::vector<std::vector<std::size_t>>& loops) {
  const BRep_Builder builder;
  std::vector<TopoDS_Vertex> vertices(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) builder.MakeVertex(vertices[i], points[i], 1e-7);
  std::map<std::pair<std::size_t, std::size_t>, TopoDS_Edge> edges;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const auto& loop : loops) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t from = loop[i], to = loop[(i + 1) % loop.size()];
      TopoDS_Edge& edge = edges[std::minmax(from, to)];
      if (edge.IsNull())
        edge = BRepBuilderAPI_MakeEdge(vertices[std::min(from, to)], vertices[std::max(from, to)]).Edge();
      wire.Add(TopoDS::Edge(edge.Oriented(from < to ? TopAbs_FORWARD : TopAbs_REVERSED)));
    }
    builder.Add(shell, BRepBuilderAPI_MakeFace(wire.Wire(), true).Face());
  }
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// A hip roof over a rectangle of 20 by 10, 6 high, with a ridge of the given length.
TopoDS_Shape hip_roof(double ridge) {
  return polyhedron(
      {{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}, {10 - ridge / 2, 5, 6}, {10 + ridge / 2, 5, 6}},
      {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 5}, {2, 3, 4, 5}, {3, 0, 4}});
}

/// A box 20 by 10 by 6 with a corner's edge cut off, so that the cut is as wide as given.
TopoDS_Shape nearly_a_box(double cut) {
  return polyhedron({{0, 0, 0},
                     {20, 0, 0},
                     {20, 10 - cut, 0},
                     {20 - cut, 10, 0},
                     {0, 10, 0},
                     {0, 0, 6},
                     {20, 0, 6},
                     {20, 10 - cut, 6},
                     {20 - cut, 10, 6},
                     {0, 10, 6}},
                    {{4, 3, 2, 1, 0},
                     {5, 6, 7, 8, 9},
                     {0, 1, 6, 5},
                     {1, 2, 7, 6},
                     {2, 3, 8, 7},
                     {3, 4, 9, 8},
                     {4, 0, 5, 9}});
}

TEST(ShortEdges, AnEdgeThatRoundingLeftBecomesAVertex) {
  const Model model = model_from_shape(hip_roof(8e-7));
  EXPECT_EQ(model.count(2), 5);
  EXPECT_EQ(model.count(1), 8);
  EXPECT_EQ(model.count(0), 5);
  EXPECT_EQ(check_model(model), "");
  EXPECT_NEAR(model.region(1).volume, 400.0, 1e-4);
  ASSERT_FALSE(model.notes().empty());
  EXPECT_NE(model.notes()[0].find("became vertices"), std::string::npos) << model.notes()[0];
}

TEST(ShortEdges, AShortEdgeStays) {
  const Model model = model_from_shape(hip_roof(8e-5));
  EXPECT_EQ(model.count(1), 9);
  EXPECT_TRUE(model.notes().empty()) << model.notes()[0];
}

TEST(ShortEdges, AFaceThatRoundingLeftBecomesAnEdge) {
  const Model model = model_from_shape(nearly_a_box(6e-7));
  EXPECT_EQ(model.count(2), 6);
  EXPECT_EQ(model.count(1), 12);
  EXPECT_EQ(model.count(0), 8);
  EXPECT_EQ(check_model(model), "");
  EXPECT_NEAR(model.region(1).volume, 1200.0, 1e-4);
}

TEST(ShortEdges, ANarrowFaceStays) {
  const Model model = model_from_shape(nearly_a_box(6e-5));
  EXPECT_EQ(model.count(2), 7);
  EXPECT_TRUE(model.notes().empty()) << model.notes()[0];
}

}  // namespace
}  // namespace octet
