// SPDX-License-Identifier: BSD-3-Clause
// In or out of a face's loops in (u,v), by the parity of a ray.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "geom/surface.h"

namespace octet {

/// One curve of a face's border in (u,v). A seam gives two.
struct TrimCurve {
  std::function<Vec2(double)> at;  ///< asked from several threads at once
  std::vector<double> breaks;      ///< ascending: both ends, and where the curvature may jump
  bool straight = false;           ///< a straight line, at any speed
  std::array<int, 2> vertex{};     ///< identities of the model vertices at its ends
  int edge = 0;                    ///< identity of the model edge: both curves of a seam have the same
};

struct LoopTrimOptions {
  Vec2 tolerance = Vec2::Zero();  ///< half width in u and in v of the band that is kOn
  Vec2 period = Vec2::Zero();     ///< 0: not periodic
};

/// The trim that these curves bound, in any order and direction. Curves' ends that meet at a vertex are
/// joined by straight pieces where they differ. A loop around a period needs no seam.
///
/// Exact: pieces of curves stand in for their chords only outside of a band that holds the piece; within it
/// the piece is halved until the side is clear or the band is below the tolerance. Null where the ends at
/// some vertex do not pair up.
/// Cost: a query looks at the pieces in one strip; 20 to 200 ns. Memory: about 100 bytes a piece.
[[nodiscard]] std::shared_ptr<const Trim> make_loop_trim(std::vector<TrimCurve> curves,
                                                         const LoopTrimOptions& options);

}  // namespace octet
