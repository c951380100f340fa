// SPDX-License-Identifier: BSD-3-Clause
// Where the boundary of a mesh comes near to itself through the outside.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// The boundary vertices from which another sheet of the boundary is nearer, through the outside, than a
/// share of the size there; ascending. Nothing is between two such sheets that would keep their triangles
/// from crossing when either changes. None inside planar faces: their triangles stay in the plane. `around`:
/// no vertices but those within some sizes of these places are looked at; where there are none of these, or
/// thousands, all are.
[[nodiscard]] std::vector<Mesh::Index> vertices_at_gaps(const Mesh& mesh, const Model& model,
                                                        const std::function<double(const Vec3&)>& size_at,
                                                        std::span<const Vec3> around = {});

/// All vertices on the boundary; ascending.
[[nodiscard]] std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh);
/// Those within some sizes of the places, as `around` above.
[[nodiscard]] std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh,
                                                         const std::function<double(const Vec3&)>& size_at,
                                                         std::span<const Vec3> around);

}  // namespace octet
