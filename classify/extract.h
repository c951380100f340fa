// SPDX-License-Identifier: BSD-3-Clause
// From the classified band to a Mesh: the outside dropped, vertices compacted.
#pragma once

#include <functional>

#include "classify/band.h"
#include "mesh/mesh.h"

namespace octet {

struct ExtraTets {
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< positive, over the point numbers
  std::vector<std::int32_t> region;
  std::vector<std::uint32_t> first;  ///< points that become the first vertices of the mesh, in this order
  /// Whether the band's own tetrahedron fills the space of these and is dropped; may be empty.
  /// Asked by many threads at once, of tetrahedra whose points are all of those below.
  std::function<bool(const Vec3& centroid)> covers;
  std::uint32_t first_covered = 0, last_covered = UINT32_MAX;  ///< points [first, last)
};

/// The mesh of all tetrahedra in regions, with the facets of the band as triangles and the chains as edges.
/// `points` and `on` hold all points, those that only `extra` uses included. Facets that fit no model face
/// get the nearest one (they have been reported as gaps).
[[nodiscard]] Mesh extract_mesh(Band& band, const TetMesh& tets, std::span<const Vec3> points,
                                std::span<const ModelRef> on, const EdgeChains& chains,
                                const ExtraTets& extra);

}  // namespace octet
