// SPDX-License-Identifier: BSD-3-Clause
// Octants are subdivided where a mesh has faults, and where an attempt has gaps.
#include <gtest/gtest.h>

#include "app/attempt.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "octree/even_walls.h"
#include "tests/support/families.h"

namespace octet {
namespace {

Model void_in_a_box() {
  for (const test::FamilyPart& part : test::family_parts())
    if (part.name == "small_void") return model_from_shape(part.build());
  throw std::runtime_error("no such family");
}

Octree unit_octants(const Model& model) { return build_octree(model, {.size = 1.0}, {}); }

TEST(Subdivision, OctantsAroundAPlaceAreHalvedAndNoneBelowTheFinest) {
  const Model model = void_in_a_box();
  const Octree tree = unit_octants(model);
  const Vec3 place(1.3, -0.4, 0.2);
  const auto once = subdivide_at(tree, model, {place}, 0.3);
  ASSERT_TRUE(once);
  EXPECT_DOUBLE_EQ(once->length_at(place), 0.5 * tree.length_at(place));
  EXPECT_EQ(once->length_at(place - Vec3(2.5, 0, 0)), tree.length_at(place - Vec3(2.5, 0, 0)));
  EXPECT_EQ(check_octree(*once), "");
  EXPECT_FALSE(subdivide_at(*subdivide_at(*once, model, {place}, 0.3), model, {place}, 0.3));
  EXPECT_FALSE(subdivide_at(tree, model, {}, 0.3));
}

TEST(Subdivision, OctantsAcrossAThinWallAreHalvedAsWell) {
  Frame oblique;
  oblique.axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const double thickness : {0.14, 0.17, 0.2, 0.23}) {
    const Model model = analytic_box(Vec3(2, 2, thickness), {oblique});
    Octree tree = unit_octants(model);
    for (int i = 0; i < 3; ++i)
      tree = subdivide_at(tree, model, {oblique.axes * Vec3(1, 1, thickness)}, 0.01).value();
    EXPECT_EQ(with_even_walls(model, tree).size(), tree.size()) << thickness;
  }
}

TEST(Subdivision, AFaceBetweenTheOctantsIsAGapAndGetsOctantsOfHalfItsExtent) {
  const Model model = void_in_a_box();
  Attempt attempt(unit_octants(model));
  cut_tree(attempt, model);
  place_points(attempt, model, {1.0});
  triangulate(attempt, model);
  Observer silent;
  AttributeLimits limits;
  limits.points = 1000;
  classify(attempt);
  close_holes(attempt, model, 1.0, limits, silent);
  ASSERT_EQ(attempt.closed.gaps.size(), 1u);
  const Gap& gap = attempt.closed.gaps[0];
  EXPECT_EQ(gap.kind, GapKind::kBareFace);
  EXPECT_NEAR((gap.place - Vec3(0.37, 0, 0)).norm(), 0.05, 1e-9);
  const auto finer = subdivide_at_gaps(attempt, model, 1e-3);
  ASSERT_TRUE(finer);
  EXPECT_LE(finer->length_at(gap.place), 0.05);
  EXPECT_GT(finer->length_at(gap.place), 0.02);
}

}  // namespace
}  // namespace octet
