// SPDX-License-Identifier: BSD-3-Clause
// Sets and surfaces by model entity: what loads and supports are given on.
#include "io/inp_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/face_sides.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kPerLine = 16;         // the most that a line may hold
constexpr std::size_t kLongestInpName = 60;  // of the 80 that Abaqus allows

/// The side of a C3D4 or C3D10 by the local number of the vertex that it lacks: S1 is 1-2-3, S2 1-4-2, S3
/// 2-4-3, S4 3-4-1.
constexpr int kInpSideWithout[4] = {3, 4, 2, 1};

void write_inp_nodes(OutputFile& file, const Mesh& mesh, double scale) {
  file.write("*NODE, NSET=Nall\n");
  file.write_blocks(node_count(mesh), kItemsATask,
                    [&](std::size_t first, std::size_t last, std::string& bytes) {
                      auto out = std::back_inserter(bytes);
                      for (std::size_t v = first; v < last; ++v) {
                        const Vec3 p = node_point(mesh, static_cast<std::uint32_t>(v)) * scale;
                        // CalculiX reads the first twenty characters of a number.
                        fmt::format_to(out, "{}, {:.12e}, {:.12e}, {:.12e}\n", v + 1, p.x(), p.y(), p.z());
                      }
                    });
}

void write_elements(OutputFile& file, const Mesh& mesh, const std::string& name,
                    const std::vector<std::uint32_t>& tets) {
  const bool second = !mesh.mid.empty();
  file.write(fmt::format("*ELEMENT, TYPE={}, ELSET={}\n", second ? "C3D10" : "C3D4", name));
  file.write_blocks(tets.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
    auto out = std::back_inserter(bytes);
    for (std::size_t i = first; i < last; ++i) {
      const auto& v = mesh.tets[tets[i]];
      fmt::format_to(out, "{}, {}, {}, {}, {}", tets[i] + 1, v[0] + 1, v[1] + 1, v[2] + 1, v[3] + 1);
      if (second)
        for (const std::size_t e : kVtkTetMid)
          fmt::format_to(out, ", {}", mesh.points.size() + mesh.mid.of_tets[tets[i]][e] + 1);
      bytes.push_back('\n');
    }
  });
}

std::string node_set(const std::string& head, const std::vector<std::uint64_t>& nodes) {
  std::string text = fmt::format("*NSET, NSET={}\n", head);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    text +=
        fmt::format("{}{}", nodes[k], k + 1 == nodes.size() || k % kPerLine == kPerLine - 1 ? "\n" : ", ");
  return text;
}

/// The nodes of these elements of a dimension, ascending, as a set.
void write_node_set(OutputFile& file, const Mesh& mesh, const ElementGroups& groups, int dim,
                    const std::vector<std::uint32_t>& items, const std::string& name) {
  file.write(node_set(name, nodes_of_elements(mesh, groups, dim, items)));
}

/// Of faces that are images two sets in an order in which the one's nodes are the images of the other's, as
/// equations between two sets take them.
void write_periodic(OutputFile& file, const std::vector<PeriodicLink>& links, const SetNames& names) {
  for (const PeriodicLink& link : links) {
    if (link.entity.dim != 2) continue;
    std::vector<std::uint64_t> nodes, sources;
    for (const auto& [node, source] : link.nodes) {
      nodes.push_back(node + std::uint64_t{1});
      sources.push_back(source + std::uint64_t{1});
    }
    const std::string& name = names.of.at(link.entity);
    file.write(node_set(name + "_image, UNSORTED", nodes) + node_set(name + "_source, UNSORTED", sources));
  }
}

void write_surface(OutputFile& file, const Mesh& mesh, const FaceSides& sides, const std::string& name,
                   const std::vector<std::uint32_t>& triangles) {
  std::string text = fmt::format("*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
  for (const std::uint32_t i : triangles)
    if (const auto side = sides.of(mesh.triangles[i]))  // a triangle of no tetrahedron has no side to tell
      text += fmt::format("{}, S{}\n", side->tet + 1, kInpSideWithout[side->lacking]);
  file.write(text);
}

/// What several entities have a name for together: sets of their sets, and the surface of all their sides.
void write_shared(OutputFile& file, const Mesh& mesh, const ElementGroups& groups, const FaceSides& sides,
                  const SetNames& names) {
  for (const OutlineGroup& set : names.shared) {
    const std::vector<std::uint32_t> items = items_of(groups, set);
    if (items.empty()) continue;
    std::string members;
    for (const int tag : set.tags)
      if (groups.items.contains({set.dim, tag})) members += names.of.at({set.dim, tag}) + "\n";
    file.write(fmt::format("*{0}SET, {0}SET={1}\n{2}", set.dim == 3 ? "EL" : "N", set.name, members));
    if (set.dim == 2) write_surface(file, mesh, sides, set.name, items);
  }
}

}  // namespace

void write_inp(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  if (std::max(node_count(mesh), mesh.tets.size()) > kMost)
    throw OutputError("the mesh is too large for an .inp file; use MSH 4.1");
  const SetNames names = set_names(complete_outline(outline, mesh), kLongestInpName);
  const ElementGroups groups = group_elements(mesh);
  file.write("*HEADING\nmesh by Octet\n");
  write_inp_nodes(file, mesh, scale);
  for (const auto& [ref, items] : groups.items)
    if (ref.dim == 3) write_elements(file, mesh, names.of.at(ref), items);
  const FaceSides sides(mesh);
  for (const auto& [ref, items] : groups.items) {
    const std::string& name = names.of.at(ref);
    if (ref.dim == 0) {
      file.write(fmt::format("*NSET, NSET={}\n{}\n", name, groups.vertex_nodes[items.front()] + 1));
    } else if (ref.dim == 1) {
      write_node_set(file, mesh, groups, 1, items, name);
    } else if (ref.dim == 2) {
      write_node_set(file, mesh, groups, 2, items, name);
      write_surface(file, mesh, sides, name, items);
    }
  }
  write_shared(file, mesh, groups, sides, names);
  write_periodic(file, outline.links, names);
}

}  // namespace octet
