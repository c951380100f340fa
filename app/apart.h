// SPDX-License-Identifier: BSD-3-Clause
// Bodies that share nothing, meshed and judged each by itself.
#pragma once

#include "app/mesh_part.h"

namespace octet {

/// As mesh_part(), body by body: solids that touch or overlap without sharing faces get meshes of their own,
/// which do not fit where the solids meet. The size, where it is to be chosen, is one for all. A claim holds
/// when it holds for every body. Faces outside of all regions are not meshed; each is a fault of the report.
[[nodiscard]] MeshResult mesh_apart(const Model& model, const MeshOptions& options, Observer& observer);

/// Whether mesh_part() meshes body by body: where bodies may touch though they share nothing
/// (ModelParts::apart), or faces lie outside of all regions.
[[nodiscard]] bool is_meshed_apart(const Model& model);

/// As accept_mesh(), body by body: for a mesh that mesh_apart() made.
[[nodiscard]] Acceptance accept_apart(const Mesh& mesh, const Model& model);

/// Either, as mesh_part() would have made the mesh.
[[nodiscard]] Acceptance accept_as_meshed(const Mesh& mesh, const Model& model);

/// What of the part is in no mesh, whatever its claims say: solids that reading left out or could not join,
/// and faces outside of all regions.
[[nodiscard]] std::vector<Fault> faults_of_part(const Model& model);

}  // namespace octet
