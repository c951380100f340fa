// SPDX-License-Identifier: BSD-3-Clause
// The part in its own axes, in which it is meshed: so the mesh does not depend on how the part lies.
#pragma once

#include <optional>
#include <vector>

#include "app/mesh_part.h"

namespace octet {

/// Between the part as the user has it and the part turned into its own axes (geom/own_axes). It stays as it
/// is where these are the coordinate axes, in their order, where sizes are asked for over space (shapes,
/// fields: their boxes do not turn), and where bodies are meshed apart, each of which has axes of its own.
class OwnFrame {
 public:
  OwnFrame(const Model& part, const MeshOptions& options);
  OwnFrame(const OwnFrame&) = delete;
  OwnFrame& operator=(const OwnFrame&) = delete;

  [[nodiscard]] const Model& part() const { return part_; }  ///< as the user has it
  [[nodiscard]] const Model& model() const { return turned_ ? *turned_ : part_; }
  [[nodiscard]] const MeshOptions& options() const { return options_; }  ///< for model()

  [[nodiscard]] Vec3 to_part(const Vec3& p) const { return turned_ ? Vec3(axes_.transpose() * p) : p; }
  [[nodiscard]] Vec3 to_model(const Vec3& p) const { return turned_ ? Vec3(axes_ * p) : p; }
  void to_part(std::vector<Vec3>& points) const;

 private:
  const Model& part_;
  MeshOptions options_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  std::optional<Model> turned_;
};

}  // namespace octet
