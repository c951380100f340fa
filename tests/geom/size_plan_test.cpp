// SPDX-License-Identifier: BSD-3-Clause
// Plans of sizes: what is refused, and how soon.
#include "geom/size_plan.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "base/error.h"
#include "geom/analytic.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SizeControl control(double size, const std::string& wish, double unit = 1.0) {
  SizeControl control;
  control.size = size;
  control.attributes.push_back(parse_size_attribute(wish, unit));
  return control;
}

/// What the plan of a box of 10 x 20 x 30 is refused with, which takes less than a second; empty where it is
/// not.
std::string limit_told(const SizeControl& control) {
  const Model box = analytic_box(Vec3(10, 20, 30));
  const auto start = std::chrono::steady_clock::now();
  std::string told;
  try {
    (void)plan_sizes(box, control);
  } catch (const LimitError& limit) {
    told = limit.what();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  }
  return told;
}

void expect_told(const SizeControl& control, const std::string& words) {
  const std::string told = limit_told(control);
  EXPECT_EQ(told.find(words), 0u) << "wanted \"" << words << "\" in: " << told;
}

TEST(SizePlan, AWishFarTooCostlyIsRefusedBeforeItIsSampledInTheUsersOwnNumbers) {
  expect_told(control(3.0, "Face1-6=0.001"), "Face1-6=0.001 asks for about 3.3e+10 elements");
  expect_told(control(3.0, "Face1-6=0.000001", 1000.0), "Face1-6=0.000001 asks for about 3.3e+10 elements");
  expect_told(control(3.0, "Edge1-12=1e-6"), "Edge1-12=1e-6 asks for about ");
  expect_told(control(3.0, "Edge1-12=/100000000"), "Edge1-12=/100000000 asks for about ");
  expect_told(control(3.0, "Region1=0.01"), "Region1=0.01 asks for about 5.7e+10 elements");
  expect_told(control(3.0, "ball:0,0,0,5=0.01"), "ball:0,0,0,5=0.01 asks for about ");
  expect_told(control(3.0, "box:0,0,0,5,5,5=0.01"), "box:0,0,0,5,5,5=0.01 asks for about 1.2e+09 elements");
  expect_told(control(3.0, "Vertex1=1e-6"), "Vertex1=1e-6 is too small for a part of its extent");
}

TEST(SizePlan, WhatIsAdvisedInsteadIsTaken) {
  for (const std::string place : {"Face1", "Edge1-12", "Region1", "box:0,0,0,5,5,5"}) {
    const std::string told = limit_told(control(3.0, place + "=1e-7"));
    const std::size_t at = told.find("ask for about ");
    ASSERT_NE(at, std::string::npos) << told;
    const std::string advised = told.substr(at + 14, told.find(" there") - at - 14);
    EXPECT_EQ(limit_told(control(3.0, place + "=" + advised)), "") << told;
  }
}

TEST(SizePlan, AShapeCostsWhatOfItLiesInThePart) {
  EXPECT_EQ(limit_told(control(3.0, "ball:-500,0,0,499=0.01")), "");
  EXPECT_EQ(limit_told(control(3.0, "ball:1000,0,0,900=0.01")), "");
}

TEST(SizePlan, AControlThatMakesNoSenseIsRefused) {
  const Model box = analytic_box(Vec3(10, 20, 30));
  const auto refused = [&](const SizeControl& given) {
    EXPECT_THROW((void)plan_sizes(box, given), InputError);
  };
  const auto with = [](SizeAttribute attribute) {
    SizeControl control;
    control.size = 3.0;
    control.attributes.push_back(std::move(attribute));
    return control;
  };
  const SizeAttribute face = parse_size_attribute("Face1=1"), ball = parse_size_attribute("ball:1,1,1,2=1");
  refused(with({}));
  for (const int dim : {-1, 4, 7}) {
    SizeAttribute attribute = face;
    attribute.dim = dim;
    refused(with(attribute));
  }
  for (const double size : {0.0, -1.0, kNan, kInfinity})
    for (SizeAttribute attribute : {face, ball, parse_size_attribute("Region1=1")}) {
      attribute.size = size;
      refused(with(attribute));
    }
  for (const double radius : {0.0, -1.0, kNan, kInfinity}) {
    SizeAttribute attribute = ball;
    attribute.radius = radius;
    refused(with(attribute));
  }
  SizeAttribute nowhere = ball, pieces = face;
  nowhere.a.y() = kNan;
  refused(with(nowhere));
  pieces.elements = 4;
  refused(with(pieces));
  SizeControl budget;
  budget.wall_budget = kNan;
  refused(budget);
  EXPECT_NO_THROW((void)plan_sizes(box, with(face)));
  EXPECT_NO_THROW((void)plan_sizes(box, with(ball)));
}

TEST(SizePlan, AFieldOfNoPositiveNumberIsRefusedWhereItIsAsked) {
  const Model box = analytic_box(Vec3(10, 20, 30));
  for (const double size : {0.0, -1.0, kNan}) {
    SizeControl given = control(3.0, "ball:1,1,1,2=1");
    given.background = [size](const Box3&) { return size; };
    for (const double floor : {0.0, 0.1}) {
      given.min_size = floor;
      const SizePlan plan = plan_sizes(box, given);
      EXPECT_THROW((void)plan.field({Vec3(0, 0, 0), Vec3(1, 1, 1)}), InputError) << size;
    }
  }
}

TEST(SizePlan, PlanningEndsWhenCancelled) {
  const Model box = analytic_box(Vec3(10, 20, 30));
  SizeControl given = control(3.0, "Face1-6=0.5");
  given.wall_elements = given.gap_elements = 0.0;
  given.cancelled = [] { return true; };
  EXPECT_THROW((void)plan_sizes(box, given), Cancelled);
}

}  // namespace
}  // namespace octet
