// SPDX-License-Identifier: BSD-3-Clause
// The outline holds what the model holds, with closed and consistently signed boundaries.
#include "app/outline.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "geom/analytic.h"

namespace octet {
namespace {

TEST(Outline, CountsAndTagsAreTheModels) {
  const Model model = analytic_box(Vec3(1, 2, 3));
  const ModelOutline outline = outline_of(model);
  for (int dim = 0; dim < 4; ++dim) {
    const auto& entities = outline.entities[static_cast<std::size_t>(dim)];
    ASSERT_EQ(static_cast<int>(entities.size()), model.count(dim));
    for (std::size_t i = 0; i < entities.size(); ++i) EXPECT_EQ(entities[i].tag, static_cast<int>(i) + 1);
  }
}

TEST(Outline, BoundaryOfABoundaryIsNothing) {
  const Model model = analytic_two_boxes(Vec3(1, 2, 3));
  const ModelOutline outline = outline_of(model);
  for (std::size_t dim = 2; dim < 4; ++dim)
    for (const OutlineEntity& entity : outline.entities[dim]) {
      std::map<int, int> sum;
      for (const int part : entity.bounded_by) {
        const auto& side = outline.entities[dim - 1][static_cast<std::size_t>(std::abs(part)) - 1];
        for (const int corner : side.bounded_by) sum[std::abs(corner)] += (part > 0) == (corner > 0) ? 1 : -1;
      }
      for (const auto& [tag, times] : sum)
        EXPECT_EQ(times, 0) << "dimension " << dim << " entity " << entity.tag;
    }
}

TEST(Outline, BoxesHoldTheEntities) {
  const Model model = analytic_torus(3.0, 1.0);
  const ModelOutline outline = outline_of(model);
  const Box3& region = outline.entities[3][0].box;
  for (const double radius : {2.0, 4.0}) EXPECT_TRUE(region.contains(Vec3(radius, 0, 0)));
  EXPECT_TRUE(region.contains(Vec3(3, 0, 1)));
  EXPECT_TRUE(region.contains(Vec3(0, -4, 0)));
}

}  // namespace
}  // namespace octet
