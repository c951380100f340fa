// SPDX-License-Identifier: BSD-3-Clause
// MSH 4.1: one walk over the sections, with a sink that prints or copies each number.
#include <fmt/format.h>

#include "io/msh_entities.h"
#include "io/msh_write.h"

namespace octet {
namespace {

/// Numbers as text separated by blanks, or as the machine's bytes.
class Sink {
 public:
  Sink(OutputFile& file, Encoding encoding) : file_(file), binary_(encoding == Encoding::kBinary) {}
  void integer(int value) { put(value); }
  void size(std::uint64_t value) { put(value); }
  void real(double value) { put(value); }
  void end_line() {
    if (binary_) return;
    line_.push_back('\n');
    file_.write({line_.data(), line_.size()});
    line_.clear();
  }
  void begin(const char* section) { file_.write(fmt::format("${}\n", section)); }
  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", binary_ ? "\n" : "", section)); }

 private:
  template <class T>
  void put(T value) {
    if (binary_) {
      file_.put(value);
      return;
    }
    if (line_.size() > 0) line_.push_back(' ');
    fmt::format_to(fmt::appender(line_), "{}", value);
  }
  OutputFile& file_;
  bool binary_;
  fmt::memory_buffer line_;
};

void write_header(OutputFile& file, Encoding encoding) {
  const bool binary = encoding == Encoding::kBinary;
  file.write(fmt::format("$MeshFormat\n4.1 {} 8\n", binary ? 1 : 0));
  if (binary) {
    file.put(int{1});  // tells the byte order
    file.write("\n");
  }
  file.write("$EndMeshFormat\n");
}

void write_entity(Sink& sink, int dim, const OutlineEntity& entity, bool in_group, double scale) {
  sink.integer(entity.tag);
  for (int i = 0; i < 3; ++i) sink.real(entity.box.lo[i] * scale);
  if (dim > 0)
    for (int i = 0; i < 3; ++i) sink.real(entity.box.hi[i] * scale);
  sink.size(in_group ? 1 : 0);
  if (in_group) sink.integer(entity.tag);
  if (dim > 0) {
    sink.size(entity.bounded_by.size());
    for (const int tag : entity.bounded_by) sink.integer(tag);
  }
  sink.end_line();
}

void write_entities(Sink& sink, const ModelOutline& outline, const std::map<ModelRef, std::string>& names,
                    double scale) {
  sink.begin("Entities");
  for (const auto& entities : outline.entities) sink.size(entities.size());
  sink.end_line();
  for (int dim = 0; dim < 4; ++dim)
    for (const auto& entity : outline.entities[dim])
      write_entity(sink, dim, entity, names.contains({dim, entity.tag}), scale);
  sink.end("Entities");
}

void write_nodes(Sink& sink, const Mesh& mesh, double scale) {
  const ItemsOn blocks = group_nodes(mesh);
  sink.begin("Nodes");
  sink.size(blocks.size());
  sink.size(mesh.points.size());
  sink.size(mesh.points.empty() ? 0 : 1);
  sink.size(mesh.points.size());
  sink.end_line();
  for (const auto& [ref, nodes] : blocks) {
    sink.integer(ref.dim);
    sink.integer(ref.tag);
    sink.integer(0);  // no parameters on the entity
    sink.size(nodes.size());
    sink.end_line();
    for (const std::uint32_t v : nodes) {
      sink.size(std::uint64_t{v} + 1);
      sink.end_line();
    }
    for (const std::uint32_t v : nodes) {
      for (int i = 0; i < 3; ++i) sink.real(mesh.points[v][i] * scale);
      sink.end_line();
    }
  }
  sink.end("Nodes");
}

void write_elements(Sink& sink, const Mesh& mesh) {
  const ElementGroups groups = group_elements(mesh);
  sink.begin("Elements");
  sink.size(groups.items.size());
  sink.size(groups.total);
  sink.size(groups.total == 0 ? 0 : 1);
  sink.size(groups.total);
  sink.end_line();
  for (const auto& [ref, items] : groups.items) {
    sink.integer(ref.dim);
    sink.integer(ref.tag);
    sink.integer(kMshType[ref.dim]);
    sink.size(items.size());
    sink.end_line();
    for (const std::uint32_t i : items) {
      std::uint64_t nodes[4];
      const int n = element_nodes(mesh, groups, ref.dim, i, nodes);
      sink.size(groups.first_tag[ref.dim] + i);
      for (int k = 0; k < n; ++k) sink.size(nodes[k]);
      sink.end_line();
    }
  }
  sink.end("Elements");
}

}  // namespace

void write_msh41(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale) {
  const ModelOutline whole = complete_outline(outline, mesh);
  const auto names = physical_names(whole);
  write_header(file, encoding);
  file.write(physical_names_section(names));
  Sink sink(file, encoding);
  write_entities(sink, whole, names, scale);
  write_nodes(sink, mesh, scale);
  write_elements(sink, mesh);
}

}  // namespace octet
