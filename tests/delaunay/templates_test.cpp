// SPDX-License-Identifier: BSD-3-Clause
// Templates are the global triangulation of balanced octrees, octant by octant.
#include "delaunay/templates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "base/predicates.h"
#include "tests/delaunay/balanced_octree.h"

namespace octet {
namespace {

using namespace testing;

Vec3 at(int point) { return Vec3(point % 3, point / 3 % 3, point / 9); }

// Smallest dihedral angle of the tetrahedra, in degrees.
double smallest_dihedral(const OctantTets& tets) {
  double smallest = 180;
  for (const auto& t : tets) {
    Vec3 normal[4];
    for (int f = 0; f < 4; ++f) {
      const Vec3 a = at(t[kTetFace[f][0]]), b = at(t[kTetFace[f][1]]), c = at(t[kTetFace[f][2]]);
      normal[f] = (b - a).cross(c - a).normalized();
    }
    for (int f = 0; f < 4; ++f) {
      for (int g = f + 1; g < 4; ++g) {
        const double angle = std::numbers::pi - std::acos(std::clamp(normal[f].dot(normal[g]), -1.0, 1.0));
        smallest = std::min(smallest, angle * 180 / std::numbers::pi);
      }
    }
  }
  return smallest;
}

// The global triangulation, split by the octant that holds each tetrahedron.
std::map<TestOctant, TetSet> tets_by_octant(const BalancedOctree& tree) {
  std::map<TestOctant, TetSet> result;
  const Triangulation triangulation = triangulate(tree.vertices());
  EXPECT_EQ(check_triangulation(triangulation), "");
  for (const auto& t : tet_set(triangulation)) {
    Vec3 centre = Vec3::Zero();
    for (const auto v : t) centre += 0.25 * tree.vertices().points[v];
    const TestOctant o = tree.find({static_cast<std::uint32_t>(centre.x() * 0x1p18),
                                    static_cast<std::uint32_t>(centre.y() * 0x1p18),
                                    static_cast<std::uint32_t>(centre.z() * 0x1p18)});
    const Vec3 lo = Vec3(o.corner[0], o.corner[1], o.corner[2]) * 0x1p-18;
    const Box3 box{lo, lo + Vec3::Constant(o.extent() * 0x1p-18)};
    for (const auto v : t) EXPECT_TRUE(box.contains(tree.vertices().points[v]));
    result[o].push_back(t);
  }
  return result;
}

TetSet named(const OctantTets& tets, const std::array<std::int64_t, 27>& points) {
  TetSet set;
  for (const auto& t : tets) {
    std::array<std::uint32_t, 4> vertices{};
    for (int k = 0; k < 4; ++k) vertices[k] = static_cast<std::uint32_t>(points[t[k]]);
    set.push_back(testing::canonical(vertices));
  }
  std::sort(set.begin(), set.end());
  return set;
}

TEST(Templates, AreTheGlobalTriangulationOfBalancedOctrees) {
  TemplateTable table;
  std::set<std::uint32_t> masks;
  int plain = 0, transition = 0;
  double least_plain = 180, least_transition = 180;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Engine engine(seed);
    const BalancedOctree tree(2, 5, 0.2 + 0.05 * seed, engine);
    const auto by_octant = tets_by_octant(tree);
    ASSERT_EQ(by_octant.size(), tree.leaves().size());
    for (const TestOctant& o : tree.leaves()) {
      const OctantPattern pattern = tree.pattern_of(o);
      const OctantTets& tets = table.tets(pattern);
      ASSERT_EQ(named(tets, tree.points_of(o)), by_octant.at(o));
      masks.insert(pattern.hanging);
      if (pattern.hanging == 0) {
        ++plain;
        ASSERT_EQ(tets.size(), 5u);
        least_plain = std::min(least_plain, smallest_dihedral(tets));
      } else {
        ++transition;
        least_transition = std::min(least_transition, smallest_dihedral(tets));
      }
    }
  }
  EXPECT_GT(plain, 2000);
  EXPECT_GT(transition, 1000);
  EXPECT_GT(masks.size(), 300u);
  EXPECT_GT(least_plain, 54.7);
  EXPECT_GE(least_transition, 17.0);
}

TEST(Templates, NumberingIsTheDrawnOne) {
  for (int b = 0; b < 18; ++b) {
    const Vec3 p = at(kHangingPoint[b]);
    const int ones = (p.x() == 1) + (p.y() == 1) + (p.z() == 1);
    EXPECT_EQ(ones, b < 12 ? 1 : 2);
  }
  for (const std::uint8_t c : kCornerPoint) {
    EXPECT_TRUE((at(c).array() != 1).all());
  }
}

TEST(Templates, FillTheOctantForEveryMaskWithPositiveTetrahedra) {
  // Masks of hanging points are arbitrary here, ranks too: the table must not rely on balance.
  TemplateTable table;
  Engine engine(77);
  for (int n = 0; n < 400; ++n) {
    OctantPattern pattern;
    pattern.hanging = static_cast<std::uint32_t>(below(engine, 1u << 18));
    const auto order = shuffled(27, engine);
    for (int k = 0; k < 27; ++k) {
      pattern.rank[k] = (std::uint64_t{below(engine, 4)} << kRankClassShift) | order[k];
    }
    double volume = 0;
    for (const auto& t : table.tets(pattern)) {
      ASSERT_EQ(orient3d(at(t[0]), at(t[1]), at(t[2]), at(t[3])), 1);
      volume += (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).dot(at(t[3]) - at(t[0])) / 6;
    }
    ASSERT_NEAR(volume, 8.0, 1e-12);
  }
}

TEST(Templates, TheSameKeyIsTriangulatedOnce) {
  TemplateTable table;
  OctantPattern pattern;
  for (std::size_t k = 0; k < 27; ++k) pattern.rank[k] = 100 + k;
  const OctantTets& first = table.tets(pattern);
  for (std::size_t k = 0; k < 27; ++k) pattern.rank[k] = 1000 + 7 * k;
  EXPECT_EQ(&table.tets(pattern), &first);
  EXPECT_EQ(table.size(), 1u);
}

}  // namespace
}  // namespace octet
