// SPDX-License-Identifier: BSD-3-Clause
// Sizes that follow from a number of elements, told from octrees alone.
#pragma once

#include <functional>

#include "app/mesh_part.h"

namespace octet {

/// The options with all sizes, wherever they come from, multiplied: those of the user, and with them the
/// angle of an element on curved faces, to 60 degrees; elements across walls and gaps become fewer where
/// sizes grow.
[[nodiscard]] MeshOptions scaled_sizes(const Model& model, const MeshOptions& options, double scale);

/// The logarithm of the scale at which the octree of sizes(log_scale) promises so many elements, but for
/// `near` in the logarithm of their number; the search begins at `start` and takes eight octrees at most.
[[nodiscard]] double log_scale_for(const Model& model, const std::function<SizePlan(double)>& sizes,
                                   double log_elements, double start, double near);

/// What a mesh without any size asked for may have at most (a fifth more before finalization) where that does
/// not cost its being complete: 500 000 elements, and from 1000 model faces on 500 a face.
[[nodiscard]] double most_by_default(const Model& model);

/// Whether the user asks for no size at all.
[[nodiscard]] bool has_free_sizes(const MeshOptions& options);

/// Where no size is asked for: the part's default size, with octants that suit its commonest radius. When
/// nothing else is asked for either, they get more elements on a circle where that costs little (20, 16 or
/// 13, while they stay below 40 000 by estimate, or grow by a quarter at most), and a size that promises
/// fewer than 2 000 or more than 500 000 elements is scaled to the nearer of them, whatever the radius. Of
/// more than 1000 faces (an assembly's) sizes become no more than 1.6 times larger for that, while it has
/// most_by_default() at most: small features cannot all be coarser, and a mesh so coarse that they decide its
/// sizes is a bad one, and no sooner made. Other options are returned as they are. `memo`, where given, has
/// what the plans found, most of which the plan of the options returned asks for again.
[[nodiscard]] MeshOptions with_default_size(const Model& model, const MeshOptions& options,
                                            SizeMemo* memo = nullptr);

}  // namespace octet
