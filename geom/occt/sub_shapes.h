// SPDX-License-Identifier: BSD-3-Clause
// Parts of a shape, each once.
#pragma once

#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

namespace octet {

/// Of vertices, edges, faces and solids, by dimension.
inline constexpr TopAbs_ShapeEnum kShapeTypes[4] = {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID};

/// The vertices, edges, faces or solids of a shape, in the order of TopExp::MapShapes.
inline TopTools_IndexedMapOfShape sub_shapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, type, map);
  return map;
}

/// 0 for no shape.
[[nodiscard]] inline int count_faces(const TopoDS_Shape& shape) {
  return shape.IsNull() ? 0 : sub_shapes(shape, TopAbs_FACE).Extent();
}

}  // namespace octet
