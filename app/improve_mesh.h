// SPDX-License-Identifier: BSD-3-Clause
// Finalization of a classified mesh from anywhere.
#pragma once

#include "app/mesh_part.h"

namespace octet {

struct ImproveOptions {
  double size = 0.0;  ///< edge length wished for everywhere (millimetre); 0: as the mesh is around each place
  int threads = 1;    ///< as MeshOptions::threads
  int order = 0;      ///< of the elements; 0: as they are
};

/// Improves the shapes of a mesh of the model on the exact geometry (finalize/finalize.h), and accepts it
/// like a mesh of our own: body by body where mesh_part() meshes so, and incomplete where some of the part is
/// in no mesh. Seams and degenerate edges, which other meshers take for edges of the part, are first given to
/// their faces. Nodes in the middles of edges are put on the CAD anew. InputError when the mesh is no sound
/// classified mesh of this model: the first claim that does not hold, and where. Throws what mesh_part()
/// throws.
[[nodiscard]] MeshResult improve_mesh(Mesh mesh, const Model& model, const ImproveOptions& options,
                                      Observer& observer);

/// Vertices on seams and degenerate edges to their faces, mesh edges there forgotten.
void release_seams(Mesh& mesh, const Model& model);

}  // namespace octet
