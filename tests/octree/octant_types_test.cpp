// SPDX-License-Identifier: BSD-3-Clause
#include "octree/octant_types.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <numbers>

#include "tests/octree/labelled_models.h"

namespace octet {
namespace {

using test::analytic_models;

double volume_of_inside(const Octree& tree, const OctantTypes& types) {
  double volume = 0.0;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const double length = tree.length(tree[OctantId(i)].level);
    if (types.type[i] == OctantType::kIn) volume += length * length * length;
  }
  return volume;
}

TEST(OctantTypes, AgreeWithTheModelOctantByOctant) {
  for (const auto& [name, model, size] : analytic_models()) {
    const Octree tree = build_octree(model, {size}, {});
    const OctantTypes types = octant_types(model, tree);
    for (std::size_t i = 0; i < tree.size(); ++i) {
      const Box3 box = tree.box(OctantId(i));
      ASSERT_EQ(types.type[i] == OctantType::kBoundary, model.near_boundary(box)) << name;
      if (types.type[i] == OctantType::kBoundary) {
        EXPECT_EQ(types.region[i], 0) << name;
      } else {
        const int region = model.region_at(box.centre());
        EXPECT_EQ(types.region[i], region) << name;
        EXPECT_EQ(types.type[i] == OctantType::kIn, region != 0) << name;
      }
    }
  }
}

TEST(OctantTypes, VolumeOfInsideOctantsConvergesToTheModelsFromBelow) {
  const double radius = 0.5;
  const Model model = analytic_ball(radius, {{}, 1e-4});
  const double exact = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  double last = 0.0;
  for (const double h : {0.1, 0.05, 0.025}) {
    const Octree tree = build_octree(model, {h}, {});
    const double volume = volume_of_inside(tree, octant_types(model, tree));
    EXPECT_GT(volume, last);
    EXPECT_LT(volume, exact);
    // What is missing lies within one octant diagonal of the surface.
    EXPECT_GT(volume, exact - 4.0 * std::numbers::pi * radius * radius * std::sqrt(3.0) * h);
    last = volume;
  }
}

TEST(OctantTypes, FollowRefinementBySamplesAndCoarseInsides) {
  const Model model = analytic_box_minus_ball(1.0, 0.35);
  const std::vector<SizeSample> samples{{Vec3(0.35, 0.0, 0.0), 0.01}, {Vec3(0.0, 0.0, 0.0), 0.01}};
  const Octree tree = build_octree(model, {0.2}, samples);
  const OctantTypes types = octant_types(model, tree);
  EXPECT_EQ(types.type[tree.find(Vec3(0.0, 0.0, 0.0)).index()], OctantType::kOut);
  EXPECT_EQ(types.type[tree.find(Vec3(0.35, 0.0, 0.0)).index()], OctantType::kBoundary);
  EXPECT_EQ(types.type[0], OctantType::kOut);
}

TEST(OctantTypes, DoNotDependOnTheNumberOfThreads) {
  const Model model = analytic_hollow_ball(0.6, 0.4);
  const Octree tree = build_octree(model, {0.05}, {});
  const auto types = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return octant_types(model, tree);
  };
  const OctantTypes one = types(1), two = types(2);
  EXPECT_EQ(one.type, two.type);
  EXPECT_EQ(one.region, two.region);
}

}  // namespace
}  // namespace octet
