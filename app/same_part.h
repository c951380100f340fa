// SPDX-License-Identifier: BSD-3-Clause
// Whether a mesh may be one of a part, by what can be told without its classification.
#pragma once

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// InputError where the mesh's box or volume (of its corners) differ from the part's by more than coarse
/// elements on curved faces, or walls and regions narrower than one that have none, explain. Tags are not
/// asked about: the part may have been read with other options, or meshed by another mesher.
void require_mesh_of(const Mesh& mesh, const Model& model);

}  // namespace octet
