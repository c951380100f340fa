// SPDX-License-Identifier: BSD-3-Clause
// MSH 4.1: one walk over the sections, with a sink that prints or copies each number.
#include <fmt/format.h>

#include <iterator>

#include "io/msh_entities.h"
#include "io/msh_write.h"

namespace octet {
namespace {

/// Rows a task.
constexpr std::size_t kMshBlock = 8192;

/// Numbers as text separated by blanks, or as the machine's bytes, appended to `out`.
class Row {
 public:
  Row(std::string& out, bool binary) : out_(out), binary_(binary) {}
  void integer(int value) { put(&value, 1); }
  void size(std::uint64_t value) { put(&value, 1); }
  void sizes(const std::uint64_t* values, int n) { put(values, n); }
  void reals(const Vec3& values) { put(values.data(), 3); }
  void reals(const std::array<double, 16>& values) { put(values.data(), 16); }
  void end_line() {
    if (!binary_) out_.push_back('\n');
    begun_ = false;
  }

 private:
  template <class T>
  void put(const T* values, int n) {
    if (binary_) {
      out_.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(n) * sizeof(T));
      return;
    }
    for (int i = 0; i < n; ++i) {
      if (begun_) out_.push_back(' ');
      fmt::format_to(std::back_inserter(out_), "{}", values[i]);
      begun_ = true;
    }
  }
  std::string& out_;
  bool binary_;
  bool begun_ = false;
};

/// The sections of the file.
class Sink {
 public:
  Sink(OutputFile& file, Encoding encoding) : file_(file), binary_(encoding == Encoding::kBinary) {}
  /// One line that fill(row) makes.
  template <class Fill>
  void line(const Fill& fill) {
    std::string bytes;
    Row row(bytes, binary_);
    fill(row);
    row.end_line();
    file_.write(bytes);
  }
  /// n lines; fill(row, i) makes the i-th, in parallel.
  template <class Fill>
  void lines(std::size_t n, const Fill& fill) {
    file_.write_blocks(n, kMshBlock, [&](std::size_t first, std::size_t last, std::string& bytes) {
      Row row(bytes, binary_);
      for (std::size_t i = first; i < last; ++i) {
        fill(row, i);
        row.end_line();
      }
    });
  }
  void begin(const char* section) { file_.write(fmt::format("${}\n", section)); }
  void end(const char* section) { file_.write(fmt::format("{}$End{}\n", binary_ ? "\n" : "", section)); }

 private:
  OutputFile& file_;
  bool binary_;
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

/// Numbers of the physical groups that hold each entity: the first is its own, which is all that some readers
/// take.
using GroupsOf = std::map<ModelRef, std::vector<int>>;

GroupsOf groups_of_entities(const std::map<ModelRef, std::string>& names,
                            const std::vector<PhysicalSet>& sets) {
  GroupsOf groups;
  for (const auto& entity : names) groups[entity.first] = {entity.first.tag};
  for (const PhysicalSet& set : sets)
    for (const int tag : set.tags) groups[{set.dim, tag}].push_back(set.number);
  return groups;
}

void write_entity(Row& row, int dim, const OutlineEntity& entity, const GroupsOf& groups, double scale) {
  row.integer(entity.tag);
  row.reals(entity.box.lo * scale);
  if (dim > 0) row.reals(entity.box.hi * scale);
  const auto own = groups.find({dim, entity.tag});
  row.size(own == groups.end() ? 0 : own->second.size());
  if (own != groups.end())
    for (const int number : own->second) row.integer(number);
  if (dim > 0) {
    row.size(entity.bounded_by.size());
    for (const int tag : entity.bounded_by) row.integer(tag);
  }
}

void write_entities(Sink& sink, const ModelOutline& outline, const GroupsOf& groups, double scale) {
  sink.begin("Entities");
  sink.line([&](Row& row) {
    for (const auto& entities : outline.entities) row.size(entities.size());
  });
  for (int dim = 0; dim < 4; ++dim)
    for (const auto& entity : outline.entities[dim])
      sink.line([&](Row& row) { write_entity(row, dim, entity, groups, scale); });
  sink.end("Entities");
}

/// Blocks, items, and the least and largest tag.
void write_counts(Sink& sink, std::size_t blocks, std::uint64_t items) {
  const std::uint64_t counts[4] = {blocks, items, items == 0 ? 0u : 1u, items};
  sink.line([&](Row& row) { row.sizes(counts, 4); });
}

void write_block_head(Sink& sink, ModelRef ref, int kind, std::size_t items) {
  sink.line([&](Row& row) {
    row.integer(ref.dim);
    row.integer(ref.tag);
    row.integer(kind);
    row.size(items);
  });
}

void write_nodes(Sink& sink, const Mesh& mesh, double scale) {
  const ItemsOn blocks = group_nodes(mesh);
  sink.begin("Nodes");
  write_counts(sink, blocks.size(), node_count(mesh));
  for (const auto& [ref, nodes] : blocks) {
    write_block_head(sink, ref, 0, nodes.size());  // 0: no parameters on the entity
    const auto& items = nodes;
    sink.lines(items.size(), [&](Row& row, std::size_t i) { row.size(std::uint64_t{items[i]} + 1); });
    sink.lines(items.size(), [&](Row& row, std::size_t i) { row.reals(node_point(mesh, items[i]) * scale); });
  }
  sink.end("Nodes");
}

void write_elements(Sink& sink, const Mesh& mesh, const ElementGroups& groups) {
  sink.begin("Elements");
  write_counts(sink, groups.items.size(), groups.total);
  for (const auto& group : groups.items) {
    const ModelRef ref = group.first;
    const auto& items = group.second;
    write_block_head(sink, ref, msh_type(mesh, ref.dim), items.size());
    sink.lines(items.size(), [&](Row& row, std::size_t i) {
      std::uint64_t record[1 + kMostNodes] = {groups.first_tag[ref.dim] + items[i]};
      row.sizes(record, 1 + element_nodes(mesh, groups, ref.dim, items[i], record + 1));
    });
  }
  sink.end("Elements");
}

void write_periodic(Sink& sink, const std::vector<PeriodicLink>& links, double scale) {
  if (links.empty()) return;
  sink.begin("Periodic");
  sink.line([&](Row& row) { row.size(links.size()); });
  for (const PeriodicLink& link : links) {
    sink.line([&](Row& row) {
      row.integer(link.entity.dim);
      row.integer(link.entity.tag);
      row.integer(link.source.tag);
    });
    sink.line([&](Row& row) {
      row.size(16);
      row.reals(scaled_motion(link, scale));
    });
    sink.line([&](Row& row) { row.size(link.nodes.size()); });
    sink.lines(link.nodes.size(), [&](Row& row, std::size_t i) {
      for (const std::uint32_t node : link.nodes[i]) row.size(std::uint64_t{node} + 1);
    });
  }
  sink.end("Periodic");
}

}  // namespace

void write_msh41(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale) {
  const ModelOutline whole = complete_outline(outline, mesh);
  const ElementGroups groups = group_elements(mesh);
  const auto names = physical_names(whole, groups);
  write_header(file, encoding);
  const auto sets = physical_sets(whole, groups, names);
  file.write(physical_names_section(names, sets));
  Sink sink(file, encoding);
  write_entities(sink, whole, groups_of_entities(names, sets), scale);
  write_nodes(sink, mesh, scale);
  write_elements(sink, mesh, groups);
  write_periodic(sink, whole.links, scale);
}

}  // namespace octet
