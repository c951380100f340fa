// SPDX-License-Identifier: BSD-3-Clause
// Volumes within the facets of regions.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// By region tag, negative where the boundary is turned inside out; [0] is the outside's, all others'
/// negated. By the divergence theorem about one point, so right to rounding of the whole part's size cubed.
[[nodiscard]] std::vector<double> facet_volumes(const ModelParts& parts);

}  // namespace octet
