// SPDX-License-Identifier: BSD-3-Clause
// What OCCT's STEP reader does to a shape, without what takes it minutes.
#pragma once

#include <Message_ProgressRange.hxx>
#include <ShapeProcess_ShapeContext.hxx>
#include <TopoDS_Shape.hxx>

namespace octet {

/// Whether a face has more than 256 loops, or a loop more than 512 sides (perforated plates, combs, racks):
/// OCCT looks for sides of a loop that cross by going through the whole face for each loop, and through the
/// loop for each pair of its sides.
[[nodiscard]] bool has_countless_sides(const TopoDS_Shape& shape);

/// The repairs of XSAlgo_AlgoContainer::ProcessShape where no resource file asks for others, but for the
/// search for sides that cross (the caller's own repairs look for these). What it changes is recorded in
/// `context`, which is of the shape.
void repair_but_for_crossings(const TopoDS_Shape& shape, double precision, double most_tolerance,
                              ShapeProcess_ShapeContext& context, const Message_ProgressRange& progress);

}  // namespace octet
