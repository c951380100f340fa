// SPDX-License-Identifier: BSD-3-Clause
// One mesh at the sizes given.
#pragma once

#include "app/mesh_part.h"
#include "app/own_frame.h"
#include "geom/size_memo.h"
#include "octree/given_points.h"

namespace octet {

/// `most`: tetrahedra; TooManyTets is thrown where there would be far more. `periodic`: what edges and faces
/// have in common; may be null. `memo`: what plans of the frame's model found.
[[nodiscard]] MeshResult run_pipeline(const OwnFrame& frame, const MeshOptions& options, double most,
                                      const PeriodicSeeds* periodic, SizeMemo& memo, Observer& observer);

}  // namespace octet
