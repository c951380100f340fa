// SPDX-License-Identifier: BSD-3-Clause
#include "finalize/work_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "finalize/cavity.h"
#include "mesh/soundness.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

TEST(WorkMesh, OfALatticeHoldsItsInvariantsAndComesBackAsItWas) {
  const testing::Part part = testing::box_part({1, 2, 1}, 2, 3, 2);
  const WorkMesh work = to_work_mesh(part.mesh);
  EXPECT_EQ(check_work_mesh(work), "");
  const Mesh back = to_mesh(work);
  EXPECT_EQ(check_mesh_soundness(back), "");
  EXPECT_EQ(back.points, part.mesh.points);
  EXPECT_EQ(back.tets, part.mesh.tets);
  EXPECT_EQ(back.triangles.size(), part.mesh.triangles.size());
  EXPECT_EQ(back.edges.size(), part.mesh.edges.size());
  EXPECT_EQ(testing::face_euler(back, 6), testing::face_euler(part.mesh, 6));
}

TEST(WorkMesh, StarHoldsEveryTetrahedronAtTheVertexOnce) {
  const testing::Part part = testing::box_part({1, 1, 1}, 3, 3, 3);
  WorkMesh work = to_work_mesh(part.mesh);
  std::vector<TetId> tets;
  for (std::size_t i = 0; i < work.points.size(); ++i) {
    star(work, VertexId(i), tets);
    std::sort(tets.begin(), tets.end());
    EXPECT_EQ(std::unique(tets.begin(), tets.end()), tets.end());
    const auto degree = std::count_if(part.mesh.tets.begin(), part.mesh.tets.end(), [&](const auto& v) {
      return std::find(v.begin(), v.end(), static_cast<Mesh::Index>(i)) != v.end();
    });
    EXPECT_EQ(static_cast<std::ptrdiff_t>(tets.size()), degree);
    EXPECT_FALSE(work.frozen(VertexId(i)));
  }
}

TEST(WorkMesh, RingGoesAroundTheEdgeInPositiveOrder) {
  const testing::Part part = testing::spindle_part(5);
  const WorkMesh work = to_work_mesh(part.mesh);
  EdgeRing ring;
  edge_ring(work, TetId(2), VertexId(0), VertexId(1), ring);
  EXPECT_TRUE(ring.closed);
  ASSERT_EQ(ring.tets.size(), 5u);
  ASSERT_EQ(ring.rim.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3 &c = work.points[ring.rim[i]], &d = work.points[ring.rim[(i + 1) % 5]];
    EXPECT_GT((work.points[ring.b] - work.points[ring.a]).dot(c.cross(d)), 0.0);
    EXPECT_EQ(ring.face_on[i], 0);
  }
}

TEST(WorkMesh, RingOfABoundaryEdgeIsOpenAndClassifiedAtBothEnds) {
  const testing::Part part = testing::spindle_part(5);
  const WorkMesh work = to_work_mesh(part.mesh);
  EdgeRing ring;
  edge_ring(work, TetId(0), VertexId(0), VertexId(2), ring);
  EXPECT_FALSE(ring.closed);
  EXPECT_EQ(ring.tets.size(), 2u);
  ASSERT_EQ(ring.rim.size(), 3u);
  EXPECT_EQ(ring.face_on.front(), 1);
  EXPECT_EQ(ring.face_on[1], 0);
  EXPECT_EQ(ring.face_on.back(), 1);
}

TEST(WorkMesh, FreezesVerticesWhereTetrahedraTouchByAnEdgeOnly) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.point_on.assign(6, model_vertex(1));
  for (int i = 0; i < 6; ++i) mesh.point_on[static_cast<std::size_t>(i)].tag = i + 1;
  mesh.tets = {{0, 2, 3, 1}, {0, 4, 5, 1}};
  mesh.tet_in = {1, 2};
  for (const auto& v : mesh.tets) {
    for (const auto& f : kTetFace) {
      mesh.triangles.push_back({v[f[0]], v[f[1]], v[f[2]]});
      mesh.triangle_on.push_back(static_cast<int>(mesh.triangles.size()));
    }
  }
  const WorkMesh work = to_work_mesh(mesh);
  EXPECT_EQ(check_work_mesh(work), "");
  EXPECT_TRUE(work.frozen(VertexId(0)) && work.frozen(VertexId(1)));
  EXPECT_FALSE(work.frozen(VertexId(2)));
}

TEST(Cavity, RefusesWhatWouldBreakTheMeshAndLeavesItUntouched) {
  const testing::Part part = testing::spindle_part(3);
  WorkMesh work = to_work_mesh(part.mesh);
  const std::vector<TetId> all{TetId(0), TetId(1), TetId(2)};
  std::vector<TetId> made;
  const auto v = [](int i) { return VertexId(static_cast<std::size_t>(i)); };
  const std::vector<NewTet> good{{{v(2), v(3), v(4), v(1)}, 1}, {{v(2), v(4), v(3), v(0)}, 1}};
  std::vector<NewTet> inverted = good, elsewhere = good, half{good[0]};
  std::swap(inverted[0].vertices[0], inverted[0].vertices[1]);
  elsewhere[0].region = 2;
  EXPECT_FALSE(replace_cavity(work, {all, inverted}, made));
  EXPECT_FALSE(replace_cavity(work, {all, elsewhere}, made));
  EXPECT_FALSE(replace_cavity(work, {all, half}, made));
  EXPECT_EQ(check_work_mesh(work), "");
  EXPECT_EQ(to_mesh(work).tets, part.mesh.tets);
  ASSERT_TRUE(replace_cavity(work, {all, good}, made));
  EXPECT_EQ(made.size(), 2u);
  EXPECT_EQ(check_work_mesh(work), "");
  EXPECT_EQ(check_mesh_soundness(to_mesh(work)), "");
}

TEST(Cavity, MovesNoVertexThroughAFace) {
  const testing::Part part = testing::box_part({1, 1, 1}, 2, 2, 2);
  WorkMesh work = to_work_mesh(part.mesh);
  const VertexId centre = testing::vertex_near(work, {0.5, 0.5, 0.5});
  std::vector<TetId> tets;
  star(work, centre, tets);
  const auto moves = [&](const Vec3& place) {
    return move_vertex(work, centre, place, tets, shapes_at(work, centre, place, tets));
  };
  EXPECT_FALSE(moves({1.5, 0.5, 0.5}));
  EXPECT_EQ(work.points[centre], Vec3(0.5, 0.5, 0.5));
  EXPECT_TRUE(moves({0.6, 0.5, 0.4}));
  EXPECT_EQ(check_work_mesh(work), "");
}

}  // namespace
}  // namespace octet
