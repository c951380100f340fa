// SPDX-License-Identifier: BSD-3-Clause
// A wedge of a ball, one of whose two round faces was given the rest of the ball.
#include "geom/occt/sphere_sides.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Standard_Handle.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kRadius = 10.0, kPi = std::numbers::pi;

TopoDS_Face lune(double from, double to) {
  return BRepBuilderAPI_MakeFace(new Geom_SphericalSurface(gp_Ax3(), kRadius), from, to, -0.5 * kPi,
                                 0.5 * kPi, 1e-7);
}

/// Half a disk through the axis.
TopoDS_Face cut(double angle) {
  const gp_Dir out(std::cos(angle), std::sin(angle), 0.0);
  const gp_Ax2 axes(gp::Origin(), gp_Dir(out.Crossed(gp::DZ())), out);
  const gp_Pnt top(0, 0, kRadius), bottom(0, 0, -kRadius);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(gp_Circ(axes, kRadius), -0.5 * kPi, 0.5 * kPi);
  const TopoDS_Edge axis = BRepBuilderAPI_MakeEdge(top, bottom);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(axes)), BRepBuilderAPI_MakeWire(arc, axis).Wire());
}

/// A wedge of a ball from angle 0 to `end`, its round side in two at `middle`; of these the second one, where
/// it is `wrong`, has what neither has in place of its own.
TopoDS_Shape wedge(double middle, double end, bool wrong) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(lune(0.0, middle));
  sewing.Add(wrong ? lune(end, middle + 2.0 * kPi) : lune(middle, end));
  sewing.Add(cut(0.0));
  sewing.Add(cut(end));
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
}

void expect_wedge(const TopoDS_Shape& solid, double end) {
  const Model model = model_from_shape(solid);
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.count(2), 4);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 2.0 / 3.0 * end * std::pow(kRadius, 3), 1e-6);
}

class SphereSides : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(SphereSides, TheRestOfTheSphereIsGivenBack) {
  const auto [middle, end] = GetParam();
  const TopoDS_Shape solid = wedge(middle, end, true);
  ASSERT_EQ(edge_uses(solid).first(&Uses::open), 0);
  const Repair chosen = choose_sphere_sides(solid);
  EXPECT_EQ(chosen.entities.size(), 1u);
  EXPECT_EQ(edge_uses(chosen.solid).first(&Uses::open), 0);
  EXPECT_EQ(edge_uses(chosen.solid).first(&Uses::turned), 0);
  EXPECT_TRUE(has_note(model_from_shape(solid), "1 face(s) of Solid 1 lay on another of the same sphere"));
  expect_wedge(solid, end);
}

TEST_P(SphereSides, ThatAreRightStay) {
  const auto [middle, end] = GetParam();
  const TopoDS_Shape solid = wedge(middle, end, false);
  EXPECT_TRUE(choose_sphere_sides(solid).entities.empty());
  expect_wedge(solid, end);
}

INSTANTIATE_TEST_SUITE_P(Wedges, SphereSides,
                         ::testing::Values(std::pair{1.2, 2.4}, std::pair{0.5, 3.5}, std::pair{2.5, 4.0}));

}  // namespace
}  // namespace octet::test
