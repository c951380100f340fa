// SPDX-License-Identifier: BSD-3-Clause
// Edges too short to be meant.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

struct ShortEdgesDropped {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> edges;  ///< that are gone; none: `solid` is the one given
};

/// Drops every edge no longer than `length` (mm); its two vertices become one. Nothing is done where a face
/// would go with it. Whether the result is closed is for the caller to test.
[[nodiscard]] ShortEdgesDropped drop_short_edges(const TopoDS_Shape& solid, double length);

}  // namespace octet
