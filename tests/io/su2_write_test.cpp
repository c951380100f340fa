// SPDX-License-Identifier: BSD-3-Clause
// What SU2's reader finds behind its keys.
#include "io/su2_write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
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

struct Zone {
  std::vector<std::vector<int>> tets;
  std::vector<Vec3> points;
  std::map<std::string, std::vector<std::vector<int>>> markers;
};

/// Keys with "= ", lines of numbers behind them, % until a line's end.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : in_(path) {
    while (next()) {
      if (key("NZONE")) {
        told = number();
      } else if (key("IZONE")) {
        EXPECT_EQ(number(), static_cast<int>(zones.size()) + 1);
      } else if (key("NDIME")) {
        EXPECT_EQ(number(), 3);
        zones.emplace_back();
      } else if (key("NELEM")) {
        zones.back().tets = rows(number(), 10, 4, true);
      } else if (key("NPOIN")) {
        read_points(number());
      } else if (key("NMARK")) {
        read_markers(number());
      } else {
        ADD_FAILURE() << line_;
      }
    }
  }
  std::vector<Zone> zones;
  int told = 0;  ///< zones, if the file tells

 private:
  bool next() {
    while (std::getline(in_, line_)) {
      line_.resize(std::min(line_.size(), line_.find('%')));
      if (!line_.empty()) return true;
    }
    return false;
  }
  bool key(const std::string& name) const { return line_.rfind(name + "= ", 0) == 0; }
  int number() const { return std::stoi(line_.substr(line_.find('=') + 1)); }

  std::vector<std::vector<int>> rows(int n, int kind, std::size_t nodes, bool counted) {
    std::vector<std::vector<int>> found;
    for (int i = 0; i < n; ++i) {
      EXPECT_TRUE(next());
      std::istringstream numbers(line_);
      int first = 0, last = -1;
      numbers >> first;
      EXPECT_EQ(first, kind) << line_;
      found.emplace_back(nodes);
      for (int& v : found.back()) numbers >> v;
      EXPECT_TRUE(numbers) << line_;
      if (counted) {
        numbers >> last;
        EXPECT_EQ(last, i);
      }
      EXPECT_FALSE(numbers >> last) << line_;
    }
    return found;
  }

  void read_points(int n) {
    for (int i = 0; i < n; ++i) {
      ASSERT_TRUE(next());
      Vec3 p;
      int number = -1;
      std::istringstream(line_) >> p.x() >> p.y() >> p.z() >> number;
      EXPECT_EQ(number, i);
      zones.back().points.push_back(p);
    }
  }

  void read_markers(int n) {
    for (int i = 0; i < n; ++i) {
      ASSERT_TRUE(next() && key("MARKER_TAG")) << line_;
      const std::string name = line_.substr(12);
      ASSERT_TRUE(next() && key("MARKER_ELEMS")) << line_;
      EXPECT_TRUE(zones.back().markers.emplace(name, rows(number(), 5, 3, false)).second) << name;
    }
  }

  std::ifstream in_;
  std::string line_;
};

Reader file_of(const Mesh& mesh, const ModelOutline& outline, double scale = 1.0) {
  const auto path =
      std::filesystem::temp_directory_path() /
      (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".su2");
  write_mesh(path, mesh, outline, mesh_format(path, ""), {.scale = scale});
  Reader reader(path);
  std::filesystem::remove(path);
  return reader;
}

/// The zone's surface is its markers', each once and outwards: its volume by the divergence theorem.
double enclosed(const Zone& zone) {
  double six_volumes = 0.0;
  for (const auto& [name, sides] : zone.markers)
    for (const std::vector<int>& side : sides) {
      const auto at = [&](std::size_t k) { return zone.points.at(static_cast<std::size_t>(side[k])); };
      six_volumes += at(0).dot(at(1).cross(at(2)));
    }
  return six_volumes / 6.0;
}

TEST(Su2Write, OneRegionIsTheMeshInItsOrder) {
  const Mesh mesh = test::plain_box_mesh(2);
  const Reader file = file_of(mesh, test::plain_box_outline(Vec3(3.0, 2.0, 1.0), true), 2.0);
  EXPECT_EQ(file.told, 0);
  ASSERT_EQ(file.zones.size(), 1u);
  const Zone& zone = file.zones[0];
  ASSERT_EQ(zone.points.size(), mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) EXPECT_EQ(zone.points[v], Vec3(2.0 * mesh.points[v]));
  ASSERT_EQ(zone.tets.size(), mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    EXPECT_EQ(zone.tets[t], std::vector<int>(mesh.tets[t].begin(), mesh.tets[t].end()));
  ASSERT_EQ(zone.markers.size(), 6u);
  EXPECT_EQ(zone.markers.at("bore__A_").size(), 8u);
  for (const int v : zone.markers.at("Face1")[0])
    EXPECT_NE(mesh.point_on[static_cast<std::size_t>(v)].dim, 3);
  EXPECT_NEAR(enclosed(zone), 8.0 * 6.0, 1e-12);
}

TEST(Su2Write, SeveralRegionsAreZonesWithTheirInterfacesInBoth) {
  for (const int behind : {1, 2}) {
    const Mesh mesh = test::halved_box_mesh(behind, {4, 2, 2});
    const Reader file = file_of(mesh, {});
    EXPECT_EQ(file.told, 2);
    ASSERT_EQ(file.zones.size(), 2u);
    for (const Zone& zone : file.zones) {
      EXPECT_EQ(zone.tets.size(), mesh.tets.size() / 2);
      EXPECT_EQ(zone.points.size(), 27u);
      EXPECT_EQ(zone.markers.size(), 6u);
      EXPECT_EQ(zone.markers.at("Face7").size(), 8u);
      EXPECT_NEAR(enclosed(zone), 1.0, 1e-12);
      double volume = 0.0;
      for (const std::vector<int>& tet : zone.tets) {
        const auto from_first = [&](std::size_t k) {
          return Vec3(zone.points.at(static_cast<std::size_t>(tet[k])) -
                      zone.points.at(static_cast<std::size_t>(tet[0])));
        };
        volume += from_first(1).cross(from_first(2)).dot(from_first(3)) / 6.0;
      }
      EXPECT_NEAR(volume, 1.0, 1e-12);
    }
    for (const Vec3& p : file.zones[0].points) EXPECT_LE(p.x(), 1.0);
    for (const Vec3& p : file.zones[1].points) EXPECT_GE(p.x(), 1.0);
  }
}

/// A face within a region, as baffles are, is no end of the zone.
TEST(Su2Write, FacesWithinARegionAreNoMarkers) {
  Mesh mesh = test::halved_box_mesh(1, {4, 2, 2});
  for (std::int32_t& region : mesh.tet_in) region = 1;
  const Reader file = file_of(mesh, {});
  ASSERT_EQ(file.zones.size(), 1u);
  EXPECT_EQ(file.zones[0].markers.count("Face7"), 0u);
  EXPECT_EQ(file.zones[0].markers.size(), 6u);
  EXPECT_NEAR(enclosed(file.zones[0]), 2.0, 1e-12);
}

TEST(Su2Write, SecondOrderIsRefused) {
  Mesh mesh = test::plain_box_mesh(1);
  mesh.mid = straight_mid_nodes(mesh);
  EXPECT_THROW((void)file_of(mesh, {}), OutputError);
  EXPECT_THROW(check_format(MeshFormat::kSu2, 2), InputError);
  EXPECT_NO_THROW(check_format(MeshFormat::kSu2, 1));
  EXPECT_NO_THROW(check_format(MeshFormat::kMedit, 2));
}

}  // namespace
}  // namespace octet
