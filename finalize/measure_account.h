// SPDX-License-Identifier: BSD-3-Clause
// Volumes and areas of a mesh that is worked on in blocks: each block has its share of the errors.
#pragma once

#include <span>
#include <vector>

#include "finalize/boundary_guard.h"
#include "mesh/mesh.h"

namespace octet {

[[nodiscard]] Measures measures_of(const Mesh& mesh, const Model& model);

class MeasureAccount {
 public:
  /// `volume_beyond`: of what is not in the mesh, per region tag; empty: nothing. What the errors are now
  /// bounds what they may become.
  MeasureAccount(const Mesh& mesh, const Model& model, std::span<const double> volume_beyond);

  /// What a block is to have: its part of a region's error of volume is that of the region's curved surface,
  /// its part of a face's error of area that of the face. So are its parts of what the errors may become.
  [[nodiscard]] MeasureGoals goals_of(const Measures& block) const;
  /// A block has changed.
  void add(const Measures& before, const Measures& after);

 private:
  /// Per region tag: area of its faces that are no planes.
  [[nodiscard]] std::vector<double> curved_areas(const Measures& measures) const;

  const Model& model_;
  Measures now_;
  MeasureGoals goals_;  ///< of the whole
};

}  // namespace octet
