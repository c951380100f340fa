// SPDX-License-Identifier: BSD-3-Clause
// Boxes of floats against the same questions axis by axis.
#include "geom/float_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

/// Few coordinates, so that sides of boxes often meet.
Vec3 on_lattice(Dice& dice) {
  const Vec3 p = dice.in({Vec3::Constant(-3.0), Vec3::Constant(3.0)});
  return {std::round(p.x()), std::round(p.y()), std::round(p.z())};
}

Box3 some_box(Dice& dice) {
  Box3 box;
  box.add(on_lattice(dice));
  box.add(on_lattice(dice));
  return box;
}

TEST(FloatBox, ApartAndHoldsAreWhatTheAxesSay) {
  Dice dice(1);
  for (int i = 0; i < 5000; ++i) {
    const Box3 a = some_box(dice), b = some_box(dice);
    const bool apart = (a.lo.array() > b.hi.array()).any() || (b.lo.array() > a.hi.array()).any();
    const bool holds = (a.lo.array() <= b.lo.array()).all() && (a.hi.array() >= b.hi.array()).all();
    EXPECT_EQ(FloatBox::around(a).apart(FloatBox::around(b)), apart);
    EXPECT_EQ(FloatBox::around(a).apart(b), apart);
    EXPECT_EQ(FloatBox::around(a).holds(FloatBox::around(b)), holds);
  }
}

TEST(FloatBox, DistancesAreThoseOfTheBox) {
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    const Box3 box = some_box(dice);
    const Vec3 p = dice.in({Vec3::Constant(-4.0), Vec3::Constant(4.0)});
    EXPECT_DOUBLE_EQ(FloatBox::around(box).squared_distance(p), box.squared_distance(p));
  }
}

TEST(FloatBox, NumbersAreRoundedToTheNextFloatOutwards) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float f : {1.0f, -1.0f, 0.1f, -0.1f, 1e-40f, -1e-40f, 3e38f, -3e38f, 0.0f}) {
    const double above = std::nextafter(static_cast<double>(f), 1e300),
                 below = std::nextafter(static_cast<double>(f), -1e300);
    EXPECT_EQ(round_down(f), f);
    EXPECT_EQ(round_up(f), f);
    EXPECT_EQ(round_down(above), f);
    EXPECT_EQ(round_up(above), std::nextafter(f, kInfinity));
    EXPECT_EQ(round_up(below), f);
    EXPECT_EQ(round_down(below), std::nextafter(f, -kInfinity));
  }
}

}  // namespace
}  // namespace octet
