// SPDX-License-Identifier: BSD-3-Clause
// What the report tells of a mesh beside its claims.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/mesh_part.h"
#include "app/own_frame.h"
#include "finalize/finalize.h"

namespace octet {

/// Fills counts, shapes, volume and area of the mesh and of the CAD.
void measure_mesh(const Mesh& mesh, const Model& model, MeshReport& report);

/// Fills what the report has of areas, from those of the mesh's triangles by face tag.
void set_areas(const std::vector<double>& area_on, const Model& model, MeshReport& report);

/// Where the CAD is farthest from the mesh; of a mesh of second order, where its curved elements are from it.
[[nodiscard]] std::optional<Farthest> farthest_from_cad(const MeshReport& report);

/// Faults of all kinds, those that are not listed with their claim as well.
[[nodiscard]] std::size_t fault_count(const MeshReport& report);

/// Where claims fail, in the frame's own axes: each place once, in order.
[[nodiscard]] std::vector<Vec3> places_at_fault(const Acceptance& acceptance, const OwnFrame& frame);

/// One line.
[[nodiscard]] std::string describe(const FinalizeReport& report);

}  // namespace octet
