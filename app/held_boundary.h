// SPDX-License-Identifier: BSD-3-Clause
// What finalization must not change of a boundary that it made faults on: more from try to try.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/narrow_gaps.h"
#include "geom/model.h"
#include "mesh/mesh.h"
#include "octree/octree.h"

namespace octet {

/// Where sheets of the boundary are near to each other, through the outside, nothing is between them that
/// would keep their triangles from crossing when either changes (app/narrow_gaps). First the boundary keeps
/// to its room at such gaps, now and in all that follows. Then vertices are held, in this order: those at
/// gaps around the faults so far, up to three times; those at all gaps; then, where nothing else helps, those
/// and all around the faults; and the whole boundary, which leaves no fault that was not there before.
class HeldBoundary {
 public:
  explicit HeldBoundary(const Model& model) : model_(model) {}

  /// Ascending, in the mesh asked about last.
  [[nodiscard]] const std::vector<Mesh::Index>& vertices() const { return vertices_; }
  /// What the boundary has to keep to; none before the first try, and where there are no gaps.
  [[nodiscard]] const GapRooms* rooms() const { return rooms_ && !rooms_->empty() ? &*rooms_ : nullptr; }
  [[nodiscard]] bool holds_any() const { return tries_ > kNone; }
  /// Whether more at gaps may help.
  [[nodiscard]] bool is_hopeful() const { return tries_ < kEverywhere && !spent_; }
  /// Whether smaller octants have been given up for holding more.
  [[nodiscard]] bool is_last_resort() const { return tries_ > kEverywhere; }
  /// What is done by now, in words.
  [[nodiscard]] const char* words() const;

  /// Goes on to the next try, for a mesh with faults at `places`; where its boundary does not cross itself,
  /// rooms alone are no try. Requires is_hopeful().
  void hold_more(std::span<const Vec3> places, bool crosses);
  /// Goes on to the next last resort. False: the whole boundary was held.
  [[nodiscard]] bool hold_at_last(std::span<const Vec3> places);
  /// Finds rooms and vertices in `mesh`, which finalization will begin with, made of `tree`, to be there for
  /// as long as the rooms are asked. Where there are no gaps to keep to, it goes on to vertices at once.
  /// False: the same as before.
  bool find(const Mesh& mesh, const Octree& tree);
  /// The same in a mesh made anew; where it is the same as before, no more at gaps is worth its time.
  void find_anew(const Mesh& mesh, const Octree& tree);

 private:
  enum Try { kNone = 0, kRooms = 1, kAroundFaults = 4, kEverywhere = 5, kAllAroundFaults = 6, kAll = 7 };

  const Model& model_;
  int tries_ = kNone;
  bool spent_ = false;
  std::vector<Vec3> places_;  ///< of the faults so far, in the model's own frame
  std::vector<Mesh::Index> vertices_;
  std::optional<GapRooms> rooms_;  ///< of the mesh asked about last
};

}  // namespace octet
