// SPDX-License-Identifier: BSD-3-Clause
// When a mesh is right: the claims of docs/conventions.md, each with its worst place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/fault.h"
#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// The place of a CAD edge or face that is farthest from its chords or triangles.
struct Farthest {
  ModelRef entity;
  Vec3 place = Vec3::Zero();
  double distance = 0.0;  ///< model units
};

/// One claim about a mesh of a model.
struct Claim {
  std::string name;       ///< short, stable: "positive-volume", "edge-chains", ...
  std::string statement;  ///< what is claimed, one sentence
  bool holds = false;
  double worst = 0.0;  ///< the measured figure (0 where the claim is yes or no)
  double limit = 0.0;
  std::vector<Fault> faults;  ///< the worst first, at most ten
  std::vector<Vec3> places;   ///< of all faults, those of `faults` and others
  std::optional<Farthest>
      farthest;  ///< of the claims edge-length and surface-distance, where any place is off
};

/// Of the claims that do not hold, in their order.
[[nodiscard]] std::vector<Fault> faults_of(const std::vector<Claim>& claims);

struct Acceptance {
  std::vector<Claim> claims;
  /// Volume of the tetrahedra (model units, cubed), per region tag; empty where the numbers do not hold.
  std::vector<double> filled;
  [[nodiscard]] bool holds() const;
  /// Whether there is no claim of that name that does not hold.
  [[nodiscard]] bool holds(std::string_view name) const;
  /// None where the CAD's surface was not sampled, or is nowhere off the mesh.
  [[nodiscard]] std::optional<Farthest> farthest() const;
};

struct AcceptanceOptions {
  bool sample_surface = true;  ///< also sample the CAD surface densely against the mesh (the costly claim)
  bool overlap = true;
};

/// Tests every claim of the design: positive and conforming elements; classified boundary and interfaces;
/// closure; upward counts; every model vertex, edge (one chain) and face (Euler characteristic, loops,
/// orientation) covered; nodes on their entity; measures per entity within the chord error of the mesh's own
/// edge lengths; CAD samples near the mesh; no orphan or duplicate nodes.
/// All of these speak of the elements between their corners; of a mesh of second order accept_second_order()
/// is asked as well.
[[nodiscard]] Acceptance accept_mesh(const Mesh& mesh, const Model& model,
                                     const AcceptanceOptions& options = {});

/// The claims about the second order alone: nodes in the middles of edges are where they should be, and no
/// element turns over. Of a mesh of first order: none.
[[nodiscard]] std::vector<Claim> accept_second_order(const Mesh& mesh, const Model& model);

}  // namespace octet
