// SPDX-License-Identifier: BSD-3-Clause
// What finalization does with a mesh, or with a block of one.
#pragma once

#include <optional>

#include "base/observer.h"
#include "finalize/workshop.h"

namespace octet {

/// The worst are chased with every operator up to here (radians, 32 degrees). Measured on three parts at 100
/// k: chasing to 20 left 18 to 25 degrees, to 28 left 28, to 32 left 30; to 35 costs four times as much and
/// gains nothing.
inline constexpr double kChaseAngle = 0.559;
/// Angles larger than this (radians, 137.5 degrees) are worked on last, each by itself.
inline constexpr double kObtuse = 2.40;

enum class Chosen {
  kByScope,  ///< what the options' scope asks for
  kWorst,    ///< the worst alone
};

struct Scheduled {
  FinalizeReport report;
  std::optional<Mesh> better;  ///< none where its smallest angle would be less than that of the mesh given
};
/// Works on the mesh in the shop.
[[nodiscard]] Scheduled run_schedule(Workshop& shop, Chosen chosen, Observer& observer);

}  // namespace octet
