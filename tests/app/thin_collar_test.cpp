// SPDX-License-Identifier: BSD-3-Clause
// A collar far thinner than its elements that stands around a bore, into a hollow.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>

#include "geom/occt/from_shape.h"
#include "tests/support/expect_complete.h"

namespace octet {
namespace {

TopoDS_Shape cylinder(double radius, double z0, double z1) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.0, 0.0, z0), gp::DZ()), radius, z1 - z0).Shape();
}

/// A bore through the ceiling of a hollow, whose wall goes on for 0.78 below the ceiling.
TopoDS_Shape bored_hollow(double wall) {
  constexpr double kBore = 3.175, kHollow = 5.7, kCeiling = 1.73, kEnd = 0.95, kTop = 12.0;
  const TopoDS_Shape block =
      BRepPrimAPI_MakeBox(gp_Pnt(-20.0, -20.0, -8.0), gp_Pnt(20.0, 20.0, kTop)).Shape();
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(block, cylinder(kHollow, 0.0, kCeiling)).Shape();
  const TopoDS_Shape collared = BRepAlgoAPI_Fuse(hollow, cylinder(kBore + wall, kEnd, kCeiling)).Shape();
  ShapeUpgrade_UnifySameDomain whole(BRepAlgoAPI_Cut(collared, cylinder(kBore, 0.0, kTop)).Shape());
  whole.Build();
  return whole.Shape();
}

/// Points of the collar's edges, and the vertex of its outer seam, had no partner on the bore.
TEST(ThinCollar, CornersBehindItGetTheirPartnersOnTheBore) {
  const Model model = model_from_shape(bored_hollow(0.005));
  ASSERT_EQ(model.count(2), 12);
  test::expect_complete(model, {7.0, 10.0, 12.0});
}

}  // namespace
}  // namespace octet
