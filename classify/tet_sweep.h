// SPDX-License-Identifier: BSD-3-Clause
// What a single pass over all tetrahedra tells, so that the claims need no list of all their faces.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

struct TetSweep {
  double smallest_volume = 0.0;             ///< 0 without tetrahedra
  std::vector<std::uint32_t> not_positive;  ///< ascending; by the exact sign
  std::vector<double> filled;               ///< volume of the tetrahedra, per region tag
  std::vector<std::uint8_t> on_surface;     ///< per vertex: whether it is a corner of a triangle
  std::vector<std::uint8_t> in_own;         ///< per vertex in a region: whether a tetrahedron of that has it
  /// Tetrahedra with a vertex on a triangle, or not inside their own region; ascending. The other ones are
  /// nearly all, and have nothing to do with the boundary.
  std::vector<std::uint32_t> outer;
  /// Whether the boundary of each region's tetrahedra, as a chain of oriented faces, is the sum of the
  /// triangles on the region's faces, each with the side that its face turns to the region.
  bool closes = false;

  /// All positive, and the chains close. Then faces that are no triangles have their tetrahedra in pairs, one
  /// on each side and in one region; and since the number of tetrahedra over a place of space is the winding
  /// number of the region's triangles there, it is one or none wherever these are no surface that meets
  /// itself, which is a claim of its own. So all that is left to look at are faces whose three vertices lie
  /// on triangles.
  [[nodiscard]] bool proves_pairs() const { return closes && not_positive.empty(); }
};

/// O(tetrahedra), in parallel. The chains are compared by sums of 64-bit hashes of their faces, signed by
/// orientation and modulo 2^64: chains that differ are taken for equal with a probability of about 2^-64.
/// Requires indices and tags in range.
[[nodiscard]] TetSweep sweep_tets(const Mesh& mesh, const Model& model);

}  // namespace octet
