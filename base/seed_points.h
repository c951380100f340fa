// SPDX-License-Identifier: BSD-3-Clause
// The points that the octree hands to the triangulation, each with the model entity it lies on.
#pragma once

#include <cstdint>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// Structure of arrays; all arrays have the same size.
///
/// Invariants: positions are pairwise distinct; `order` values are pairwise distinct.
struct SeedPoints {
  std::vector<Vec3> position;  ///< model units
  std::vector<ModelRef> on;    ///< dim 0..2: on that model entity; dim 3: inside region `tag`, {3,0} outside
  std::vector<std::uint64_t>
      order;  ///< place in the one symbolic order: larger = larger weight (delaunay/vertex_order.h)
  std::vector<double> spacing;  ///< local mesh size, model units

  [[nodiscard]] std::size_t size() const { return position.size(); }
  std::size_t add(const Vec3& p, ModelRef ref, std::uint64_t rank, double h) {
    position.push_back(p);
    on.push_back(ref);
    order.push_back(rank);
    spacing.push_back(h);
    return position.size() - 1;
  }
  void resize(std::size_t n) {
    position.resize(n);
    on.resize(n);
    order.resize(n);
    spacing.resize(n);
  }
  void set(std::size_t i, const Vec3& p, ModelRef ref, std::uint64_t rank, double h) {
    position[i] = p;
    on[i] = ref;
    order[i] = rank;
    spacing[i] = h;
  }
};

/// One piece of a model edge between two consecutive points on it.
struct EdgePiece {
  std::uint32_t a = 0, b = 0;  ///< point numbers
  double ta = 0.0, tb = 0.0;   ///< parameters on the edge, ta < tb
  std::int32_t edge = 0;
};

}  // namespace octet
