// SPDX-License-Identifier: BSD-3-Clause
// The one public header that includes OCCT: a shape in memory to a Model.
#pragma once

#include <TopoDS_Shape.hxx>

#include "geom/occt/read_part.h"

namespace octet {

/// As read_part(), for a shape whose lengths are millimetre. Entities are numbered in the order of
/// TopExp::MapShapes of the shape as given. The shape is not changed.
[[nodiscard]] Model model_from_shape(const TopoDS_Shape& shape, const ReadOptions& options = {},
                                     const char* installed_reader = kInstalledReader);

}  // namespace octet
