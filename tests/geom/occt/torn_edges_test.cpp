// SPDX-License-Identifier: BSD-3-Clause
// An edge is torn where its vertex is elsewhere, at either end.
#include "geom/occt/torn_edges.h"

#include <gtest/gtest.h>

#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>

namespace octet::test {
namespace {

/// From the origin to (1, 0, 0), with vertices at `first` and `last`.
TopoDS_Edge edge_between(double first, double last) {
  const BRep_Builder builder;
  const auto vertex_at = [&](double x) {
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, gp_Pnt(x, 0, 0), 10.0);  // a tolerance that covers any gap
    return vertex;
  };
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_Line(gp::OX()), 1e-7);
  builder.Add(edge, vertex_at(first).Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex_at(last).Oriented(TopAbs_REVERSED));
  builder.Range(edge, 0.0, 1.0);
  return edge;
}

TEST(TornEdges, AnEdgeEndsWhereItsVerticesAre) {
  EXPECT_FALSE(is_torn(edge_between(0.0, 1.0), 1e-6));
  EXPECT_TRUE(is_torn(edge_between(0.25, 1.0), 0.1)) << "the first";
  EXPECT_TRUE(is_torn(edge_between(0.0, 1.25), 0.1)) << "the last";
  EXPECT_FALSE(is_torn(edge_between(0.25, 1.25), 0.3)) << "no farther than allowed";
  EXPECT_FALSE(is_torn(edge_between(0.25, 1.0), 0.1, 0.3)) << "nor than the share of its length";
  EXPECT_TRUE(is_torn(edge_between(0.25, 1.0), 0.1, 0.2));
}

TEST(TornEdges, AnEdgeTurnedRoundIsTheSame) {
  const TopoDS_Edge whole = edge_between(0.0, 1.0);
  EXPECT_FALSE(is_torn(TopoDS::Edge(whole.Reversed()), 1e-6));
}

}  // namespace
}  // namespace octet::test
