// SPDX-License-Identifier: BSD-3-Clause
// Model::intersect loses and adds nothing against every surface asked without facets.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <algorithm>
#include <string_view>

#include "geom/occt/from_shape.h"
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

/// The chamfer of a square head: the planes cut the cone in hyperbolas, nearly straight in space, well curved
/// in (u,v). Segments along the normal beside the middles of the border's facet sides.
TEST(IntersectBesideABorder, KeepsToTheTrimWhereTheFacetsBulgeOverIt) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(11.0, 5.0, 2.0).Shape();
  const TopoDS_Shape bar = BRepPrimAPI_MakeBox(gp_Pnt(-7, -7, -1), gp_Pnt(7, 7, 5)).Shape();
  ReadOptions coarse;
  coarse.facet_deflection = 0.05;
  const Model model = model_from_shape(BRepAlgoAPI_Common(cone, bar).Shape(), coarse);
  const Facets& facets = model.facets();
  int asked = 0, outside = 0, wrong = 0;
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const int face = facets.face[i];
    if (std::string_view(model.surface(face).kind()) != "cone") continue;
    for (int k = 0; k < 3; ++k)
      for (const double inwards : {0.001, 0.01, 0.05, 0.2}) {
        const auto& uv = facets.uv[i];
        const Vec2 middle = 0.5 * (uv[k] + uv[(k + 1) % 3]);
        const Vec2 at = middle + inwards * (uv[(k + 2) % 3] - middle);
        const Vec3 x = model.face_jet(face, at, 0).p, n = 0.01 * model.face_normal(face, at);
        hits.clear();
        model.intersect(x - n, x + n, hits);
        const TrimSide side = model.face_side(face, at);
        const bool hit =
            std::any_of(hits.begin(), hits.end(), [&](const Hit& h) { return h.on == model_face(face); });
        ++asked;
        outside += side == TrimSide::kOut;
        wrong += (side == TrimSide::kIn && !hit) || (side == TrimSide::kOut && hit);
      }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(asked, 100);
  EXPECT_GT(outside, 10);
}

INSTANTIATE_TEST_SUITE_P(Samples, Intersect,
                         ::testing::Values("ball", "blade", "box", "box_minus_ball", "bracket", "cone",
                                           "cylinder", "plate_with_hole", "torus", "two_boxes"),
                         [](const auto& sample) { return std::string(sample.param); });

}  // namespace
}  // namespace octet::test
