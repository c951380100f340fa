// SPDX-License-Identifier: BSD-3-Clause
// What every operator of finalization works on.
#pragma once

#include <chrono>
#include <limits>

#include "finalize/boundary_guard.h"
#include "finalize/finalize.h"
#include "finalize/flat_guard.h"
#include "finalize/local_star.h"
#include "finalize/work_mesh.h"

namespace octet {

/// The mesh, the exact geometry that guards it, and the account of the work done.
struct Workshop {
  Workshop(WorkMesh work_mesh, const Model& the_model, const FinalizeOptions& the_options)
      : mesh(std::move(work_mesh)),
        model(the_model),
        options(the_options),
        guard(the_model, mesh, the_options.volume_beyond) {}
  /// Of a mesh, with what the options fix and hold of it.
  Workshop(const Mesh& given, const Model& the_model, const FinalizeOptions& the_options)
      : Workshop(to_work_mesh(given, the_options.fixed_vertices), the_model, the_options) {
    for (const Mesh::Index v : the_options.held)
      if (Hold& hold = mesh.hold[VertexId(v)]; hold == Hold::kFree) hold = Hold::kOnBoundary;
    release_alone(mesh, the_options.alone);
  }

  WorkMesh mesh;
  const Model& model;
  const FinalizeOptions& options;
  BoundaryGuard guard;
  FlatGuard flats;
  FinalizeReport report;
  bool coarsening = false;          ///< sizes are those of `coarse_size_at`
  bool thorough = false;            ///< project every place tried, also where projections are dear
  std::uint64_t work = 0;           ///< evaluations of `shape`, the unit of the work budget
  std::uint64_t compound_work = 0;  ///< of these, those for compound moves
  std::uint64_t compound_kept = 0;  ///< compound moves that were kept
  std::vector<TetId> made;          ///< tetrahedra made or changed by the last operator that succeeded
  EdgeRing ring;                    ///< scratch
  LocalStar star;                   ///< scratch
  std::vector<TetId> tets;          ///< scratch: most stars that are walked end at their first tetrahedra

  /// Serial numbers of operations: when tetrahedra at the vertex last changed, when the tetrahedron was last
  /// tried in vain, and the smoothing of the vertex. What has not changed since is not tried again.
  std::vector<std::uint32_t> touched, tried, still;
  std::uint32_t serial = 0;
  std::vector<std::uint8_t> in_vain;  ///< compound moves tried in vain at tetrahedra of the vertex

  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();

  /// Marks the vertices of what an operation made.
  void note_change() {
    ++serial;
    touched.resize(mesh.points.size(), 0);
    for (const TetId t : made) {
      if (!mesh.alive(t)) continue;
      for (const VertexId v : mesh.tets[t]) touched[v.index()] = serial;
    }
  }
  /// Lets everything be tried again: what changes without marks must call it.
  void forget_failures() {
    tried.clear();
    still.clear();
  }
  [[nodiscard]] bool unchanged_since(std::uint32_t when, VertexId v) const {
    return v.index() >= touched.size() || touched[v.index()] < when;
  }

  [[nodiscard]] double size_at(const Vec3& p) const {
    return (coarsening ? options.coarse_size_at : options.size_at)(p);
  }
  [[nodiscard]] double room_at(const Vec3& p) const {
    return options.room_at ? options.room_at(p) : std::numeric_limits<double>::infinity();
  }
};

/// An operator must raise the worst shape of what it touches by this factor (0.1 per cent of an angle), or it
/// would trade ever smaller gains for ever.
inline constexpr double kGain = 1.002;
/// Shapes up to this are noise: the sine of a millionth of a degree.
inline constexpr double kNoise = 1e-16;

/// The least shape that counts as better than `worst`.
[[nodiscard]] inline double better_than(double worst) { return worst > kNoise ? worst * kGain : kNoise; }

}  // namespace octet
