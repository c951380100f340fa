// SPDX-License-Identifier: BSD-3-Clause
// Faces of different solids that lie on one another but for noise.
#pragma once

#include <TopoDS_Face.hxx>
#include <cstddef>
#include <limits>
#include <vector>

namespace octet {

/// A face and the solid that it bounds.
struct FaceOfSolid {
  TopoDS_Face face;
  std::size_t solid = 0;
};

/// Pairs of faces of different solids that lie on one another.
struct NearFaces {
  int count = 0;
  double narrowest =
      std::numeric_limits<double>::infinity();  ///< least, over pairs, of their widest distance
};

/// The pairs that are nowhere `near` or farther apart where they lie over one another. Planes, quadrics and
/// tori only, and by some thirty places on each face: what is narrower than a sixth of its face may be
/// missed. O(n log n) for n faces, each of which meets few others' boxes.
[[nodiscard]] NearFaces near_faces(const std::vector<FaceOfSolid>& faces, double near);

}  // namespace octet
