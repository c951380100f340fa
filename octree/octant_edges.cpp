// SPDX-License-Identifier: BSD-3-Clause
// Gathering octant edges once each.
#include "octree/octant_edges.h"

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>

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
  // Packed as numbers, which sort twice as fast as pairs and in the same order.
  std::vector<std::uint64_t> packed;
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    packed.push_back(std::uint64_t{from} << 32 | to);
  };
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (types.type[i] != OctantType::kBoundary) continue;
    const OctantLattice lattice = octant_lattice(tree, vertices, OctantId(i));
    for (const auto& [from, middle, to] : kPlaces) {
      if (lattice[middle] == kNoVertex) {
        add(lattice[from], lattice[to]);
      } else {
        add(lattice[from], lattice[middle]);
        add(lattice[middle], lattice[to]);
      }
    }
  }
  tbb::parallel_sort(packed.begin(), packed.end());
  packed.erase(std::unique(packed.begin(), packed.end()), packed.end());
  std::vector<OctantEdge> edges(packed.size());
  std::transform(packed.begin(), packed.end(), edges.begin(), [](std::uint64_t edge) {
    return OctantEdge{static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)};
  });
  return edges;
}

}  // namespace octet
