// SPDX-License-Identifier: BSD-3-Clause
// Where the entities of a part are, and what they look like.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geom/closed_shapes.h"
#include "geom/model.h"

namespace octet {

struct EdgeShape {
  std::array<Vec3, 2> ends;       ///< as the edge runs
  Vec3 middle = Vec3::Zero();     ///< halfway along it
  std::optional<ConicShape> arc;  ///< of a circle or an ellipse
  Box3 box;
};

struct FaceShape {
  Vec3 centre = Vec3::Zero();  ///< of gravity; off the face where that is bent or has a hole there
  Vec3 point = Vec3::Zero();   ///< the centre where it is within the face, else a point that is
  Vec3 normal = Vec3::Zero();  ///< there, unit, out of the region behind the face (the lower number of two)
  /// Of a cylinder, `origin` is the place of the axis beside the centre.
  std::optional<RoundShape> round;
  std::array<double, 2> radii{0.0, 0.0};  ///< of a cone: least and largest, of the facets' corners
  bool concave = false;                   ///< a round face whose normal points to its axis or middle: a hole
  Box3 box;
};

struct RegionShape {
  Vec3 centre = Vec3::Zero();  ///< of gravity
  Box3 box;
};

/// Per tag, [0] unused. What is within rounding of 0 is 0.
struct EntityShapes {
  std::vector<EdgeShape> edges;
  std::vector<FaceShape> faces;
  std::vector<RegionShape> regions;
};

/// A place whose coordinates are 0 where they are within rounding of it.
[[nodiscard]] Vec3 without_rounding(const Model& model, const Vec3& p);

[[nodiscard]] EntityShapes entity_shapes(const Model& model);

}  // namespace octet
