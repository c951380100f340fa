// SPDX-License-Identifier: BSD-3-Clause
// Limits of elements, options that make no sense, and runs that are to end.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <chrono>
#include <gp_Ax2.hxx>
#include <limits>

#include "app/mesh_part.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/read_part.h"
#include "tests/app/program.h"

namespace octet {
namespace {

std::string limit_told(const Model& model, const MeshOptions& options) {
  try {
    (void)mesh_part(model, options);
  } catch (const LimitError& limit) {
    return limit.what();
  }
  return {};
}

TEST(Limits, AFieldFarTooFineIsRefusedAtOnceAndItsPlaceIsNamed) {
  MeshOptions options;
  options.size = 1.0;
  options.max_elements = 100'000;
  options.background = [](const Box3& box) { return box.lo.x() > 5.0 ? 0.001 : 1.0; };
  const auto start = std::chrono::steady_clock::now();
  const std::string told = limit_told(analytic_box(Vec3(10, 6, 3)), options);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_EQ(told.find("sizes over space, 0.001 mm at "), 0u) << told;
}

TEST(Limits, AMeshThatIsThereIsNotGivenUpForAFinerOne) {
  const TopoDS_Shape void_within =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.5, 0.5, 0.5), gp_Dir(0, 0, 1)), 0.01, 1.0).Shape();
  const Model model =
      model_from_shape(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(2.0, 2.0, 2.0).Shape(), void_within).Shape());
  MeshOptions options;
  options.size = 0.6;
  options.curvature_angle = options.wall_elements = options.gap_elements = 0.0;
  options.short_edges = false;
  options.max_elements = 100'000;
  const MeshResult result = mesh_part(model, options);
  ASSERT_EQ(result.report.status, MeshStatus::kIncomplete);
  EXPECT_GT(result.mesh.tets.size(), 0u);
  ASSERT_FALSE(result.report.faults.empty());
  EXPECT_NE(result.report.faults.back().cause.find("more than the limit"), std::string::npos);
}

TEST(Limits, ElementsAcrossWallsThatNoDefaultSizeGivesAreTold) {
  const Model bracket = read_part(model_file("bracket.step"));
  const auto told = [&](double elements, double size) {
    MeshOptions options;
    options.wall_elements = elements;
    options.wall_budget = 0.0;
    options.size = size;
    options.finalize = false;
    const MeshResult result = mesh_part(bracket, options);
    EXPECT_LT(result.mesh.tets.size(), 1'200'000u);
    std::string text;
    for (const Fault& warning : result.report.warnings)
      if (warning.cause.find("elements across walls") == 0) text = warning.cause;
    return text;
  };
  EXPECT_NE(told(12.0, 0.0).find("12 asked for"), std::string::npos);
  EXPECT_EQ(told(2.0, 6.0), "");
}

TEST(Options, WhatMakesNoSenseIsRefused) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double target : {nan, -5.0, 0.5, std::numeric_limits<double>::infinity()}) {
    MeshOptions options;
    options.target_elements = target;
    EXPECT_THROW((void)mesh_part(box, options), InputError) << target;
  }
  for (const double shift : {nan, -0.1, 1.0}) {
    MeshOptions options;
    options.shift[1] = shift;
    EXPECT_THROW((void)mesh_part(box, options), InputError) << shift;
  }
  MeshOptions nothing;
  nothing.attributes.emplace_back();
  EXPECT_THROW((void)mesh_part(box, nothing), InputError);
}

TEST(Options, TheirOwnQuestionEndsARunAsAnObserversDoes) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  MeshOptions options;
  int asked = 0;
  options.cancelled = [&] { return ++asked > 5; };
  EXPECT_THROW((void)mesh_part(box, options), Cancelled);
  options.cancelled = [] { return false; };
  EXPECT_EQ(mesh_part(box, options).report.status, MeshStatus::kComplete);
}

}  // namespace
}  // namespace octet
