// SPDX-License-Identifier: BSD-3-Clause
// A welded triangulation of the boundary.
#pragma once

#include "geom/model.h"
#include "geom/occt/child_process.h"
#include "geom/occt/numbering.h"

namespace octet {

/// What facets keep to where no deflection is asked for, of the part's diagonal.
inline constexpr double kDeflectionShare = 1.0 / 2000.0;

/// Triangulates the faces (their OCCT triangulation is replaced) and fills `parts.facets`, welded by
/// topology, with measured deviations: by triangulate_boundary(), or by OCCT's mesher where that fails.
/// `deflection` 0: a two-thousandth of the diagonal; never more than a fiftieth of that of the solids that a
/// face bounds. ModelError: a face that cannot be triangulated, a region whose facets are not closed
/// (entity and place).
void tessellate(const Numbering& numbering, double deflection, const StageLog& log, ModelParts& parts);

}  // namespace octet
