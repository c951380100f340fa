// SPDX-License-Identifier: BSD-3-Clause
// An edge inside a face is a half cut where another solid goes on beyond both of the face's sides.
#include "geom/occt/half_cuts.h"
#include "geom/occt/gathered.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pln.hxx>

#include <array>

namespace octet::test {
namespace {

/// From (-1, 0, 0) to (1, 0, 0).
TopoDS_Edge edge_along_x() { return BRepBuilderAPI_MakeEdge(gp_Pnt(-1, 0, 0), gp_Pnt(1, 0, 0)); }

/// The square of side 10 around the origin at z = 0, with the edge inside.
TopoDS_Shape square_with(const TopoDS_Edge& edge) {
  TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(), -5.0, 5.0, -5.0, 5.0);
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, edge.Oriented(TopAbs_INTERNAL));
  builder.Add(face, wire);
  return face;
}

/// The triangle from the edge to (0, y, z).
TopoDS_Shape triangle_from(const TopoDS_Edge& edge, double y, double z) {
  const gp_Pnt tip(0, y, z);
  BRepBuilderAPI_MakeWire wire(edge);
  const TopoDS_Vertex end = BRepBuilderAPI_MakeVertex(tip);
  wire.Add(BRepBuilderAPI_MakeEdge(TopExp::LastVertex(edge), end));
  wire.Add(BRepBuilderAPI_MakeEdge(end, TopExp::FirstVertex(edge)));
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Shape();
}

std::size_t cuts_where_others_go(const TopoDS_Edge& edge, const std::vector<std::array<double, 2>>& tips) {
  std::vector<TopoDS_Shape> faces;
  for (const auto& [y, z] : tips) faces.push_back(triangle_from(edge, y, z));
  return half_cuts({{square_with(edge)}, {compound_of(faces)}}).size();
}

TEST(HalfCuts, WhatGoesThroughAFaceCutsItInPartOnly) {
  const TopoDS_Edge edge = edge_along_x();
  EXPECT_EQ(cuts_where_others_go(edge, {{0.0, 1.0}, {0.0, -1.0}}), 1u);
  EXPECT_EQ(cuts_where_others_go(edge, {{0.5, 1.0}, {0.5, -1.0}}), 1u);
  const auto found = half_cuts(
      {{square_with(edge)}, {compound_of({triangle_from(edge, 0, 1), triangle_from(edge, 0, -1)})}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].solids, (std::array<std::size_t, 2>{0, 1}));
  EXPECT_LT(found[0].place.norm(), 1e-12);
}

TEST(HalfCuts, WhatTouchesAFaceFromOneSideDoesNot) {
  const TopoDS_Edge edge = edge_along_x();
  EXPECT_EQ(cuts_where_others_go(edge, {{1.0, 1.0}, {-1.0, 1.0}}), 0u);
  EXPECT_EQ(cuts_where_others_go(edge, {{1.0, 0.0}, {0.0, -1.0}}), 0u) << "one runs along the face";
  EXPECT_EQ(cuts_where_others_go(edge, {}), 0u) << "an edge that no other has";
}

}  // namespace
}  // namespace octet::test
