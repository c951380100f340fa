// SPDX-License-Identifier: BSD-3-Clause
// Solids with voids, as files have them.
#pragma once

#include <BRep_Builder.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>

namespace octet::test {

/// A solid with the shell of another turned inside out, which shares nothing with it: a void to the file,
/// wherever it lies.
inline TopoDS_Shape with_void(const TopoDS_Shape& outer, const TopoDS_Shape& inner) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, TopExp_Explorer(outer, TopAbs_SHELL).Current());
  builder.Add(solid, TopExp_Explorer(inner, TopAbs_SHELL).Current().Reversed());
  return solid;
}

}  // namespace octet::test
