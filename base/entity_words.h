// SPDX-License-Identifier: BSD-3-Clause
// What entities are called, by their dimension.
#pragma once

#include <array>
#include <cstddef>

namespace octet {

/// An entity of the model.
[[nodiscard]] constexpr const char* entity_word(int dim) {
  constexpr std::array<const char*, 4> kWords{"Vertex", "Edge", "Face", "Region"};
  return kWords[static_cast<std::size_t>(dim)];
}

/// An entity as the file has it, where regions are solids.
[[nodiscard]] constexpr const char* shape_word(int dim) { return dim == 3 ? "Solid" : entity_word(dim); }

}  // namespace octet
