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

int middles(const std::array<int, 3>& p) { return static_cast<int>(std::ranges::count(p, 1)); }

/// The 26 places an octant's vertices can take, lattice 0..2.
std::vector<std::array<int, 3>> places() {
  std::vector<std::array<int, 3>> result;
  for (int n = 0; n < 27; ++n) {
    if (n != 13) result.push_back({n % 3, n / 3 % 3, n / 9});
  }
  return result;
}

/// Vertices that are there whenever p is: balance hangs all edges of a face in whose middle a vertex hangs.
std::set<std::array<int, 3>> with(const std::array<int, 3>& p) {
  std::set<std::array<int, 3>> result{p};
  if (middles(p) != 2) return result;
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] != 1) continue;
    for (const int end : {0, 2}) {
      auto q = p;
      q[axis] = end;
      result.insert(q);
    }
  }
  return result;
}

Vec3 vec(const std::array<int, 3>& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

/// Overhang in lengths of the octant of the sphere through four places, negative when no octant has it as an
/// empty circumsphere.
double overhang(const std::array<std::array<int, 3>, 4>& t, const std::set<std::array<int, 3>>& corners) {
  Eigen::Matrix3d m;
  Vec3 rhs;
  for (int i = 0; i < 3; ++i) {
    m.row(i) = 2.0 * (vec(t[i + 1]) - vec(t[0]));
    rhs[i] = vec(t[i + 1]).squaredNorm() - vec(t[0]).squaredNorm();
  }
  if (std::abs(m.determinant()) < 1e-9) return -1.0;
  const Vec3 centre = m.partialPivLu().solve(rhs);
  const double radius = (vec(t[0]) - centre).norm();
  std::set<std::array<int, 3>> there = corners;
  for (const auto& p : t) there.merge(with(p));
  for (const auto& p : there) {
    if ((vec(p) - centre).norm() < radius - 1e-9) return -1.0;
  }
  return 0.5 * std::max((Vec3::Constant(radius) - centre).maxCoeff(),
                        (centre - Vec3::Constant(2.0 - radius)).maxCoeff());
}

TEST(Interior, NoCircumsphereOfAnOctantOverhangsMoreThanHalfItsLength) {
  const auto all = places();
  std::set<std::array<int, 3>> corners;
  for (const auto& p : all) {
    if (middles(p) == 0) corners.insert(p);
  }
  double plain = 0.0, transition = 0.0;
  const std::size_t n = all.size();
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      for (std::size_t c = b + 1; c < n; ++c) {
        for (std::size_t d = c + 1; d < n; ++d) {
          const double over = overhang({all[a], all[b], all[c], all[d]}, corners);
          transition = std::max(transition, over);
          if (middles(all[a]) + middles(all[b]) + middles(all[c]) + middles(all[d]) == 0)
            plain = std::max(plain, over);
        }
      }
    }
  }
  EXPECT_NEAR(plain, (std::sqrt(3.0) - 1.0) / 2.0, 1e-12);
  EXPECT_NEAR(transition, 0.5, 1e-12);
  EXPECT_LT(plain, kPlainOverhang);
  EXPECT_LT(transition, kTransitionOverhang);
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

TEST(Interior, TemplateOctantsHaveAllTheirVertices) {
  const Model model = analytic_ball(0.5);
  const Labelled l = label(model, 0.06, kSamples);
  const auto kept = keep_inner(model, l, 0.6);
  const auto templates = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
  ASSERT_GT(templates.size(), 1000u);
  std::size_t hanging = 0;
  for (const OctantId t : templates) {
    EXPECT_EQ(l.labels.type[t.index()], OctantType::kIn);
    const OctantLattice lattice = octant_lattice(l.tree, l.vertices, t);
    for (const std::uint32_t v : lattice) EXPECT_TRUE(v == kNoVertex || kept[v] != 0);
    if (27 - std::ranges::count(lattice, kNoVertex) > 8) ++hanging;
  }
  EXPECT_GT(hanging, 20u);
}

TEST(Interior, CircumspheresOfPlainTemplateOctantsHoldNoPointOfTheBoundary) {
  for (const auto& [name, model, size] : test::analytic_models()) {
    const Labelled l = label(model, size / 2);
    const auto kept = keep_inner(model, l, 0.6);
    for (const OctantId t : template_octants(model, l.tree, l.vertices, l.labels, kept, {})) {
      const double length = l.tree.length(l.tree[t].level);
      EXPECT_FALSE(model.closest(l.tree.box(t).centre(), std::sqrt(0.75) * length)) << name;
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

TEST(Interior, BandVerticesArePillarsAndThoseOfOctantsThatAreNoTemplates) {
  const Model model = analytic_ball(0.5);
  const Labelled l = label(model, 0.06, kSamples);
  const auto kept = keep_inner(model, l, 0.6);
  const auto templates = template_octants(model, l.tree, l.vertices, l.labels, kept, {});
  const double length = 0.06;
  const auto band = band_vertices(l.tree, l.vertices, templates, kept, length);
  std::set<std::uint32_t> expected;
  std::size_t next = 0;
  for (std::size_t i = 0; i < l.tree.size(); ++i) {
    if (next < templates.size() && templates[next] == OctantId(i)) {
      ++next;
      continue;
    }
    const Box3 box = l.tree.box(OctantId(i));
    for (const std::uint32_t v : octant_lattice(l.tree, l.vertices, OctantId(i))) {
      if (v == kNoVertex || kept[v] == 0) continue;
      expected.insert(v);
      EXPECT_TRUE(box.contains(l.tree.position(l.vertices.at[v])));
    }
  }
  ASSERT_EQ(next, templates.size());
  const Lattice::value_type spacing = pillar_spacing(l.tree, length);
  EXPECT_NEAR(l.tree.length(0) * spacing / (1u << kLatticeLevels), 8 * length, 1e-3 * length);
  for (std::uint32_t v = 0; v < kept.size(); ++v)
    if (kept[v] != 0 && is_pillar(l.vertices.at[v], spacing)) expected.insert(v);
  for (std::uint32_t v = 0; v < band.size(); ++v) EXPECT_EQ(band[v] != 0, expected.contains(v));
  EXPECT_LT(expected.size(), static_cast<std::size_t>(std::ranges::count(kept, 1)));
}

}  // namespace
}  // namespace octet
