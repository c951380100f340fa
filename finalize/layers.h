// SPDX-License-Identifier: BSD-3-Clause
// Thin layers of elements along walls: boundary layers of flows, skins of fields.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/observer.h"
#include "geom/model.h"
#include "mesh/mesh.h"
#include "mesh/quality.h"

namespace octet {

/// Layers on faces, from the wall on.
struct LayerWish {
  std::vector<int> faces;       ///< tags
  std::vector<double> heights;  ///< of each layer's far side from the wall, ascending (model units)
};

struct LayerOptions {
  std::vector<LayerWish> wishes;               ///< each face once; all have as many layers
  std::function<double(const Vec3&)> size_at;  ///< of the elements beyond; required
  std::function<bool()> cancelled = {};
};

struct LayerReport {
  std::size_t tets = 0;     ///< in layers
  std::size_t nodes = 0;    ///< on walls that have layers
  std::size_t thinner = 0;  ///< of these, where layers are thinner than asked for
  std::size_t bare = 0;     ///< further nodes of the walls, where there are none
  double least = 1.0;       ///< share of the thickness asked for, where it is least
  Vec3 least_at = Vec3::Zero();
  QualitySummary beyond;  ///< shapes of all elements that are in no layer
};

/// Puts layers of tetrahedra between the walls and a valid classified mesh of first order. Its vertices on
/// walls are moved inwards, along what else they are on, as far as the elements there allow; what is between
/// is filled, each prism by three tetrahedra; the elements beyond are finalized around what was moved.
/// Where walls of other directions meet (a wedge, an edge between three faces), and where a wall's edge ends
/// in none that goes inwards, nodes stay, and layers thin out to nothing. Classification and the invariants
/// of Mesh are kept. [Handbook 15.6 for what finalization does]
LayerReport add_layers(Mesh& mesh, const Model& model, const LayerOptions& options, Observer& observer);

}  // namespace octet
