// SPDX-License-Identifier: BSD-3-Clause
// Sizes scaled until the mesh has about as many tetrahedra as asked for.
#pragma once

#include <functional>

#include "app/mesh_part.h"

namespace octet {

/// Meshes with sizes scaled so that the tetrahedra are within an eighth of options.target_elements, as far as
/// that can be had (where small features decide, counts jump as octants halve): octrees alone are tried
/// first, at a small share of a mesh's cost, and at most ten meshes are made. The nearest one is returned,
/// with a note in its report where it is farther off than that.
/// `mesh` runs without a target. `memo`, where given: what the plans know of the part, for `mesh` to use as
/// well.
[[nodiscard]] MeshResult mesh_to_target(const Model& model, const MeshOptions& options,
                                        const std::function<MeshResult(const MeshOptions&)>& mesh,
                                        SizeMemo* memo = nullptr);

/// Thrown before finalization, which is most of the work, by a mesh that will have far more tetrahedra than
/// it may.
struct TooManyTets {
  double count = 0.0;
  bool open = false;  ///< gaps are left: it will not be complete either
};

/// Meshes with options, or throws TooManyTets where the mesh would have far more than `most` tetrahedra.
using BoundedMesher = std::function<MeshResult(const MeshOptions&, double most)>;

/// Meshes with the default size (with_default_size()), and, where nothing was asked for, with larger ones
/// instead of a mesh of far more than most_by_default() tetrahedra, or of one of more that is not complete:
/// octrees promise too little where a part has many features far below the size. The larger mesh is returned
/// where it alone is complete, the one of fewer elements where neither is. Where most of the boundary has no
/// mesh faces at the default size, and no size was asked for, the part is meshed with elements twice as long
/// as it is wide in the mean (twice its volume over its area: a tube's wall, a rod's radius) as well, if the
/// octree promises no more of them than options allow, and that mesh is returned where it has fewer faults.
/// `memo`: as above.
[[nodiscard]] MeshResult mesh_by_default(const Model& model, const MeshOptions& options,
                                         const BoundedMesher& mesh, SizeMemo* memo = nullptr);

}  // namespace octet
