// SPDX-License-Identifier: BSD-3-Clause
// Segments and triangles: crossing, touching, coplanar, apart.
#include "classify/triangle_crossing.h"

#include <gtest/gtest.h>

namespace octet {
namespace {

const Vec3 kA(0, 0, 0), kB(4, 0, 0), kC(0, 4, 0);

bool meets(const Vec3& p, const Vec3& q) {
  const bool forward = segment_meets_triangle(p, q, kA, kB, kC);
  EXPECT_EQ(forward, segment_meets_triangle(q, p, kA, kB, kC));
  EXPECT_EQ(forward, segment_meets_triangle(p, q, kC, kB, kA));
  return forward;
}

TEST(TriangleCrossing, ASegmentThroughTheInsideMeets) { EXPECT_TRUE(meets({1, 1, -1}, {1, 1, 1})); }

TEST(TriangleCrossing, TouchingASideACornerOrAnEndMeets) {
  EXPECT_TRUE(meets({2, 2, -1}, {2, 2, 1}));
  EXPECT_TRUE(meets({4, 0, -1}, {4, 0, 1}));
  EXPECT_TRUE(meets({1, 1, 0}, {1, 1, 1}));
}

TEST(TriangleCrossing, BesideOrAboveItDoesNot) {
  EXPECT_FALSE(meets({3, 3, -1}, {3, 3, 1}));
  EXPECT_FALSE(meets({1, 1, 1}, {1, 1, 2}));
  EXPECT_FALSE(meets({1, 1, 1e-300}, {1, 1, 2}));
  EXPECT_FALSE(meets({2, 2 + 1e-15, -1}, {2, 2 + 1e-15, 1}));
}

TEST(TriangleCrossing, InThePlaneEveryWayOfMeetingIsSeen) {
  EXPECT_TRUE(meets({1, 1, 0}, {1.5, 1, 0}));
  EXPECT_TRUE(meets({-1, 1, 0}, {5, 1, 0}));
  EXPECT_TRUE(meets({-1, 0, 0}, {9, 0, 0}));
  EXPECT_TRUE(meets({-1, 1, 0}, {1, -1, 0}));
  EXPECT_FALSE(meets({-1, 1, 0}, {-1, 5, 0}));
  EXPECT_FALSE(meets({4, 4, 0}, {5, 5, 0}));
  EXPECT_FALSE(meets({5, 0, 0}, {6, 0, 0}));
}

TEST(TriangleCrossing, FromACornerOnlyTheAngleBetweenTheSidesIsInside) {
  EXPECT_TRUE(segment_enters_triangle(kA, {1, 1, 0}, kB, kC));
  EXPECT_TRUE(segment_enters_triangle(kA, {9, 0, 0}, kB, kC));
  EXPECT_FALSE(segment_enters_triangle(kA, {-1, 1, 0}, kB, kC));
  EXPECT_FALSE(segment_enters_triangle(kA, {-1, -1, 0}, kB, kC));
  EXPECT_FALSE(segment_enters_triangle(kA, {1, 1, 1e-9}, kB, kC));
}

}  // namespace
}  // namespace octet
