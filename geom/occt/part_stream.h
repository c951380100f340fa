// SPDX-License-Identifier: BSD-3-Clause
// A part between processes: what was measured of it, and the shapes its exact geometry is made from.
#pragma once

#include <string>
#include <string_view>

#include "geom/model.h"
#include "geom/occt/numbering.h"

namespace octet {

/// All of `parts` but curves, surfaces and trims, and the shapes of `numbering` in OCCT's binary format.
/// Numbers are kept to the last bit, but for directions and placements, which OCCT normalises as it reads.
[[nodiscard]] std::string encode_part(const Numbering& numbering, const ModelParts& parts);

/// The parts again, with curves, surfaces and trims made from the shapes. Bug: not what encode_part() wrote.
[[nodiscard]] ModelParts decode_part(std::string_view bytes);

/// A shape in OCCT's binary format, without triangulations.
[[nodiscard]] std::string encode_shape(const TopoDS_Shape& shape);
[[nodiscard]] TopoDS_Shape decode_shape(const std::string& bytes);

}  // namespace octet
