// SPDX-License-Identifier: BSD-3-Clause
// Names of sets and groups that solvers take.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/model_ref.h"
#include "mesh/model_outline.h"

namespace octet {

/// Solid1, Face12, Edge3, Vertex4.
[[nodiscard]] std::string entity_name(ModelRef entity);

/// Names for solvers, in letters, digits, _ and - with a letter first, of at most `longest` characters. None
/// is given twice, not even with other upper and lower case, for solvers tell these apart no better.
struct SetNames {
  /// Of each entity: its own where no other of its dimension has that, else with entity_name() behind it, or
  /// entity_name() alone.
  std::map<ModelRef, std::string> of;
  /// The outline's groups, then the entities of a dimension that have one name, by that name: a load on
  /// `bolt` is meant for all of them.
  std::vector<OutlineGroup> shared;
};
[[nodiscard]] SetNames set_names(const ModelOutline& outline, std::size_t longest);

}  // namespace octet
