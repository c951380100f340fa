// SPDX-License-Identifier: BSD-3-Clause
// Sizes met by powers of two.
#include "app/octant_sizes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace octet {
namespace {

/// Octaves between a size and the nearest one of the lattice.
double off(double size, double lattice) {
  const double octaves = std::log2(size / (lattice * kEdgePerOctant));
  return std::abs(octaves - std::round(octaves));
}

TEST(OctantSizes, TheSizeAskedForAloneIsMetExactly) {
  EXPECT_DOUBLE_EQ(lattice_length(3.0, {}) * kEdgePerOctant, 3.0);
  EXPECT_DOUBLE_EQ(lattice_length(3.0, {0.75, 6.0}) * kEdgePerOctant, 3.0);
}

TEST(OctantSizes, AnAttributeIsMissedByASixthOfAnOctaveAtMost) {
  for (double size = 0.3; size < 0.7; size += 0.01) {
    const double lattice = lattice_length(1.0, {size});
    EXPECT_LT(off(size, lattice), 1.0 / 6.0 + 0.01) << size;
    EXPECT_LT(off(1.0, lattice), 1.0 / 3.0 + 0.01) << size;
  }
}

TEST(OctantSizes, CoarserRegionsAreWholeLevelsAbove) {
  SizePlan plan;
  plan.asked = 1.0;
  plan.size = 4.1;
  plan.region_size = {kNoSize, 4.1, 1.0};
  const OctreeRequest request = octant_request(plan);
  EXPECT_DOUBLE_EQ(request.size * kEdgePerOctant, 4.0);
  EXPECT_EQ(request.region_size.size(), 3u);
}

TEST(OctantSizes, SamplesAreRoundedToTheNearestLevelUnlessTheyForbidIt) {
  SizePlan plan;
  plan.samples = {{Vec3::Zero(), 1.0}, {Vec3::Zero(), 1.0, {}, SizeReason::kWall, true}};
  const auto samples = octant_samples(plan);
  EXPECT_DOUBLE_EQ(samples[0].size, M_SQRT2 / kEdgePerOctant);
  EXPECT_DOUBLE_EQ(samples[1].size, 1.0);
}

}  // namespace
}  // namespace octet
