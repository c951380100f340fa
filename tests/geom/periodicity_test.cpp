// SPDX-License-Identifier: BSD-3-Clause
// Which motions take faces to their images, and what they take to what.
#include "geom/periodicity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"
#include "geom/analytic.h"

namespace octet {
namespace {

/// The face of the model whose nearest point to p is p.
int face_at(const Model& model, const Vec3& p) {
  for (int f = 1; f <= model.count(2); ++f)
    if (model.face_closest(f, p).distance < 1e-9) return f;
  return 0;
}

PeriodicFaces pair(int face, int image) { return {"the words", {face}, {image}}; }

std::string refusal(const Model& model, const std::vector<PeriodicFaces>& wishes) {
  try {
    const Periodicity periodicity(model, wishes);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Periodicity, ABoxIsItsOwnNeighbourAlongEachAxis) {
  const Vec3 size(3.0, 4.0, 5.0);
  const Model box = analytic_box(size);
  const Periodicity periodicity(box, {faces_across(box, 0), faces_across(box, 1), faces_across(box, 2)});
  ASSERT_EQ(periodicity.faces().size(), 3u);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& orbit = periodicity.faces()[static_cast<std::size_t>(axis)];
    ASSERT_EQ(orbit.size(), 2u);
    EXPECT_LT((orbit[1].motion.shift - size[axis] * Vec3::Unit(axis)).norm(), 1e-12);
    EXPECT_TRUE(orbit[1].motion.turn.isIdentity());
  }
  // Four edges along each axis are one, and all corners are.
  ASSERT_EQ(periodicity.pieces().size(), 3u);
  for (const auto& orbit : periodicity.pieces()) {
    EXPECT_EQ(orbit.size(), 4u);
    EXPECT_TRUE(periodicity.is_whole(orbit));
  }
  ASSERT_EQ(periodicity.vertices().size(), 1u);
  EXPECT_EQ(periodicity.vertices()[0].size(), 8u);
  for (const OrbitMember& member : periodicity.vertices()[0])
    EXPECT_LT(
        (member.motion(box.vertex(periodicity.vertices()[0][0].tag).point) - box.vertex(member.tag).point)
            .norm(),
        1e-12);
}

TEST(Periodicity, ASectorTurnsAboutItsAxisAndKeepsIt) {
  const double angle = std::numbers::pi / 5.0;
  const Model wedge = analytic_wedge(angle, 4.0, 3.0);
  const Vec3 on_first(2.0, 0.0, 1.0), on_second(2.0 * std::cos(angle), 2.0 * std::sin(angle), 1.0);
  const int first = face_at(wedge, on_first), second = face_at(wedge, on_second);
  ASSERT_TRUE(first > 0 && second > 0);
  const Periodicity periodicity(wedge, {pair(first, second)});
  const Motion motion = periodicity.images_on_faces(first).at(0).motion;
  EXPECT_LT((motion(on_first) - on_second).norm(), 1e-9);
  EXPECT_LT((motion(Vec3(0.0, 0.0, 2.0)) - Vec3(0.0, 0.0, 2.0)).norm(), 1e-9);
  EXPECT_LT((periodicity.images_on_faces(second).at(0).motion(on_second) - on_first).norm(), 1e-9);
  // Of seven edges the axis is alone; so are its ends.
  std::size_t alone = 0;
  for (const auto& orbit : periodicity.pieces()) alone += orbit.size() == 1 ? 1 : 0;
  EXPECT_EQ(periodicity.pieces().size(), 4u);
  EXPECT_EQ(alone, 1u);
}

TEST(Periodicity, PartsMayStandAnyWhere) {
  AnalyticOptions turned;
  turned.frame.origin = Vec3(100.0, -20.0, 7.0);
  turned.frame.axes = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const Model wedge = analytic_wedge(0.5, 4.0, 3.0, turned);
  const auto place = [&](double angle) {
    return Vec3(turned.frame.origin +
                turned.frame.axes * Vec3(2.0 * std::cos(angle), 2.0 * std::sin(angle), 1.0));
  };
  const Periodicity periodicity(wedge, {pair(face_at(wedge, place(0.5)), face_at(wedge, place(0.0)))});
  const Motion motion = periodicity.images_on_faces(face_at(wedge, place(0.5))).at(0).motion;
  EXPECT_LT((motion(place(0.5)) - place(0.0)).norm(), 1e-9);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0, Vec3::UnitZ()).toRotationMatrix();
  const Motion seen = periodicity.turned(turn).images_on_faces(face_at(wedge, place(0.5))).at(0).motion;
  EXPECT_LT((seen(turn * place(0.5)) - turn * place(0.0)).norm(), 1e-9);
}

TEST(Periodicity, CirclesAreTakenToCircles) {
  const Model cylinder = analytic_cylinder(2.0, 5.0);
  const Periodicity periodicity(cylinder, {faces_across(cylinder, 2)});
  EXPECT_EQ(periodicity.faces().size(), 1u);
  ASSERT_EQ(periodicity.pieces().size(), 1u);
  const PieceMember& piece = periodicity.pieces()[0][0];
  const double t = 0.3 * piece.t0 + 0.7 * piece.t1;
  const auto images = periodicity.images_on_edges(piece.edge, t);
  ASSERT_EQ(images.size(), 1u);
  const Vec3 p = images[0].motion(cylinder.edge_point(piece.edge, t));
  EXPECT_LT(cylinder.edge_closest(images[0].tag, p).distance, 1e-9);
  EXPECT_TRUE(periodicity.holds(model_edge(piece.edge)));
  EXPECT_FALSE(periodicity.holds(model_region(1)));
}

TEST(Periodicity, WhatCannotBeIsToldInTheUsersWords) {
  const Model box = analytic_box(Vec3(3.0, 4.0, 5.0));
  const int left = face_at(box, Vec3(0.0, 2.0, 2.5)), right = face_at(box, Vec3(3.0, 2.0, 2.5)),
            front = face_at(box, Vec3(1.5, 0.0, 2.5));
  const std::pair<std::vector<PeriodicFaces>, const char*> wrong[] = {
      {{pair(left, left)}, "its own image"},
      {{pair(left, front)}, "no motion takes"},
      {{pair(left, right), pair(left, right)}, "has an image already"},
      {{pair(left, right), pair(front, right)}, "is an image already"},
      {{{"the words", {left, front}, {right}}}, "not as many"}};
  for (const auto& [wishes, told] : wrong) {
    const std::string text = refusal(box, wishes);
    EXPECT_NE(text.find(told), std::string::npos) << text;
    EXPECT_NE(text.find("the words"), std::string::npos) << text;
  }
  EXPECT_THROW((void)faces_across(analytic_ball(1.0), 0), InputError);
  // A cube's face would be taken to itself, turned: first to the next face, then on to where it began.
  const Model cube = analytic_box(Vec3(1.0, 1.0, 1.0));
  const int a = face_at(cube, Vec3(0.0, 0.5, 0.5)), b = face_at(cube, Vec3(0.5, 0.0, 0.5)),
            c = face_at(cube, Vec3(0.5, 0.5, 0.0));
  EXPECT_NE(refusal(cube, {pair(a, b), pair(b, c), pair(c, a)}).find("in another place"), std::string::npos)
      << refusal(cube, {pair(a, b), pair(b, c), pair(c, a)});
}

}  // namespace
}  // namespace octet
