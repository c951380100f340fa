// SPDX-License-Identifier: BSD-3-Clause
// Faces of one solid that meet where the file has no edge: cut along each other, or imprinted.
#pragma once

#include <array>
#include <vector>

#include "geom/occt/child_process.h"
#include "geom/occt/missing_curves.h"
#include "geom/occt/solids.h"

namespace octet {

/// Numbers as read of pairs of faces.
using FaceNumberPairs = std::vector<std::array<int, 2>>;

/// Faces of one solid that meet where the file has no edge.
struct MeetingFaces {
  FaceNumberPairs crossing;  ///< to be cut along each other
  FaceNumberPairs touching;  ///< to be imprinted on each other
};

/// Solids with faces that cross, as the pairs say, become what their boundary encloses (unite_crossed();
/// ModelError where that can be done for none of them); faces that touch are imprinted on each other. Both
/// are told in set.notes; `curves` gives edges the curves that they lack then.
void join_meeting_faces(const ShapeMaps& as_read, const MeetingFaces& meeting, MissingCurves& curves,
                        const StageLog& log, SolidSet& set);

}  // namespace octet
