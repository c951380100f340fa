// SPDX-License-Identifier: BSD-3-Clause
// Solids with splines for the surfaces of faces where they meet others.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace octet {

struct SplineFaces {
  std::vector<TopoDS_Shape> solids;
  Handle(BRepTools_History) history;                          ///< of faces and solids
  int faces = 0;                                              ///< so many are splines now
  std::vector<std::pair<TopoDS_Edge, TopoDS_Face>> curves{};  ///< that edges got on those faces
  std::vector<std::pair<TopoDS_Shape, double>> tolerances{};  ///< of edges and vertices as they were (mm)
};

/// Solids that may share faces and edges, with rational splines for the surfaces of all faces where the last
/// of them comes near another: the same geometry, to which OCCT's intersections go another way. Edges stay,
/// and get a curve on the new surface, so that what shares them, in more solids, too, shares them still; that
/// makes them less help than solids that are splines all over (geom/occt/spline_solids). Offset surfaces and
/// splines stay. Nothing where more faces come near than a fuse of splines has time for, where OCCT fails, or
/// where the new curves would run farther beside their edges than those of the old surfaces may.
[[nodiscard]] std::optional<SplineFaces> with_spline_faces_about_last(
    const std::vector<TopoDS_Shape>& solids);

/// Takes the new curves from the edges, which the solids as they were have, too, and what their tolerances
/// were widened by.
void take_back(const SplineFaces& splines);

}  // namespace octet
