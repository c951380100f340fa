// SPDX-License-Identifier: BSD-3-Clause
// What a reader of STL finds: closed surfaces turned outwards, a solid for every face.
#include "io/stl_write.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

struct Facet {
  Vec3 normal;
  std::array<Vec3, 3> corners;
};

std::string written(const Mesh& mesh, const ModelOutline& outline, const char* format, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".stl");
  write_mesh(path, mesh, outline, mesh_format(path, format), {.scale = scale});
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  return bytes;
}

std::vector<Facet> read_binary(const std::string& bytes) {
  std::uint32_t n = 0;
  EXPECT_NE(bytes.substr(0, 5), "solid");
  std::memcpy(&n, bytes.data() + 80, sizeof n);
  EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t{n});
  std::vector<Facet> facets(n);
  for (std::size_t i = 0; i < n; ++i) {
    float x[12];
    std::memcpy(x, bytes.data() + 84 + 50 * i, sizeof x);
    facets[i].normal = Vec3(x[0], x[1], x[2]);
    for (std::size_t k = 0; k < 3; ++k) facets[i].corners[k] = Vec3(x[3 * k + 3], x[3 * k + 4], x[3 * k + 5]);
  }
  return facets;
}

std::map<std::string, std::vector<Facet>> read_text(const std::string& text) {
  std::map<std::string, std::vector<Facet>> solids;
  std::istringstream in(text);
  const auto take = [&](const char* expected) {
    std::string word;
    in >> word;
    EXPECT_EQ(word, expected);
  };
  std::string word, name;
  while (in >> word) {
    EXPECT_EQ(word, "solid");
    in >> name;
    EXPECT_EQ(solids.count(name), 0u);
    while (in >> word && word == "facet") {
      Facet f;
      take("normal");
      in >> f.normal[0] >> f.normal[1] >> f.normal[2];
      take("outer"), take("loop");
      for (Vec3& p : f.corners) {
        take("vertex");
        in >> p[0] >> p[1] >> p[2];
      }
      take("endloop"), take("endfacet");
      solids[name].push_back(f);
    }
    EXPECT_EQ(word, "endsolid");
    take(name.c_str());
  }
  return solids;
}

/// Of what the facets enclose, by the theorem of divergence: positive where they are turned outwards.
double volume(const std::vector<Facet>& facets) {
  double sum = 0.0;
  for (const Facet& f : facets) sum += f.corners[0].dot(f.corners[1].cross(f.corners[2])) / 6.0;
  return sum;
}

TEST(StlWrite, BinaryHasTheBoundaryTurnedOutwards) {
  const Mesh mesh = test::plain_box_mesh(2);
  const std::vector<Facet> facets = read_binary(written(mesh, {}, "", 0.5));
  ASSERT_EQ(facets.size(), mesh.triangles.size());
  EXPECT_NEAR(volume(facets), 6.0 / 8.0, 1e-6);
  for (const Facet& f : facets) {
    const Vec3 across = (f.corners[1] - f.corners[0]).cross(f.corners[2] - f.corners[0]);
    EXPECT_LT((across.normalized() - f.normal).norm(), 1e-6);
  }
}

/// Faces whose normals point into the solid are turned, those between two solids are as the face is.
TEST(StlWrite, TrianglesAreTurnedOutOfTheirTetrahedra) {
  Mesh mesh = test::plain_box_mesh(1);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(volume(read_binary(written(mesh, {}, ""))), 6.0, 1e-5);
  const Mesh halves = test::halved_box_mesh(1, {4, 2, 2});
  EXPECT_EQ(read_binary(written(halves, {}, "")).size(), halves.triangles.size());
}

TEST(StlWrite, TextHasASolidForEveryFaceByItsName) {
  const Mesh mesh = test::plain_box_mesh(2);
  const auto solids =
      read_text(written(mesh, test::plain_box_outline(Vec3(3.0, 2.0, 1.0), true), "stl-ascii"));
  ASSERT_EQ(solids.size(), 6u);
  std::vector<Facet> all;
  for (const auto& [name, facets] : solids) {
    EXPECT_EQ(facets.size(), 8u) << name;
    all.insert(all.end(), facets.begin(), facets.end());
  }
  EXPECT_EQ(solids.count("Face1"), 1u);
  EXPECT_EQ(solids.count("Face3"), 0u) << "its name is bore";
  EXPECT_NEAR(volume(all), 6.0, 1e-12);
}

TEST(StlWrite, SecondOrderIsRefused) {
  EXPECT_THROW(check_format(MeshFormat::kStl, 2), InputError);
  EXPECT_THROW(check_format(MeshFormat::kStlAscii, 2), InputError);
  EXPECT_NO_THROW(check_format(MeshFormat::kStl, 1));
  Mesh mesh = test::plain_box_mesh(1);
  mesh.mid = straight_mid_nodes(mesh);
  EXPECT_THROW(written(mesh, {}, ""), OutputError);
}

}  // namespace
}  // namespace octet
