// SPDX-License-Identifier: BSD-3-Clause
// Partners across thin walls, gaps and knife edges.
#include "geom/opposite.h"

#include <gtest/gtest.h>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

struct Start {
  Vec3 point, normal;
  int face;
};

/// The boundary point nearest to p.
Start start_at(const Model& model, const Vec3& p) {
  const auto foot = model.closest(p, 1e9);
  return {foot->point, foot->normal, foot->face};
}

TEST(Opposite, PlatePartnerIsStraightAcross) {
  const Model plate = analytic_box(Vec3(10, 10, 0.1));
  Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p(dice(1, 9), dice(1, 9), 0.1);
    const Start a = start_at(plate, p);
    const auto b = opposite_point(plate, a.point, a.face, a.normal, -1, 0.5);
    ASSERT_TRUE(b.has_value());
    EXPECT_LT((b->point - Vec3(p.x(), p.y(), 0)).norm(), 1e-9);
    EXPECT_NEAR(b->distance, 0.1, 1e-9);
    EXPECT_FALSE(opposite_point(plate, a.point, a.face, a.normal, 1, 0.5).has_value());
  }
}

TEST(Opposite, SheetsFaceEachOtherOnWhicheverSideTheirNormalsAre) {
  const Model wedge = analytic_wedge(20.0 * std::numbers::pi / 180.0, 10, 10, {{}, 1e-2});
  const Model blunt = analytic_wedge(60.0 * std::numbers::pi / 180.0, 10, 10, {{}, 1e-2});
  for (const Model* model : {&wedge, &blunt}) {
    const Start a = start_at(*model, Vec3(1, 0, 5));
    const auto b = opposite_point(*model, a.point, a.face, a.normal, -1, 3.0);
    ASSERT_TRUE(b.has_value());
    Foot turned = *b;
    turned.normal *= -1.0;
    for (const Vec3& normal : {a.normal, Vec3(-a.normal)}) {
      EXPECT_EQ(face_each_other(a.point, normal, *b), model == &wedge);
      EXPECT_EQ(face_each_other(a.point, normal, turned), model == &wedge);
    }
  }
}

TEST(Opposite, AFacingPointIsTheOppositePointWhereThatFaces) {
  std::size_t facing = 0, others = 0;
  for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
    Dice dice(6);
    for (int i = 0; i < 60; ++i) {
      const auto a = s.model.closest(dice.in(s.model.box()), 1e9);
      if (!a || a->on.dim != 2) continue;
      for (const int side : {-1, 1})
        for (const double reach : {0.2, 1.0, 4.0}) {
          const auto b = opposite_point(s.model, a->point, a->face, a->normal, side, reach);
          const auto c = facing_point(s.model, a->point, a->face, a->normal, side, reach);
          const bool faces = b && b->on.dim == 2 && face_each_other(a->point, a->normal, *b);
          ASSERT_EQ(c.has_value(), faces) << s.name;
          if (faces) EXPECT_EQ(c->point, b->point) << s.name;
          ++(faces ? facing : others);
        }
    }
  }
  EXPECT_GT(facing, 200u);
  EXPECT_GT(others, 200u);
}

TEST(Opposite, WedgePartnerHasTheSameDistanceFromTheEdge) {
  const Frame frame = test::tilted_frame();
  for (const double degrees : {1.0, 5.0, 20.0, 60.0, 90.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Model wedge = analytic_wedge(angle, 10, 10, {frame, 1e-2});
    Dice dice(2);
    for (int i = 0; i < 50; ++i) {
      const double r = dice(0.1, 2.0), z = dice(4, 6);
      const Start a = start_at(wedge, frame.origin + frame.axes * Vec3(r, 0, z));
      const auto b = opposite_point(wedge, a.point, a.face, a.normal, -1, 3.0);
      ASSERT_TRUE(b.has_value()) << degrees;
      const Vec3 expected = frame.origin + frame.axes * Vec3(r * std::cos(angle), r * std::sin(angle), z);
      EXPECT_LT((b->point - expected).norm(), 1e-7) << degrees;
      EXPECT_NE(b->face, a.face);
    }
  }
}

TEST(Opposite, ShellPartnerIsOnTheSameRay) {
  const Model shell = analytic_hollow_ball(2.0, 1.9, {test::tilted_frame(), 1e-2});
  Dice dice(3);
  const Vec3 o = test::tilted_frame().origin;
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = dice.direction();
    const Start outer = start_at(shell, o + 2.0 * d), inner = start_at(shell, o + 1.9 * d);
    const auto from_outer = opposite_point(shell, outer.point, outer.face, outer.normal, -1, 0.5);
    const auto from_inner = opposite_point(shell, inner.point, inner.face, inner.normal, -1, 0.5);
    ASSERT_TRUE(from_outer && from_inner);
    EXPECT_LT((from_outer->point - (o + 1.9 * d)).norm(), 1e-8);
    EXPECT_LT((from_inner->point - (o + 2.0 * d)).norm(), 1e-8);
    EXPECT_FALSE(opposite_point(shell, outer.point, outer.face, outer.normal, 1, 0.5).has_value());
    EXPECT_FALSE(opposite_point(shell, inner.point, inner.face, inner.normal, 1, 0.5).has_value());
  }
}

TEST(Opposite, ConvexBoxSeenFromInsideHasNoneNearby) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  Dice dice(4);
  for (int i = 0; i < 200; ++i) {
    const Start a = start_at(box, Vec3(dice(0.3, 0.7), dice(0.3, 0.7), 1.0));
    EXPECT_FALSE(opposite_point(box, a.point, a.face, a.normal, -1, 0.25).has_value());
    EXPECT_FALSE(opposite_point(box, a.point, a.face, a.normal, 1, 0.25).has_value());
  }
}

TEST(Opposite, NearABoxEdgeThePartnerIsOnTheAdjacentFaceAtTheSameDistance) {
  const Model box = analytic_box(Vec3(1, 1, 1));
  const Start a = start_at(box, Vec3(0.05, 0.5, 1.0));
  const auto b = opposite_point(box, a.point, a.face, a.normal, -1, 0.25);
  ASSERT_TRUE(b.has_value());
  EXPECT_LT((b->point - Vec3(0, 0.5, 0.95)).norm(), 1e-7);
}

TEST(Opposite, SmoothCurvedSheetIsNotItsOwnPartner) {
  const Model ball = analytic_ball(1.0, {test::tilted_frame(), 1e-3});
  const Model torus = analytic_torus(2.0, 0.5);
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const Start a = start_at(ball, test::tilted_frame().origin + dice.direction());
    EXPECT_FALSE(opposite_point(ball, a.point, a.face, a.normal, -1, 0.4).has_value());
    const double u = dice(0, 6.28), v = dice(0, 6.28);
    const Vec3 p = torus.face_jet(1, Vec2(u, v), 0).p;
    const auto across = opposite_point(torus, p, 1, torus.face_normal(1, Vec2(u, v)), -1, 1.5);
    ASSERT_TRUE(across.has_value());
    EXPECT_NEAR(across->distance, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace octet
