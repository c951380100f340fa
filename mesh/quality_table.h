// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a mesh's elements as distributions, and its worst elements by place and entity.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/quality.h"

namespace octet {

/// One measure over all elements (or edges) that it was taken of. Angles in radians.
struct Distribution {
  std::string name;
  bool angle = false;  ///< values are radians
  std::size_t count = 0;
  double least = 0.0, p1 = 0.0, median = 0.0, mean = 0.0, p99 = 0.0, largest = 0.0;
  double lo = 0.0, width = 0.0;   ///< bins[i] counts values in [lo + i width, lo + (i + 1) width)
  std::vector<std::size_t> bins;  ///< the first and the last hold what lies beyond, too
};

struct WorstTet {
  std::size_t tet = 0;  ///< from 0
  DihedralRange dihedral;
  double mean_ratio = 0.0;
  Vec3 place = Vec3::Zero();  ///< centroid
  std::vector<ModelRef> on;   ///< its region, and the entities of its vertices on the boundary, once each
  bool limited = false;       ///< see mesh/forbidden.h
};

struct QualityTable {
  std::size_t tets = 0, limited = 0;  ///< elements; of these limited by the geometry (mesh/forbidden.h)
  /// Over all elements, and over those that the geometry does not limit: smallest and largest dihedral angle
  /// per element, mean ratio, radius ratio, aspect, all of the element between the corners; of a mesh of
  /// second order also the scaled Jacobian (mesh/quadratic.h).
  std::vector<Distribution> all, free;
  Distribution edges;           ///< length over the local size, each edge once
  std::vector<WorstTet> worst;  ///< by the smallest sine of a dihedral angle, worst first
};

/// `size` is the size asked for per vertex (model units), against which edges and walls are held. Requires
/// the invariants of Mesh. InputError where arrays or `size` do not fit. O(n log n).
[[nodiscard]] QualityTable quality_table(const Mesh& mesh, std::span<const double> size,
                                         std::size_t worst_count);

}  // namespace octet
