// SPDX-License-Identifier: BSD-3-Clause
// Counts in the file are promises, not facts: each is held against the bytes that are left.
#include "io/msh_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "base/error.h"
#include "io/byte_cursor.h"
#include "io/msh_entities.h"

namespace octet {
namespace {

/// Numbers by the file's encoding.
class Source {
 public:
  ByteCursor cursor;
  bool binary = false;
  bool swap = false;

  explicit Source(std::string_view bytes) : cursor(bytes) {}
  std::int32_t integer() {
    if (binary) return cursor.raw<std::int32_t>(swap);
    const std::int64_t value = cursor.integer();
    if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
      cursor.fail("a number is too large for a tag");
    return static_cast<std::int32_t>(value);
  }
  std::uint64_t size() {
    if (binary) return cursor.raw<std::uint64_t>(swap);
    const std::int64_t value = cursor.integer();
    if (value < 0) cursor.fail("a count or a tag is negative");
    return static_cast<std::uint64_t>(value);
  }
  double real() { return binary ? cursor.raw<double>(swap) : cursor.real(); }
  /// Bytes that a number takes at least.
  [[nodiscard]] std::size_t least(std::size_t binary_bytes) const { return binary ? binary_bytes : 2; }
};

int nodes_of_type(Source& in, int type) {
  switch (type) {
    case 15:
      return 1;
    case 1:
      return 2;
    case 2:
    case 8:
      return 3;
    case 4:
      return 4;
    case 9:
      return 6;
    case 11:
      return 10;
    default:
      in.cursor.fail(fmt::format(
          "element type {} is not read: only points, and lines, triangles and tetrahedra of first "
          "and second order are",
          type));
  }
}

void add_element(RawMesh& mesh, int type, std::uint64_t tag, std::int32_t entity,
                 const std::uint64_t* nodes) {
  const auto as_given = [](std::size_t k) { return k; };
  switch (type) {
    case 15:
      mesh.vertices.add(tag, entity, nodes);
      break;
    case 1:
      mesh.edges.add(tag, entity, nodes);
      break;
    case 2:
      mesh.triangles.add(tag, entity, nodes);
      break;
    case 4:
      mesh.tets.add(tag, entity, nodes);
      break;
    case 8:
      mesh.edges.add_second(tag, entity, nodes, as_given);
      break;
    case 9:
      mesh.triangles.add_second(tag, entity, nodes, as_given);
      break;
    default:
      mesh.tets.add_second(tag, entity, nodes, [](std::size_t k) { return kMshTetMid[k]; });
  }
}

Vec3 read_point(Source& in) {
  Vec3 p;
  for (int i = 0; i < 3; ++i) p[i] = in.real();
  return p;
}

/// [MSH 4.1, $Nodes]
void read_nodes41(Source& in, RawMesh& mesh) {
  const auto blocks = in.cursor.checked_count(in.size(), in.least(20), "blocks of nodes");
  for (int i = 0; i < 3; ++i) (void)in.size();
  for (std::size_t b = 0; b < blocks; ++b) {
    const int dim = in.integer();
    const int entity = in.integer();
    const bool parametric = in.integer() != 0;
    if (dim < 0 || dim > 3) in.cursor.fail(fmt::format("an entity has dimension {}", dim));
    const auto n = in.cursor.checked_count(in.size(), in.least(32), "nodes");
    for (std::size_t i = 0; i < n; ++i) {
      mesh.node_tag.push_back(in.size());
      mesh.point_on.push_back({dim, entity});
    }
    for (std::size_t i = 0; i < n; ++i) {
      mesh.points.push_back(read_point(in));
      for (int k = 0; parametric && k < dim; ++k) (void)in.real();
    }
  }
}

/// [MSH 4.1, $Elements]
void read_elements41(Source& in, RawMesh& mesh) {
  const auto blocks = in.cursor.checked_count(in.size(), in.least(20), "blocks of elements");
  for (int i = 0; i < 3; ++i) (void)in.size();
  for (std::size_t b = 0; b < blocks; ++b) {
    (void)in.integer();  // the dimension, which the type tells too
    const int entity = in.integer();
    const int type = in.integer();
    const int nodes_each = nodes_of_type(in, type);
    const auto n = in.cursor.checked_count(in.size(), in.least(16), "elements");
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint64_t tag = in.size();
      std::uint64_t nodes[kMostNodes] = {};
      for (int k = 0; k < nodes_each; ++k) nodes[k] = in.size();
      add_element(mesh, type, tag, entity, nodes);
    }
  }
}

std::size_t count22(Source& in, std::size_t least_bytes, const char* what) {
  const std::int64_t n = in.cursor.integer();
  if (n < 0) in.cursor.fail("a count is negative");
  if (in.binary) (void)in.cursor.line();
  return in.cursor.checked_count(static_cast<std::uint64_t>(n), in.least(least_bytes), what);
}

std::uint64_t positive(Source& in) {
  const std::int32_t value = in.integer();
  if (value < 0) in.cursor.fail("a tag is negative");
  return static_cast<std::uint64_t>(value);
}

/// [MSH 2.2, $Nodes]
void read_nodes22(Source& in, RawMesh& mesh) {
  const std::size_t n = count22(in, 28, "nodes");
  for (std::size_t i = 0; i < n; ++i) {
    mesh.node_tag.push_back(positive(in));
    mesh.points.push_back(read_point(in));
    mesh.point_on.push_back({});
  }
}

/// One element behind its type: tag, number of tags (ASCII only), tags, nodes.
void read_element22(Source& in, RawMesh& mesh, int type, std::uint64_t tag, std::int32_t tags) {
  if (tags < 0) in.cursor.fail("a number of tags is negative");
  std::int32_t entity = 0;
  for (std::int32_t k = 0; k < tags; ++k) {
    const std::int32_t value = in.integer();
    if (k < 2) entity = value;  // physical, then elementary
  }
  std::uint64_t nodes[kMostNodes] = {};
  const int nodes_each = nodes_of_type(in, type);
  for (int k = 0; k < nodes_each; ++k) nodes[k] = positive(in);
  add_element(mesh, type, tag, entity, nodes);
}

/// [MSH 2.2, $Elements]
void read_elements22(Source& in, RawMesh& mesh) {
  const std::size_t n = count22(in, 8, "elements");
  for (std::size_t done = 0; done < n;) {
    if (!in.binary) {
      const std::uint64_t tag = positive(in);
      const int type = in.integer();
      read_element22(in, mesh, type, tag, in.integer());
      ++done;
      continue;
    }
    const int type = in.integer();
    const std::int32_t follow = in.integer();
    const std::int32_t tags = in.integer();
    if (follow <= 0 || static_cast<std::size_t>(follow) > n - done)
      in.cursor.fail("a block of elements has a wrong length");
    for (std::int32_t i = 0; i < follow; ++i) read_element22(in, mesh, type, positive(in), tags);
    done += static_cast<std::size_t>(follow);
  }
}

/// Returns whether the version is 4.1 (else 2.2).
bool read_format(Source& in) {
  const std::string version(in.cursor.word());
  const std::int64_t file_type = in.cursor.integer();
  const std::int64_t data_size = in.cursor.integer();
  if (version != "4.1" && version != "2.2" && version != "2" && version != "2.0" && version != "2.1")
    in.cursor.fail(
        fmt::format("MSH version \"{}\" is not read: only 4.1 and 2.2 are", version.substr(0, 20)));
  if (data_size != 8) in.cursor.fail("numbers of a size other than 8 bytes are not read");
  if (file_type != 0 && file_type != 1) in.cursor.fail("the file is neither ASCII nor binary");
  in.binary = file_type == 1;
  if (in.binary) {
    (void)in.cursor.line();
    if (in.cursor.raw<std::int32_t>(false) != 1) in.swap = true;
  }
  return version == "4.1";
}

/// How many words or numbers of text follow.
std::int64_t text_count(Source& in, const char* what) {
  const std::int64_t n = in.cursor.integer();
  if (n < 0) in.cursor.fail("a count is negative");
  return static_cast<std::int64_t>(in.cursor.checked_count(static_cast<std::uint64_t>(n), 2, what));
}

/// [MSH 4.1 and 2.2, $NodeData, $ElementData, $ElementNodeData]: what stands before the values is text in
/// binary files, too.
RawView read_view(Source& in, RawView::On on) {
  RawView view;
  view.on = on;
  for (std::int64_t n = text_count(in, "texts of a view"), i = 0; i < n; ++i) {
    in.cursor.skip_blanks();
    const std::string_view text = in.cursor.line();
    if (i > 0) continue;
    const std::size_t first = text.find('"'), last = text.rfind('"');
    view.name = last > first ? text.substr(first + 1, last - first - 1) : text;
  }
  for (std::int64_t n = text_count(in, "real numbers of a view"); n > 0; --n) (void)in.cursor.real();
  std::int64_t word[3] = {0, 1, 0};  // step, components, values
  for (std::int64_t n = text_count(in, "integers of a view"), i = 0; i < n; ++i) {
    const std::int64_t value = in.cursor.integer();
    if (i < 3) word[i] = value;
  }
  (void)in.cursor.line();
  if (word[1] < 1 || word[1] > 9 || word[2] < 0) in.cursor.fail("a view has an impossible number of values");
  view.components = static_cast<int>(word[1]);
  const auto values = in.cursor.checked_count(static_cast<std::uint64_t>(word[2]), in.least(12), "values");
  for (std::size_t i = 0; i < values; ++i) {
    view.tag.push_back(positive(in));
    const std::int32_t nodes = on == RawView::On::kElementNodes ? in.integer() : 1;
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t k = 0; k < nodes; ++k) {
      least = std::min(least, in.real());
      for (int c = 1; c < view.components; ++c) (void)in.real();
    }
    view.value.push_back(least);
  }
  return view;
}

std::optional<RawView::On> place_of_view(const std::string& section) {
  if (section == "NodeData") return RawView::On::kNodes;
  if (section == "ElementData") return RawView::On::kElements;
  if (section == "ElementNodeData") return RawView::On::kElementNodes;
  return std::nullopt;
}

void end_section(Source& in, const std::string& name) {
  const std::string end = "$End" + name;
  if (in.cursor.word() != end)
    in.cursor.fail(fmt::format("the section {} does not end where it should", name));
}

}  // namespace

RawMesh read_msh(std::string_view bytes, bool views_suffice) {
  Source in(bytes);
  RawMesh mesh;
  bool version41 = false, formatted = false, has_nodes = false, has_elements = false;
  while (!in.cursor.at_end()) {
    const std::string_view word = in.cursor.word();
    if (word.size() < 2 || word[0] != '$') in.cursor.fail("a section ($...) is expected");
    const std::string name(word.substr(1));
    (void)in.cursor.line();
    if (!formatted && name != "MeshFormat") in.cursor.fail("the file does not begin with $MeshFormat");
    if (name == "MeshFormat") {
      version41 = read_format(in);
      formatted = true;
    } else if (name == "Nodes") {
      version41 ? read_nodes41(in, mesh) : read_nodes22(in, mesh);
      has_nodes = true;
    } else if (name == "Elements") {
      version41 ? read_elements41(in, mesh) : read_elements22(in, mesh);
      has_elements = true;
    } else if (const auto on = place_of_view(name)) {
      mesh.views.push_back(read_view(in, *on));
    } else {
      if (!in.cursor.skip_past("$End" + name)) in.cursor.fail(fmt::format("the section {} has no end", name));
      continue;
    }
    end_section(in, name);
  }
  if ((!has_nodes || !has_elements) && !(views_suffice && !mesh.views.empty()))
    throw InputError("the file has no nodes or no elements");
  return mesh;
}

}  // namespace octet
