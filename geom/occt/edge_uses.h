// SPDX-License-Identifier: BSD-3-Clause
// Whether the faces of a solid close along its edges.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

/// How often the faces of a solid use one of its edges in either direction.
struct Uses {
  int forward = 0, reversed = 0;
  [[nodiscard]] bool open() const { return forward + reversed == 1; }
  [[nodiscard]] bool turned() const { return forward + reversed == 2 && forward != 1; }
  [[nodiscard]] bool unbalanced() const { return forward != reversed; }
};

struct EdgeUses {
  TopTools_IndexedMapOfShape edges;
  std::vector<Uses> uses;  ///< by index, [0] unused
  /// Index of the first edge of which `wrong` is true, 0: none.
  [[nodiscard]] int first(bool (Uses::*wrong)() const) const;
};

/// Edges without length do not count, nor do faces inside the solid, which bound it on neither side.
[[nodiscard]] EdgeUses edge_uses(const TopoDS_Shape& solid);

}  // namespace octet
