// SPDX-License-Identifier: BSD-3-Clause
// The name of a model entity: its dimension and its number, nothing else.
#pragma once

#include <compare>
#include <cstdint>

namespace octet {

/// A model entity of dimension 0 (vertex), 1 (edge), 2 (face) or 3 (region), numbered from 1 within
/// its dimension as FreeCAD and Gmsh show it. Tag 0 means "none"; {3, 0} is the outside.
struct ModelRef {
  std::int32_t dim = -1;
  std::int32_t tag = 0;

  [[nodiscard]] constexpr bool valid() const { return dim >= 0 && tag > 0; }
  constexpr auto operator<=>(const ModelRef&) const = default;
};

[[nodiscard]] constexpr ModelRef model_vertex(int tag) { return {0, tag}; }
[[nodiscard]] constexpr ModelRef model_edge(int tag) { return {1, tag}; }
[[nodiscard]] constexpr ModelRef model_face(int tag) { return {2, tag}; }
[[nodiscard]] constexpr ModelRef model_region(int tag) { return {3, tag}; }

}  // namespace octet
