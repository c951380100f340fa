// SPDX-License-Identifier: BSD-3-Clause
// How often boundaries that cross themselves enclose a point.
#include "geom/winding.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "geom/occt/reader.h"
#include "tests/support/crossed.h"
#include "tests/support/with_void.h"

namespace octet {
namespace {

Model as_it_is(const TopoDS_Shape& shape) {
  ReadJob job;
  job.shape = shape;
  return Model(read_job(job));
}

TEST(Winding, IsTwoWhereABoundaryEnclosesTwice) {
  const Model model = as_it_is(test::crossed_boxes());
  EXPECT_EQ(winding_number(model, 1, {2, 2, 2}), 1);
  EXPECT_EQ(winding_number(model, 1, {12, 12, 12}), 1);
  EXPECT_EQ(winding_number(model, 1, {7, 7, 7}), 2);
  EXPECT_EQ(winding_number(model, 1, {2, 12, 12}), 0);
  EXPECT_EQ(winding_number(model, 1, {-100, 7, 7}), 0);
}

TEST(Winding, IsNegativeWhereItIsTurnedInsideOut) {
  const Model model = as_it_is(
      test::with_void(test::box_between({0, 0, 0}, {10, 10, 10}),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5.0, 5.0, 4.0), gp::DZ()), 2.0, 9.0).Shape()));
  EXPECT_EQ(winding_number(model, 1, {5.1, 5.2, 11}), -1);
  EXPECT_EQ(winding_number(model, 1, {5.1, 5.2, 7}), 0);
  EXPECT_EQ(winding_number(model, 1, {1, 1, 7}), 1);
}

TEST(Winding, IsUnknownOnTheBoundary) {
  EXPECT_EQ(winding_number(as_it_is(BRepPrimAPI_MakeSphere(1.0).Shape()), 1, {0.6, 0.8, 0.0}), std::nullopt);
}

TEST(Winding, WhatOnlyOneModelCovers) {
  const TopoDS_Shape fused = BRepAlgoAPI_Fuse(test::box_between({0, 0, 0}, {10, 10, 10}),
                                              test::box_between({5, 5, 5}, {15, 15, 15}));
  const Model box = as_it_is(test::box_between({0, 0, 0}, {10, 10, 10})),
              crossed = as_it_is(test::crossed_boxes()), united = as_it_is(fused),
              ball = as_it_is(BRepPrimAPI_MakeSphere(1.0).Shape());
  EXPECT_EQ(share_covered_once(box, box, {1}), 0.0);
  EXPECT_EQ(share_covered_once(crossed, united, {1}), 0.0);
  EXPECT_NEAR(share_covered_once(crossed, box, {1}), 875.0 / 1875.0, 0.01);
  ReadJob fine;
  fine.shape = BRepPrimAPI_MakeSphere(1.0).Shape();
  fine.options.facet_deflection = 1e-4;
  EXPECT_EQ(share_covered_once(ball, Model(read_job(fine)), {1}), 0.0) << "other facets are no other ball";
  fine.shape = BRepPrimAPI_MakeSphere(1.01).Shape();
  EXPECT_NEAR(share_covered_once(ball, Model(read_job(fine)), {1}), 0.03, 0.005);
}

}  // namespace
}  // namespace octet
