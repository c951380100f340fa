// SPDX-License-Identifier: BSD-3-Clause
// Fields read by boxes.
#include "mesh/background.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"

namespace octet {
namespace {

Box3 around(const Vec3& p, double half) { return Box3{p, p}.grown(half); }

/// Two tetrahedra on both sides of the triangle (x, y, z axes' ends).
Background two_tets() {
  Background field;
  field.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  field.tets = {{0, 1, 2, 3}, {4, 1, 3, 2}};
  field.tet_size = {0.1, 0.5};
  return field;
}

TEST(Background, ABoxGetsTheSmallestSizeOfTheElementsItMeets) {
  const SizeField field = background_field(two_tets());
  EXPECT_EQ(field(around(Vec3(0.1, 0.1, 0.1), 0.05)), 0.1);
  EXPECT_EQ(field(around(Vec3(0.6, 0.6, 0.6), 0.05)), 0.5);
  EXPECT_EQ(field(around(Vec3(0.4, 0.4, 0.4), 0.2)), 0.1);
}

TEST(Background, WhatDoesNotFitIsRefused) {
  const auto refuses = [](const std::function<void(Background&)>& spoil) {
    Background broken = two_tets();
    spoil(broken);
    EXPECT_THROW((void)background_field(broken), InputError);
  };
  refuses([](Background& b) { b.tets[1][0] = 5; });
  refuses([](Background& b) { b.tet_size.pop_back(); });
  refuses([](Background& b) { b.tet_size.clear(); });
  refuses([](Background& b) { b.tets.clear(); });
}

TEST(Background, NothingIsWantedOutside) {
  const SizeField field = background_field(two_tets());
  EXPECT_EQ(field(around(Vec3(2.0, 2.0, 2.0), 0.1)), kNoSize);
  // In the bounding box of an element, but not in the element.
  EXPECT_EQ(field(around(Vec3(0.05, 0.9, 0.9), 0.02)), kNoSize);
}

TEST(Background, VertexSizesCountByTheSmallestOfAnElement) {
  Background field = two_tets();
  field.tet_size.clear();
  field.point_size = {0.3, 0.2, 0.4, 0.4, 0.1};
  const SizeField wanted = background_field(field);
  EXPECT_EQ(wanted(around(Vec3(0.1, 0.1, 0.1), 0.05)), 0.2);
  EXPECT_EQ(wanted(around(Vec3(0.8, 0.8, 0.8), 0.05)), 0.1);
}

TEST(Background, PointsSpeakForWhatIsNearestToThemUpToTheEndOfTheCloud) {
  Background cloud;
  for (int i = 0; i < 1000; ++i) {
    cloud.points.emplace_back(i % 10, i / 10 % 10, i / 100);
    cloud.point_size.push_back(1.0 + i % 10);
  }
  const SizeField field = background_field(cloud);
  EXPECT_EQ(field(around(Vec3(3.2, 4.4, 4.6), 0.01)), 4.0);
  EXPECT_EQ(field(around(Vec3(3.2, 4.4, 4.6), 1.0)), 4.0);
  EXPECT_EQ(field(around(Vec3(3.2, 4.4, 4.6), 1.5)), 3.0);
  EXPECT_EQ(field(around(Vec3(-3.0, 4.0, 4.0), 0.5)), kNoSize);
}

TEST(Background, SizesThatAreNoneAreLeftOut) {
  Background field = two_tets();
  field.tet_size = {0.0, 0.5};
  EXPECT_EQ(background_field(field)(around(Vec3(0.1, 0.1, 0.1), 0.01)), kNoSize);
}

}  // namespace
}  // namespace octet
