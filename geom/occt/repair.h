// SPDX-License-Identifier: BSD-3-Clause
// A solid that something was mended of.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <vector>

namespace octet {

/// What a repair made of a solid. Whether the result is closed is for the caller to test.
struct Repair {
  TopoDS_Shape solid;
  Handle(BRepTools_History) history;
  std::vector<TopoDS_Shape> entities;  ///< of the solid given, that are gone; none: `solid` is that one
};

/// The solid as it is.
[[nodiscard]] inline Repair no_repair(const TopoDS_Shape& solid) {
  return {solid, new BRepTools_History, {}};
}

}  // namespace octet
