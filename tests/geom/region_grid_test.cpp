// SPDX-License-Identifier: BSD-3-Clause
// The coarse grid never contradicts the formula, and knows most of a compact part.
#include "geom/region_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

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

TEST(RegionGrid, CellsAroundASegmentHoldAllFacetsThatItMeets) {
  for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
    const FacetBvh& bvh = s.model.bvh();
    const RegionGrid grid(bvh, s.model.box(), [&](const Vec3& p) { return s.model.region_at(p); });
    test::Dice dice(3);
    const double step = 0.02 * s.model.diagonal();
    int answered = 0, met = 0, empty = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vec3 p = dice.in(s.model.box().grown(step));
      const Vec3 q = p + step * Vec3(dice(-1.0, 1.0), dice(-1.0, 1.0), dice(-1.0, 1.0));
      std::set<std::uint32_t> from_cells, from_tree;
      bool seen = false;
      if (!grid.visit_segment(p, q, [&](std::uint32_t item) {
            seen = true;
            if (bvh.item_meets(item, FacetBvh::Probe(p, q))) from_cells.insert(bvh.triangle(item));
          }))
        continue;
      bvh.visit_segment(p, q, [&](std::uint32_t t) { from_tree.insert(t); });
      ASSERT_TRUE(std::includes(from_cells.begin(), from_cells.end(), from_tree.begin(), from_tree.end()))
          << s.name;
      ++answered;
      met += from_tree.empty() ? 0 : 1;
      empty += seen ? 0 : 1;
    }
    EXPECT_GT(answered, 4000) << s.name;
    EXPECT_GT(met, 100) << s.name;
    EXPECT_GT(empty, 1500) << s.name;
  }
}

TEST(RegionGrid, AnEmptyGridKnowsNothing) {
  EXPECT_EQ(RegionGrid().at(Vec3::Zero()), RegionGrid::kUnknown);
  EXPECT_FALSE(RegionGrid().visit_segment(Vec3::Zero(), Vec3::Ones(), [](std::uint32_t) {}));
}

}  // namespace
}  // namespace octet
