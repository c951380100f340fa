// SPDX-License-Identifier: BSD-3-Clause
// What the faces make of edges and vertices, against a search of all faces for each.
#include "classify/expected_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geom/analytic.h"

namespace octet {
namespace {

TEST(ExpectedFaces, AtEachEdgeAreTheFacesWithASideAlongIt) {
  const AnalyticOptions coarse{{}, 1e-2};
  for (const Model& model : {analytic_two_boxes(Vec3(1.0, 2.0, 3.0)), analytic_wedge(0.5, 2.0, 1.0),
                             analytic_cylinder(1.0, 2.0, coarse), analytic_cone(1.0, 2.0, coarse),
                             analytic_torus(2.0, 0.5, coarse)}) {
    const ExpectedFaces expected(model);
    std::size_t met = 0;
    for (int e = 1; e <= model.count(1); ++e) {
      std::vector<int> faces;
      for (int f = 1; f <= model.count(2); ++f)
        for (const FaceBoundary& side : model.face(f).boundary)
          if (side.edge == e) faces.push_back(f);
      EXPECT_TRUE(std::ranges::equal(expected.at_edge(e), faces)) << "Edge " << e;
      met += faces.size();
    }
    EXPECT_GT(met, 0u);
  }
}

TEST(ExpectedFaces, OfABoxTwoAtEachEdgeAndNoneWithoutAnEdge) {
  const Model box = analytic_box(Vec3(1.0, 2.0, 3.0));
  const ExpectedFaces expected(box);
  for (int e = 1; e <= box.count(1); ++e) {
    ASSERT_EQ(expected.at_edge(e).size(), 2u);
    EXPECT_LT(expected.at_edge(e)[0], expected.at_edge(e)[1]);
  }
  for (int v = 1; v <= box.count(0); ++v) EXPECT_EQ(expected.edgeless_at(v), 0);
}

TEST(ExpectedFaces, AConesTipLiesInAFaceWithoutAnEdge) {
  const Model cone = analytic_cone(1.0, 2.0, {{}, 1e-3});
  const ExpectedFaces expected(cone);
  int tips = 0;
  for (int v = 1; v <= cone.count(0); ++v) tips += expected.edgeless_at(v);
  EXPECT_EQ(tips, 1);
}

}  // namespace
}  // namespace octet
