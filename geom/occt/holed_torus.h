// SPDX-License-Identifier: BSD-3-Clause
// A torus with holes.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Torus.hxx>

#include <vector>

namespace octet {

/// All of a torus but what these edges enclose, its normal outward; they run with that to their left, seen
/// from outside. Null where a loop goes around the torus, encloses its left side, or leaves no circle along
/// and none across to cut it at. Standard_Failure where a curve cannot be interpolated.
[[nodiscard]] TopoDS_Face holed_torus(const gp_Torus& torus, const std::vector<TopoDS_Edge>& border);

}  // namespace octet
