// SPDX-License-Identifier: BSD-3-Clause
// One grid for each dimension; all share the array of points.
#include "io/xdmf_write.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "io/hdf5_file.h"
#include "io/msh_entities.h"

namespace octet {
namespace {

/// A kind of cell by its name in XDMF, and nodes of one.
struct Cell {
  const char* name;
  std::size_t nodes;
};
constexpr Cell kCells[2][4] = {{{"Polyvertex", 1}, {"Polyline", 2}, {"Triangle", 3}, {"Tetrahedron", 4}},
                               {{"Polyvertex", 1}, {"Edge_3", 3}, {"Triangle_6", 6}, {"Tetrahedron_10", 10}}};
constexpr const char* kGrids[4] = {"vertices", "edges", "faces", "mesh"};
constexpr const char* kTagNames[4] = {"vertex", "edge", "face", "region"};

std::string xml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

class XdmfFile {
 public:
  XdmfFile(OutputFile& file, OutputFile& arrays, const std::string& arrays_name, const Mesh& mesh)
      : file_(file),
        arrays_(arrays),
        arrays_name_(xml(arrays_name)),
        mesh_(mesh),
        groups_(group_elements(mesh)) {}

  void begin(double scale) {
    file_.write("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n");
    arrays_.array<double>("/points", {node_count(mesh_), 3}, [&](std::uint64_t i) {
      return node_point(mesh_, static_cast<std::uint32_t>(i / 3))[static_cast<int>(i % 3)] * scale;
    });
  }

  /// Cells of a dimension; `tags`: of the entity that each is on.
  void write_grid(int dim, const std::vector<std::int32_t>& tags,
                  const std::vector<OutlineEntity>& entities) {
    if (tags.empty()) return;
    const Cell& cell = kCells[mesh_.mid.empty() ? 0 : 1][dim];
    const std::string group = fmt::format("/{}", kGrids[dim]);
    arrays_.group(group);
    const std::uint64_t n = tags.size();
    arrays_.array<std::int32_t>(group + "/topology", {n, cell.nodes}, [&](std::uint64_t i) {
      std::uint64_t nodes[kMostNodes];
      element_nodes(mesh_, groups_, dim, static_cast<std::uint32_t>(i / cell.nodes), nodes, kVtkTetMid);
      return static_cast<std::int32_t>(nodes[i % cell.nodes] - 1);
    });
    arrays_.array<std::int32_t>(group + "/tags", {n, 1}, [&](std::uint64_t i) { return tags[i]; });
    file_.write(fmt::format("    <Grid Name=\"{}\" GridType=\"Uniform\">\n", kGrids[dim]));
    for (const OutlineEntity& e : entities)
      if (!e.name.empty())
        file_.write(fmt::format("      <Information Name=\"{} {}\" Value=\"{}\"/>\n", kTagNames[dim], e.tag,
                                xml(printable(e.name))));
    file_.write(
        fmt::format("      <Topology TopologyType=\"{}\" NumberOfElements=\"{}\" NodesPerElement=\"{}\">\n{} "
                    "     </Topology>\n",
                    cell.name, n, cell.nodes, data_item("Int", 4, n, cell.nodes, group + "/topology")));
    file_.write(fmt::format("      <Geometry GeometryType=\"XYZ\">\n{}      </Geometry>\n",
                            data_item("Float", 8, node_count(mesh_), 3, "/points")));
    file_.write(
        fmt::format("      <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Cell\">\n{}      "
                    "</Attribute>\n    </Grid>\n",
                    kTagNames[dim], data_item("Int", 4, n, 1, group + "/tags")));
  }

  std::vector<std::int32_t> vertex_tags() const {
    std::vector<std::int32_t> tags;
    for (const std::uint32_t v : groups_.vertex_nodes) tags.push_back(node_entity(mesh_, v).tag);
    return tags;
  }

  void end() {
    file_.write("  </Domain>\n</Xdmf>\n");
    arrays_.close();
  }

 private:
  std::string data_item(const char* type, int bytes, std::uint64_t rows, std::uint64_t columns,
                        const std::string& path) const {
    return fmt::format(
        "        <DataItem Dimensions=\"{} {}\" NumberType=\"{}\" Precision=\"{}\" "
        "Format=\"HDF\">{}:{}</DataItem>\n",
        rows, columns, type, bytes, arrays_name_, path);
  }

  OutputFile& file_;
  Hdf5File arrays_;
  std::string arrays_name_;
  const Mesh& mesh_;
  ElementGroups groups_;
};

}  // namespace

void write_xdmf(OutputFile& file, OutputFile& arrays, const std::string& arrays_name, const Mesh& mesh,
                const ModelOutline& outline, double scale) {
  if (node_count(mesh) > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw OutputError("the mesh is too large for an .xdmf file; use MSH 4.1");
  XdmfFile xdmf(file, arrays, arrays_name, mesh);
  xdmf.begin(scale);
  xdmf.write_grid(3, mesh.tet_in, outline.entities[3]);
  xdmf.write_grid(2, mesh.triangle_on, outline.entities[2]);
  xdmf.write_grid(1, mesh.edge_on, outline.entities[1]);
  xdmf.write_grid(0, xdmf.vertex_tags(), outline.entities[0]);
  xdmf.end();
}

}  // namespace octet
