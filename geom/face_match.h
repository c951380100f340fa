// SPDX-License-Identifier: BSD-3-Clause
// Partners on faces for a point on a model edge or vertex.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// A point inside a face, symmetric to a point of an edge about the local medial axis of edge and face.
struct FacePartner {
  int face = 0;
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< of the face there, unit, pointing to region[1]
};

/// Partners of the point `a` of an edge or vertex on the faces that come closer to it than `max_distance` and
/// that `on` does not bound: for an edge that runs along a face the foot of `a`, for one that leaves the face
/// at a vertex or a tangency the point at a's distance from there. `tangent` is the edge's (any length; zero
/// for a vertex). Faces that the edge leaves at more than 45 degrees have none. At most one a face, ascending
/// by face tag.
[[nodiscard]] std::vector<FacePartner> face_partners(const Model& model, ModelRef on, const Vec3& a,
                                                     const Vec3& tangent, double max_distance);

}  // namespace octet
