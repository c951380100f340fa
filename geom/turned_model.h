// SPDX-License-Identifier: BSD-3-Clause
// A model seen from axes of other directions.
#pragma once

#include "geom/model.h"

namespace octet {

/// The model with every point p at turn * p; entities, parameters and their order are the same. The places
/// and boxes that its provenance and faults tell stay those of `model`. Requires a rotation.
/// Cost: that of a Model; questions cost two products with a 3x3 matrix more.
[[nodiscard]] Model turned_model(const Model& model, const Eigen::Matrix3d& turn);

}  // namespace octet
