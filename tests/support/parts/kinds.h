// SPDX-License-Identifier: BSD-3-Clause
// The kinds of parts that are drawn: each function makes another part at each call, of 1 to 1000 mm.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "tests/support/parts/draw.h"

namespace octet::test {

struct PartKind {
  std::string name;
  TopoDS_Shape (*make)(Draw&);
};

[[nodiscard]] std::vector<PartKind> milled_kinds();     ///< sketches, holes, pockets, ribs, blends
[[nodiscard]] std::vector<PartKind> turned_kinds();     ///< shafts, flanges, threads, springs, gears, wheels
[[nodiscard]] std::vector<PartKind> thin_kinds();       ///< shells, sheets, tubes, fins, wires
[[nodiscard]] std::vector<PartKind> free_form_kinds();  ///< lofts, sweeps, spline faces, castings
[[nodiscard]] std::vector<PartKind> joined_kinds();     ///< solids that touch or are inserted, sheets

}  // namespace octet::test
