// SPDX-License-Identifier: BSD-3-Clause
// Parts whose boundary crosses itself are meshed as what it encloses.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/geometry_faults.h"
#include "app/mesh_part.h"
#include "geom/face_crossings.h"
#include "geom/occt/from_shape.h"
#include "tests/support/crossed.h"
#include "tests/support/with_void.h"

namespace octet {
namespace {

void expect_complete(const TopoDS_Shape& shape, double size) {
  const Model model = model_from_shape(shape);
  MeshOptions options;
  options.size = size;
  const MeshResult result = mesh_part(model, options);
  const MeshReport& report = result.report;
  EXPECT_EQ(report.status, MeshStatus::kComplete) << (report.faults.empty() ? "" : report.faults[0].cause);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_NEAR(report.volume, model.region(1).volume, 0.03 * model.region(1).volume);
}

TEST(Crossed, BoxesAreMeshedAsOne) {
  for (const double size : {4.0, 1.5}) expect_complete(test::crossed_boxes(), size);
}

TEST(Crossed, PinsBentTighterThanTheyAreThick) {
  for (const double bend : {0.9, 0.6, 0.3}) expect_complete(test::bent_pin(1.0, bend), 0.4);
}

TEST(Crossed, AChamferThatNarrowsToNothingAndGoesOn) {
  for (const double size : {1.0, 0.3}) expect_complete(test::plate_with_a_bow_tie(), size);
}

TEST(Crossed, AWireThatPiercesItself) { expect_complete(test::looped_wire(), 0.5); }

TEST(Crossed, AVoidThroughTheTop) {
  expect_complete(
      test::with_void(test::box_between({0, 0, 0}, {10, 10, 10}),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5.0, 5.0, 4.0), gp::DZ()), 2.0, 9.0).Shape()),
      1.0);
}

TEST(Crossed, AFaultMayComeOfTheCrossingsOfItsOwnFaces) {
  gp_Trsf away;
  away.SetTranslation(gp_Vec(-50.0, 0.0, 0.0));
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  builder.Add(all, test::folded_bar(2.5));
  builder.Add(all, test::folded_bar(2.2).Moved(TopLoc_Location(away)));
  builder.Add(all, test::box_between({50, 0, 0}, {60, 10, 10}));
  const Model model = model_from_shape(all);
  ASSERT_EQ(model.count(3), 3);
  const auto depth_of = [&](ModelRef entity) { return deepest_crossing_at({entity, {}, "", ""}, model); };
  std::array<double, 4> depth{};  // by region
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& region = model.face(f).region;
    double& deepest = depth[static_cast<std::size_t>(std::max(region[0], region[1]))];
    deepest = std::max(deepest, depth_of(model_face(f)));
  }
  EXPECT_GT(depth[2], 0.0);
  EXPECT_GT(depth[1], 1.1 * depth[2]);
  EXPECT_EQ(depth[3], 0.0);
  EXPECT_EQ(depth_of({}), depth[1]);
}

TEST(Crossed, WhatElseIsAtFaultWhereAFaceCrossesItselfIsPutToThat) {
  const Model model = model_from_shape(test::folded_bar(2.5));
  ASSERT_FALSE(model.crossings().empty());
  MeshOptions options;
  options.size = 3.0;
  const MeshReport report = mesh_part(model, options).report;
  EXPECT_EQ(report.status, MeshStatus::kIncomplete);
  ASSERT_GT(report.faults.size(), 1u);
  EXPECT_NE(report.faults.front().cause.find("crosses itself"), std::string::npos) << report.faults[0].cause;
  for (const Fault& fault : report.faults)
    EXPECT_EQ(fault.advice.rfind("mend the part", 0), 0u) << fault.cause;
}

}  // namespace
}  // namespace octet
