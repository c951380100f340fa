// SPDX-License-Identifier: BSD-3-Clause
// Keyword, number, items; in binary each keyword tells where the next one stands.
#include "io/medit_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/msh_entities.h"
#include "io/set_names.h"

namespace octet {
namespace {

/// A keyword's name, and its number in binary files.
struct Keyword {
  const char* name;
  std::int32_t code;
};
constexpr Keyword kDimension{"Dimension", 3}, kVertices{"Vertices", 4}, kCorners{"Corners", 13},
    kEnd{"End", 54};
/// Elements by order and dimension.
constexpr Keyword kMeditElements[2][4] = {{{}, {"Edges", 5}, {"Triangles", 6}, {"Tetrahedra", 8}},
                                          {{}, {"EdgesP2", 25}, {"TrianglesP2", 24}, {"TetrahedraP2", 30}}};

/// Numbers as text, blanks between and a line for each item, or as the machine keeps them.
class Items {
 public:
  Items(std::string& bytes, Encoding encoding) : bytes_(bytes), encoding_(encoding) {}

  Items& operator<<(double x) {
    add(x);
    return *this;
  }
  Items& operator<<(std::uint64_t n) {
    add(static_cast<std::int32_t>(n));
    return *this;
  }
  void end_item() {
    if (encoding_ == Encoding::kAscii) bytes_.back() = '\n';
  }

 private:
  template <class T>
  void add(T value) {
    if (encoding_ == Encoding::kAscii) {
      fmt::format_to(std::back_inserter(bytes_), "{} ", value);
    } else {
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }

  std::string& bytes_;
  Encoding encoding_;
};

class MeditFile {
 public:
  /// `wide`: places in a binary file have eight bytes, in place of four.
  MeditFile(OutputFile& file, Encoding encoding, bool wide) : file_(file), encoding_(encoding), wide_(wide) {}

  void begin(const ModelOutline& outline) {
    if (encoding_ == Encoding::kAscii) {
      file_.write("MeshVersionFormatted 2\n\nDimension 3\n\n");
      write_names(outline);
      return;
    }
    put(std::int32_t{1});  // tells the order of bytes
    put(std::int32_t{wide_ ? 3 : 2});
    put_keyword(kDimension, 0);
    put(std::int32_t{3});
  }

  /// Items of one keyword, `integers` and `reals` each; write(i, items) adds those of the i-th.
  template <class Write>
  void section(Keyword keyword, std::size_t n, std::size_t integers, std::size_t reals, const Write& write) {
    if (n == 0) return;
    if (encoding_ == Encoding::kAscii) {
      file_.write(fmt::format("{}\n{}\n", keyword.name, n));
    } else {
      const std::size_t bytes = n * (integers * sizeof(std::int32_t) + reals * sizeof(double));
      put_keyword(keyword, bytes);
      put(static_cast<std::int32_t>(n));
      at_ += bytes;
    }
    file_.write_blocks(n, kItemsATask, [&](std::size_t first, std::size_t last, std::string& bytes) {
      Items items(bytes, encoding_);
      for (std::size_t i = first; i < last; ++i) {
        write(i, items);
        items.end_item();
      }
    });
    if (encoding_ == Encoding::kAscii) file_.write("\n");
  }

  void end() {
    if (encoding_ == Encoding::kAscii) {
      file_.write(fmt::format("{}\n", kEnd.name));
    } else {
      put(kEnd.code);
      put_place(0);
    }
  }

 private:
  template <class T>
  void put(const T& value) {
    file_.put(value);
    at_ += sizeof value;
  }

  void put_place(std::size_t place) {
    if (wide_) {
      put(static_cast<std::int64_t>(place));
    } else {
      put(static_cast<std::int32_t>(place));
    }
  }

  /// A keyword, and where the next one stands: behind a number of four bytes and so many more.
  void put_keyword(Keyword keyword, std::size_t bytes) {
    put(keyword.code);
    put_place(at_ + (wide_ ? 8 : 4) + 4 + bytes);
  }

  void write_names(const ModelOutline& outline) {
    std::string text;
    for (int dim = 3; dim >= 0; --dim)
      for (const OutlineEntity& e : outline.entities[static_cast<std::size_t>(dim)])
        if (!e.name.empty()) text += fmt::format("# {}: {}\n", entity_name({dim, e.tag}), printable(e.name));
    if (!text.empty()) file_.write(text + "\n");
  }

  OutputFile& file_;
  Encoding encoding_;
  bool wide_;
  std::size_t at_ = 0;  ///< where in a binary file
};

/// No fewer than a binary file has.
std::size_t bytes_at_most(const Mesh& mesh) {
  constexpr std::size_t kHeads = 1024;
  const bool second = !mesh.mid.empty();
  // A node has a reference, and may be a corner.
  const std::size_t integers = 2 * node_count(mesh) + mesh.edges.size() * (second ? 4 : 3) +
                               mesh.triangles.size() * (second ? 7 : 4) +
                               mesh.tets.size() * (second ? 11 : 5);
  return kHeads + node_count(mesh) * 3 * sizeof(double) + integers * sizeof(std::int32_t);
}

void write_elements(MeditFile& file, const Mesh& mesh, const ElementGroups& groups, int dim,
                    const std::vector<std::int32_t>& tags) {
  const bool second = !mesh.mid.empty();
  constexpr std::size_t kNodes[2][4] = {{1, 2, 3, 4}, {1, 3, 6, 10}};
  const std::size_t nodes = kNodes[second ? 1 : 0][dim];
  file.section(kMeditElements[second ? 1 : 0][dim], tags.size(), nodes + 1, 0,
               [&](std::size_t i, Items& items) {
                 std::uint64_t own[kMostNodes];
                 element_nodes(mesh, groups, dim, static_cast<std::uint32_t>(i), own, kVtkTetMid);
                 for (std::size_t k = 0; k < nodes; ++k) items << own[k];
                 items << static_cast<std::uint64_t>(tags[i]);
               });
}

}  // namespace

void write_medit(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, Encoding encoding,
                 double scale, std::size_t most_narrow) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  const std::size_t nodes = node_count(mesh);
  if (std::max({nodes, mesh.tets.size(), mesh.triangles.size()}) > kMost)
    throw OutputError("the mesh is too large for a .mesh file; use MSH 4.1");
  const ElementGroups groups = group_elements(mesh);
  MeditFile medit(file, encoding, bytes_at_most(mesh) > most_narrow);
  medit.begin(outline);
  medit.section(kVertices, nodes, 1, 3, [&](std::size_t v, Items& items) {
    const auto node = static_cast<std::uint32_t>(v);
    const Vec3 p = node_point(mesh, node) * scale;
    items << p.x() << p.y() << p.z() << static_cast<std::uint64_t>(node_entity(mesh, node).tag);
  });
  medit.section(kCorners, groups.vertex_nodes.size(), 1, 0,
                [&](std::size_t i, Items& items) { items << std::uint64_t{groups.vertex_nodes[i]} + 1; });
  write_elements(medit, mesh, groups, 1, mesh.edge_on);
  write_elements(medit, mesh, groups, 2, mesh.triangle_on);
  write_elements(medit, mesh, groups, 3, mesh.tet_in);
  medit.end();
}

}  // namespace octet
