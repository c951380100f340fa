// SPDX-License-Identifier: BSD-3-Clause
// Axes that turn with the part.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// A direction of planes and their area together.
struct PlaneDirection {
  Vec3 normal = Vec3::Zero();  ///< unit
  double area = 0.0;
};

/// What turns with a part, in the order of its entities.
struct Landmarks {
  std::vector<PlaneDirection> planes;
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< second moments about the centre, per weight
  std::vector<Vec3> vertices;
  double diagonal = 0.0;

  /// Adds to a direction that is known, or makes it one; a part of countless directions is described by some.
  void add_plane(const Vec3& normal, double area);
};

/// The rows are orthonormal and right-handed: the part's own axes, the same whichever way it lies. Where a
/// part has planes, the first axis is the normal of the most area of them, the second that of the most area
/// at right angles to it; what planes leave open is taken from the second moments of the surface, and where
/// these are equal from the vertex farthest away. Of equal ones the first in the order of entities counts.
/// Axes along the coordinate axes are exactly along them; the identity for parts like a ball.
[[nodiscard]] Eigen::Matrix3d own_axes(const Model& model);
[[nodiscard]] Eigen::Matrix3d own_axes(const Landmarks& landmarks);

}  // namespace octet
