// SPDX-License-Identifier: BSD-3-Clause
// Families of parts that are hard at an element size of 1: thin, sharp, touching, or full of small features.
#pragma once

#include <TopoDS_Shape.hxx>

#include <functional>
#include <string>
#include <vector>

namespace octet::test {

struct FamilyPart {
  std::string name;  ///< letters, digits and underscores
  double size = 1.0;
  std::function<TopoDS_Shape()> build;
};

/// All of them, built when asked for.
[[nodiscard]] std::vector<FamilyPart> family_parts();

/// The shape turned about an oblique axis; turn 0 leaves it, 1 and 2 are rotations in general position.
[[nodiscard]] TopoDS_Shape turned(const TopoDS_Shape& shape, int turn);

}  // namespace octet::test
