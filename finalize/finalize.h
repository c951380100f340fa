// SPDX-License-Identifier: BSD-3-Clause
// Mesh finalization: the shapes of a valid classified mesh made good, on the exact geometry.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/observer.h"
#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// How much is done.
enum class FinalizeScope {
  kSmoothing,  ///< vertices are moved, and nothing else
  kNicks,      ///< also the edges below `short_edge` are collapsed first
  kFast,       ///< nicks, one round for the mean, then all operators on what is below the target alone
  kAll,
};

struct FinalizeOptions {
  double target_dihedral = 0.349;  ///< radians (20 degrees): what every element should have; less is reported
  double leave_interior =
      0.524;  ///< radians (30 degrees): elements without a boundary vertex are touched only below this
  double short_edge =
      0.35;  ///< edges shorter than this share of the local size are collapsed where the model allows
  double long_edge =
      2.0;  ///< edges longer than this share of the local size are split where no shape gets worse by it
  double max_seconds =
      0.0;  ///< 0: the built-in work budget only (deterministic; counts of operations, not time)
  FinalizeScope scope = FinalizeScope::kAll;
  /// Meshes of twice as many tetrahedra and more are worked on in blocks of no more than this, side by side;
  /// what lies about their seams, once more, which costs one thread a tenth of the time (a fifth with half as
  /// many in a block). Blocks are twice as large, or four times, ..., where more than three tenths of the
  /// mesh lie about their seams; meshes that have no two such blocks stay whole.
  std::size_t block_tets = 150'000;
  /// The first so many vertices stay where they are and keep their numbers: tetrahedra that are not given
  /// here hold on to them, beyond faces that have one tetrahedron and are no triangles.
  std::size_t fixed_vertices = 0;
  /// Those of them that hold on to nothing that could come to be joined with a neighbour of theirs once more:
  /// collapses may go to them. Not in blocks.
  std::vector<Mesh::Index> alone;
  /// Boundary vertices that stay where they are, and so do the boundary's triangles between them.
  std::vector<Mesh::Index> held;
  std::vector<double> volume_beyond;  ///< of what is not given, per region tag; empty: nothing
  /// Local mesh size asked for at a place (model units); required.
  std::function<double(const Vec3&)> size_at;
  /// How far the boundary may come off its faces and edges at a place (model units): where sheets of it are
  /// near to each other, nothing else keeps them from crossing. What is farther off already stays as it is:
  /// it may be so on both sides of the gap. Empty: as far as elsewhere.
  std::function<double(const Vec3&)> room_at;
  /// Where octants were made smaller than asked for, the size asked for; empty: nowhere. Once the shapes are
  /// good, the short edges of that size are collapsed as well, as far as the shapes stay good.
  std::function<double(const Vec3&)> coarse_size_at;
};

struct FinalizeReport {
  double min_dihedral_before = 0.0, min_dihedral_after = 0.0;  ///< radians
  double max_dihedral_after = 0.0;
  std::size_t below_target = 0;  ///< elements still below target_dihedral
  std::size_t smoothed = 0, edge_removals = 0, face_swaps = 0, collapses = 0, splits = 0;
  bool budget_spent = false;
};

/// Improves `mesh` in place. Topology, classification and the invariants of Mesh are kept by every operation:
/// model vertices stay, vertices on model edges move along them, vertices on faces move on them by exact
/// projection, boundary swaps and collapses keep every model edge a chain and every face a disk-wise surface.
/// The distance of the boundary to the CAD never grows beyond what the chord error of the local size allows.
/// The smallest dihedral never decreases, but for coarsening, which may lower it to the target. Runs on the
/// threads of the caller's arena; the result does not depend on their number. [Handbook 15.6]
FinalizeReport finalize(Mesh& mesh, const Model& model, const FinalizeOptions& options, Observer& observer);

}  // namespace octet
