// SPDX-License-Identifier: BSD-3-Clause
// Where a part's boundary touches itself: legal, but no mesh is a manifold there.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

struct SelfContact {
  std::vector<int> edges;     ///< real ones at which one region, or the outside, has more than two faces
  std::vector<int> vertices;  ///< at which the faces towards the outside are not one fan over common edges
};

/// Tags are ascending.
[[nodiscard]] SelfContact self_contact(const Model& model);

}  // namespace octet
