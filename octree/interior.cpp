// SPDX-License-Identifier: BSD-3-Clause
// Which octants the boundary cannot reach.
#include "octree/interior.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace octet {
namespace {

/// Vertices of octants off the inside: a circumsphere may reach the boundary only beyond these.
std::vector<std::uint8_t> near_the_boundary(const Octree& tree, const OctreeVertices& vertices,
                                            const OctreeLabels& labels) {
  std::vector<std::uint8_t> flags(vertices.size(), 0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (labels.type[i] == OctantType::kBoundary) flag_vertices(vertices, OctantId(i), flags);
  }
  return flags;
}

/// Vertices of octants that hold a free point off the boundary.
std::vector<std::uint8_t> near_a_free_point(const Octree& tree, const OctreeVertices& vertices,
                                            const SeedPoints& points) {
  std::vector<std::uint8_t> flags(vertices.size(), 0);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const bool octree_vertex = (points.order[p] >> 63) != 0;
    if (octree_vertex || points.on[p].dim < 3) continue;
    flag_vertices(vertices, tree.find(points.position[p]), flags);
  }
  return flags;
}

}  // namespace

std::vector<OctantId> template_octants(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                                       const OctreeLabels& labels, std::span<const std::uint8_t> kept,
                                       const SeedPoints& points) {
  const std::vector<std::uint8_t> boundary = near_the_boundary(tree, vertices, labels);
  const std::vector<std::uint8_t> occupied = near_a_free_point(tree, vertices, points);
  const auto suits = [&](OctantId octant) {
    if (!vertices.hanging_on(octant).empty()) return false;
    bool is_free = true, touches_boundary = false;
    for_each_vertex(vertices, octant, [&](std::uint32_t v) {
      is_free = is_free && kept[v] != 0 && occupied[v] == 0;
      touches_boundary = touches_boundary || boundary[v] != 0;
    });
    if (!is_free) return false;
    // Neighbours are no smaller than this octant where nothing hangs, so spheres end within them.
    return !touches_boundary ||
           !model.near_boundary(tree.box(octant).grown(kOverhang * tree.length(tree[octant].level)));
  };
  std::vector<std::uint8_t> suitable(tree.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size()), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if (labels.type[i] != OctantType::kIn) continue;
      suitable[i] = suits(OctantId(i)) ? 1 : 0;
    }
  });
  // Two passes: the list is large, and growing it would copy it.
  std::vector<OctantId> result;
  result.reserve(static_cast<std::size_t>(std::count(suitable.begin(), suitable.end(), 1)));
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (suitable[i] != 0) result.emplace_back(i);
  }
  return result;
}

std::vector<std::uint8_t> band_vertices(const Octree& tree, const OctreeVertices& vertices,
                                        std::span<const OctantId> templates,
                                        std::span<const std::uint8_t> kept, double length) {
  const Lattice::value_type spacing = pillar_spacing(tree, length);
  std::vector<std::uint8_t> band(vertices.size(), 0);
  std::vector<std::uint8_t> is_template(tree.size(), 0);
  for (const OctantId o : templates) is_template[o.index()] = 1;
  for (std::size_t i = 0; i < tree.size(); ++i)
    if (is_template[i] == 0) flag_vertices(vertices, OctantId(i), band);
  // A template octant across a face from one that is none has tetrahedra there.
  for (const OctantId o : templates) {
    const auto& corners = vertices.corners[o.index()];
    if (std::none_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return band[v] != 0; })) continue;
    if (!tree.all_across(o, [&](OctantId other) { return is_template[other.index()] != 0; }))
      band[vertices.centre(o)] = 1;
  }
  for (std::size_t v = 0; v < band.size(); ++v)
    band[v] = kept[v] != 0 && (band[v] != 0 || is_pillar(vertices.at[v], spacing)) ? 1 : 0;
  return band;
}

}  // namespace octet
