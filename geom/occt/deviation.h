// SPDX-License-Identifier: BSD-3-Clause
// How far the facets are from the exact surfaces and curves.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// Fills Facets::deviation and edge_deviation from samples between the nodes, inflated by half: the mesher's
/// own deflection is no bound. `chain_parameters`: per edge tag, parameters of the inner nodes of its
/// polyline.
void measure_deviation(const std::vector<std::vector<double>>& chain_parameters, ModelParts& parts);

}  // namespace octet
