// SPDX-License-Identifier: BSD-3-Clause
// Edges and faces of different solids that are in one place.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <optional>

namespace octet {

/// Whether `other` runs as `one` does, not the other way, where their points at like shares of their ranges
/// are nowhere farther apart than `near`; none where they are. Edges without a curve in space are in no
/// place.
[[nodiscard]] std::optional<bool> same_way(const TopoDS_Edge& one, const TopoDS_Edge& other, double near);

/// Whether the normals of two faces, as they are turned, look the same way, where places all over either lie
/// within `near` on the other; none where they do not, or cannot be found.
[[nodiscard]] std::optional<bool> same_side(const TopoDS_Face& one, const TopoDS_Face& other, double near);

/// Gives `to` the curve, or the two curves, that `from` has on the face. `along`: whether `to` runs as `from`
/// does. Faces of planes need no curve, and where `from` has none `to` gets none.
void take_curve(const TopoDS_Edge& from, const TopoDS_Face& face, const TopoDS_Edge& to, bool along);

}  // namespace octet
