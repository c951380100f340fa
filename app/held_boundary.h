// SPDX-License-Identifier: BSD-3-Clause
// What finalization must not change of a boundary that it made faults on: more from try to try.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// Where sheets of the boundary are near to each other, through the outside, nothing is between them that
/// would keep their triangles from crossing when either changes (app/narrow_gaps). Held are, in this order:
/// vertices at such gaps around the faults so far, up to three times; those at all such gaps; then, where
/// nothing else helps, those and all around the faults; and the whole boundary, which leaves no fault that
/// was not there before.
class HeldBoundary {
 public:
  using SizeAt = std::function<double(const Vec3&)>;

  explicit HeldBoundary(const Model& model) : model_(model) {}

  /// Ascending, in the mesh asked about last.
  [[nodiscard]] const std::vector<Mesh::Index>& vertices() const { return vertices_; }
  [[nodiscard]] bool holds_any() const { return tries_ > 0; }
  /// Whether more vertices at gaps may help.
  [[nodiscard]] bool is_hopeful() const { return tries_ < kEverywhere && !spent_; }
  /// Whether smaller octants have been given up for holding more.
  [[nodiscard]] bool is_last_resort() const { return tries_ > kEverywhere; }
  /// What is held by now, in words.
  [[nodiscard]] const char* words() const;

  /// Goes on to the next try, for a mesh with faults at `places`. Requires is_hopeful().
  void hold_more(std::span<const Vec3> places);
  /// Goes on to the next last resort. False: the whole boundary was held.
  [[nodiscard]] bool hold_at_last(std::span<const Vec3> places);
  /// Finds the vertices in `mesh`, which finalization will begin with. False: the same as before.
  bool find(const Mesh& mesh, const SizeAt& size_at);
  /// The same in a mesh made anew; where they are the same as before, no more at gaps are worth their time.
  void find_anew(const Mesh& mesh, const SizeAt& size_at) { spent_ = !find(mesh, size_at); }

 private:
  enum Try { kNone = 0, kAroundFaults = 3, kEverywhere = 4, kAllAroundFaults = 5, kAll = 6 };

  const Model& model_;
  int tries_ = kNone;
  bool spent_ = false;
  std::vector<Vec3> places_;  ///< of the faults so far, in the model's own frame
  std::vector<Mesh::Index> vertices_;
};

}  // namespace octet
