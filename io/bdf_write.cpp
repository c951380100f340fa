// SPDX-License-Identifier: BSD-3-Clause
// Fixed fields of eight characters, of sixteen for coordinates.
#include "io/bdf_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/face_sides.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestBdfName = 60;
constexpr std::size_t kFields = 8;                 // of a line, behind the entry's name
constexpr std::size_t kWide = 16, kDigits = 15;    // a blank sets fields apart for readers that count none
constexpr const char* kContinued = "+\n+       ";  // some readers take blanks for no continuation

void write_bdf_nodes(OutputFile& file, const Mesh& mesh, double scale) {
  file.write_blocks(node_count(mesh), kItemsATask,
                    [&](std::size_t first, std::size_t last, std::string& bytes) {
                      for (std::size_t v = first; v < last; ++v) {
                        const Vec3 p = node_point(mesh, static_cast<std::uint32_t>(v)) * scale;
                        fmt::format_to(std::back_inserter(bytes), "GRID*   {:16}{:16}{}{}*\n*       {}\n",
                                       v + 1, "", wide_field(p.x()), wide_field(p.y()), wide_field(p.z()));
                      }
                    });
}

void write_elements(OutputFile& file, const Mesh& mesh, int property,
                    const std::vector<std::uint32_t>& tets) {
  file.write_blocks(tets.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
    auto out = std::back_inserter(bytes);
    for (std::size_t i = first; i < last; ++i) {
      const auto& v = mesh.tets[tets[i]];
      fmt::format_to(out, "CTETRA  {:8}{:8}{:8}{:8}{:8}{:8}", tets[i] + 1, property, v[0] + 1, v[1] + 1,
                     v[2] + 1, v[3] + 1);
      if (!mesh.mid.empty())
        for (std::size_t k = 0; k < 6; ++k)
          fmt::format_to(out, "{}{:8}", k == 2 ? kContinued : "",
                         mesh.points.size() + mesh.mid.of_tets[tets[i]][kVtkTetMid[k]] + 1);
      bytes.push_back('\n');
    }
  });
}

void write_set(OutputFile& file, int number, const std::vector<std::uint64_t>& nodes) {
  std::string text = fmt::format("SET1    {:8}", number);
  std::size_t fields = 1;
  for (const std::uint64_t node : nodes) {
    if (fields++ % kFields == 0) text += kContinued;
    text += fmt::format("{:8}", node);
  }
  file.write(text + "\n");
}

/// Pressure on a CTETRA is given by a corner of the side and the corner off it.
void write_pressure(OutputFile& file, const Mesh& mesh, const FaceSides& sides, int load,
                    const std::vector<std::uint32_t>& triangles) {
  file.write_blocks(triangles.size(), kItemsATask,
                    [&](std::size_t first, std::size_t last, std::string& bytes) {
                      for (std::size_t i = first; i < last; ++i) {
                        const auto side = sides.of(mesh.triangles[triangles[i]]);
                        if (!side) continue;  // a triangle of no tetrahedron has no side to press on
                        fmt::format_to(std::back_inserter(bytes), "PLOAD4  {:8}{:8}{:8}{:24}{:8}{:8}\n", load,
                                       side->tet + 1, "1.", "", mesh.triangles[triangles[i]][0] + 1,
                                       mesh.tets[side->tet][side->lacking] + 1);
                      }
                    });
}

}  // namespace

std::string wide_field(double x) {
  const double size = std::fabs(x);
  const std::size_t sign = std::signbit(x) ? 1 : 0;
  std::string text;
  if (size >= 1e9 || (size < 1e-3 && size > 1e-90)) {  // an exponent spares more than its own width
    text = fmt::format("{:.{}E}", x, kDigits - sign - 6);
  } else {
    const std::size_t before = size < 1.0 ? 1 : 1 + static_cast<std::size_t>(std::log10(size));
    text = fmt::format("{:.{}f}", x, kDigits - sign - before - 1);
    text.resize(std::min(text.size(), kDigits));  // rounding may have put a digit more before the point
  }
  return fmt::format("{:>{}}", text, kWide);
}

void write_bdf(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  constexpr std::size_t kMost = 99'999'999;
  if (std::max(node_count(mesh), mesh.tets.size()) > kMost)
    throw OutputError("the mesh is too large for a .bdf file; use MSH 4.1");
  const SetNames names = set_names(complete_outline(outline, mesh), kLongestBdfName);
  const ElementGroups groups = group_elements(mesh);
  const auto comment = [&](ModelRef entity, const char* what) {
    const std::string own = entity_name(entity), &name = names.of.at(entity);
    return fmt::format("$ {}{}: {}\n", own, name == own ? "" : ", " + name, what);
  };
  file.write("$ mesh by Octet: bulk data, to be included behind BEGIN BULK\n");
  write_bdf_nodes(file, mesh, scale);
  for (const auto& group : groups.items) {
    const ModelRef entity = group.first;
    if (entity.dim != 3) continue;
    file.write(comment(entity, "its elements"));
    file.write(fmt::format("PSOLID  {:8}{:8}\n", entity.tag, entity.tag));
    write_elements(file, mesh, entity.tag, group.second);
  }
  const FaceSides sides(mesh);
  const std::array<int, 4> before = before_node_sets(groups);
  for (int dim = 2; dim >= 0; --dim)
    for (const auto& [entity, items] : groups.items) {
      if (entity.dim != dim) continue;
      file.write(comment(entity, dim == 2 ? "its nodes, and a load set of unit pressure" : "its nodes"));
      write_set(file, before[static_cast<std::size_t>(dim)] + entity.tag,
                nodes_of_elements(mesh, groups, dim, items));
      if (dim == 2) write_pressure(file, mesh, sides, entity.tag, items);
    }
  int number = before[3];
  for (const OutlineGroup& set : names.shared) {
    const std::vector<std::uint32_t> items = items_of(groups, set);
    if (items.empty() || set.dim == 3) continue;
    file.write(fmt::format("$ {}, {} entities: {}\n", set.name, set.tags.size(),
                           set.dim == 2 ? "their nodes, and a load set of unit pressure" : "their nodes"));
    write_set(file, ++number, nodes_of_elements(mesh, groups, set.dim, items));
    if (set.dim == 2) write_pressure(file, mesh, sides, number, items);
  }
}

}  // namespace octet
