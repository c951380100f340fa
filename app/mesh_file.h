// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to a mesh, with what the file says of itself.
#pragma once

#include <filesystem>
#include <functional>

#include "app/mesh_part.h"
#include "geom/occt/read_part.h"

namespace octet {

struct MeshedFile {
  Model model;
  MeshResult result;  ///< reading is among its times
};

/// Reads the part and meshes it. Where the mesh has faults that reading did not have, and no smallest feature
/// is given: once more without the edges, faces, spikes and slits that are smaller than the STEP file says
/// places are accurate to, or than 1e-5 of the diagonal; then, where it has faults still, without those that
/// no element resolves, smaller than 1e-4 of the diagonal, 4e-4 of the cube root of the least solid's volume
/// and a hundredth of the size. The first such mesh without faults is taken, where reading found no more of
/// them than before; the first note of the model says so. `mesh`: as mesh_part(), with
/// MeshOptions::large_mesh as it is told: a mesh larger than a default one may be is not made before the part
/// has been looked at without its smallest features. Throws what read_part() and `mesh` throw.
[[nodiscard]] MeshedFile mesh_file(const std::filesystem::path& path, const ReadOptions& reading,
                                   const std::function<MeshResult(const Model&, LargeMesh)>& mesh,
                                   Observer& observer);

}  // namespace octet
