// SPDX-License-Identifier: BSD-3-Clause
// The passes that raise the mean: sweeps of smoothing and of swaps over all but the lattice's own tetrahedra.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// Sweeps of smoothing for the mean (finalize/mean_smooth.h), colour by colour: vertices of one colour share
/// no tetrahedron, so they move at once, on all cores, and the result does not depend on how many there are.
/// Shapes stay above `floor`, or above the star's worst.
void relax_for_mean(Workshop& shop, double floor, int sweeps);

/// Collapses of edges shorter than the size that raise the mean near bad tetrahedra, make none as bad as
/// `floor` and no edge much longer than the size.
void collapse_for_mean(Workshop& shop, double floor);

/// Edge removals and face swaps that raise the mean where no tetrahedron gets as bad as `floor`. Candidates
/// are looked for on all cores, and done one by one in the order of their numbers.
void swap_for_mean(Workshop& shop, double floor);

}  // namespace octet
