// SPDX-License-Identifier: BSD-3-Clause
// The order of a mesh's elements, raised once the mesh is made.
#pragma once

#include "app/mesh_part.h"

namespace octet {

/// Gives the mesh curved elements of second order (finalize/curve.h) and the report what they come to: their
/// claims, their measures, and the time, as a stage. Throws what curve_mesh() throws.
void raise_order(MeshResult& result, const Model& model, Observer& observer);

}  // namespace octet
