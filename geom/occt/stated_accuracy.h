// SPDX-License-Identifier: BSD-3-Clause
// What a STEP file says of how near places are one and the same.
#pragma once

#include <Interface_InterfaceModel.hxx>

namespace octet {

/// The least uncertainty of lengths (mm) that a context of solids or shells in the file states [ISO 10303-43,
/// uncertainty_measure_with_unit]; 0: none does.
[[nodiscard]] double stated_accuracy(const Handle(Interface_InterfaceModel) & model);

}  // namespace octet
