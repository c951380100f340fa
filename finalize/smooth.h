// SPDX-License-Identifier: BSD-3-Clause
// Node repositioning: the constrained Laplacian, and the line search for the worst element.
#pragma once

#include "finalize/local_star.h"

namespace octet {

/// Whether the vertex may move at all.
[[nodiscard]] bool may_move(const WorkMesh& mesh, VertexId v);

/// Worst shape with the vertex at `wish`, brought onto its entity (`stand`); -1 where it cannot stand, where
/// the worst is not above the bar's, or the distortion not below.
[[nodiscard]] double probe(const Workshop& shop, LocalStar& star, const Stand& from, const Vec3& wish,
                           const StarMeasure& bar, Stand& stand);

/// What volumes and areas gain when the vertex goes to `place`; nothing where no triangle of its star lies on
/// a curved face. `tets` are the tetrahedra of the star.
[[nodiscard]] std::vector<MeasureChange> changes_by_move(const Workshop& shop, VertexId v,
                                                         std::span<const TetId> tets, const LocalStar& star,
                                                         const Vec3& place);

/// Moves the vertex to where it may stand; false, and nothing changed, when the guard does not admit the
/// changes or the exact signs refuse. `shapes` are those of the star there, where they are known, else none.
bool commit_move(Workshop& shop, VertexId v, std::span<const TetId> star, const Stand& stand,
                 std::span<const MeasureChange> changes, std::span<const double> shapes = {});

/// Improves the smallest shape of the star, which is `worst` at `stand`, towards `goal` by moving the vertex
/// along directions that raise all of the nearly worst dihedral angles, with a golden section search on each
/// line [Handbook 15.6.1]. Returns the shape reached (>= worst), `stand` where.
double raise_worst(const Workshop& shop, LocalStar& star, Stand& stand, double worst, double goal);

/// The constrained Laplacian, then raise_worst: moves the vertex so that the worst of its tetrahedra gets
/// better than before by kGain; aims at `goal`. False when it stays.
bool smooth_vertex(Workshop& shop, VertexId v, double goal);

}  // namespace octet
