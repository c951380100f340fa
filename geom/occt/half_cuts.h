// SPDX-License-Identifier: BSD-3-Clause
// Places where a general fuse cut a face in part only.
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace octet {

/// An edge inside a face of the first solid, on both sides of which the second goes on.
struct HalfCut {
  std::array<std::size_t, 2> solids{0, 0};
  Vec3 place = Vec3::Zero();
};

/// `images`: what became of each solid. Where one only touches a face of another along an edge, its faces
/// there lie on one side of it, and that is none.
[[nodiscard]] std::vector<HalfCut> half_cuts(const std::vector<std::vector<TopoDS_Shape>>& images);

}  // namespace octet
