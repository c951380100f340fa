// SPDX-License-Identifier: BSD-3-Clause
// Edges far shorter than asked for are counted once, and told by entity, the worst first.
#include "app/size_shortfall.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

MeshReport report_of(const TopoDS_Shape& shape) {
  MeshOptions options;
  options.size = 1.0;
  options.curvature_angle = options.wall_elements = options.gap_elements = 0.0;
  options.short_edges = options.small_regions = false;
  return mesh_part(model_from_shape(shape), options).report;
}

TEST(SizeShortfall, NoneInABlock) {
  const MeshReport report = report_of(BRepPrimAPI_MakeBox(4, 4, 4).Shape());
  EXPECT_EQ(report.shortfall.edges, 0u);
  EXPECT_TRUE(report.shortfall.shortest.empty());
}

TEST(SizeShortfall, AStepAtTheFootOfABlockIsNamed) {
  // Its riser, the face x = 3 between z = 0 and 0.02, has two edges of 0.02.
  const TopoDS_Shape step = BRepPrimAPI_MakeBox(gp_Pnt(3, -1, -1), gp_Pnt(5, 5, 0.02)).Shape();
  const MeshReport report = report_of(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4, 4, 4).Shape(), step).Shape());
  EXPECT_EQ(report.status, MeshStatus::kComplete);
  ASSERT_GE(report.shortfall.shortest.size(), 2u);
  EXPECT_LE(report.shortfall.shortest.size(), kShortEdgesTold);
  EXPECT_GE(report.shortfall.edges, report.shortfall.shortest.size());
  for (int i = 0; i < 2; ++i) {
    const ShortEdge& edge = report.shortfall.shortest[static_cast<std::size_t>(i)];
    EXPECT_EQ(edge.entity.dim, 1);
    EXPECT_NEAR(edge.length, 0.02, 1e-12);
    EXPECT_NEAR(edge.place.x(), 3.0, 1e-9);
    EXPECT_NEAR(edge.place.z(), 0.01, 1e-9);
    EXPECT_GT(edge.asked, 4.0 * edge.length);
  }
  for (std::size_t i = 1; i < report.shortfall.shortest.size(); ++i) {
    const ShortEdge &worse = report.shortfall.shortest[i - 1], &better = report.shortfall.shortest[i];
    EXPECT_LE(worse.length / worse.asked, better.length / better.asked);
    EXPECT_NE(worse.entity, better.entity);
  }
}

TEST(SizeShortfall, KeepsTheWorstOfTwo) {
  SizeShortfall a, b;
  a.edges = 3;
  a.shortest = {{model_edge(1), Vec3::Zero(), 0.1, 1.0}, {model_edge(2), Vec3::Zero(), 0.2, 1.0}};
  b.edges = 2;
  for (int i = 0; i < 10; ++i) b.shortest.push_back({model_face(i + 1), Vec3::Zero(), 0.11, 1.0});
  a.add(b);
  EXPECT_EQ(a.edges, 5u);
  ASSERT_EQ(a.shortest.size(), kShortEdgesTold);
  EXPECT_EQ(a.shortest.front().entity, model_edge(1));
  EXPECT_EQ(a.shortest.back().entity, model_face(9));
}

}  // namespace
}  // namespace octet
