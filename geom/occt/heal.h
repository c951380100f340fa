// SPDX-License-Identifier: BSD-3-Clause
// Repairs what is wrong with solids, and says what it changed.
#pragma once

#include <string>

#include "geom/occt/child_process.h"
#include "geom/occt/meeting_faces.h"
#include "geom/occt/solids.h"

namespace octet {

struct HealOptions {
  SewOptions sewing;
  double smallest_feature = 0.0;  ///< mm; at least kRoundingShare of the solid's diagonal
};

/// Nothing is touched that is right, and each repair is one line in set.notes with its count and the first
/// entity, numbered as read:
///  1. edges without a curve in space, and edges without a curve on a face, get one; edges far beside their
///     faces are drawn anew where these meet;
///  2. a face that has the rest of its sphere gets its own part back, and faces of a solid that are not
///     turned alike are turned as their neighbours;
///  3. an open solid: its faces are sewn, and capped where that is asked for, where that closes it;
///  4. faces no wider than the tolerance or the gaps of their sides or the smallest feature become edges,
///     rings no wider than that edges, edges no longer than that vertices; edges that a vertex of their face
///     lies on are split, and sides that cross within their tolerance, spikes and slits of faces no wider
///     are closed, faces folded flat onto a neighbour go;
///  5. where there are several, a solid turned inside out, so that it fills all space but its hole, is turned
///     before they are fused (a single one shows by its facets, which is surer);
///  6. edges and vertices of voids that touch the outside of their solid become those of the outside;
///  7. solids with faces that cross, as the pairs given say, become what their boundary encloses (ModelError
///     where that can be done for none of them);
///  8. the faces of the pairs that touch are imprinted on each other.
/// What remains open or damaged is left for the later stages to name.
void heal(const ShapeMaps& as_read, const HealOptions& options, const MeetingFaces& meeting,
          const StageLog& log, SolidSet& set);

/// What the notes say of a solid that was turned.
[[nodiscard]] std::string inside_out_note(const std::string& solid);

}  // namespace octet
