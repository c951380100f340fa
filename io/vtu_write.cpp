// SPDX-License-Identifier: BSD-3-Clause
// Raw arrays, for compressing them takes ten times as long as writing them. Their lengths are known before
// their values, so the header in front of them can tell their offsets and they are written as they are made.
#include "io/vtu_write.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include "io/msh_entities.h"
#include "io/vtu_appended.h"

namespace octet {
namespace {

/// By order and dimension.
constexpr std::uint8_t kVtkType[2][4] = {{1, 3, 5, 10}, {1, 21, 22, 24}};
constexpr std::size_t kNodes[2][4] = {{1, 2, 3, 4}, {1, 3, 6, 10}};

/// The cells in order: nodes on model vertices, edges, triangles, tetrahedra.
class Cells {
 public:
  explicit Cells(const Mesh& mesh) : mesh_(mesh), order_(mesh.mid.empty() ? 0 : 1) {
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
      if (node_entity(mesh, v).dim == 0) vertex_nodes_.push_back(v);
    const std::size_t counts[4] = {vertex_nodes_.size(), mesh.edges.size(), mesh.triangles.size(),
                                   mesh.tets.size()};
    for (int dim = 0; dim < 4; ++dim) {
      first_[dim + 1] = first_[dim] + counts[dim];
      first_value_[dim + 1] = first_value_[dim] + counts[dim] * kNodes[order_][dim];
    }
  }
  [[nodiscard]] std::size_t size() const { return first_[4]; }
  /// Length of the connectivity.
  [[nodiscard]] std::uint64_t values() const { return first_value_[4]; }
  [[nodiscard]] int dim(std::size_t cell) const {
    return cell < first_[1] ? 0 : cell < first_[2] ? 1 : cell < first_[3] ? 2 : 3;
  }
  [[nodiscard]] std::uint8_t type(std::size_t cell) const { return kVtkType[order_][dim(cell)]; }
  [[nodiscard]] std::size_t nodes_of(std::size_t cell) const { return kNodes[order_][dim(cell)]; }
  [[nodiscard]] std::int32_t tag(std::size_t cell) const {
    const int d = dim(cell);
    const std::size_t i = cell - first_[d];
    if (d == 0) return mesh_.point_on[vertex_nodes_[i]].tag;
    return d == 1 ? mesh_.edge_on[i] : d == 2 ? mesh_.triangle_on[i] : mesh_.tet_in[i];
  }
  /// Where the cell ends in the connectivity.
  [[nodiscard]] std::uint64_t end(std::size_t cell) const {
    const int d = dim(cell);
    return first_value_[d] + (cell - first_[d] + 1) * std::uint64_t{kNodes[order_][d]};
  }
  template <class T>
  void nodes(std::size_t cell, T* values) const {
    const int d = dim(cell);
    const std::size_t i = cell - first_[d];
    const Mesh::Index* v = d == 0   ? &vertex_nodes_[i]
                           : d == 1 ? mesh_.edges[i].data()
                           : d == 2 ? mesh_.triangles[i].data()
                                    : mesh_.tets[i].data();
    for (int k = 0; k <= d; ++k) *values++ = static_cast<T>(v[k]);
    if (order_ == 0) return;
    const auto add = [&](Mesh::Index m) { *values++ = static_cast<T>(mesh_.points.size() + m); };
    if (d == 1) add(mesh_.mid.of_edges[i]);
    if (d == 2)
      for (const Mesh::Index m : mesh_.mid.of_triangles[i]) add(m);
    if (d == 3)
      for (const std::size_t e : kVtkTetMid) add(mesh_.mid.of_tets[i][e]);
  }

 private:
  const Mesh& mesh_;
  std::size_t order_;  ///< 0: of the first, 1: of the second
  std::vector<std::uint32_t> vertex_nodes_;
  std::size_t first_[5] = {};
  std::uint64_t first_value_[5] = {};
};

/// T: 32 bits while they hold all numbers.
template <class T>
std::string add_cells(VtuAppended& data, const Cells& cells) {
  const Cells* c = &cells;
  return data.add<T>(
             "connectivity", 1, cells.size(), cells.values(), [c](std::size_t i) { return c->nodes_of(i); },
             [c](std::size_t i, T* values) { c->nodes(i, values); }) +
         data.add<T>("offsets", cells.size(), [c](std::size_t i) { return c->end(i); }) +
         data.add<std::uint8_t>("types", cells.size(), [c](std::size_t i) { return c->type(i); });
}

using Colour = std::array<std::uint8_t, 3>;

/// "#rrggbb" to bytes; white for anything else.
Colour colour_of(const std::string& text) {
  constexpr Colour kWhite{255, 255, 255};
  Colour colour = kWhite;
  if (text.size() != 7 || text[0] != '#') return kWhite;
  for (std::size_t i = 0; i < 3; ++i) {
    const char* digits = text.data() + 1 + 2 * i;
    if (std::from_chars(digits, digits + 2, colour[i], 16).ptr != digits + 2) return kWhite;
  }
  return colour;
}

/// The colours of the entities by dimension and tag.
class EntityColours {
 public:
  explicit EntityColours(const ModelOutline& outline) {
    for (std::size_t dim = 0; dim < 4; ++dim)
      for (const OutlineEntity& e : outline.entities[dim]) {
        if (e.colour.empty() || e.tag < 1) continue;
        const auto tag = static_cast<std::size_t>(e.tag);
        if (by_tag_[dim].size() <= tag) by_tag_[dim].resize(tag + 1, Colour{255, 255, 255});
        by_tag_[dim][tag] = colour_of(e.colour);
        any_ = true;
      }
  }
  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] Colour of(int dim, std::int32_t tag) const {
    const auto& colours = by_tag_[static_cast<std::size_t>(dim)];
    const auto index = static_cast<std::size_t>(tag);
    return tag > 0 && index < colours.size() ? colours[index] : Colour{255, 255, 255};
  }

 private:
  std::array<std::vector<Colour>, 4> by_tag_;
  bool any_ = false;
};

std::string add_colours(VtuAppended& data, const Cells& cells, const EntityColours& colours) {
  if (!colours.any()) return {};
  const Cells* c = &cells;
  const EntityColours* of = &colours;
  return data.add<std::uint8_t>(
      "colour", 3, cells.size(), 3 * cells.size(), [](std::size_t) { return std::size_t{3}; },
      [c, of](std::size_t i, std::uint8_t* values) {
        const Colour colour = of->of(c->dim(i), c->tag(i));
        std::copy(colour.begin(), colour.end(), values);
      });
}

/// One line per tag from 1; nothing when all are empty.
std::string add_lines(VtuAppended& data, const std::string& name, const std::vector<OutlineEntity>& entities,
                      std::string OutlineEntity::*member) {
  std::vector<std::string> lines;
  bool any = false;
  for (const OutlineEntity& e : entities) {
    if (e.tag < 1) continue;
    lines.resize(std::max(lines.size(), static_cast<std::size_t>(e.tag)));
    std::string& line = lines[static_cast<std::size_t>(e.tag) - 1] = printable(e.*member);
    any = any || !line.empty();
  }
  if (!any) return {};
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return data.add_text(name, text);
}

std::string add_field_data(VtuAppended& data, const ModelOutline& outline) {
  static constexpr std::array<const char*, 4> kKind{"vertex", "edge", "face", "region"};
  std::string xml;
  for (std::size_t dim = 4; dim-- > 0;) {
    const std::string kind = kKind[dim];
    xml += add_lines(data, kind + "_names", outline.entities[dim], &OutlineEntity::name);
    xml += add_lines(data, kind + "_layers", outline.entities[dim], &OutlineEntity::layer);
    xml += add_lines(data, kind + "_materials", outline.entities[dim], &OutlineEntity::material);
  }
  return xml.empty() ? xml : "    <FieldData>\n" + xml + "    </FieldData>\n";
}

}  // namespace

void write_vtu(OutputFile& file, const Mesh& mesh, const ModelOutline& outline, double scale) {
  VtuAppended data;
  const EntityColours colours(outline);
  const Cells cells(mesh);
  const Mesh* m = &mesh;
  const Cells* c = &cells;
  const std::size_t points = node_count(mesh);
  std::string xml = kVtuHead;
  xml += add_field_data(data, outline);
  xml += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <PointData>\n", points,
                     cells.size());
  xml += data.add<std::int32_t>("entity_dim", points, [m](std::size_t v) {
    return node_entity(*m, static_cast<std::uint32_t>(v)).dim;
  });
  xml += data.add<std::int32_t>("entity_tag", points, [m](std::size_t v) {
    return node_entity(*m, static_cast<std::uint32_t>(v)).tag;
  });
  xml += "      </PointData>\n      <CellData>\n";
  xml += data.add<std::int32_t>("entity_dim", cells.size(), [c](std::size_t i) { return c->dim(i); });
  xml += data.add<std::int32_t>("entity_tag", cells.size(), [c](std::size_t i) { return c->tag(i); });
  xml += data.add<std::int32_t>("region", cells.size(),
                                [c](std::size_t i) { return c->dim(i) == 3 ? c->tag(i) : 0; });
  xml += add_colours(data, cells, colours);
  xml += "      </CellData>\n      <Points>\n";
  xml += data.add<double>(
      "Points", 3, points, 3 * points, [](std::size_t) { return std::size_t{3}; },
      [m, scale](std::size_t v, double* values) {
        const Vec3& p = node_point(*m, static_cast<std::uint32_t>(v));
        for (int i = 0; i < 3; ++i) values[i] = p[i] * scale;
      });
  xml += "      </Points>\n      <Cells>\n";
  const bool narrow = std::max<std::uint64_t>(cells.values(), points) <=
                      static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  xml += narrow ? add_cells<std::int32_t>(data, cells) : add_cells<std::int64_t>(data, cells);
  xml += "      </Cells>\n    </Piece>\n";
  data.write(file, xml);
}

}  // namespace octet
