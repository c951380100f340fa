// SPDX-License-Identifier: BSD-3-Clause
// Gathering octant edges once each.
#include "octree/octant_edges.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <functional>

#include "base/blocks.h"
#include "base/bucket_sort.h"

namespace octet {
namespace {

/// From, middle and to of the twelve edges, as places of the octant's 3x3x3 lattice.
constexpr std::array<std::array<std::uint8_t, 3>, 12> edge_places() {
  std::array<std::array<std::uint8_t, 3>, 12> places{};
  constexpr std::array<int, 3> kStride{1, 3, 9};
  int edge = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 4; ++side, ++edge) {
      const int from = 2 * (side & 1) * kStride[(axis + 1) % 3] + 2 * (side >> 1) * kStride[(axis + 2) % 3];
      for (int step = 0; step < 3; ++step) {
        places[edge][step] = static_cast<std::uint8_t>(from + step * kStride[axis]);
      }
    }
  }
  return places;
}

}  // namespace

std::vector<OctantEdge> boundary_octant_edges(const Octree& tree, const OctreeVertices& vertices,
                                              const OctantTypes& types) {
  static constexpr auto kPlaces = edge_places();
  // Packed as numbers, which sort faster than pairs and in the same order.
  using Lines = std::vector<std::uint64_t>;
  const auto add = [](Lines& lines, std::uint32_t from, std::uint32_t to) {
    lines.push_back(std::uint64_t{std::min(from, to)} << 32 | std::max(from, to));
  };
  Lines along_axes = collect<std::uint64_t>(tree.size(), [&](std::size_t i, Lines& lines) {
    if (types.type[i] != OctantType::kBoundary) return;
    const OctantId o(i);
    const OctantLattice lattice = octant_lattice(vertices, o);
    for (const auto& [from, middle, to] : kPlaces) {
      if (lattice[middle] == kNoVertex) {
        add(lines, lattice[from], lattice[to]);
      } else {
        add(lines, lattice[from], lattice[middle]);
        add(lines, lattice[middle], lattice[to]);
      }
    }
    for (int face = 0; face < 6; ++face) {
      if (const auto other = tree.across(o, face / 2, face % 2 != 0))
        add(lines, vertices.centre(o), vertices.centre(*other));
    }
  });
  const Lines diagonal = collect<std::uint64_t>(tree.size(), [&](std::size_t i, Lines& lines) {
    if (types.type[i] != OctantType::kBoundary) return;
    for (const std::uint32_t corner : vertices.corners[i]) add(lines, corner, vertices.centre(OctantId(i)));
  });
  bucket_sort(
      along_axes, vertices.size(), [](std::uint64_t line) { return line >> 32; }, std::less<>());
  along_axes.erase(std::unique(along_axes.begin(), along_axes.end()), along_axes.end());
  std::vector<OctantEdge> edges(along_axes.size() + diagonal.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    const std::uint64_t line = i < along_axes.size() ? along_axes[i] : diagonal[i - along_axes.size()];
    edges[i] = {static_cast<std::uint32_t>(line >> 32), static_cast<std::uint32_t>(line)};
  });
  return edges;
}

}  // namespace octet
