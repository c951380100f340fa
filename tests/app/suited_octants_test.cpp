// SPDX-License-Identifier: BSD-3-Clause
// Octants whose lengths suit walls and radii.
#include "app/suited_octants.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/element_estimate.h"
#include "app/scaled_sizes.h"
#include "geom/analytic.h"
#include "geom/size_attributes.h"
#include "geom/size_memo.h"

namespace octet {
namespace {

struct Planned {
  SizePlan plan;
  std::string note;
};

Planned planned(const Model& model, const MeshOptions& options) {
  const MeshOptions sized = with_default_size(model, options);
  Planned made{plan_sizes(model, sized), {}};
  made.note = suit_octants(model, sized, made.plan);
  return made;
}

MeshOptions of_size(double size) {
  MeshOptions options;
  options.size = size;
  return options;
}

/// Its walls want edges of 1: octants for edges of 3 are halved to 0.75.
Model plate() { return analytic_box(Vec3(40.0, 30.0, 1.0)); }

TEST(SuitedOctants, AWallGetsItsOwnThickness) {
  const Model model = plate();
  const auto [plan, note] = planned(model, of_size(3.0));
  EXPECT_NEAR(3.0 * std::exp2(plan.octaves), 2.0, 0.05);
  EXPECT_NE(note.find("edges of 2"), std::string::npos) << note;
  SizePlan as_asked = plan;
  as_asked.octaves = 0.0;
  EXPECT_LT(estimated_elements(model, plan), 0.7 * estimated_elements(model, as_asked));
}

TEST(SuitedOctants, NoLongerThanAskedForNorMuchShorter) {
  const Model model = plate();
  double least = 0.0, most = -1.0;
  for (double size = 2.0; size < 4.0; size *= 1.03) {
    const double octaves = planned(model, of_size(size)).plan.octaves;
    least = std::min(least, octaves);
    most = std::max(most, octaves);
  }
  EXPECT_EQ(most, 0.0);
  EXPECT_LT(least, -0.5);
  EXPECT_GE(least, -0.75);
}

/// All of the torus asks for edges of 2.35, whose double is 4.7.
TEST(SuitedOctants, CoarserSizesGiveAsManyElementsAsTheOneThatIsMeant) {
  const Model model = analytic_torus(12.0, 4.0, {{}, 1e-2});
  const auto elements = [&](double size) {
    const MeshResult mesh = mesh_part(model, of_size(size));
    EXPECT_EQ(mesh.report.status, MeshStatus::kComplete) << size;
    return static_cast<double>(mesh.report.tets);
  };
  const double meant = elements(2.35);
  for (const double size : {3.6, 4.0, 4.4}) EXPECT_NEAR(elements(size) / meant, 1.0, 0.3) << size;
}

TEST(SuitedOctants, TheSizeAskedForWhereTheInsideDecides) {
  for (const double size : {0.9, 1.1, 1.3, 1.5, 1.7}) {
    EXPECT_EQ(planned(analytic_box(Vec3(20.0, 20.0, 20.0)), of_size(size)).plan.octaves, 0.0) << size;
    EXPECT_EQ(planned(analytic_ball(10.0, {{}, 1e-3}), of_size(size)).plan.octaves, 0.0) << size;
  }
}

TEST(SuitedOctants, WhatElseDecidesOnLengthsHasPrecedence) {
  const Model model = plate();
  MeshOptions at_place = of_size(3.0);
  at_place.attributes.push_back(parse_size_attribute("Face1=0.75"));
  MeshOptions over_space = of_size(3.0);
  over_space.background = [](const Box3&) { return 2.5; };
  MeshOptions unasked;
  for (const MeshOptions& options : {at_place, over_space, unasked}) {
    const auto [plan, note] = planned(model, options);
    EXPECT_EQ(plan.octaves, 0.0);
    EXPECT_TRUE(note.empty());
  }
}

TEST(SuitedOctants, TheReportTellsOfIt) {
  const MeshResult suited = mesh_part(plate(), of_size(3.0));
  ASSERT_EQ(suited.report.notes.size(), 1u);
  EXPECT_NE(suited.report.notes.front().find("in place of 3 mm"), std::string::npos);
  EXPECT_EQ(suited.report.size, 3.0);
  EXPECT_TRUE(mesh_part(plate(), of_size(2.0)).report.notes.empty());
}

}  // namespace
}  // namespace octet
