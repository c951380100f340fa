// SPDX-License-Identifier: BSD-3-Clause
// Columns of ten characters, as readers count them.
#include "io/unv_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

constexpr std::size_t kLongestUnvName = 40;
constexpr int kColour = 7;  // of a palette that readers draw with

/// Elements by order and dimension: linear and parabolic beam, thin shell, solid tetrahedron.
constexpr int kElement[2][4] = {{0, 21, 91, 111}, {0, 24, 92, 118}};
/// Nodes of the parabolic ones by their places in MSH's: along the border, each middle between its ends.
constexpr int kParabolic[4][kMostNodes] = {
    {0}, {0, 2, 1}, {0, 3, 1, 4, 2, 5}, {0, 4, 1, 5, 2, 6, 7, 9, 8, 3}};
/// Kinds of a group's members.
constexpr int kNodeMember = 7, kElementMember = 8;

void begin_dataset(OutputFile& file, int number) { file.write(fmt::format("    -1\n{:6}\n", number)); }
void end_dataset(OutputFile& file) { file.write("    -1\n"); }

/// A number as 1P3D25.16 has it.
void append_coordinate(std::string& bytes, double x) {
  const std::size_t first = bytes.size();
  fmt::format_to(std::back_inserter(bytes), "{:25.16E}", x);
  bytes[bytes.find('E', first)] = 'D';
}

void write_unv_nodes(OutputFile& file, const Mesh& mesh, double scale) {
  begin_dataset(file, 2411);
  file.write_blocks(
      node_count(mesh), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
        for (std::size_t v = first; v < last; ++v) {
          const Vec3 p = node_point(mesh, static_cast<std::uint32_t>(v)) * scale;
          fmt::format_to(std::back_inserter(bytes), "{:10}{:10}{:10}{:10}\n", v + 1, 1, 1, kColour);
          for (int k = 0; k < 3; ++k) append_coordinate(bytes, p[k]);
          bytes.push_back('\n');
        }
      });
  end_dataset(file);
}

/// MSH counts nodes on model vertices as elements, this format does not.
std::uint64_t label_of(const ElementGroups& groups, int dim, std::uint32_t i) {
  return groups.first_tag[dim] - groups.first_tag[1] + 1 + i;
}

void write_elements(OutputFile& file, const Mesh& mesh, const ElementGroups& groups) {
  const bool second = !mesh.mid.empty();
  begin_dataset(file, 2412);
  for (const auto& group : groups.items) {
    const int dim = group.first.dim, tag = group.first.tag;
    const std::vector<std::uint32_t>& items = group.second;
    if (dim == 0) continue;
    file.write_blocks(
        items.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
          auto out = std::back_inserter(bytes);
          for (std::size_t k = first; k < last; ++k) {
            std::uint64_t nodes[kMostNodes];
            const int n = element_nodes(mesh, groups, dim, items[k], nodes);
            fmt::format_to(out, "{:10}{:10}{:10}{:10}{:10}{:10}\n", label_of(groups, dim, items[k]),
                           kElement[second ? 1 : 0][dim], tag, tag, kColour, n);
            if (dim == 1) fmt::format_to(out, "{:10}{:10}{:10}\n", 0, 1, 1);  // a beam's cross sections
            for (int i = 0; i < n; ++i) {
              const std::uint64_t node = nodes[second ? kParabolic[dim][i] : i];
              fmt::format_to(out, "{:10}{}", node, i + 1 == n || i % 8 == 7 ? "\n" : "");
            }
          }
        });
  }
  end_dataset(file);
}

void write_group(OutputFile& file, const ElementGroups& groups, int number, const std::string& name, int dim,
                 const std::vector<std::uint32_t>& items) {
  file.write(fmt::format("{:10}{:10}{:10}{:10}{:10}{:10}{:10}{:10}\n{}\n", number, 0, 0, 0, 0, 0, 0,
                         items.size(), name));
  file.write_blocks(items.size(), kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
    for (std::size_t k = first; k < last; ++k)
      fmt::format_to(std::back_inserter(bytes), "{:10}{:10}{:10}{:10}{}",
                     dim == 0 ? kNodeMember : kElementMember,
                     dim == 0 ? groups.vertex_nodes[items[k]] + 1 : label_of(groups, dim, items[k]), 0, 0,
                     k % 2 == 1 || k + 1 == items.size() ? "\n" : "");
  });
}

void write_groups(OutputFile& file, const ElementGroups& groups, const SetNames& names) {
  begin_dataset(file, 2467);
  int number = 0;
  for (const auto& [entity, items] : groups.items)
    write_group(file, groups, ++number, names.of.at(entity), entity.dim, items);
  for (const OutlineGroup& set : names.shared)
    if (const auto items = items_of(groups, set); !items.empty())
      write_group(file, groups, ++number, set.name, set.dim, items);
  end_dataset(file);
}

}  // namespace

void write_unv(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  constexpr std::uint64_t kMost = 999'999'999;
  const ElementGroups groups = group_elements(mesh);
  if (std::max<std::uint64_t>(node_count(mesh), groups.total) > kMost)
    throw OutputError("the mesh is too large for a .unv file; use MSH 4.1");
  write_unv_nodes(file, mesh, scale);
  write_elements(file, mesh, groups);
  write_groups(file, groups, set_names(complete_outline(outline, mesh), kLongestUnvName));
}

}  // namespace octet
