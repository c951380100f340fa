// SPDX-License-Identifier: BSD-3-Clause
// A model of one solid while the part is still being healed.
#pragma once

#include <TopoDS_Shape.hxx>

#include "geom/model.h"
#include "geom/occt/child_process.h"

namespace octet {

/// The solid as it is, as region 1, for exact queries: no volumes, names or numbers of the file. Leaves no
/// triangulation in the solid. ModelError: as tessellate().
[[nodiscard]] Model model_of_solid(const TopoDS_Shape& solid, const StageLog& log);

}  // namespace octet
