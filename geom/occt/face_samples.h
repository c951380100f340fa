// SPDX-License-Identifier: BSD-3-Clause
// Points inside a face.
#pragma once

#include <TopoDS_Face.hxx>

#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace octet {

struct FaceSample {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, of the face as it is turned
};

/// Up to `most` points of the face, clear of its border, from all over it; none where OCCT finds no inside.
[[nodiscard]] std::vector<FaceSample> face_samples(const TopoDS_Face& face, std::size_t most);

}  // namespace octet
