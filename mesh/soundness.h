// SPDX-License-Identifier: BSD-3-Clause
// The invariants of Mesh, tested word by word.
#pragma once

#include <string>

#include "mesh/mesh.h"

namespace octet {

/// Empty when the arrays, those of second order included, fit each other and all vertex and node numbers are
/// in range, else what does not: what any use of a mesh relies on. O(n).
[[nodiscard]] std::string check_mesh_arrays(const Mesh& mesh);

/// Empty when the invariants of mesh/mesh.h hold, else the first that does not, with its place.
[[nodiscard]] std::string check_mesh_soundness(const Mesh& mesh);

}  // namespace octet
