// SPDX-License-Identifier: BSD-3-Clause
// The solids of a shape, sewn and fused where the file left them apart.
#pragma once

#include <BRepTools_History.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "base/fault.h"
#include "geom/occt/sew.h"

namespace octet {

/// Entity maps of a shape by dimension: vertices, edges, faces, solids, in the order FreeCAD and Gmsh show.
struct ShapeMaps {
  explicit ShapeMaps(const TopoDS_Shape& shape);
  TopTools_IndexedMapOfShape of[4];
};

/// Solids that share faces where they touch, and how they came from the shape as read.
struct SolidSet {
  std::vector<TopoDS_Shape> solids;   ///< in the order of the shape as read
  Handle(BRepTools_History) history;  ///< from the shape as read; what is not in it is unchanged
  std::vector<std::string> notes;
  std::vector<TopoDS_Shape> caps{};  ///< faces that were added over openings, as they were then
  std::vector<TopoDS_Shape>
      open{};  ///< shells of several faces that are open, or that sewing left so beside closed ones
};

/// What became of an entity of the shape as read; itself where nothing did, nothing where it was removed.
[[nodiscard]] TopTools_ListOfShape images_of(const TopoDS_Shape& shape, const SolidSet& set);

/// Faces of the shape as read of which nothing is in a solid of the set: their numbers, and what became of
/// them.
struct LooseFaces {
  std::vector<int> numbers;
  std::vector<TopoDS_Shape> faces;
};
[[nodiscard]] LooseFaces loose_faces(const ShapeMaps& as_read, const SolidSet& set);

/// The number of what became `shape`, an entity of the set of this dimension; of the first, where several
/// did; 0: none.
[[nodiscard]] int number_as_read(int dim, const TopoDS_Shape& shape, const ShapeMaps& as_read,
                                 const SolidSet& set);

/// Why `shape`, a part of the shape as read or of what became of that, bounds no volume: of its free edges
/// the one that is farthest from all others, numbered as read. The advice is what of sewing with
/// more and of capping may help, beyond what has been tried. `sewn`: its faces sewn, for what could be
/// capped; where faces that meet share no edges the shape itself has no loops about its openings.
[[nodiscard]] Fault opening_of(const TopoDS_Shape& shape, const TopoDS_Shape& sewn, const ShapeMaps& as_read,
                               const SolidSet& set, const SewOptions& tried);

/// Adds to the set what was closed so, and says it in a note.
void add_caps(const std::vector<Cap>& caps, const ShapeMaps& as_read, SolidSet& set);

/// Closed shells become solids, loose faces are sewn and capped (sew_faces()). Of `shape` only tolerances may
/// become wider, those of edges of caps.
/// ModelError: nothing in it bounds a volume (names the first free edge, a face of it and its place).
[[nodiscard]] SolidSet collect_solids(const TopoDS_Shape& shape, const ShapeMaps& as_read,
                                      const SewOptions& sewing);

}  // namespace octet
