// SPDX-License-Identifier: BSD-3-Clause
// What tests of files of meshes have in common: a directory, meshes that show what is lost, bytes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "io/write.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet::test {

namespace fs = std::filesystem;

inline const Vec3 kSize(3.0, 2.0, 1.0);
inline constexpr MeshFormat kFormats[] = {MeshFormat::kMsh41Binary, MeshFormat::kMsh41Ascii,
                                          MeshFormat::kMsh22Binary, MeshFormat::kMsh22Ascii,
                                          MeshFormat::kVtu};

/// A directory of its own for each test, removed at the end.
class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = fs::temp_directory_path() / (std::string("octet_io_") + info->name());
    fs::remove_all(directory_);
    fs::create_directories(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
  }
  fs::path directory_;
};

inline std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void put_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Coordinates that decimal notation does not hit, and a sheared grid.
inline Mesh crooked_mesh() {
  Mesh mesh = plain_box_mesh(3);
  for (Vec3& p : mesh.points) p = Vec3(p.x() / 3.0 + 1e-17 * p.y(), -p.y() * 0.1, 1e6 + p.z() / 7.0 - p.x());
  return mesh;
}

/// Of second order, with nodes off the middles of their edges.
inline Mesh crooked_second_order_mesh(int cells) {
  Mesh mesh = plain_box_mesh(cells);
  mesh.mid = straight_mid_nodes(mesh);
  for (std::size_t m = 0; m < mesh.mid.points.size(); ++m)
    mesh.mid.points[m] += Vec3(1e-3 / 3.0, -1e-4, 1e-5) * static_cast<double>(m % 7);
  return mesh;
}

inline void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t v = 0; v < a.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(a.points[v][i]), std::bit_cast<std::uint64_t>(b.points[v][i]));
  EXPECT_EQ(a.point_on, b.point_on);
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.edge_on, b.edge_on);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_on, b.triangle_on);
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.tet_in, b.tet_in);
  EXPECT_EQ(a.mid.points, b.mid.points);
  EXPECT_EQ(a.mid.on, b.mid.on);
  EXPECT_EQ(a.mid.between, b.mid.between);
  EXPECT_EQ(a.mid.of_edges, b.mid.of_edges);
  EXPECT_EQ(a.mid.of_triangles, b.mid.of_triangles);
  EXPECT_EQ(a.mid.of_tets, b.mid.of_tets);
}

}  // namespace octet::test
