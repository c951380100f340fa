// SPDX-License-Identifier: BSD-3-Clause
// A sound mesh passes; each broken invariant is told.
#include "mesh/soundness.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/box_mesh.h"

namespace octet {
namespace {

Mesh one_tet() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int tag = 1; tag <= 4; ++tag) mesh.point_on.push_back(model_vertex(tag));
  mesh.tets = {{0, 1, 2, 3}};
  mesh.tet_in = {1};
  mesh.triangles = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  mesh.triangle_on = {1, 2, 3, 4};
  return mesh;
}

TEST(Soundness, EmptyMeshesOneTetrahedronAndBoxesAreSound) {
  EXPECT_EQ(check_mesh_soundness({}), "");
  EXPECT_EQ(check_mesh_soundness(one_tet()), "");
  for (const int cells : {1, 2, 5}) EXPECT_EQ(check_mesh_soundness(test::plain_box_mesh(cells)), "");
}

struct Broken {
  const char* told;
  std::function<void(Mesh&)> inject;
};

TEST(Soundness, EveryBrokenInvariantIsTold) {
  const Broken cases[] = {
      {"points and point_on differ", [](Mesh& m) { m.point_on.pop_back(); }},
      {"tets and tet_in differ", [](Mesh& m) { m.tet_in.pop_back(); }},
      {"out of range", [](Mesh& m) { m.triangles[0][0] = 99; }},
      {"no element uses it",
       [](Mesh& m) {
         m.points.emplace_back(1, 1, 1);
         m.point_on.push_back(model_region(1));
       }},
      {"names a vertex twice", [](Mesh& m) { m.triangles[0][0] = m.triangles[0][1]; }},
      {"is the same as triangle 0",
       [](Mesh& m) {
         m.triangles.push_back({3, 1, 2});
         m.triangle_on.push_back(1);
       }},
      {"is the same as tetrahedron 0",
       [](Mesh& m) {
         m.tets.push_back({1, 2, 0, 3});
         m.tet_in.push_back(1);
       }},
      {"its volume is negative", [](Mesh& m) { std::swap(m.tets[0][0], m.tets[0][1]); }},
      {"its volume is zero", [](Mesh& m) { m.points[3] = Vec3(0.25, 0.5, 0.0); }},
      {"but no triangle",
       [](Mesh& m) {
         m.triangles.pop_back();
         m.triangle_on.pop_back();
       }},
      {"is on no model entity", [](Mesh& m) { m.triangle_on[2] = 0; }},
      {"is on no model entity", [](Mesh& m) { m.point_on[2] = {}; }},
      {"its vertex 2 does not", [](Mesh& m) { m.point_on[2] = model_region(1); }},
      {"its vertex 2 does not", [](Mesh& m) { m.point_on[2] = model_face(2); }},
  };
  for (const Broken& broken : cases) {
    Mesh mesh = one_tet();
    broken.inject(mesh);
    const std::string fault = check_mesh_soundness(mesh);
    EXPECT_NE(fault.find(broken.told), std::string::npos) << broken.told << ": \"" << fault << '"';
  }
}

TEST(Soundness, AVolumeOfTheLastBitIsPositiveAndNoneIsZero) {
  Mesh mesh = one_tet();
  mesh.points[3] = Vec3(0.1, 0.1, 1e-100);
  EXPECT_EQ(check_mesh_soundness(mesh), "");
  mesh.points[3].z() = 0.0;
  EXPECT_NE(check_mesh_soundness(mesh), "");
}

TEST(Soundness, FacesBetweenTwoRegionsMustBeTriangles) {
  Mesh mesh = test::plain_box_mesh(2);
  mesh.tet_in[0] = 2;
  EXPECT_NE(check_mesh_soundness(mesh).find("between two regions"), std::string::npos);
}

TEST(Soundness, OverlappingTetrahedraOnOneFaceAreTold) {
  Mesh mesh = one_tet();
  mesh.points.emplace_back(0.1, 0.1, 2.0);
  mesh.point_on.push_back(model_vertex(5));
  mesh.tets.push_back({0, 1, 2, 4});
  mesh.tet_in.push_back(1);
  EXPECT_NE(check_mesh_soundness(mesh).find("on one side"), std::string::npos);
  mesh.points.emplace_back(0.1, 0.1, -2.0);
  mesh.point_on.push_back(model_vertex(6));
  mesh.tets.push_back({1, 0, 2, 5});
  mesh.tet_in.push_back(1);
  EXPECT_NE(check_mesh_soundness(mesh).find("more than two"), std::string::npos);
}

TEST(Soundness, NeighboursOnAModelFaceMustBeOrientedAlike) {
  Mesh mesh = test::plain_box_mesh(2);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_NE(check_mesh_soundness(mesh).find("oriented against its neighbour"), std::string::npos);
}

}  // namespace
}  // namespace octet
