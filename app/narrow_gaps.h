// SPDX-License-Identifier: BSD-3-Clause
// Where the boundary of a mesh comes near to itself through the outside.
#pragma once

#include <functional>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// The boundary vertices from which another sheet of the boundary is nearer, through the outside, than a
/// share of the size there; ascending. Nothing is between two such sheets that would keep their triangles
/// from crossing when either changes.
[[nodiscard]] std::vector<Mesh::Index> vertices_at_gaps(const Mesh& mesh, const Model& model,
                                                        const std::function<double(const Vec3&)>& size_at);

}  // namespace octet
