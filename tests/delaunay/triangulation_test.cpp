// SPDX-License-Identifier: BSD-3-Clause
// The triangulation is Delaunay, unique, and keeps its invariants on degenerate sets.
#include "delaunay/triangulation.h"

#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "base/predicates.h"
#include "tests/delaunay/balanced_octree.h"
#include "tests/delaunay/point_sets.h"

namespace octet {
namespace {

using namespace testing;

double volume(const TetMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.ghost(t)) continue;
    const auto& v = mesh.tets[t];
    const Vec3 a = mesh.points[v[0]];
    sum += (mesh.points[v[1]] - a).cross(mesh.points[v[2]] - a).dot(mesh.points[v[3]] - a) / 6;
  }
  return sum;
}

// Every ranked circumsphere against every point.
void expect_empty_spheres(const RankedPoints& set, const TetSet& tets) {
  for (const auto& t : tets) {
    for (std::uint32_t e = 0; e < set.size(); ++e) {
      if (e == t[0] || e == t[1] || e == t[2] || e == t[3]) continue;
      const std::uint64_t rank[5] = {set.ranks[t[0]], set.ranks[t[1]], set.ranks[t[2]], set.ranks[t[3]],
                                     set.ranks[e]};
      ASSERT_LT(insphere_ranked(set.points[t[0]], set.points[t[1]], set.points[t[2]], set.points[t[3]],
                                set.points[e], rank),
                0);
    }
  }
}

// Four points that span space first, then the others one by one in a shuffled order.
TetSet one_by_one(const RankedPoints& set, Engine& engine) {
  std::vector<std::uint32_t> order = shuffled(set.size(), engine);
  const auto flat = [&] {
    return orient3d(set.points[order[0]], set.points[order[1]], set.points[order[2]], set.points[order[3]]) ==
           0;
  };
  while (flat()) order = shuffled(set.size(), engine);
  RankedPoints first;
  for (int i = 0; i < 4; ++i) first.add(set.points[order[i]], set.ranks[order[i]]);
  Triangulation triangulation = triangulate(first);
  std::vector<TetId> created;
  for (std::size_t i = 4; i < order.size(); ++i) {
    EXPECT_EQ(triangulation.insert(set.points[order[i]], set.ranks[order[i]], TetId(), created), VertexId(i));
  }
  EXPECT_EQ(check_triangulation(triangulation), "");
  return tet_set(triangulation, order);
}

void expect_unique(const RankedPoints& set, Engine& engine) {
  const Triangulation whole = triangulate(set);
  ASSERT_EQ(check_triangulation(whole), "");
  const TetSet tets = tet_set(whole);
  ASSERT_EQ(one_by_one(set, engine), tets);
  RankedPoints permuted;
  const auto order = shuffled(set.size(), engine);
  for (const auto i : order) permuted.add(set.points[i], set.ranks[i]);
  ASSERT_EQ(tet_set(triangulate(permuted), order), tets);
}

TEST(Triangulation, FourPointsMakeOneTetrahedronAndFourGhosts) {
  RankedPoints set;
  set.add({0, 0, 0}, 0);
  set.add({1, 0, 0}, 1);
  set.add({0, 1, 0}, 2);
  set.add({0, 0, 1}, 3);
  const Triangulation triangulation = triangulate(set);
  EXPECT_EQ(check_triangulation(triangulation), "");
  EXPECT_EQ(tet_set(triangulation), (TetSet{{0, 1, 2, 3}}));
  EXPECT_EQ(triangulation.mesh().tets.size(), 5u);
  std::vector<TetId> star;
  triangulation.star(VertexId(0), star);
  EXPECT_EQ(star.size(), 4u);
}

TEST(Triangulation, RefusesPointsOfOnePlane) {
  RankedPoints set;
  for (int i = 0; i < 10; ++i) set.add({0.1 * i, 0.7 * i * i, 0.25}, static_cast<std::uint64_t>(i));
  EXPECT_THROW(triangulate(set), InputError);
  RankedPoints line;
  for (int i = 0; i < 10; ++i) line.add({1.0 * i, 2.0 * i, 3.0 * i}, static_cast<std::uint64_t>(i));
  EXPECT_THROW(triangulate(line), InputError);
}

TEST(Triangulation, StartsFromAnyFourPointsThatSpanSpace) {
  RankedPoints set;
  for (int i = 0; i < 6; ++i) set.add({1.0 * i, 1.0 * i, 0}, static_cast<std::uint64_t>(i));
  set.add({0, 3, 0}, 10);
  set.add({5, 3, 0}, 11);
  set.add({2, 2, 4}, 12);
  const Triangulation triangulation = triangulate(set);
  EXPECT_EQ(check_triangulation(triangulation), "");
  expect_empty_spheres(set, tet_set(triangulation));
}

TEST(Triangulation, EmptySpheresOfRandomPoints) {
  Engine engine(1);
  for (int n = 5; n < 80; n += 5) {
    const RankedPoints set = random_points(static_cast<std::size_t>(n), engine);
    const Triangulation triangulation = triangulate(set);
    ASSERT_EQ(check_triangulation(triangulation), "");
    expect_empty_spheres(set, tet_set(triangulation));
  }
}

TEST(Triangulation, EmptySpheresAndFullVolumeOfLattices) {
  Engine engine(2);
  for (int n = 2; n < 6; ++n) {
    const RankedPoints set = lattice_points(n, 3, n, 1.0, engine);
    const Triangulation triangulation = triangulate(set);
    ASSERT_EQ(check_triangulation(triangulation), "");
    expect_empty_spheres(set, tet_set(triangulation));
    EXPECT_NEAR(volume(triangulation.mesh()), (n - 1) * 2.0 * (n - 1), 1e-10);
  }
}

TEST(Triangulation, EmptySpheresOfMixedPoints) {
  Engine engine(3);
  for (int n = 0; n < 4; ++n) {
    const RankedPoints set = mixed_points(4, engine);
    const Triangulation triangulation = triangulate(set);
    ASSERT_EQ(check_triangulation(triangulation), "");
    expect_empty_spheres(set, tet_set(triangulation));
  }
}

TEST(Triangulation, IsTheSameForEveryOrderOfRandomPoints) {
  Engine engine(4);
  for (int n = 0; n < 3; ++n) expect_unique(random_points(600, engine), engine);
}

TEST(Triangulation, IsTheSameForEveryOrderOfLattices) {
  Engine engine(5);
  for (int n = 0; n < 6; ++n) expect_unique(lattice_points(5, 4, 6, 0.1, engine), engine);
  expect_unique(lattice_points(9, 9, 9, 0.7, engine), engine);
}

TEST(Triangulation, IsTheSameForEveryOrderOfMixedPoints) {
  Engine engine(6);
  for (int n = 0; n < 4; ++n) expect_unique(mixed_points(6, engine), engine);
}

TEST(Triangulation, IsTheSameForEveryOrderOfOctreeVertices) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    Engine engine(seed);
    expect_unique(BalancedOctree(1, 4, 0.3, engine).vertices(), engine);
  }
}

TEST(Triangulation, IsTheSameForEveryOrderOfOctreeVerticesAndFreePoints) {
  for (unsigned seed = 1; seed < 5; ++seed) {
    Engine engine(seed);
    RankedPoints set = BalancedOctree(1, 4, 0.3, engine).vertices();
    for (std::uint64_t n = 0; n < 300; ++n) {
      Vec3 p(real(engine), real(engine), real(engine));
      if (n % 2 == 0) p.x() = 0.375;  // many cospherical and coplanar with vertices
      if (n % 4 == 0) p.y() = 0.5;
      set.add(p, free_point_rank(n));
    }
    expect_unique(set, engine);
  }
}

TEST(Triangulation, IsTheSameForEveryOrderOfCosphericalPoints) {
  // Integer points on the sphere of radius 15 about the origin, and the origin.
  Engine engine(7);
  RankedPoints set;
  for (int x = -15; x <= 15; ++x) {
    for (int y = -15; y <= 15; ++y) {
      for (int z = -15; z <= 15; ++z) {
        if (x * x + y * y + z * z == 225) set.add(Vec3(x, y, z), set.size());
      }
    }
  }
  ASSERT_GT(set.size(), 60u);
  expect_unique(set, engine);
  set.add({0, 0, 0}, 1000);
  expect_unique(set, engine);
}

TEST(Triangulation, RanksDecideTheDiagonals) {
  Engine engine(8);
  std::vector<TetSet> seen;
  for (int n = 0; n < 30; ++n) {
    const TetSet tets = tet_set(triangulate(lattice_points(2, 2, 2, 1.0, engine)));
    ASSERT_TRUE(tets.size() == 5 || tets.size() == 6);
    seen.push_back(tets);
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  EXPECT_GT(seen.size(), 4u);
}

RankedPoints cube(const std::array<std::uint64_t, 8>& ranks) {
  RankedPoints set;
  for (int c = 0; c < 8; ++c) set.add(Vec3(c & 1, c >> 1 & 1, c >> 2), ranks[c]);
  return set;
}

TEST(Triangulation, AHeavyCornerOfACubeJoinsToAll) {
  // The heaviest octree vertex is in every conflict: all cells of the cube have it.
  constexpr std::uint64_t kOctreeVertex = std::uint64_t{1} << 63;
  for (std::uint64_t h = 0; h < 8; ++h) {
    std::array<std::uint64_t, 8> ranks;
    for (std::uint64_t c = 0; c < 8; ++c) ranks[c] = kOctreeVertex | (h ^ c);
    const TetSet tets = tet_set(triangulate(cube(ranks)));
    EXPECT_EQ(tets.size(), 6u);
    for (const auto& t : tets) {
      ASSERT_NE(std::find(t.begin(), t.end(), static_cast<std::uint32_t>(h ^ 7)), t.end());
    }
  }
}

TEST(Triangulation, ALatticeOfOtherPointsIsCutAlongOneDirection) {
  // Whatever the ranks are, and if the lattice stands on its corner in the plane as well: every cell is cut
  // along the same diagonal, and so are the faces of all cells in one plane.
  for (const bool diamond : {false, true}) {
    constexpr int kSide = 4;
    RankedPoints set;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j)
        for (int k = 0; k < kSide; ++k)
          set.add(diamond ? Vec3(i + j, i - j, 1.5 * k) : Vec3(2 * i, j, 1.5 * k),
                  free_point_rank(static_cast<std::uint64_t>(37 * (set.size() + 1)) % 101));
    std::set<std::array<int, 3>> directions;
    const TetSet tets = tet_set(triangulate(set));
    EXPECT_EQ(tets.size(), 6u * (kSide - 1) * (kSide - 1) * (kSide - 1));
    for (const auto& t : tets) {
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          if (t[a] >= t[b]) continue;
          const int p = static_cast<int>(t[a]), q = static_cast<int>(t[b]);
          const std::array<int, 3> step{q / (kSide * kSide) - p / (kSide * kSide),
                                        q / kSide % kSide - p / kSide % kSide, q % kSide - p % kSide};
          directions.insert(step);
        }
      }
    }
    EXPECT_EQ(directions.size(), 7u) << "three along the lattice, three across faces, one across cells";
  }
}

TEST(Triangulation, AlternatingHeavyCornersOfACubeMakeFiveTetrahedra) {
  constexpr std::uint64_t kHeavy = std::uint64_t{1} << kRankClassShift;
  const TetSet tets =
      tet_set(triangulate(cube({0, kHeavy + 1, kHeavy + 2, 3, kHeavy + 4, 5, 6, kHeavy + 7})));
  EXPECT_EQ(tets.size(), 5u);
  EXPECT_EQ(std::count(tets.begin(), tets.end(), canonical({1, 2, 7, 4})) +
                std::count(tets.begin(), tets.end(), canonical({1, 2, 4, 7})),
            1);
}

TEST(Triangulation, ConflictsAreWhatInsertRemoves) {
  Engine engine(10);
  const RankedPoints set = mixed_points(4, engine);
  Triangulation triangulation = triangulate(set);
  std::vector<TetId> conflicts, created;
  for (int n = 0; n < 200; ++n) {
    const Vec3 p = 5.0 * Vec3(real(engine), real(engine), real(engine)) - Vec3::Constant(1.0);
    const std::uint64_t rank = 10000 + static_cast<std::uint64_t>(n);
    triangulation.conflicts(p, rank, TetId(), conflicts);
    std::vector<std::array<VertexId, 4>> before;
    for (const TetId t : conflicts) before.push_back(triangulation.mesh().tets[t]);
    triangulation.insert(p, rank, conflicts.front(), created);
    const TetMesh& mesh = triangulation.mesh();
    for (std::size_t i = 0; i < conflicts.size(); ++i) {
      ASSERT_TRUE(!mesh.alive(conflicts[i]) || mesh.tets[conflicts[i]] != before[i]);
    }
    for (const TetId t : created) {
      const auto& v = mesh.tets[t];
      ASSERT_TRUE(std::count(v.begin(), v.end(), VertexId(set.size() + static_cast<std::size_t>(n))) == 1);
    }
    std::vector<TetId> star;
    triangulation.star(VertexId(set.size() + static_cast<std::size_t>(n)), star);
    std::sort(star.begin(), star.end());
    std::sort(created.begin(), created.end());
    ASSERT_EQ(star, created);
  }
  EXPECT_EQ(check_triangulation(triangulation), "");
}

TEST(Triangulation, APointAtAnotherIsThatVertex) {
  Engine engine(11);
  const RankedPoints set = lattice_points(4, 4, 4, 0.3, engine);
  Triangulation triangulation = triangulate(set);
  const std::size_t tets = triangulation.mesh().tets.size();
  std::vector<TetId> created{TetId(1)};
  for (std::size_t i = 0; i < set.size(); ++i) {
    ASSERT_EQ(triangulation.insert(set.points[i], 100000 + i, TetId(), created), VertexId(i));
    ASSERT_TRUE(created.empty());
  }
  EXPECT_EQ(triangulation.mesh().tets.size(), tets);
  EXPECT_EQ(triangulation.mesh().points.size(), set.size());
}

TEST(Triangulation, LocateEndsInATetrahedronThatHoldsThePoint) {
  Engine engine(12);
  const RankedPoints set = mixed_points(5, engine);
  const Triangulation triangulation = triangulate(set);
  const TetMesh& mesh = triangulation.mesh();
  for (int n = 0; n < 500; ++n) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = 0.25 * static_cast<double>(below(engine, 21)) - 0.5;
    TetId near(below(engine, mesh.tets.size()));
    const TetId t = triangulation.locate(p, near);
    const auto& v = mesh.tets[t];
    if (mesh.ghost(t)) {
      ASSERT_GT(orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], p), 0);
      continue;
    }
    for (const auto& f : kTetFace) {
      ASSERT_LE(orient3d(mesh.points[v[f[0]]], mesh.points[v[f[1]]], mesh.points[v[f[2]]], p), 0);
    }
  }
}

TEST(Triangulation, FacesPointOutwards) {
  // The drawing of mesh/tet_mesh.h.
  const Vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  ASSERT_EQ(orient3d(p[0], p[1], p[2], p[3]), 1);
  for (int f = 0; f < 4; ++f) {
    EXPECT_EQ(orient3d(p[kTetFace[f][0]], p[kTetFace[f][1]], p[kTetFace[f][2]], p[f]), -1);
  }
  for (int e = 0; e < 6; ++e) {
    const int sum = kTetEdge[e][0] + kTetEdge[e][1] + kTetEdge[5 - e][0] + kTetEdge[5 - e][1];
    EXPECT_EQ(sum, 6);
    EXPECT_NE(kTetEdge[e][0], kTetEdge[5 - e][0]);
  }
}

TEST(Triangulation, TheTriangulationOfMorePointsIsThatOfTheSum) {
  Engine engine(13);
  const RankedPoints set = mixed_points(5, engine);
  Triangulation triangulation;
  const std::size_t half = set.size() / 2;
  const std::span<const Vec3> points(set.points);
  const std::span<const std::uint64_t> ranks(set.ranks);
  triangulation.insert_all(points.first(half), ranks.first(half));
  triangulation.insert_all(points.subspan(half), ranks.subspan(half));
  EXPECT_EQ(check_triangulation(triangulation), "");
  EXPECT_EQ(tet_set(triangulation), tet_set(triangulate(set)));
}

}  // namespace
}  // namespace octet
