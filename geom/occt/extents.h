// SPDX-License-Identifier: BSD-3-Clause
// Sizes of a part and of its regions before there are facets.
#pragma once

#include <vector>

#include "geom/model.h"

namespace octet {

/// Of boxes along the part's own axes, by points on its edges: the same however the part lies. Needs the
/// topology, curves and surfaces of `parts`, which must outlive it.
class Extents {
 public:
  explicit Extents(const ModelParts& parts);
  [[nodiscard]] double diagonal() const { return diagonal_; }  ///< 0: there are no edges
  [[nodiscard]] double diagonal_of(const ModelRegion& region) const;

 private:
  [[nodiscard]] double planar_area(const ModelFace& face, const Vec3& normal) const;
  [[nodiscard]] Eigen::Matrix3d axes() const;

  const ModelParts& parts_;
  std::vector<std::vector<Vec3>> points_;  ///< by edge: its ends and places between, in its direction
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  double diagonal_ = 0.0;
};

}  // namespace octet
