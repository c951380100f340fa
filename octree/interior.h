// SPDX-License-Identifier: BSD-3-Clause
// Interior octants that are meshed by templates, and the octree vertices that the triangulation needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/seed_points.h"
#include "octree/labels.h"

namespace octet {

/// The interior octants without hanging vertices whose vertices are all kept, such that between two of them
/// that share a face the triangulation has four tetrahedra for certain: those of the line between the centres
/// and the face's four edges. Their circumspheres hold neither a point of the boundary nor a free point, so
/// no point of the boundary that is added later can break them either. In array order.
///
/// `kept` tells for each octree vertex whether it is a point. `points` are all points; those that are octree
/// vertices (by `order`) or lie on the boundary (`on.dim` < 3) need no look.
[[nodiscard]] std::vector<OctantId> template_octants(const Model& model, const Octree& tree,
                                                     const OctreeVertices& vertices,
                                                     const OctreeLabels& labels,
                                                     std::span<const std::uint8_t> kept,
                                                     const SeedPoints& points);

/// The lattice on which octree vertices are points wherever they lie: eight octants of this length wide.
/// Where the triangulation has no other points, among the template octants and far outside, these few bound
/// its tetrahedra, so that parts of it far from each other can be made at once.
[[nodiscard]] inline Lattice::value_type pillar_spacing(const Octree& tree, double length) {
  const int level =
      std::clamp(static_cast<int>(std::lround(std::log2(tree.root_size() / length))) - 3, 0, kLatticeLevels);
  return Lattice::value_type{1} << (kLatticeLevels - level);
}
[[nodiscard]] inline bool is_pillar(const Lattice& at, Lattice::value_type spacing) {
  return ((at[0] | at[1] | at[2]) & (spacing - 1)) == 0;
}

/// Per octree vertex: whether it is kept and is a vertex of a tetrahedron that is not between two template
/// octants, or a pillar. These and the free points are all that the triangulation needs.
[[nodiscard]] std::vector<std::uint8_t> band_vertices(const Octree& tree, const OctreeVertices& vertices,
                                                      std::span<const OctantId> templates,
                                                      std::span<const std::uint8_t> kept, double length);

/// How far the circumspheres of the tetrahedra between two octants that share a face reach sideways beyond
/// these, in lengths of an octant: (sqrt 5 - 1) / 4. They do not reach beyond the two along the line between
/// the centres.
inline constexpr double kOverhang = 0.3091;

}  // namespace octet
