// SPDX-License-Identifier: BSD-3-Clause
// The rigid motion that takes faces to faces.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geom/model.h"
#include "geom/motion.h"

namespace octet {

struct MotionFound {
  Motion motion;
  std::vector<std::pair<int, int>> faces;  ///< each with its image
  std::string reason;                      ///< empty: there is one; else why not, for the user
};

/// Looks for a motion that takes `faces` to `images`: each onto one, what is inside at the one to what is
/// outside at the other if both are on the boundary, edges onto edges. Translations come first, along the
/// axis (0..2) alone where one is given; then rotations, the least angle first. `tolerance`: how far images
/// may be off.
[[nodiscard]] MotionFound find_motion(const Model& model, const std::vector<int>& faces,
                                      const std::vector<int>& images, int axis, double tolerance);

/// Vertices and real edges in the closures of the faces, ascending.
[[nodiscard]] std::vector<int> vertices_of(const Model& model, const std::vector<int>& faces);
[[nodiscard]] std::vector<int> edges_of(const Model& model, const std::vector<int>& faces);

/// A few points spread over a face.
[[nodiscard]] std::vector<Vec3> points_within(const Model& model, int face);

}  // namespace octet
