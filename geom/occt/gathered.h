// SPDX-License-Identifier: BSD-3-Clause
// Shapes put together in one, as they are.
#pragma once

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <vector>

namespace octet {

[[nodiscard]] inline TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

/// Faces are TopoDS_Shape or TopoDS_Face.
template <class Face>
[[nodiscard]] TopoDS_Shell shell_of(const std::vector<Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const Face& face : faces) builder.Add(shell, face);
  return shell;
}

/// A solid of one shell, whether it closes or not.
template <class Face>
[[nodiscard]] TopoDS_Solid solid_of(const std::vector<Face>& faces) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell_of(faces));
  return solid;
}

}  // namespace octet
