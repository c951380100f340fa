// SPDX-License-Identifier: BSD-3-Clause
// Solids that cross themselves become what they enclose.
#include "geom/occt/unite_crossed.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "geom/face_crossings.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/reader.h"
#include "tests/support/crossed.h"
#include "tests/support/notes.h"
#include "tests/support/with_void.h"

namespace octet {
namespace {

using test::box_between;
using test::note_with;

double volume_of(const Model& model) {
  double sum = 0.0;
  for (int r = 1; r <= model.count(3); ++r) sum += model.region(r).volume;
  return sum;
}

/// The model of the first reading.
Model as_it_is(const TopoDS_Shape& shape) {
  ReadJob job;
  job.shape = shape;
  return Model(read_job(job));
}

void expect_sound(const Model& model) {
  EXPECT_EQ(check_model(model), "");
  EXPECT_TRUE(model.crossings().empty());
  EXPECT_TRUE(model.parts().faults.empty());
}

/// The sound part of a shape of which so many pairs of faces cross before.
Model united(const TopoDS_Shape& shape, std::size_t crossings) {
  EXPECT_EQ(as_it_is(shape).crossings().size(), crossings) << "of the input";
  Model model = model_from_shape(shape);
  expect_sound(model);
  return model;
}

TEST(UniteCrossed, TwoBoxesInOneShellBecomeOneSolid) {
  const Model model = united(test::crossed_boxes(), 6);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 12);
  EXPECT_EQ(model.count(1), 12 + 12 + 6) << "each of six edges has its inner part gone, six are new";
  EXPECT_NEAR(volume_of(model), 1875.0, 1e-9);
  EXPECT_EQ(
      note_with(model, "crosses itself"),
      "Solid 1 crosses itself: 6 pair(s) of its faces cross, the first is Face 2 and Face 9; they were cut "
      "along each other, and 6 piece(s) that lay inside, or were turned inside out, were taken away");
}

TEST(UniteCrossed, FacesKeepTheirNumbers) {
  const Model before = as_it_is(test::crossed_boxes()), model = model_from_shape(test::crossed_boxes());
  ASSERT_EQ(before.count(2), model.count(2));
  for (int f = 1; f <= model.count(2); ++f) {
    const Vec3 normal = model.face_normal(f, Vec2::Zero()), was = before.face_normal(f, Vec2::Zero());
    EXPECT_NEAR(normal.dot(was), 1.0, 1e-12) << f;
    EXPECT_NEAR(normal.dot(model.face_jet(f, Vec2::Zero(), 0).p - before.face_jet(f, Vec2::Zero(), 0).p), 0.0,
                1e-12)
        << f;
    EXPECT_EQ(model.provenance().as_read[2][static_cast<std::size_t>(f)].tags, std::vector<int>{f});
  }
}

/// Of the pin's union, by slices across z.
double bent_pin_volume(double r, double bend) {
  constexpr int kSlices = 200'000;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double z = r * (2.0 * (i + 0.5) / kSlices - 1.0), w = std::sqrt(r * r - z * z);
    const double inner = std::max(0.0, bend - w), beyond = std::max(0.0, w - bend);
    sum += 2.0 * 5.0 * 2.0 * w - beyond * beyond +
           std::numbers::pi / 4.0 * ((bend + w) * (bend + w) - inner * inner);
  }
  return sum * 2.0 * r / kSlices;
}

TEST(UniteCrossed, APinBentTighterThanItIsThick) {
  for (const double bend : {0.9, 0.6, 0.3}) {
    const Model model = united(test::bent_pin(1.0, bend), 1);  // the two straight ends
    EXPECT_EQ(model.count(3), 1);
    EXPECT_NEAR(volume_of(model), bent_pin_volume(1.0, bend), 1e-6 * volume_of(model)) << bend;
    EXPECT_NE(note_with(model, "crosses itself: 1 pair(s)"), "");
    const auto cylinders = [&](const Model& m) {
      int count = 0;
      for (int f = 1; f <= m.count(2); ++f) count += std::string_view(m.surface(f).kind()) == "cylinder";
      return count;
    };
    EXPECT_EQ(cylinders(model), 2);
    EXPECT_EQ(model.region_at(Vec3(-0.02, -0.02, 0.0)), 1) << "in both ends, and in the torus turned over";
  }
  EXPECT_EQ(note_with(model_from_shape(test::bent_pin(1.0, 1.5)), "crosses itself"), "");
}

TEST(UniteCrossed, AChamferThatNarrowsToNothingAndGoesOn) {
  const Model model = united(test::plate_with_a_bow_tie(), 1);  // the two sides beside the chamfer
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 7);
  EXPECT_EQ(model.count(0), 10)
      << "two at the tip are gone, one below it and the chamfer's upper end are new";
  EXPECT_NEAR(volume_of(model), 24.0 - 1.0 / 6.0, 1e-9);
  EXPECT_EQ(model.region_at(Vec3(4.1, 4.1, 1.45)), 0) << "the tip was inside out";
}

TEST(UniteCrossed, ASweepThatPiercesItself) {
  const Model model = model_from_shape(test::looped_wire()), before = as_it_is(test::looped_wire());
  EXPECT_FALSE(before.crossings().empty());
  expect_sound(model);
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), before.count(2)) << "the second pass dents the first";
  // The lens of two cylinders of radius 1 at a right angle, 0.7 apart, by slices between the two axes.
  constexpr int kSlices = 100'000;
  double lens = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double z = -0.3 + 1.3 * (i + 0.5) / kSlices;
    lens += 4.0 * std::sqrt((1.0 - z * z) * (1.0 - (z - 0.7) * (z - 0.7))) * 1.3 / kSlices;
  }
  EXPECT_NEAR(volume_of(before) - volume_of(model), lens, 0.01 * lens)
      << "the second pass is not quite level";
}

TEST(UniteCrossed, AVoidThroughTheTopBecomesAHole) {
  const TopoDS_Shape rod =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5.0, 5.0, 4.0), gp::DZ()), 2.0, 9.0).Shape();
  const Model model = united(test::with_void(box_between({0, 0, 0}, {10, 10, 10}), rod), 1);
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 8) << "the rod's end beyond the box is gone";
  EXPECT_NEAR(volume_of(model), 1000.0 - 24.0 * std::numbers::pi, 1e-8);
  EXPECT_NE(note_with(model, "nothing is left of Face"), "") << "of the rod's end";
}

TEST(UniteCrossed, AVoidAcrossTheSolidLeavesTwo) {
  const Model model =
      united(test::with_void(box_between({0, 0, 0}, {10, 10, 10}), box_between({4, -1, -1}, {5, 11, 11})), 8);
  ASSERT_EQ(model.count(3), 2);
  EXPECT_NEAR(model.region(1).volume + model.region(2).volume, 900.0, 1e-9);
  EXPECT_NEAR(std::max(model.region(1).volume, model.region(2).volume), 500.0, 1e-9);
  EXPECT_NE(note_with(model, "it became 2 solids"), "");
}

TEST(UniteCrossed, CupsMouthToMouthEncloseAVoid) {
  const auto cup = [](const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d) {
    return BRepAlgoAPI_Cut(box_between(a, b), box_between(c, d)).Shape();
  };
  const TopoDS_Shape cups_in_one =
      test::one_shell_of({cup({0, 0, 0}, {10, 10, 10}, {1, 1, 1}, {9, 9, 11}),
                          cup({-1, -1, 9}, {11, 11, 19}, {2, 2, 8}, {8, 8, 18})});
  const Model model = united(cups_in_one, 8);
  ASSERT_EQ(model.count(3), 1);
  const double cups = (1000.0 - 64.0 * 9.0) + (1440.0 - 36.0 * 9.0), both = 100.0 - 64.0;
  EXPECT_NEAR(volume_of(model), cups - both, 1e-9);
  EXPECT_EQ(model.region_at(Vec3(5.0, 5.0, 9.5)), 0) << "inside both";
  EXPECT_EQ(model.region_at(Vec3(0.5, 5.0, 9.5)), 1);
}

TEST(UniteCrossed, OnlyTheSolidThatCrossesItselfIsTouched) {
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, box_between({-10, 0, 0}, {0, 10, 10}));
  builder.Add(all, test::crossed_boxes());
  builder.Add(all, box_between({30, 0, 0}, {31, 1, 1}));
  const Model model = united(all, 6);
  ASSERT_EQ(model.count(3), 3);
  EXPECT_NEAR(model.region(1).volume, 1000.0, 1e-9);
  EXPECT_NEAR(model.region(2).volume, 1875.0, 1e-9);
  EXPECT_NEAR(model.region(3).volume, 1.0, 1e-9);
  EXPECT_EQ(model.count(2), 6 + 12 + 6 - 1) << "the first two share a face";
  EXPECT_NE(note_with(model, "Solid 2 crosses itself"), "");
  EXPECT_EQ(note_with(model, "Solid 1 crosses"), "");
}

TEST(UniteCrossed, InsideOutIsTheSame) {
  const Model model = united(test::crossed_boxes().Reversed(), 6);
  EXPECT_NEAR(volume_of(model), 1875.0, 1e-9);
}

TEST(UniteCrossed, ThePartIsTheSameEachTime) {
  const Model a = model_from_shape(test::looped_wire()), b = model_from_shape(test::looped_wire());
  EXPECT_EQ(a.facets().nodes, b.facets().nodes);
  EXPECT_EQ(a.facets().triangles, b.facets().triangles);
  EXPECT_EQ(a.notes(), b.notes());
}

}  // namespace
}  // namespace octet
