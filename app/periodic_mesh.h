// SPDX-License-Identifier: BSD-3-Clause
// Meshes whose periodic faces fit: made once for the points on these, and again with the points there given.
#pragma once

#include <functional>
#include <vector>

#include "app/attribute_points.h"
#include "app/mesh_part.h"
#include "app/own_frame.h"
#include "octree/given_points.h"

namespace octet {

/// What a mesh is made with where faces are periodic; `seeds` are for the part in its own axes.
using PeriodicMaking =
    std::function<MeshResult(const MeshOptions&, const PeriodicSeeds* seeds, Observer& observer)>;

/// A first mesh, whose periodic edges fit, tells the points on periodic faces; in those after it these and
/// their images are given, finalization keeps them, and the triangles between them are those of one
/// triangulation for both. Where attribute points or a tie have spoilt that, it is made again, from the
/// points of that mesh. What does not fit in the end is a fault.
[[nodiscard]] MeshResult mesh_periodic(const OwnFrame& frame, const MeshOptions& options,
                                       const Periodicity& periodicity, const PeriodicMaking& make,
                                       Observer& observer);

/// Gives a mesh its links, its claim about what is periodic, and the faults of that.
void take_match(MeshResult& result, const Model& model, const Periodicity& periodicity);

/// What attribute points on periodic edges, and on faces that have points given, bring with them. `seeds` and
/// `model` are referred to; none where there are no seeds.
[[nodiscard]] std::function<std::vector<ImagePoint>(ModelRef, const Vec3&)> image_points(
    const PeriodicSeeds* seeds, const Model& model);

/// The vertices of the mesh that finalization has to keep for what is periodic, with those of `held`;
/// ascending: those on periodic edges, and those on the faces that have points given.
[[nodiscard]] std::vector<Mesh::Index> with_periodic(std::vector<Mesh::Index> held, const Mesh& mesh,
                                                     const PeriodicSeeds* seeds);

}  // namespace octet
