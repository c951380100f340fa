// SPDX-License-Identifier: BSD-3-Clause
// Model::intersect loses and adds nothing against every surface asked without facets.
#include <gtest/gtest.h>

#include <algorithm>

#include "lattice_segments.h"
#include "sample_parts.h"
#include "slow_reference.h"

namespace octet::test {
namespace {

class Intersect : public ::testing::TestWithParam<const char*> {};

TEST_P(Intersect, FindsWhatEverySurfaceFindsWithoutFacets) {
  const Model model = sample(GetParam());
  LatticeSegments segments(model);
  const int count = 20000;
  int differences = 0, hits_seen = 0;
  std::vector<Hit> hits;
  for (int i = 0; i < count; ++i) {
    const auto [p, q] = segments.next();
    hits.clear();
    model.intersect(p, q, hits);
    const std::vector<double> expected = events_without_facets(model, p, q);
    hits_seen += static_cast<int>(hits.size());
    const double near = 1e-6 * model.diagonal() / (q - p).norm();
    for (const double t : expected)
      differences +=
          std::none_of(hits.begin(), hits.end(), [&](const Hit& hit) { return std::abs(hit.t - t) < near; });
    for (const Hit& hit : hits)
      differences += std::none_of(expected.begin(), expected.end(),
                                  [&](double t) { return std::abs(hit.t - t) < near; });
  }
  EXPECT_EQ(differences, 0);
  EXPECT_GT(hits_seen, count / 4);
}

TEST_P(Intersect, HitsLeadFromRegionToRegion) {
  const Model model = sample(GetParam());
  LatticeSegments segments(model);
  std::vector<Hit> hits;
  for (int i = 0; i < 1000; ++i) {
    const auto [p, q] = segments.next();
    hits.clear();
    model.intersect(p, q, hits);
    int region = model.region_at(p);
    for (const Hit& hit : hits) {
      if (hit.kind != HitKind::kTransversal || hit.on.dim != 2) break;
      const auto& sides = model.face(hit.face).region;
      const bool forward = hit.normal.dot(q - p) > 0.0;
      EXPECT_EQ(sides[forward ? 0 : 1], region);
      region = sides[forward ? 1 : 0];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Intersect,
                         ::testing::Values("ball", "blade", "box", "box_minus_ball", "bracket", "cone",
                                           "cylinder", "plate_with_hole", "torus", "two_boxes"),
                         [](const auto& sample) { return std::string(sample.param); });

}  // namespace
}  // namespace octet::test
