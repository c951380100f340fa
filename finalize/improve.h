// SPDX-License-Identifier: BSD-3-Clause
// The passes of finalization, made of the operators.
#pragma once

#include "base/observer.h"
#include "finalize/workshop.h"

namespace octet {

/// Collapses the edges of the boundary's neighbourhood that are shorter than options.short_edge times the
/// local size: the nicks that points near to each other leave [Handbook 15.6.2].
void collapse_short_edges(Workshop& shop);
/// Halves edges longer than `long_edge` times the local size, where no shape falls below `goal` or gets
/// worse.
void split_long_edges(Workshop& shop, double goal);

/// Which operators may be used.
enum class Effort {
  kPolish,  ///< edge removal, face swaps and smoothing
  kFull,    ///< also collapses, splits and compound moves
};

/// Applies the first operator that betters t; false when none does.
bool improve_tet(Workshop& shop, TetId t, double goal, Effort effort);

/// What came of a pass over tetrahedra.
struct PassResult {
  std::size_t tried = 0, bettered = 0;
};

/// Takes the tetrahedra below `goal` (a shape) worst first, and the ones that come of them, and applies the
/// first operator that betters each [Handbook 15.6.3]. Stops when the work budget is spent.
PassResult improve_worst_first(Workshop& shop, double goal, Observer& observer);

/// The same for tetrahedra with a dihedral angle above `limit` (radians), for which `shape` says little:
/// their neighbours' small angles weigh as much.
PassResult improve_obtuse(Workshop& shop, double limit, Observer& observer);

/// Smooths everything near the tetrahedra below `goal`, towards `wish`: what could not be bettered by itself
/// may have room then.
void relax_around(Workshop& shop, double goal, double wish);

}  // namespace octet
