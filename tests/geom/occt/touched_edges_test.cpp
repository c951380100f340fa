// SPDX-License-Identifier: BSD-3-Clause
// An edge that a vertex of its face lies on is split there; one that it merely comes near to is not.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "tests/support/notes.h"

namespace octet {
namespace {

constexpr double kRadius = 2.0, kDepth = 3.0;

/// A box 20 x 10 x 6 with a conical pocket in its top, whose rim, with its vertex, ends `gap` off the edge
/// y = 0; the file says that vertex to be within the tolerance.
TopoDS_Shape pocket_beside_an_edge(double gap, double tolerance) {
  const gp_Pnt middle(10.0, gap + kRadius, 6.0);
  const gp_Ax2 axes(middle.Translated(gp_Vec(0, 0, -kDepth)), gp::DZ(), gp_Dir(0.0, -1.0, 0.0));
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20.0, 10.0, 6.0).Shape(),
                                             BRepPrimAPI_MakeCone(axes, 0.0, kRadius, kDepth).Shape());
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
    if (BRep_Tool::Pnt(TopoDS::Vertex(it.Current())).Distance(gp_Pnt(10.0, gap, 6.0)) < 1e-6)
      BRep_Builder().UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
  return shape;
}

bool was_split(const Model& model) {
  return test::has_note(model, "are touched by a vertex of their face and were split there");
}

TEST(TouchedEdges, AreSplitAtTheVertex) {
  const Model model = model_from_shape(pocket_beside_an_edge(2e-4, 1e-3));
  EXPECT_TRUE(was_split(model));
  EXPECT_EQ(model.count(2), 7);
  EXPECT_EQ(model.count(1) - model.count(0), model_from_shape(pocket_beside_an_edge(0.5, 1e-3)).count(1) -
                                                 model_from_shape(pocket_beside_an_edge(0.5, 1e-3)).count(0) +
                                                 1);
  int at = 0, ends = 0;
  for (int v = 1; v <= model.count(0); ++v)
    if ((model.vertex(v).point - Vec3(10.0, 2e-4, 6.0)).norm() < 1e-6) at = v;
  ASSERT_GT(at, 0);
  for (int e = 1; e <= model.count(1); ++e)
    for (const int end : model.edge(e).vertex)
      if (end == at) ++ends;
  EXPECT_GE(ends, 4) << "the rim's two, and one of each piece of the edge";
  EXPECT_EQ(check_model(model), "");
  EXPECT_NEAR(model.region(1).volume, 1200.0 - std::numbers::pi * kRadius * kRadius * kDepth / 3.0, 1e-6);
}

TEST(TouchedEdges, BesideAVertexStayWhole) {
  EXPECT_FALSE(was_split(model_from_shape(pocket_beside_an_edge(2e-3, 1e-3))));
}

}  // namespace
}  // namespace octet
