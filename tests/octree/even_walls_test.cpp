// SPDX-License-Identifier: BSD-3-Clause
// Octants on both sides of a thin wall or gap are of one size; elsewhere sizes are what they were.
#include "octree/even_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geom/analytic.h"

namespace octet {
namespace {

constexpr double kOctant = 0.2, kFine = 0.05;

/// Of a plate whose upper face wants small octants at its middle, in both directions: the greatest ratio of
/// lengths of the octants that hold a place of the upper face and the place below it.
double greatest_ratio(double thickness, bool even = true) {
  const Model model = analytic_box(Vec3(2, 2, thickness), {{}, 1e-3});
  OctreeRequest request;
  request.size = kOctant;
  std::vector<SizeSample> samples;
  for (double x = 0.6; x < 1.4; x += kFine)
    for (double y = 0.6; y < 1.4; y += kFine) samples.push_back({Vec3(x, y, thickness - 1e-6), kFine});
  const Octree built = build_octree(model, request, samples);
  const Octree tree = even ? with_even_walls(model, built, 2 * kOctant) : built;
  EXPECT_EQ(check_octree(tree), "");
  double greatest = 1.0;
  for (double x = 0.65; x < 1.3; x += 0.03)
    for (double y = 0.65; y < 1.3; y += 0.03) {
      const double above = tree.length_at(Vec3(x, y, thickness)), below = tree.length_at(Vec3(x, y, 0));
      EXPECT_LE(above, kFine * 1.001);
      greatest = std::max({greatest, above / below, below / above});
    }
  return greatest;
}

TEST(EvenWalls, ThinOnesHaveOctantsOfOneSizeOnBothSides) {
  // The coarser octants beside the fine ones have spacings of 0.075: walls up to 0.0975 are thin to them.
  for (const double thickness : {0.06, 0.07, 0.08, 0.09}) {
    EXPECT_EQ(greatest_ratio(thickness), 1.0) << thickness;
    EXPECT_EQ(greatest_ratio(thickness, false), 2.0) << thickness;
  }
}

TEST(EvenWalls, OthersHaveTheSizesAskedFor) { EXPECT_GE(greatest_ratio(0.3), 2.0); }

TEST(EvenWalls, ATreeThatIsEvenStaysAsItIs) {
  const Model model = analytic_hollow_ball(1.0, 0.9, {{}, 1e-3});
  OctreeRequest request;
  request.size = kOctant;
  const Octree tree = build_octree(model, request, {});
  const Octree again = with_even_walls(model, tree, 2 * kOctant);
  EXPECT_TRUE(std::equal(tree.octants().begin(), tree.octants().end(), again.octants().begin(),
                         again.octants().end()));
}

}  // namespace
}  // namespace octet
