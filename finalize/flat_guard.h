// SPDX-License-Identifier: BSD-3-Clause
// How many flat tetrahedra operations may leave where there were fewer.
#pragma once

#include <cstddef>
#include <span>

#include "finalize/work_mesh.h"

namespace octet {

/// What betters the worst of what it touches may leave all the rest as bad. Where the part forbids good
/// shapes, at a step or a slit far narrower than the size, each such operation spoils what lies about it, and
/// the next ones what lies about that. So operations may leave no more flat tetrahedra than there were, but
/// for a thousandth of the mesh (or block) in all, which the worst come to first.
class FlatGuard {
 public:
  /// Whether the shape (finalize/shape.h) is that of a flat tetrahedron: its worst angle is below 8 degrees.
  [[nodiscard]] static bool is_flat(double shape);
  [[nodiscard]] static int count_flat(std::span<const double> shapes);
  [[nodiscard]] static int count_flat(const WorkMesh& mesh, std::span<const TetId> tets);

  /// While the guard sleeps, and it does at first, nothing is counted and all is admitted.
  void wake(bool awake) { awake_ = awake; }
  [[nodiscard]] bool awake() const { return awake_; }

  /// Whether an operation may leave so many `more` flat tetrahedra in a mesh of `tets`; within a trial,
  /// always.
  [[nodiscard]] bool admits(int more, std::size_t tets) const { return trial_ || fits(more, tets); }
  void take(int more);

  /// Operations of a trial are judged together, by `settled`.
  void open_trial();
  [[nodiscard]] bool settled(std::size_t tets) const { return fits(owed_, tets); }
  void keep_trial();
  void take_back_trial();

  /// Flat tetrahedra left beyond those there were, in all; what is taken apart later does not count.
  [[nodiscard]] std::size_t made() const { return made_; }

 private:
  [[nodiscard]] bool fits(int more, std::size_t tets) const;

  bool awake_ = false, trial_ = false;
  int owed_ = 0;  ///< by the trial
  std::size_t made_ = 0;
};

/// The guard is awake as long as this lives.
class FlatWatch {
 public:
  explicit FlatWatch(FlatGuard& guard) : guard_(guard) { guard_.wake(true); }
  FlatWatch(const FlatWatch&) = delete;
  FlatWatch& operator=(const FlatWatch&) = delete;
  ~FlatWatch() { guard_.wake(false); }

 private:
  FlatGuard& guard_;
};

}  // namespace octet
