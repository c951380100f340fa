// SPDX-License-Identifier: BSD-3-Clause
// The numbers by which a CAD file itself knows its entities.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <XSControl_Reader.hxx>
#include <vector>

namespace octet {

/// A vertex, edge, face or solid and the number of the file's entity that it was made from.
struct FileId {
  TopoDS_Shape shape;
  int number = 0;
};

/// Of a STEP file that was transferred: #number of each VERTEX_POINT, EDGE_CURVE, face and solid.
[[nodiscard]] std::vector<FileId> step_ids(const XSControl_Reader& reader);

/// Of an IGES file: the line of the directory entry of each entity that became a vertex, edge, face or solid.
[[nodiscard]] std::vector<FileId> iges_ids(const XSControl_Reader& reader);

/// The number of each of these entities, all of one kind, wherever they are placed; [0] unused, 0: none.
[[nodiscard]] std::vector<int> ids_of(const TopTools_IndexedMapOfShape& entities,
                                      const std::vector<FileId>& ids);

}  // namespace octet
