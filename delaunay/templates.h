// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra of interior octants without triangulating them: templates made by the triangulator.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace octet {

/// One octant as the templates see it. All that the ranked Delaunay triangulation of a balanced octree's
/// vertices can depend on inside one octant.
struct OctantPattern {
  std::uint32_t hanging =
      0;  ///< bits 0..11: mid-edge vertices, 12..17: mid-face vertices present (numbering in templates.cpp)
  std::array<std::uint64_t, 27>
      rank{};  ///< ranks of the points of the 3x3x3 lattice of the octant, 0 where absent (never the centre)
};

/// Tetrahedra over the 27 local points, positive, as local numbers 0..26 (x fastest).
using OctantTets = std::vector<std::array<std::uint8_t, 4>>;

/// A cache of templates: filled by running Triangulation on the pattern's points, keyed by what decides the
/// result (the mask and the order of the ranks). Not thread-safe: one per thread, same answers in each.
class TemplateTable {
 public:
  TemplateTable();
  ~TemplateTable();
  [[nodiscard]] const OctantTets& tets(const OctantPattern& pattern);
  [[nodiscard]] std::size_t size() const;  ///< distinct keys met so far

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace octet
