// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that a file keeps within its solids: threads drawn as cylinders, planes and axes of construction.
#pragma once

#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// Whether half of the area of `part` and more runs inside of the solids' material, where no other body can
/// be. What lies on their boundary does not count: a pin that lacks a face lies so in its hole.
[[nodiscard]] bool runs_within(const TopoDS_Shape& part, const std::vector<TopoDS_Shape>& solids);

}  // namespace octet
