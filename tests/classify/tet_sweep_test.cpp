// SPDX-License-Identifier: BSD-3-Clause
// The sum over all tetrahedra sees what a list of all faces would.
#include "classify/tet_sweep.h"

#include <gtest/gtest.h>

#include "tests/support/model_meshes.h"

namespace octet {
namespace {

const Vec3 kSize(3.0, 2.0, 1.0);

struct Box {
  Model model = analytic_box(kSize);
  Mesh mesh = test::box_mesh(test::part_of(model), kSize, {4, 4, 4});

  /// Number of a tetrahedron with no vertex on the boundary.
  [[nodiscard]] std::size_t inner_tet() const {
    for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
      bool inner = true;
      for (const Mesh::Index v : mesh.tets[i]) inner = inner && mesh.point_on[v].dim == 3;
      if (inner) return i;
    }
    ADD_FAILURE();
    return 0;
  }
};

TEST(TetSweep, AGoodBoxCloses) {
  const Box box;
  const TetSweep sweep = sweep_tets(box.mesh, box.model);
  EXPECT_TRUE(sweep.closes);
  EXPECT_TRUE(sweep.proves_pairs());
  EXPECT_NEAR(sweep.filled[1], 6.0, 1e-12);
  EXPECT_GT(sweep.smallest_volume, 0.0);
  for (std::size_t v = 0; v < box.mesh.points.size(); ++v)
    EXPECT_EQ(sweep.on_surface[v] != 0, box.mesh.point_on[v].dim < 3);
}

TEST(TetSweep, AMissingTetrahedronLeavesAHole) {
  Box box;
  const std::size_t at = box.inner_tet();
  box.mesh.tets.erase(box.mesh.tets.begin() + static_cast<std::ptrdiff_t>(at));
  box.mesh.tet_in.pop_back();
  EXPECT_FALSE(sweep_tets(box.mesh, box.model).closes);
}

TEST(TetSweep, ATetrahedronGivenTwiceDoesNotClose) {
  Box box;
  box.mesh.tets.push_back(box.mesh.tets[box.inner_tet()]);
  box.mesh.tet_in.push_back(1);
  EXPECT_FALSE(sweep_tets(box.mesh, box.model).closes);
}

TEST(TetSweep, AnInvertedTetrahedronProvesNothing) {
  Box box;
  auto& t = box.mesh.tets[box.inner_tet()];
  std::swap(t[0], t[1]);
  const TetSweep sweep = sweep_tets(box.mesh, box.model);
  EXPECT_EQ(sweep.not_positive.size(), 1u);
  EXPECT_FALSE(sweep.proves_pairs());
}

TEST(TetSweep, OtherDiagonalsOnOneSideOfAQuadrilateralDoNotClose) {
  Box box;
  // The two triangles of a boundary quadrilateral, cut along its other diagonal.
  auto& triangles = box.mesh.triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const Mesh::Index a = triangles[i][k], b = triangles[i][(k + 1) % 3], c = triangles[i][(k + 2) % 3];
          if (triangles[j][l] != b || triangles[j][(l + 1) % 3] != a) continue;
          const Mesh::Index d = triangles[j][(l + 2) % 3];
          triangles[i] = {c, a, d};
          triangles[j] = {d, b, c};
          EXPECT_FALSE(sweep_tets(box.mesh, box.model).closes);
          return;
        }
  FAIL() << "no pair of triangles";
}

TEST(TetSweep, ATriangleTurnedOverDoesNotClose) {
  Box box;
  std::swap(box.mesh.triangles[5][0], box.mesh.triangles[5][1]);
  EXPECT_FALSE(sweep_tets(box.mesh, box.model).closes);
}

TEST(TetSweep, ATetrahedronOfNoRegionOfItsOwnDoesNotClose) {
  const Model model = analytic_two_boxes(kSize);
  Mesh mesh = test::box_mesh(test::part_of(model), Vec3(2.0 * kSize.x(), kSize.y(), kSize.z()), {4, 2, 2});
  ASSERT_TRUE(sweep_tets(mesh, model).closes);
  mesh.tet_in[0] = 3 - mesh.tet_in[0];
  EXPECT_FALSE(sweep_tets(mesh, model).closes);
}

}  // namespace
}  // namespace octet
