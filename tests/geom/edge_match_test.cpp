// SPDX-License-Identifier: BSD-3-Clause
// Points on neighbouring edges against a search of all edges.
#include "geom/edge_match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/geom/sample_models.h"

namespace octet {
namespace {

using test::Dice;

TEST(EdgeIndex, FeetAreTheNearestPointsOfAllEdgesInReach) {
  int met = 0;
  for (const double most : {0.05, 0.4, 3.0, 200.0}) {
    for (const auto& s : test::all_samples(test::tilted_frame(), 0.05)) {
      const EdgeIndex index(s.model, most);
      Dice dice(3);
      for (int i = 0; i < 100; ++i) {
        const Vec3 p = dice.in(s.model.box().grown(0.2));
        const double reach = dice(0.0, 0.8);
        std::vector<int> expected, found;
        for (int e = 1; e <= s.model.count(1); ++e) {
          if (s.model.edge(e).use == EdgeUse::kReal &&
              s.model.edge_closest(e, p).distance <= std::min(reach, most))
            expected.push_back(e);
        }
        for (const EdgePartner& foot : index.feet(p, reach)) {
          found.push_back(foot.edge);
          EXPECT_NEAR((foot.point - p).norm(), s.model.edge_closest(foot.edge, p).distance, 1e-9) << s.name;
        }
        ASSERT_EQ(found, expected) << s.name << ", most " << most;
        met += static_cast<int>(found.size());
      }
    }
  }
  EXPECT_GT(met, 300);
}

TEST(EdgeIndex, PartnersOfAPointOnABoxLieStraightAcrossAndBesideItsCorner) {
  const Model box = analytic_box(Vec3(4.0, 1.0, 0.5));
  for (const double most : {1.2, 50.0}) {
    const EdgeIndex index(box, most);
    for (int e = 1; e <= box.count(1); ++e) {
      const ModelEdge& edge = box.edge(e);
      const double t = edge.t0 + 0.2 * (edge.t1 - edge.t0);
      const Vec3 a = box.edge_point(e, t), along = box.edge_derivative(e, t).normalized();
      int across = 0, beside = 0;
      for (const EdgePartner& b : index.partners(e, t, 1.15)) {
        const Vec3 way = b.point - a, other = box.edge_derivative(b.edge, b.t).normalized();
        EXPECT_LE(way.norm(), 1.15);
        EXPECT_NEAR((box.edge_point(b.edge, b.t) - b.point).norm(), 0.0, 1e-12);
        EXPECT_NEAR(std::abs(way.dot(along)), std::abs(way.dot(other)), 1e-9) << "equal angles";
        (std::abs(along.dot(other)) > 0.5 ? across : beside) += 1;
      }
      // Of the long edges the three beside them are in reach: 0.5, 1 and 1.118 away.
      if (edge.length > 3.0) {
        EXPECT_EQ(across, 3);
      }
      EXPECT_GT(across + beside, 0);
    }
  }
}

TEST(EdgeIndex, NoEdgeIsLookedForFartherAwayThanAskedFor) {
  const Model box = analytic_box(Vec3(4.0, 1.0, 0.5));
  const EdgeIndex near(box, 0.3);
  for (int e = 1; e <= box.count(1); ++e) {
    const ModelEdge& edge = box.edge(e);
    EXPECT_TRUE(edge.length < 3.0 || near.partners(e, 0.5 * (edge.t0 + edge.t1), 5.0).empty());
  }
  EXPECT_TRUE(near.feet(box.box().centre(), 5.0).empty());
}

}  // namespace
}  // namespace octet
