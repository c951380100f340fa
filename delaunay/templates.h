// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra of interior octants without triangulating them: templates made by the triangulator.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace octet {

/// An octant's points are numbered on its 3x3x3 lattice, x fastest: number x + 3 y + 9 z, each 0..2. Corners
/// have even coordinates; bit b of a pattern's mask stands for the hanging point kHangingPoint[b]: first the
/// middles of the twelve edges, then of the six faces.
inline constexpr std::array<std::uint8_t, 18> kHangingPoint = {1,  3,  5,  7, 9,  11, 15, 17, 19,
                                                               21, 23, 25, 4, 10, 12, 14, 16, 22};
inline constexpr std::array<std::uint8_t, 8> kCornerPoint = {0, 2, 6, 8, 18, 20, 24, 26};

/// One octant as the templates see it: all that the ranked Delaunay triangulation of a balanced octree's
/// vertices can depend on inside one octant, for its tetrahedra never leave their octant.
struct OctantPattern {
  std::uint32_t hanging = 0;             ///< which of kHangingPoint are present
  std::array<std::uint64_t, 27> rank{};  ///< ranks of the present points; the others' are not read
};

/// Tetrahedra over the 27 local points, positive, as local numbers 0..26.
using OctantTets = std::vector<std::array<std::uint8_t, 4>>;

/// A cache of templates: filled by running Triangulation on the pattern's points, keyed by what decides the
/// result (the mask and the order of the ranks). Not thread-safe: one per thread, same answers in each.
class TemplateTable {
 public:
  TemplateTable();
  ~TemplateTable();
  /// The reference stays valid as long as the table.
  [[nodiscard]] const OctantTets& tets(const OctantPattern& pattern);
  [[nodiscard]] std::size_t size() const;  ///< distinct keys met so far

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace octet
