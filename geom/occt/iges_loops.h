// SPDX-License-Identifier: BSD-3-Clause
// Two readings of one IGES file, held against each other.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// Whether a face is on a surface that is closed all around, a ball's or a ring's. A loop on such bounds two
/// parts of it; which one is the face the file tells by the loop in (u,v).
[[nodiscard]] bool has_closed_surface(const TopoDS_Shape& shape);

/// The faces on surfaces that are closed one way or the other of which nothing is left: their loops, each all
/// around, came apart.
[[nodiscard]] std::vector<TopoDS_Shape> empty_faces(const TopoDS_Shape& shape);

struct OtherParts {
  std::vector<TopoDS_Shape> faces;  ///< of the first reading, on such surfaces
  /// No other face differs, and where these have corners the others have, too: else the curves in (u,v) are
  /// no good.
  bool to_be_believed = false;
};

/// Where `by_surfaces`, the file of `by_either` read by its curves in (u,v) alone, has another part of the
/// surface: by area. None where the two have not as many faces.
[[nodiscard]] OtherParts other_parts(const TopoDS_Shape& by_either, const TopoDS_Shape& by_surfaces);

}  // namespace octet
