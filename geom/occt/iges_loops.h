// SPDX-License-Identifier: BSD-3-Clause
// Two readings of one IGES file, held against each other.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// A loop on a surface that is closed all around, a ball's or a ring's, bounds two parts of it; which one is
/// the face the file tells by the loop in (u,v). Faces of `shape` on such surfaces.
[[nodiscard]] std::vector<TopoDS_Shape> faces_on_closed_surfaces(const TopoDS_Shape& shape);

/// Faces of `by_either` on such surfaces of which `by_surfaces`, the same file read by its curves in (u,v)
/// alone, has another part: by area, with the same corners. None where any other face differs as well, or a
/// corner does: those curves are no good then.
[[nodiscard]] std::vector<TopoDS_Shape> other_parts(const TopoDS_Shape& by_either,
                                                    const TopoDS_Shape& by_surfaces);

}  // namespace octet
