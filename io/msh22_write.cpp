// SPDX-License-Identifier: BSD-3-Clause
// MSH 2.2: flat lists of nodes and elements; the demand for it is constant.
#include <fmt/format.h>

#include <iterator>
#include <limits>

#include "base/error.h"
#include "io/msh_entities.h"
#include "io/msh_write.h"

namespace octet {
namespace {

constexpr int kTagsAnElement = 2;  // physical, elementary

void write_nodes(OutputFile& file, const Mesh& mesh, bool binary, double scale) {
  const std::size_t nodes = node_count(mesh);
  file.write(fmt::format("$Nodes\n{}\n", nodes));
  fmt::memory_buffer line;
  for (std::size_t v = 0; v < nodes; ++v) {
    const Vec3 p = node_point(mesh, static_cast<std::uint32_t>(v)) * scale;
    if (binary) {
      file.put(static_cast<int>(v + 1));
      file.write(p.data(), 3 * sizeof(double));
    } else {
      line.clear();
      fmt::format_to(fmt::appender(line), "{} {} {} {}\n", v + 1, p.x(), p.y(), p.z());
      file.write({line.data(), line.size()});
    }
  }
  file.write(binary ? "\n$EndNodes\n" : "$EndNodes\n");
}

void write_ascii_element(OutputFile& file, fmt::memory_buffer& line, ModelRef ref, int type,
                         std::uint64_t tag, const std::uint64_t* nodes, int n) {
  line.clear();
  fmt::format_to(fmt::appender(line), "{} {} {} {} {}", tag, type, kTagsAnElement, ref.tag, ref.tag);
  for (int k = 0; k < n; ++k) fmt::format_to(fmt::appender(line), " {}", nodes[k]);
  line.push_back('\n');
  file.write({line.data(), line.size()});
}

void write_binary_element(OutputFile& file, ModelRef ref, std::uint64_t tag, const std::uint64_t* nodes,
                          int n) {
  int record[3 + kMostNodes] = {static_cast<int>(tag), ref.tag, ref.tag};
  for (int k = 0; k < n; ++k) record[3 + k] = static_cast<int>(nodes[k]);
  file.write(record, (3 + static_cast<std::size_t>(n)) * sizeof(int));
}

void write_elements(OutputFile& file, const Mesh& mesh, const ElementGroups& groups, bool binary) {
  file.write(fmt::format("$Elements\n{}\n", groups.total));
  fmt::memory_buffer line;
  for (const auto& [ref, items] : groups.items) {
    if (binary) {
      const int head[3] = {msh_type(mesh, ref.dim), static_cast<int>(items.size()), kTagsAnElement};
      file.write(head, sizeof head);
    }
    for (const std::uint32_t i : items) {
      std::uint64_t nodes[kMostNodes];
      const int n = element_nodes(mesh, groups, ref.dim, i, nodes);
      const std::uint64_t tag = groups.first_tag[ref.dim] + i;
      if (binary) {
        write_binary_element(file, ref, tag, nodes, n);
      } else {
        write_ascii_element(file, line, ref, msh_type(mesh, ref.dim), tag, nodes, n);
      }
    }
  }
  file.write(binary ? "\n$EndElements\n" : "$EndElements\n");
}

/// As text, in binary files too.
void write_periodic(OutputFile& file, const std::vector<PeriodicLink>& links, double scale) {
  if (links.empty()) return;
  std::string text = fmt::format("$Periodic\n{}\n", links.size());
  for (const PeriodicLink& link : links) {
    text += fmt::format("{} {} {}\nAffine {}\n{}\n", link.entity.dim, link.entity.tag, link.source.tag,
                        fmt::join(scaled_motion(link, scale), " "), link.nodes.size());
    for (const auto& [node, source] : link.nodes) text += fmt::format("{} {}\n", node + 1, source + 1);
  }
  file.write(text + "$EndPeriodic\n");
}

}  // namespace

void write_msh22(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale) {
  const bool binary = encoding == Encoding::kBinary;
  const ElementGroups groups = group_elements(mesh);
  constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
  if (groups.total > kMost || node_count(mesh) > kMost)
    throw OutputError("the mesh is too large for MSH 2.2; use MSH 4.1");
  file.write(fmt::format("$MeshFormat\n2.2 {} 8\n", binary ? 1 : 0));
  if (binary) {
    file.put(int{1});  // tells the byte order
    file.write("\n");
  }
  file.write("$EndMeshFormat\n");
  file.write(physical_names_section(physical_names(complete_outline(outline, mesh), groups)));
  write_nodes(file, mesh, binary, scale);
  write_elements(file, mesh, groups, binary);
  write_periodic(file, outline.links, scale);
}

}  // namespace octet
