// SPDX-License-Identifier: BSD-3-Clause
// Octants whose halves suit the sizes that a part asks for itself.
#pragma once

#include <string>

#include "geom/size_plan.h"

namespace octet {

/// Shortens the plan's octants (SizePlan::octaves) where that spares elements, for a control that says so.
///
/// Octants have one length, halved any number of times: a wall or a radius that asks for a little less than
/// one of these lengths gets the next, and with it up to eight times as many elements as one that asks for a
/// little more. So lengths down to 0.6 of the one asked for are weighed by what an octree of that one has
/// for the part's own sake; curved faces, which get the length that is nearest to what they ask for, speak
/// against longer ones. What promises a seventh fewer elements, counted in an octree of its own, is taken.
/// Plans with sizes by which the lengths are chosen already (SizePlan::wanted), with sizes over space, or
/// with samples that have next to no share of the elements stay as they are. Returns a line that tells of it,
/// or none. Throws Cancelled.
[[nodiscard]] std::string suit_octants(const Model& model, const SizeControl& control, SizePlan& plan);

}  // namespace octet
