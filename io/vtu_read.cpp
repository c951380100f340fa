// SPDX-License-Identifier: BSD-3-Clause
// Points and cells with the arrays that tell their model entities.
#include "io/vtu_read.h"

#include <fmt/format.h>

#include <limits>

#include "base/error.h"
#include "io/msh_entities.h"
#include "io/vtu_file.h"

namespace octet {
namespace {

void read_points(const VtuFile& file, RawMesh& mesh) {
  const std::uint64_t n = file.points();
  if (n > std::numeric_limits<std::uint32_t>::max())
    throw InputError("the VTU file announces too many points");
  const auto xyz = file.array<double>("Points", "", 3 * n);
  const auto dim = file.array<std::int32_t>("PointData", "entity_dim", n);
  const auto tag = file.array<std::int32_t>("PointData", "entity_tag", n);
  for (std::size_t i = 0; i < n; ++i) {
    if (dim[i] < 0 || dim[i] > 3) throw InputError("a VTU point has an entity_dim that is not 0..3");
    mesh.node_tag.push_back(i);
    mesh.points.emplace_back(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    mesh.point_on.push_back({dim[i], tag[i]});
  }
}

void add_cell(RawMesh& mesh, std::uint64_t cell, std::uint8_t type, std::int32_t entity,
              const std::uint64_t* nodes, std::uint64_t count) {
  if (type == 1 && count == 1) return mesh.vertices.add(cell, entity, nodes);
  if (type == 3 && count == 2) return mesh.edges.add(cell, entity, nodes);
  if (type == 5 && count == 3) return mesh.triangles.add(cell, entity, nodes);
  if (type == 10 && count == 4) return mesh.tets.add(cell, entity, nodes);
  const auto as_given = [](std::size_t k) { return k; };
  if (type == 21 && count == 3) return mesh.edges.add_second(cell, entity, nodes, as_given);
  if (type == 22 && count == 6) return mesh.triangles.add_second(cell, entity, nodes, as_given);
  if (type == 24 && count == 10)
    return mesh.tets.add_second(cell, entity, nodes, [](std::size_t k) { return kVtkTetMid[k]; });
  throw InputError(fmt::format("VTU cell {} of type {} is not read", cell, type));
}

void read_cells(const VtuFile& file, RawMesh& mesh) {
  const std::uint64_t n = file.cells();
  const auto types = file.array<std::uint8_t>("Cells", "types", n);
  const auto offsets = file.array<std::int64_t>("Cells", "offsets", n);
  const auto tag = file.array<std::int32_t>("CellData", "entity_tag", n);
  const std::int64_t length = n == 0 ? 0 : offsets.back();
  if (length < 0) throw InputError("the VTU file has a negative offset");
  const auto connectivity =
      file.array<std::int64_t>("Cells", "connectivity", static_cast<std::uint64_t>(length));
  std::int64_t start = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const std::int64_t count = offsets[i] - start;
    if (count < 1 || count > static_cast<std::int64_t>(kMostNodes) || offsets[i] > length)
      throw InputError(fmt::format("VTU cell {} has a wrong number of nodes", i));
    std::uint64_t nodes[kMostNodes] = {};
    for (std::int64_t k = 0; k < count; ++k) nodes[k] = static_cast<std::uint64_t>(connectivity[start + k]);
    add_cell(mesh, i, types[i], tag[i], nodes, static_cast<std::uint64_t>(count));
    start = offsets[i];
  }
}

}  // namespace

RawMesh read_vtu(std::string_view bytes) {
  const VtuFile file(bytes);
  RawMesh mesh;
  read_points(file, mesh);
  read_cells(file, mesh);
  return mesh;
}

}  // namespace octet
