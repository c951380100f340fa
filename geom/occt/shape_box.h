// SPDX-License-Identifier: BSD-3-Clause
// Boxes of OCCT shapes.
#pragma once

#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <cmath>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Grown by tolerances; of the exact geometry, never of a triangulation.
inline Bnd_Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box;
}

/// Of the exact geometry, as tight as OCCT makes it, without tolerances: slow on free-form faces.
inline Bnd_Box bare_box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  return box;
}

/// Of the vertices alone: no larger than the shape, and cheap.
inline Bnd_Box vertex_box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next())
    box.Add(BRep_Tool::Pnt(TopoDS::Vertex(it.Current())));
  return box;
}

inline double diagonal_of(const Bnd_Box& box) { return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent()); }

/// Of the box around several shapes.
inline double diagonal_of_all(const std::vector<TopoDS_Shape>& shapes) {
  Bnd_Box all;
  for (const TopoDS_Shape& shape : shapes) all.Add(box_of(shape));
  return diagonal_of(all);
}

/// The middle of its box.
inline Vec3 middle_of(const TopoDS_Shape& shape) {
  const Bnd_Box box = box_of(shape);
  if (box.IsVoid()) return Vec3::Zero();
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  return 0.5 * Vec3(low.X() + high.X(), low.Y() + high.Y(), low.Z() + high.Z());
}

}  // namespace octet
