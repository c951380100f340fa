// SPDX-License-Identifier: BSD-3-Clause
// Topology, facets and measures of the analytic models.
#include "geom/analytic.h"

#include <gtest/gtest.h>

#include <map>

#include "geom/facet_volumes.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

std::array<int, 4> counts(const Model& m) { return {m.count(0), m.count(1), m.count(2), m.count(3)}; }

TEST(Analytic, EntitiesAreCountedAsCadKernelsDo) {
  using A = std::array<int, 4>;
  EXPECT_EQ(counts(analytic_box(Vec3(1, 2, 3))), (A{8, 12, 6, 1}));
  EXPECT_EQ(counts(analytic_two_boxes(Vec3(1, 2, 3))), (A{12, 20, 11, 2}));
  EXPECT_EQ(counts(analytic_wedge(0.2, 2, 1)), (A{6, 9, 5, 1}));
  EXPECT_EQ(counts(analytic_ball(1)), (A{2, 3, 1, 1}));
  EXPECT_EQ(counts(analytic_hollow_ball(2, 1)), (A{4, 6, 2, 1}));
  EXPECT_EQ(counts(analytic_box_minus_ball(3, 1)), (A{10, 15, 7, 1}));
  EXPECT_EQ(counts(analytic_cylinder(1, 2)), (A{2, 3, 3, 1}));
  EXPECT_EQ(counts(analytic_cone(1, 2)), (A{2, 3, 2, 1}));
  EXPECT_EQ(counts(analytic_torus(2, 1)), (A{1, 2, 1, 1}));
}

TEST(Analytic, FacetsCloseAndTheirVolumeIsThatOfTheShape) {
  for (const auto& frame : {Frame{}, test::tilted_frame()})
    for (const auto& s : test::all_samples(frame, 1e-3)) {
      EXPECT_NEAR(s.model.region(1).volume, s.volume, 1e-12 * s.volume) << s.name;
      EXPECT_NEAR(facet_volumes(s.model.parts())[1], s.volume, 5e-3 * s.volume) << s.name;
      std::map<std::pair<unsigned, unsigned>, int> uses;
      for (const auto& t : s.model.facets().triangles)
        for (int k = 0; k < 3; ++k) {
          const unsigned a = t[k], b = t[(k + 1) % 3];
          uses[std::minmax(a, b)] += a < b ? 1 : -1;
        }
      for (const auto& [side, sum] : uses) ASSERT_EQ(sum, 0) << s.name;
    }
}

TEST(Analytic, FacetsStayWithinTheDeflection) {
  for (const auto& s : test::all_samples({}, 1e-3)) {
    for (int f = 1; f <= s.model.count(2); ++f)
      EXPECT_LE(s.model.facets().deviation[f], 1.5e-3) << s.name << " face " << f;
    for (const Vec3& n : s.model.facets().nodes) {
      const double depth = s.depth(n);
      ASSERT_TRUE(std::abs(depth) < 1e-12 || s.name != "ball") << depth;
    }
  }
}

TEST(Analytic, FacetAreasAddUpToTheFaces) {
  for (const auto& s : test::all_samples(test::tilted_frame(), 1e-3)) {
    std::vector<double> area(s.model.count(2) + 1, 0.0);
    const Facets& f = s.model.facets();
    for (std::size_t i = 0; i < f.triangles.size(); ++i) {
      const auto& t = f.triangles[i];
      area[f.face[i]] += triangle_area(f.nodes[t[0]], f.nodes[t[1]], f.nodes[t[2]]);
    }
    for (int k = 1; k <= s.model.count(2); ++k)
      EXPECT_NEAR(area[k], s.model.face(k).area, 5e-3 * s.model.face(k).area) << s.name << " face " << k;
  }
}

TEST(Analytic, EulerNumbersOfFacesAreThoseOfTheirFacets) {
  for (const auto& s : test::all_samples()) {
    for (int face = 1; face <= s.model.count(2); ++face) {
      std::map<unsigned, int> nodes;
      std::map<std::pair<unsigned, unsigned>, int> sides;
      int triangles = 0;
      const Facets& f = s.model.facets();
      for (std::size_t i = 0; i < f.triangles.size(); ++i) {
        if (f.face[i] != face) continue;
        ++triangles;
        for (int k = 0; k < 3; ++k) {
          nodes[f.triangles[i][k]] = 1;
          sides[std::minmax(f.triangles[i][k], f.triangles[i][(k + 1) % 3])] = 1;
        }
      }
      const int euler = static_cast<int>(nodes.size()) - static_cast<int>(sides.size()) + triangles;
      EXPECT_EQ(euler, s.model.face(face).euler) << s.name << " face " << face;
    }
  }
}

TEST(Analytic, FacetCornersCarryTheirSurfaceParameters) {
  for (const auto& s : test::all_samples(test::tilted_frame())) {
    const Facets& f = s.model.facets();
    for (std::size_t i = 0; i < f.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Vec3 x = s.model.face_jet(f.face[i], f.uv[i][k], 0).p;
        ASSERT_LT((x - f.nodes[f.triangles[i][k]]).norm(), 1e-12 * s.model.diagonal() + 1e-14) << s.name;
      }
  }
}

TEST(Analytic, FacesLieToTheLeftOfTheirBoundary) {
  for (const auto& s : test::all_samples(test::tilted_frame())) {
    for (int f = 1; f <= s.model.count(2); ++f)
      for (const FaceBoundary& b : s.model.face(f).boundary) {
        const ModelEdge& edge = s.model.edge(b.edge);
        if (edge.use != EdgeUse::kReal) continue;
        const double t = edge.t0 + 0.37 * (edge.t1 - edge.t0);
        const Vec3 x = s.model.edge_point(b.edge, t);
        const FaceFoot foot = s.model.face_project(f, x);
        const Vec3 left = b.sense * foot.normal.cross(s.model.edge_derivative(b.edge, t)).normalized();
        const FaceFoot in = s.model.face_project(f, x + 1e-3 * left);
        EXPECT_EQ(s.model.face_side(f, in.uv), TrimSide::kIn)
            << s.name << " face " << f << " edge " << b.edge;
        const FaceFoot out = s.model.face_project(f, x - 1e-3 * left);
        EXPECT_EQ(s.model.face_side(f, out.uv), TrimSide::kOut)
            << s.name << " face " << f << " edge " << b.edge;
      }
  }
}

}  // namespace
}  // namespace octet
