// SPDX-License-Identifier: BSD-3-Clause
// How often boundaries that cross themselves enclose a point.
#pragma once

#include <optional>
#include <vector>

#include "geom/model.h"

namespace octet {

/// How many times the region's oriented boundary goes around p: 1 inside and 0 outside of one that does not
/// cross itself; where it does, as many times as it encloses p, less the times that it does turned inside
/// out. By the signed crossings of rays with the exact faces, of which several must agree; nothing where they
/// do not (p is on the boundary). Rays that graze a face or meet an edge do not count.
[[nodiscard]] std::optional<int> winding_number(const Model& model, int region, const Vec3& p);

/// Of what some regions of `before` enclose, the share that only one of the two models covers. A model covers
/// a point where the winding number of a region there is 1 or more. By the facets along straight lines across
/// these regions; what is no thicker than the facets deviate is no difference. Deterministic.
[[nodiscard]] double share_covered_once(const Model& before, const Model& after,
                                        const std::vector<int>& regions);

}  // namespace octet
