// SPDX-License-Identifier: BSD-3-Clause
// Model edges that the user wants in a number of equal pieces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geom/size_attributes.h"
#include "mesh/mesh.h"

namespace octet {

/// Per edge tag, as SeedOptions::divisions has it: the largest number of elements that is asked for there.
/// Empty where none is.
[[nodiscard]] std::vector<int> edge_divisions(const Model& model, const std::vector<SizeAttribute>& wishes);

/// The vertices of the mesh on edges that have the number asked for, with those of `held`; ascending. `held`
/// where there are no such.
[[nodiscard]] std::vector<Mesh::Index> with_divided(std::vector<Mesh::Index> held, const Mesh& mesh,
                                                    const std::vector<int>& divisions);

/// Vertices of the mesh on edges that have a vertex where each piece ends, and others besides: of such.
[[nodiscard]] std::vector<Mesh::Index> surplus_vertices(const Mesh& mesh, const Model& model,
                                                        const std::vector<int>& divisions);

/// That edges have another number of elements than asked for, and which; none where all have theirs.
[[nodiscard]] std::optional<std::string> note_of_divisions(const Mesh& mesh,
                                                           const std::vector<int>& divisions);

}  // namespace octet
