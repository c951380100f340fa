// SPDX-License-Identifier: BSD-3-Clause
// Insertion in blocks: the one triangulation, and the same numbers from any number of threads.
#include "delaunay/insertion.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include "tests/delaunay/point_sets.h"

namespace octet {
namespace {

using testing::Engine;
using testing::RankedPoints;

// A thin sheet of points, dense enough for several blocks.
RankedPoints sheet(std::size_t n) {
  Engine engine(7);
  RankedPoints set = testing::random_points(n, engine);
  for (Vec3& p : set.points) p.z() *= 0.02;
  return set;
}

Triangulation triangulate_with(int threads, const RankedPoints& set) {
  Triangulation result;
  tbb::task_arena arena(threads);
  arena.execute([&] { result = testing::triangulate(set); });
  return result;
}

TEST(InsertionInBlocks, GivesADelaunayTriangulation) {
  const RankedPoints set = sheet(3 * kBlockVertices);
  const Triangulation triangulation = triangulate_with(2, set);
  EXPECT_EQ(check_triangulation(triangulation), "");
  for (std::size_t v = 0; v < set.points.size(); ++v) {
    const TetId t = triangulation.tet_at(VertexId(v));
    ASSERT_TRUE(t.valid());
    const auto& corners = triangulation.mesh().tets[t];
    EXPECT_NE(std::find(corners.begin(), corners.end(), VertexId(v)), corners.end());
  }
}

TEST(InsertionInBlocks, GivesTheSameNumbersFromOneAndTwoThreads) {
  const RankedPoints set = sheet(3 * kBlockVertices);
  const Triangulation one = triangulate_with(1, set), two = triangulate_with(2, set);
  EXPECT_EQ(one.mesh().tets.values(), two.mesh().tets.values());
  EXPECT_EQ(one.mesh().neighbours.values(), two.mesh().neighbours.values());
}

TEST(InsertionInBlocks, LeavesWhatReachesBeyondABlockPending) {
  const RankedPoints set = sheet(100);
  Triangulation whole = testing::triangulate(set);
  Complex complex;
  for (std::size_t i = 0; i < set.points.size(); ++i) complex.add_vertex(set.points[i], set.ranks[i]);
  complex.mesh.tets = whole.mesh().tets;
  complex.mesh.neighbours = whole.mesh().neighbours;
  complex.mark.resize(complex.mesh.tets.size());
  for (std::size_t v = 0; v < set.points.size(); ++v)
    complex.vertex_tet[VertexId(v)] = whole.tet_at(VertexId(v));
  const auto before = complex.mesh.tets.values();
  const VertexId added = complex.add_vertex(Vec3(0.5, 0.5, 0.01), 1000);
  // The new point alone in its block: whatever its cavity is made of belongs to another.
  std::vector<std::uint32_t> block_of(set.points.size() + 1, 0);
  block_of[added.index()] = 1;
  Inserter inserter;
  inserter.block = {&block_of, 1};
  inserter.last = whole.tet_at(VertexId(0));
  EXPECT_EQ(join_vertex(complex, inserter, added), Insertion::kLeft);
  EXPECT_EQ(complex.mesh.tets.values(), before);
}

}  // namespace
}  // namespace octet
