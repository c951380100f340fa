// SPDX-License-Identifier: BSD-3-Clause
// Ogives as OCCT's reader leaves them: a round face with the rim of its base alone.
#include "geom/occt/missing_poles.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <tuple>
#include <vector>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kArc = 48.75, kRim = 1.5, kHeight = 12.0;

/// The meridian is a whole circle that meets the axis at both kHeight and -kHeight; the rim is in `pieces`.
TopoDS_Shape ogive_without_pole(int pieces, bool upward) {
  const gp_Ax2 across(gp_Pnt(kRim - kArc, 0, 0), -gp::DY(), gp::DZ());
  const Handle(Geom_SurfaceOfRevolution) surface =
      new Geom_SurfaceOfRevolution(new Geom_Circle(across, kArc), gp::OZ());
  const TopAbs_Orientation way = upward ? TopAbs_FORWARD : TopAbs_REVERSED;
  const BRep_Builder builder;
  TopoDS_Wire rim;
  builder.MakeWire(rim);
  BRepBuilderAPI_MakeWire disk;
  std::vector<TopoDS_Edge> edges;
  const gp_Circ circle(gp::XOY(), kRim);
  std::vector<TopoDS_Vertex> ends;
  for (int i = 0; i < pieces; ++i) {
    const double angle = 2.0 * kPi * i / pieces;
    ends.push_back(
        BRepBuilderAPI_MakeVertex(gp_Pnt(kRim * std::cos(angle), kRim * std::sin(angle), 0)).Vertex());
  }
  for (int i = 0; i < pieces; ++i) {
    const double from = 2.0 * kPi * i / pieces, to = 2.0 * kPi * (i + 1) / pieces;
    const TopoDS_Edge edge =
        BRepBuilderAPI_MakeEdge(new Geom_Circle(circle), ends[i], ends[(i + 1) % pieces], from, to).Edge();
    builder.UpdateEdge(edge, new Geom2d_Line(gp_Pnt2d(0, 1.5 * kPi), gp::DX2d()), surface, TopLoc_Location(),
                       1e-7);
    edges.push_back(edge);
    disk.Add(edge);
  }
  for (int i = 0; i < pieces; ++i) builder.Add(rim, edges[upward ? i : pieces - 1 - i].Oriented(way));
  TopoDS_Face side;
  builder.MakeFace(side, surface, 1e-7);
  builder.Add(side, rim);
  const TopoDS_Face base = BRepBuilderAPI_MakeFace(gp_Pln(), disk.Wire()).Face();
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, side);
  builder.Add(shell, base.Oriented(upward ? TopAbs_REVERSED : TopAbs_FORWARD));
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// Where the place on the axis is.
Vec3 on_axis(const TopLoc_Location& place, double z) {
  const gp_Pnt p = gp_Pnt(0, 0, z).Transformed(place.Transformation());
  return {p.X(), p.Y(), p.Z()};
}

double ogive_volume() {
  constexpr int kSteps = 1000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double z = kHeight * (i + 0.5) / kSteps, r = std::sqrt(kArc * kArc - z * z) - (kArc - kRim);
    sum += kPi * r * r * kHeight / kSteps;
  }
  return sum;
}

class MissingPoles : public ::testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(MissingPoles, AreAddedOnTheFacesSideOfItsLoop) {
  const auto [pieces, upward] = GetParam();
  const TopoDS_Shape solid = ogive_without_pole(pieces, upward);
  const Repair mended = add_missing_poles(solid);
  EXPECT_EQ(mended.entities.size(), 1u);
  EXPECT_EQ(edge_uses(mended.solid).first(&Uses::open), 0);
  EXPECT_EQ(edge_uses(mended.solid).first(&Uses::turned), 0);
  EXPECT_TRUE(add_missing_poles(mended.solid).entities.empty());
}

TEST_P(MissingPoles, LeaveAModelWithTheOgivesVolume) {
  const auto [pieces, upward] = GetParam();
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(3, 1, 2), gp_Dir(1, 2, 3)), 0.7);
  for (const TopLoc_Location& place : {TopLoc_Location(), TopLoc_Location(turn)}) {
    const Model model = model_from_shape(ogive_without_pole(pieces, upward).Located(place));
    EXPECT_EQ(check_model(model), "");
    EXPECT_TRUE(has_note(model, "1 face(s) of revolution of Solid 1 lacked the pole on their axis"));
    ASSERT_EQ(model.count(3), 1);
    EXPECT_NEAR(model.region(1).volume, ogive_volume(), 1e-3);
    const double way = upward ? 1.0 : -1.0;
    EXPECT_EQ(model.region_at(on_axis(place, 0.9 * way * kHeight)), 1);
    EXPECT_EQ(model.region_at(on_axis(place, 1.1 * way * kHeight)), 0);
    EXPECT_EQ(model.region_at(on_axis(place, -0.1 * way)), 0);
  }
}

TEST(MissingPolesOf, OtherFacesStay) {
  EXPECT_TRUE(add_missing_poles(BRepPrimAPI_MakeCone(1.0, 0.0, 3.0).Shape()).entities.empty());
}

INSTANTIATE_TEST_SUITE_P(Ogives, MissingPoles,
                         ::testing::Combine(::testing::Values(1, 2, 3), ::testing::Bool()));

}  // namespace
}  // namespace octet::test
