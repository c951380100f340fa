// SPDX-License-Identifier: BSD-3-Clause
// From edge lengths of the mesh to lengths of octants.
#pragma once

#include <array>
#include <vector>

#include "geom/size_plan.h"
#include "octree/octree.h"

namespace octet {

/// Tetrahedra that an octant inside gives.
inline constexpr double kTetsPerOctant = 12.0;

/// The length that octants of the size asked for should have, so that its halves and doubles suit the sizes
/// of attributes too: none of these is missed by more than a sixth of an octave where there is one, the size
/// asked for itself by a third (a fifth of it); with more attributes by more, up to half an octave.
[[nodiscard]] double lattice_length(double asked, const std::vector<double>& wanted);

/// The request and the samples for build_octree(). A size h becomes octants of h / kEdgePerOctant; of the
/// powers of two that the lattice offers the nearest one is taken, by ratio, or the next smaller one for
/// samples that say so.
[[nodiscard]] OctreeRequest octant_request(const SizePlan& plan);
[[nodiscard]] std::vector<SizeSample> octant_samples(const SizePlan& plan);

/// The tree that a mesh is made from: octants as the plan has them, of one size on both sides of thin walls.
/// `shift` as in OctreeRequest. LimitError, in the user's sizes, where build_octree() throws one.
[[nodiscard]] Octree planned_octree(const Model& model, const SizePlan& plan,
                                    const std::array<double, 3>& shift = kRootShift);

}  // namespace octet
