// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <chrono>
#include <limits>

#include "base/error.h"
#include "tests/octree/labelled_models.h"

namespace octet {
namespace {

using test::analytic_models;

TEST(BuildOctree, KeepsTheInvariantsOnEveryAnalyticModel) {
  for (const auto& [name, model, size] : analytic_models()) {
    EXPECT_EQ(check_octree(build_octree(model, {size}, {})), "") << name;
  }
}

TEST(BuildOctree, OctantsThatMeetTheModelHaveTheSizeAsked) {
  for (const auto& [name, model, size] : analytic_models()) {
    const Octree tree = build_octree(model, {size}, {});
    std::size_t finest = 0, asked = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
      const Box3 box = tree.box(OctantId(i));
      const double length = tree.length(tree[OctantId(i)].level);
      if (model.near_boundary(box) || model.region_at(box.centre()) != 0) {
        EXPECT_LE(length, size) << name;
        EXPECT_NEAR(length, size, 1e-8 * size) << name;
        ++asked;
      }
      if (length <= size) ++finest;
    }
    EXPECT_GT(asked, 100u) << name;
    EXPECT_LT(finest, 9 * asked) << name;  // no more than siblings of octants that are asked for
  }
}

TEST(BuildOctree, OutsideAwayFromTheModelIsCoarse) {
  const Model model = analytic_ball(0.5);
  const Octree tree = build_octree(model, {0.02}, {});
  EXPECT_GT(tree.length(tree[OctantId(0)].level), 7.0 * 0.02);
  EXPECT_LT(tree.size(), 250'000u);  // the ball alone holds 65 thousand
}

TEST(BuildOctree, OctantsThatHoldASampleHaveItsSize) {
  const Model model = analytic_box(Vec3(1.0, 1.2, 0.8));
  const std::vector<SizeSample> samples{{Vec3(0.0, 0.0, 0.0), 0.01},
                                        {Vec3(0.5, 0.6, 0.4), 0.03},
                                        {Vec3(1.0, 0.3, 0.2), 0.1},
                                        {Vec3(1.0, 1.0, 0.4), 5.0}};
  const Octree tree = build_octree(model, {0.1}, samples);
  EXPECT_EQ(check_octree(tree), "");
  for (const SizeSample& s : samples) EXPECT_LE(tree.length_at(s.place), s.size * (1.0 + 1e-6));
  EXPECT_GT(tree.length_at(samples[0].place), 0.0049);
  EXPECT_NEAR(tree.length_at(samples[2].place), 0.1, 1e-9);
  const auto plain = build_octree(model, {0.1}, {});
  EXPECT_GT(tree.size(), plain.size());
  EXPECT_LT(tree.size(), plain.size() + 4000);
}

TEST(BuildOctree, TooSmallASizeFailsAtOnceAndSaysWhatWouldDo) {
  const Model model = analytic_box(Vec3(1.0, 1.2, 0.8));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW((void)build_octree(model, {1e-4}, {}), LimitError);
  EXPECT_THROW((void)build_octree(model, {1e-8}, {}), LimitError);
  EXPECT_THROW((void)build_octree(analytic_box(Vec3(1.0, 1.0, 1e-6)), {0.002, 100'000}, {}), LimitError);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  try {
    (void)build_octree(model, {0.01, 10'000}, {});
    FAIL();
  } catch (const LimitError& e) {
    EXPECT_NE(std::string(e.what()).find("limit is 10000"), std::string::npos) << e.what();
  }
  EXPECT_THROW((void)build_octree(model, {0.1}, std::array{SizeSample{Vec3(0.5, 0.5, 0.5), 1e-7}}),
               LimitError);
  EXPECT_THROW((void)build_octree(model, {0.1}, std::array{SizeSample{Vec3(0.5, 0.5, 0.5), 0.0}}),
               InputError);
  EXPECT_THROW((void)build_octree(model, {0.0}, {}), InputError);
}

TEST(BuildOctree, OctantsBeyondTheLimitAreCountedBeforeTheyAreMade) {
  const Model model = analytic_box(Vec3(10.0, 6.0, 3.0));
  std::size_t asked = 0;
  OctreeRequest request{1.0};
  request.max_within = 10'000;
  request.field = [&](const Box3&) {
    ++asked;
    return 0.001;
  };
  EXPECT_THROW((void)build_octree(model, request, {}), TooManyOctants);
  EXPECT_LT(asked, 2 * request.max_within);
  request.field = [](const Box3& box) { return box.lo.x() < 1.0 ? 1e-5 : kNoSize; };
  try {
    (void)build_octree(model, request, {});
    FAIL();
  } catch (const TooManyOctants& many) {
    ASSERT_TRUE(many.finest());
    EXPECT_LT(many.finest()->lo.x(), 1.0);
  }
}

TEST(BuildOctree, AFieldOfNoPositiveNumberIsRefused) {
  const Model model = analytic_box(Vec3(10.0, 6.0, 3.0));
  for (const double size : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    OctreeRequest request{1.0, 10'000};
    request.field = [size](const Box3&) { return size; };
    EXPECT_THROW((void)build_octree(model, request, {}), InputError) << size;
  }
}

TEST(BuildOctree, EndsWhenCancelled) {
  const Model model = analytic_box(Vec3(10.0, 6.0, 3.0));
  int left = 3;
  OctreeRequest request{0.5};
  request.cancelled = [&] { return left-- == 0; };
  EXPECT_THROW((void)build_octree(model, request, {}), Cancelled);
}

TEST(BuildOctree, DoesNotDependOnTheNumberOfThreads) {
  const Model model = analytic_torus(0.7, 0.2, test::turned());
  const auto build = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Octree tree = build_octree(model, {0.05}, std::array{SizeSample{Vec3(0.7, 0.0, 0.2), 0.01}});
    return std::vector<Octant>(tree.octants().begin(), tree.octants().end());
  };
  EXPECT_EQ(build(1), build(2));
}

}  // namespace
}  // namespace octet
