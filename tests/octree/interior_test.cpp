// SPDX-License-Identifier: BSD-3-Clause
#include "octree/interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/octree/labelled_models.h"

namespace octet {
namespace {

using test::label;
using test::Labelled;

TEST(Interior, SpheresBetweenTwoOctantsReachNoFartherThanTheOverhang) {
  // Centres of octants of length 1 at z = -1/2 and 1/2, an edge of the face between them at y = 1/2.
  const std::array<Vec3, 4> t{Vec3(0, 0, -0.5), Vec3(0, 0, 0.5), Vec3(0.5, 0.5, 0), Vec3(-0.5, 0.5, 0)};
  const Vec3 centre(0, 0.25, 0);
  const double radius = (t[0] - centre).norm();
  for (const Vec3& p : t) EXPECT_NEAR((p - centre).norm(), radius, 1e-15);
  EXPECT_LT(radius, 1.0);                                                 // along the line
  EXPECT_NEAR(radius + 0.25 - 0.5, (std::sqrt(5.0) - 1.0) / 4.0, 1e-15);  // sideways
  EXPECT_LT(radius + 0.25 - 0.5, kOverhang);
}

/// Keeps the octree vertices of region 1 that are farther than `share` of the local size from the surface.
std::vector<std::uint8_t> keep_inner(const Model& model, const Labelled& l, double share) {
  std::vector<std::uint8_t> kept(l.vertices.size());
  for (std::size_t v = 0; v < kept.size(); ++v) {
    const double reach = share * l.tree.length(l.vertices.finest_level[v]);
    kept[v] =
        l.labels.vertex_region[v] == 1 && !model.closest(l.tree.position(l.vertices.at[v]), reach) ? 1 : 0;
  }
  return kept;
}

const std::vector<SizeSample> kSamples{{Vec3(0.5, 0.0, 0.0), 0.02}, {Vec3(0.1, 0.1, 0.1), 0.02}};

TEST(Interior, TemplateOctantsHaveAllTheirVerticesAndNoneHangs) {
  const Model model = analytic_ball(0.5);
  const Labelled l = label(model, 0.06, kSamples);
  const auto kept = keep_inner(model, l, 0.6);
  const auto templates = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
  constexpr int kCornersAndCentre = 9;
  ASSERT_GT(templates.size(), 1000u);
  for (const OctantId t : templates) {
    EXPECT_EQ(l.labels.type[t.index()], OctantType::kIn);
    const OctantLattice lattice = octant_lattice(l.vertices, t);
    for (const std::uint32_t v : lattice) EXPECT_TRUE(v == kNoVertex || kept[v] != 0);
    EXPECT_EQ(27 - std::ranges::count(lattice, kNoVertex), kCornersAndCentre);
  }
}

TEST(Interior, CircumspheresBetweenTemplateOctantsHoldNoPointOfTheBoundary) {
  for (const auto& [name, model, size] : test::analytic_models()) {
    const Labelled l = label(model, size / 2);
    const auto kept = keep_inner(model, l, 0.45);
    std::vector<std::uint8_t> is_template(l.tree.size(), 0);
    const auto templates = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
    for (const OctantId t : templates) is_template[t.index()] = 1;
    for (const OctantId t : templates) {
      const double length = l.tree.length(l.tree[t].level);
      for (int axis = 0; axis < 3; ++axis) {
        const auto other = l.tree.across(t, axis, true);
        if (!other || is_template[other->index()] == 0) continue;
        const Vec3 middle = 0.5 * (l.tree.box(t).centre() + l.tree.box(*other).centre());
        for (const int sideways : {1, 2}) {
          for (const double sign : {-0.25, 0.25}) {
            const Vec3 centre = middle + sign * length * Vec3::Unit((axis + sideways) % 3);
            EXPECT_FALSE(model.closest(centre, 0.559 * length)) << name;
          }
        }
      }
    }
  }
}

TEST(Interior, MostOctantsOfAThickPartAreTemplates) {
  const Model model = analytic_box(Vec3(1.0, 1.0, 1.0));
  const Labelled l = label(model, 1.0 / 20);
  const auto templates = template_octants(model, l.tree, l.vertices, l.labels, keep_inner(model, l, 0.6), {});
  EXPECT_GE(templates.size(), 17u * 17 * 17);
  EXPECT_LE(templates.size(), 19u * 19 * 19);
}

TEST(Interior, AFreePointInsideKeepsTheOctantsAroundItOut) {
  const Model model = analytic_ball(0.5);
  const Labelled l = label(model, 0.06);
  const auto kept = keep_inner(model, l, 0.6);
  const auto without = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
  SeedPoints points;
  points.add(Vec3(0.01, 0.02, 0.03), model_region(1), free_point_rank(0), 0.06);
  points.add(Vec3(0.5, 0.0, 0.0), model_face(1), free_point_rank(1), 0.06);
  const auto with_point = template_octants(model, l.tree, l.vertices, l.labels, kept, points);
  EXPECT_EQ(with_point.size() + 27, without.size());
  for (const OctantId t : with_point) {
    const double length = l.tree.length(l.tree[t].level);
    EXPECT_GT((l.tree.box(t).centre() - points.position[0]).norm(), std::sqrt(0.75) * length);
  }
}

TEST(Interior, BandVerticesArePillarsAndThoseOfTetrahedraThatAreNotBetweenTemplates) {
  const Model model = analytic_ball(0.5);
  const Labelled l = label(model, 0.06, kSamples);
  const auto kept = keep_inner(model, l, 0.6);
  const auto templates = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
  const double length = 0.06;
  const auto band = band_vertices(l.tree, l.vertices, templates, kept, length);
  const std::set<OctantId> is_template(templates.begin(), templates.end());
  std::set<std::uint32_t> expected;
  const auto expect = [&](std::uint32_t v) {
    if (v != kNoVertex && kept[v] != 0) expected.insert(v);
  };
  for (std::size_t i = 0; i < l.tree.size(); ++i) {
    const OctantId o(i);
    if (!is_template.contains(o)) {
      for (const std::uint32_t v : octant_lattice(l.vertices, o)) expect(v);
      continue;
    }
    for (int face = 0; face < 6; ++face) {
      const auto other = l.tree.across(o, face / 2, face % 2 != 0);
      if (!other || !is_template.contains(*other)) expect(l.vertices.centre(o));
    }
  }
  const Lattice::value_type spacing = pillar_spacing(l.tree, length);
  EXPECT_NEAR(l.tree.length(0) * spacing / (1u << kLatticeLevels), 8 * length, 1e-3 * length);
  for (std::uint32_t v = 0; v < kept.size(); ++v)
    if (is_pillar(l.vertices.at[v], spacing)) expect(v);
  for (std::uint32_t v = 0; v < band.size(); ++v) EXPECT_EQ(band[v] != 0, expected.contains(v));
  EXPECT_LT(expected.size(), static_cast<std::size_t>(std::ranges::count(kept, 1)));
}

}  // namespace
}  // namespace octet
