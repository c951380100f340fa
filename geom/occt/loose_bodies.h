// SPDX-License-Identifier: BSD-3-Clause
// Which loose faces belong to one body.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// Files that have nothing but faces write one body after the other, and where two touch each has a face of
/// its own: to sew all at once is to choose between four faces at an edge, or to join edges that lie on each
/// other in part. The faces in as many runs as can be, in their order, such that within each every edge has a
/// partner: one that ends where it does and has the same middle and length within `tolerance`. None where
/// they are no such bodies, or one alone.
[[nodiscard]] std::vector<std::vector<TopoDS_Shape>> bodies_in_order(const std::vector<TopoDS_Shape>& faces,
                                                                     double tolerance);

}  // namespace octet
