// SPDX-License-Identifier: BSD-3-Clause
// What finalization does with a mesh, or with a block of one.
#pragma once

#include <optional>

#include "base/observer.h"
#include "finalize/improve.h"
#include "finalize/workshop.h"
#include "mesh/quality.h"

namespace octet {

/// The worst are chased with every operator up to here (radians, 32 degrees). Measured on three parts at 100
/// k: chasing to 20 left 18 to 25 degrees, to 28 left 28, to 32 left 30; to 35 costs four times as much and
/// gains nothing.
inline constexpr double kChaseAngle = 0.559;
/// And where more than a tenth of the elements fall short even of the target, up to here alone (radians, 16
/// degrees), as in walls of one layer far thinner than the size. Measured on a frame of hollow tubes: three
/// fifths of the time, for 0.3 degrees of the first percentile; up to 14 a coil of tube lost 1.2 degrees.
inline constexpr double kThinAngle = 0.279;
/// Angles larger than this (radians, 137.5 degrees) are worked on last, each by itself.
inline constexpr double kObtuse = 2.40;

/// The shape that the worst are chased up to: `goal`, or where more than a tenth of the elements, and more
/// than 3000, fall short of it, as in a thin shell of one layer, what so many fall short of, if that is above
/// `least`. To chase all of them took most of finalization and brought them 1 degree more.
[[nodiscard]] double chase_goal(const WorkMesh& mesh, double least, double goal);

/// The angle (radians) above which the largest are worked on: kObtuse, or where more than a tenth of the
/// elements, and more than 3000, are above it, what so many are above.
[[nodiscard]] double obtuse_limit(const WorkMesh& mesh);

/// Whether so little came of a pass, less than a twentieth of more than 2000 tried, that another one would
/// find next to nothing: where walls are thinner than the elements most of what falls short does so for good,
/// and smoothing around it would let all of it be tried again.
[[nodiscard]] bool is_exhausted(const PassResult& pass);

enum class Chosen {
  kByScope,  ///< what the options' scope asks for
  kWorst,    ///< the worst alone
};

/// Whether a mesh is a worse one than what it was made of: its smallest angle is less, or where fewer
/// elements fall short of the target, less by more than a tenth. Shapes grow by the sine, which an obtuse
/// angle may have won by; and of a part of a mesh the worst element may be one that only the next part can
/// mend, which moves a little with its neighbours.
[[nodiscard]] bool is_worse(const DihedralExtremes& made, const DihedralExtremes& given);

struct Scheduled {
  FinalizeReport report;
  std::optional<Mesh> better;  ///< none where it would be worse than the mesh given
};
/// Works on the mesh in the shop.
[[nodiscard]] Scheduled run_schedule(Workshop& shop, Chosen chosen, Observer& observer);

}  // namespace octet
