// SPDX-License-Identifier: BSD-3-Clause
// Zones of tetrahedra, and markers around them; elements by VTK's numbers.
#include "io/su2_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "io/face_sides.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestSu2Name = 60;
constexpr int kTriangle = 5, kTetrahedron = 10;
constexpr Mesh::Index kNotInZone = std::numeric_limits<Mesh::Index>::max();

/// Nodes of these tetrahedra, ascending, and the place of each there.
struct ZoneNodes {
  std::vector<Mesh::Index> nodes;
  std::vector<Mesh::Index> place;  ///< per node of the mesh, or kNotInZone
};

ZoneNodes zone_nodes(const Mesh& mesh, const std::vector<std::uint32_t>& tets) {
  ZoneNodes zone;
  zone.place.assign(mesh.points.size(), kNotInZone);
  for (const std::uint32_t t : tets)
    for (const Mesh::Index v : mesh.tets[t]) zone.place[v] = 0;
  for (Mesh::Index v = 0; v < mesh.points.size(); ++v) {
    if (zone.place[v] == kNotInZone) continue;
    zone.place[v] = static_cast<Mesh::Index>(zone.nodes.size());
    zone.nodes.push_back(v);
  }
  return zone;
}

/// Triangles of a face with a tetrahedron of the region on one side alone, each turned out of it.
std::vector<std::array<Mesh::Index, 3>> outward_sides(const Mesh& mesh, const FaceUses& uses,
                                                      const std::vector<std::uint32_t>& triangles,
                                                      int region) {
  std::vector<std::array<Mesh::Index, 3>> sides;
  for (const std::uint32_t i : triangles) {
    std::array<Mesh::Index, 3> triangle = mesh.triangles[i];
    const auto sharing = uses.find(triangle);
    const auto within = [&](const FaceUse& use) { return mesh.tet_in[use.tet] == region; };
    if (std::count_if(sharing.begin(), sharing.end(), within) != 1) continue;
    const FaceUse& use = *std::find_if(sharing.begin(), sharing.end(), within);
    if (use.even != sorted_face(triangle).even) std::swap(triangle[1], triangle[2]);
    sides.push_back(triangle);
  }
  return sides;
}

void write_zone(OutputFile& file, const Mesh& mesh, const std::vector<std::uint32_t>& tets, double scale,
                const ZoneNodes& zone) {
  file.write(fmt::format("NDIME= 3\nNELEM= {}\n", tets.size()));
  file.write_blocks(tets.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& v = mesh.tets[tets[i]];
      fmt::format_to(std::back_inserter(bytes), "{} {} {} {} {} {}\n", kTetrahedron, zone.place[v[0]],
                     zone.place[v[1]], zone.place[v[2]], zone.place[v[3]], i);
    }
  });
  file.write(fmt::format("NPOIN= {}\n", zone.nodes.size()));
  file.write_blocks(zone.nodes.size(), kItemsATask,
                    [&](std::size_t first, std::size_t last, std::string& bytes) {
                      for (std::size_t i = first; i < last; ++i) {
                        const Vec3 p = mesh.points[zone.nodes[i]] * scale;
                        fmt::format_to(std::back_inserter(bytes), "{} {} {} {}\n", p.x(), p.y(), p.z(), i);
                      }
                    });
}

void write_marker(OutputFile& file, const std::string& name, const ZoneNodes& zone,
                  const std::vector<std::array<Mesh::Index, 3>>& sides) {
  file.write(fmt::format("MARKER_TAG= {}\nMARKER_ELEMS= {}\n", name, sides.size()));
  file.write_blocks(sides.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t i = first; i < last; ++i)
      fmt::format_to(std::back_inserter(bytes), "{} {} {} {}\n", kTriangle, zone.place[sides[i][0]],
                     zone.place[sides[i][1]], zone.place[sides[i][2]]);
  });
}

}  // namespace

void write_su2(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  if (!mesh.mid.empty()) throw OutputError("a .su2 file has no elements of second order; use --order 1");
  const ElementGroups groups = group_elements(mesh);
  const auto names = set_names(complete_outline(outline, mesh), kLongestSu2Name).of;
  const FaceUses uses = boundary_face_uses(mesh);
  const auto zones =
      std::count_if(groups.items.begin(), groups.items.end(), [](const auto& g) { return g.first.dim == 3; });
  file.write("% mesh by Octet\n");
  if (zones > 1) file.write(fmt::format("NZONE= {}\n", zones));
  int number = 0;
  for (const auto& [region, tets] : groups.items) {
    if (region.dim != 3) continue;
    file.write(fmt::format("% {}: {}\n", entity_name(region), names.at(region)));
    if (zones > 1) file.write(fmt::format("IZONE= {}\n", ++number));
    const ZoneNodes zone = zone_nodes(mesh, tets);
    write_zone(file, mesh, tets, scale, zone);
    std::vector<std::pair<std::string, std::vector<std::array<Mesh::Index, 3>>>> markers;
    for (const auto& [face, triangles] : groups.items) {
      if (face.dim != 2) continue;
      auto sides = outward_sides(mesh, uses, triangles, region.tag);
      if (!sides.empty()) markers.emplace_back(names.at(face), std::move(sides));
    }
    file.write(fmt::format("NMARK= {}\n", markers.size()));
    for (const auto& [name, sides] : markers) write_marker(file, name, zone, sides);
  }
}

}  // namespace octet
