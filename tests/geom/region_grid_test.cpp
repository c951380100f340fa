// SPDX-License-Identifier: BSD-3-Clause
// The coarse grid never contradicts the formula, and knows most of a compact part.
#include "geom/region_grid.h"

#include <gtest/gtest.h>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

TEST(RegionGrid, KnownCellsAreRightAndMany) {
  for (const auto& s : test::all_samples(test::tilted_frame())) {
    const RegionGrid grid(s.model.bvh(), s.model.box(), [&](const Vec3& p) { return s.model.region_at(p); });
    test::Dice dice(1);
    int known = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const int region = grid.at(p);
      if (region == RegionGrid::kUnknown) continue;
      ASSERT_EQ(region, s.depth(p) > 0 ? 1 : 0) << s.name;
      ++known;
    }
    EXPECT_GT(known, 2500) << s.name;
    EXPECT_EQ(grid.at(s.model.box().lo - Vec3::Ones()), RegionGrid::kUnknown);
  }
}

TEST(RegionGrid, NoBoundaryIsOnAClearSegment) {
  for (const auto& s : test::all_samples(test::tilted_frame())) {
    const RegionGrid grid(s.model.bvh(), s.model.box(), [&](const Vec3& p) { return s.model.region_at(p); });
    test::Dice dice(3);
    const double step = 0.02 * s.model.diagonal();
    int clear = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = dice.in(s.model.box());
      const Vec3 q = p + step * Vec3(dice(-1.0, 1.0), dice(-1.0, 1.0), dice(-1.0, 1.0));
      if (!grid.is_clear(p, q)) continue;
      ++clear;
      for (int k = 0; k <= 16; ++k) ASSERT_EQ(s.depth(p + k / 16.0 * (q - p)) > 0, s.depth(p) > 0) << s.name;
    }
    EXPECT_GT(clear, 1500) << s.name;
  }
}

TEST(RegionGrid, EmptyGridKnowsNothing) { EXPECT_EQ(RegionGrid().at(Vec3::Zero()), RegionGrid::kUnknown); }

}  // namespace
}  // namespace octet
