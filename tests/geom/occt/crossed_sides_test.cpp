// SPDX-License-Identifier: BSD-3-Clause
// A wedge one of whose sides was fitted badly: it begins beyond the one beside it.
#include "geom/occt/crossed_sides.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cmath>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {
namespace {

constexpr double kHeight = 0.004, kTolerance = 0.002;

TopoDS_Vertex vertex(double x, double y, double z) {
  TopoDS_Vertex made;
  BRep_Builder().MakeVertex(made, gp_Pnt(x, y, z), 1e-7);
  return made;
}

TopoDS_Edge line(const TopoDS_Vertex& a, const TopoDS_Vertex& b) { return BRepBuilderAPI_MakeEdge(a, b); }

/// A wedge along x of triangles (0, 0), (1, 0), (1, kHeight) in y and z. The upper side of the one at x = 0
/// is a cubic with z = -3 dip y (1 - y)^2 + kHeight y^3.
TopoDS_Shape wedge(double dip) {
  const TopoDS_Vertex tip[] = {vertex(0, 0, 0), vertex(1, 0, 0)}, low[] = {vertex(0, 1, 0), vertex(1, 1, 0)},
                      high[] = {vertex(0, 1, kHeight), vertex(1, 1, kHeight)};
  TColgp_Array1OfPnt poles(1, 4);
  const double heights[] = {0.0, -dip, 0.0, kHeight};
  for (int i = 0; i < 4; ++i) poles(i + 1) = gp_Pnt(0.0, i / 3.0, heights[i]);
  const TopoDS_Edge fitted = BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles), tip[0], high[0]);
  const BRep_Builder builder;
  builder.UpdateEdge(fitted, kTolerance);
  const TopoDS_Edge bottom[] = {line(tip[0], low[0]), line(tip[1], low[1])},
                    back[] = {line(low[0], high[0]), line(low[1], high[1])},
                    top[] = {fitted, line(tip[1], high[1])};
  const TopoDS_Edge edge = line(tip[0], tip[1]), under = line(low[0], low[1]), over = line(high[0], high[1]);
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const auto add = [&](const gp_Pln& plane, BRepBuilderAPI_MakeWire wire) {
    builder.Add(shell, BRepBuilderAPI_MakeFace(plane, wire.Wire()).Face());
  };
  for (int i = 0; i < 2; ++i)
    add(gp_Pln(gp_Pnt(i, 0, 0), gp::DX()), BRepBuilderAPI_MakeWire(bottom[i], back[i], top[i]));
  add(gp_Pln(gp::Origin(), gp::DZ()), BRepBuilderAPI_MakeWire(bottom[0], under, bottom[1], edge));
  add(gp_Pln(gp_Pnt(0, 1, 0), gp::DY()), BRepBuilderAPI_MakeWire(back[0], over, back[1], under));
  add(gp_Pln(gp::Origin(), gp_Dir(0, -kHeight, 1)), BRepBuilderAPI_MakeWire(top[0], over, top[1], edge));
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TEST(CrossedSides, AreSplitWhereTheyCross) {
  constexpr double kDip = 0.0003;
  const Repair split = split_crossed_sides(wedge(kDip));
  ASSERT_EQ(split.entities.size(), 2u);
  const TopTools_IndexedMapOfShape vertices = sub_shapes(split.solid, TopAbs_VERTEX);
  ASSERT_EQ(vertices.Extent(), 7);
  // 3 dip y (1 - y)^2 = height y^3
  const double ratio = std::sqrt(3.0 * kDip / kHeight), crossing = ratio / (1.0 + ratio);
  double nearest = 1.0;
  for (int v = 1; v <= 7; ++v)
    nearest =
        std::min(nearest, BRep_Tool::Pnt(TopoDS::Vertex(vertices(v))).Distance(gp_Pnt(0.0, crossing, 0.0)));
  EXPECT_LT(nearest, 1e-6);
  EXPECT_EQ(sub_shapes(split.solid, TopAbs_EDGE).Extent(), 11);
}

TEST(CrossedSides, ProperOnesStay) {
  EXPECT_TRUE(split_crossed_sides(wedge(0.0)).entities.empty());
  EXPECT_TRUE(split_crossed_sides(wedge(-0.0003)).entities.empty());
  EXPECT_TRUE(split_crossed_sides(wedge(1e-6)).entities.empty()) << "beyond by 4e-7: rounding";
}

TEST(CrossedSides, BecomeOneEdgeUpToTheCrossing) {
  const Model model = model_from_shape(wedge(0.0003), {});
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.count(0), 7);
  EXPECT_EQ(model.count(1), 10);
  EXPECT_EQ(model.count(2), 5);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 0.5 * kHeight, 0.05 * kHeight);
  // The better of the two stays: from the tip to the crossing all that is left is the straight side.
  const Vec3 tip(0, 0, 0);
  int from_tip = 0;
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    const Vec3 middle = model.edge_point(e, 0.5 * (edge.t0 + edge.t1));
    const bool at_tip = (model.vertex(edge.vertex[0]).point - tip).norm() < 1e-6 ||
                        (model.vertex(edge.vertex[1]).point - tip).norm() < 1e-6;
    if (!at_tip || middle.x() > 1e-6) continue;
    ++from_tip;
    EXPECT_NEAR(middle.z(), 0.0, 1e-9);
  }
  EXPECT_EQ(from_tip, 1);
}

}  // namespace
}  // namespace octet::test
