// SPDX-License-Identifier: BSD-3-Clause
// Places that part a model edge into pieces of one length.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// The n - 1 parameters, ascending, that part the edge into n pieces as long as each other along it.
[[nodiscard]] std::vector<double> equal_parts(const Model& model, int edge, int n);

}  // namespace octet
