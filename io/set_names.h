// SPDX-License-Identifier: BSD-3-Clause
// Names of sets and groups that solvers take.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "base/model_ref.h"
#include "mesh/model_outline.h"

namespace octet {

/// Solid1, Face12, Edge3, Vertex4.
[[nodiscard]] std::string entity_name(ModelRef entity);

/// A name for each entity: its own of at most `longest` characters, in letters, digits, _ and - with a letter
/// first, or else entity_name(). Names that differ in nothing else than upper and lower case
/// get that behind them, for solvers tell neither apart.
[[nodiscard]] std::map<ModelRef, std::string> set_names(const ModelOutline& outline, std::size_t longest);

}  // namespace octet
