// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions.
#pragma once

#include "base/vec.h"

namespace octet {

/// A rotation and then a translation.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 operator()(const Vec3& p) const { return turn * p + shift; }
  [[nodiscard]] Motion inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
  /// `first`, then this one.
  [[nodiscard]] Motion after(const Motion& first) const {
    return {turn * first.turn, turn * first.shift + shift};
  }
};

}  // namespace octet
