// SPDX-License-Identifier: BSD-3-Clause
// What finalization does with a mesh, or with a block of one.
#pragma once

#include <array>
#include <cstddef>

#include "base/observer.h"
#include "finalize/workshop.h"
#include "mesh/quality.h"

namespace octet {

/// The worst are chased with every operator up to here (radians, 32 degrees). Measured on three parts at 100
/// k: chasing to 20 left 18 to 25 degrees, to 28 left 28, to 32 left 30; to 35 costs four times as much and
/// gains nothing.
inline constexpr double kChaseAngle = 0.559;
/// Angles larger than this (radians, 137.5 degrees) are worked on last, each by itself.
inline constexpr double kObtuse = 2.40;

/// The extreme angles of tetrahedra, and how many have one below the target.
class Extremes {
 public:
  /// `target`: radians.
  explicit Extremes(double target);

  /// Adds a tetrahedron of that shape (finalize/shape.h). O(1) where it can add nothing.
  void add(double shape, const std::array<Vec3, 4>& points);
  /// Adds those of another with the same target.
  void join(const Extremes& other);

  [[nodiscard]] DihedralRange range() const;
  [[nodiscard]] std::size_t below_target() const { return below_target_; }

 private:
  void note_more();

  double target_;
  double of_target_;                ///< squared cotangent
  DihedralCotangents range_{0, 0};  ///< none is taken for a right angle
  std::size_t below_target_ = 0;
  double of_note_ = 1.0;  ///< shapes above this can add nothing
};

enum class Chosen {
  kByScope,  ///< what the options' scope asks for
  kWorst,    ///< the worst alone
};

/// Works on the mesh in the shop, which was made of `mesh`; puts the result there, or leaves it as it was
/// where the smallest angle would be less.
FinalizeReport run_schedule(Workshop& shop, Chosen chosen, Mesh& mesh, Observer& observer);

}  // namespace octet
