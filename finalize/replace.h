// SPDX-License-Identifier: BSD-3-Clause
// The door that operators use: `replace_cavity`, unless more flat tetrahedra would be left than may be.
#pragma once

#include "finalize/cavity.h"
#include "finalize/workshop.h"

namespace octet {

/// Makes the change, if the shop's guard of flat tetrahedra admits it; shop.made receives the new tetrahedra.
/// False: the mesh is untouched.
[[nodiscard]] bool replace(Workshop& shop, const CavityChange& change);

}  // namespace octet
