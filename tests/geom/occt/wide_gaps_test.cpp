// SPDX-License-Identifier: BSD-3-Clause
// Gaps of the B-rep that are wide for the size asked are found, edge by edge and vertex by vertex.
#include "geom/wide_gaps.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Vec.hxx>

#include "geom/occt/from_shape.h"

namespace octet::test {
namespace {

constexpr double kGap = 0.008;  // too small a share of the box for the edge to be drawn anew

/// A box of side 10 whose first edge runs `gap` beside its faces.
TopoDS_Shape box_with_a_gap(double gap) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape();
  const TopoDS_Edge edge = TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current());
  double a = 0.0, b = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, a, b);
  const double share = gap / std::sqrt(3.0);
  BRep_Builder().UpdateEdge(
      edge, Handle(Geom_Curve)::DownCast(curve->Translated(gp_Vec(share, share, share))), 2.0 * gap);
  return box;
}

TEST(WideGaps, NoneInAPartThatIsTight) {
  EXPECT_TRUE(wide_gaps(model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()), 1e-3).empty());
}

TEST(WideGaps, AreThoseAboveATwentiethOfTheSizeTheWidestShareFirst) {
  const Model model = model_from_shape(box_with_a_gap(kGap));
  EXPECT_TRUE(wide_gaps(model, 50.0 * kGap).empty());
  const std::vector<WideGap> gaps = wide_gaps(model, 10.0 * kGap);
  ASSERT_EQ(gaps.size(), 3u);
  int edges = 0;
  for (const WideGap& gap : gaps) {
    edges += gap.entity.dim == 1 ? 1 : 0;
    EXPECT_NEAR(gap.gap, kGap, 0.3 * kGap);
    EXPECT_EQ(gap.local, 10.0 * kGap);
  }
  EXPECT_EQ(edges, 1);
  for (std::size_t i = 1; i < gaps.size(); ++i) EXPECT_GE(gaps[i - 1].gap, gaps[i].gap);
}

TEST(WideGaps, AreMeasuredWhateverTheFileSays) {
  const TopoDS_Shape box = box_with_a_gap(kGap);
  BRep_Builder().UpdateEdge(TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()), 1e-7);
  EXPECT_EQ(wide_gaps(model_from_shape(box), 10.0 * kGap).size(), 3u);
}

}  // namespace
}  // namespace octet::test
