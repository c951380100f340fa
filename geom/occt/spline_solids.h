// SPDX-License-Identifier: BSD-3-Clause
// Solids with their planes, cylinders, cones, spheres and tori as splines.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <optional>
#include <vector>

namespace octet {

struct SplineSolids {
  std::vector<TopoDS_Shape> solids;  ///< those that were not asked for are as they were
  Handle(BRepTools_History) history;
};

/// The solids `which` (indices) with rational splines for all their surfaces and curves: the same geometry,
/// to which OCCT's intersections go another way. What several of them share they share afterwards. Nothing
/// where that is not exact (offset surfaces), where curves on faces would run farther beside their edges than
/// now, where it fails, or where the solids have more faces than a fuse of splines has time for.
[[nodiscard]] std::optional<SplineSolids> as_splines(const std::vector<TopoDS_Shape>& solids,
                                                     const std::vector<std::size_t>& which);

}  // namespace octet
