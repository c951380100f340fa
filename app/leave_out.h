// SPDX-License-Identifier: BSD-3-Clause
// The retreat: a region that cannot be closed is left out, so that the others stay whole.
#pragma once

#include <vector>

#include "app/attempt.h"

namespace octet {

/// Regions on whose boundary gaps are left, ascending; none when there are no gaps, and none when every
/// region of the model has some: then there is nothing to save.
[[nodiscard]] std::vector<int> broken_regions(const Attempt& attempt, const Model& model);

/// The broken regions' octants give no template tetrahedra any more. Call before extraction.
void leave_out_octants(Attempt& attempt, const std::vector<int>& broken);

/// Removes the broken regions' tetrahedra and what only they have; the order of the rest stays. What the
/// others share with them stays as their boundary.
void leave_out(Mesh& mesh, const Model& model, const std::vector<int>& broken);

/// One fault a region left out.
[[nodiscard]] std::vector<Fault> describe_left_out(const Attempt& attempt, const Model& model,
                                                   const std::vector<int>& broken);

}  // namespace octet
