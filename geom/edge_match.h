// SPDX-License-Identifier: BSD-3-Clause
// Partners of a point on a model edge on other edges that run close by.
#pragma once

#include <cstdint>
#include <vector>

#include "geom/box_tree.h"
#include "geom/model.h"

namespace octet {

/// A point on another edge, symmetric about the local medial axis of the two curves.
struct EdgePartner {
  int edge = 0;
  double t = 0.0;
  Vec3 point = Vec3::Zero();
};

/// The real edges of a model in samples, and a tree of boxes around runs of them.
///
/// Cost: one sample each half `most` along the edges, at least three an edge; a look-up goes through the runs
/// whose boxes come near, however far other edges may be looked for. Immutable, thread-safe.
class EdgeIndex {
 public:
  /// `most`: no edge is looked for farther away than this.
  EdgeIndex(const Model& model, double most);

  /// Points b on the edges other than `edge` with |b - a| <= max_distance (and <= `most`) for which
  /// the chord a-b makes equal angles with both curves: straight across between parallel edges, at a's
  /// distance from the common vertex on edges that meet there. Interior points only, at most one an edge,
  /// ascending by edge tag.
  [[nodiscard]] std::vector<EdgePartner> partners(int edge, double t, double max_distance) const;

  /// The nearest point of each edge that comes closer to p than max_distance (and `most`), ascending by tag.
  [[nodiscard]] std::vector<EdgePartner> feet(const Vec3& p, double max_distance) const;

 private:
  struct Sample {
    int edge;
    double t;
    Vec3 point;
  };
  /// Samples from `begin` to before `end`.
  struct Run {
    std::uint32_t begin, end;
  };
  /// Of each edge that may come within `reach` of p the sample nearest to p of the runs that may, ascending
  /// by edge tag.
  [[nodiscard]] std::vector<Sample> nearest_samples(const Vec3& p, double reach) const;
  [[nodiscard]] bool mirror(const Vec3& a, const Vec3& tangent, const Sample& start, EdgePartner& out) const;
  void add_edge(int e, std::vector<Box3>& boxes);

  const Model* model_;
  double most_;
  std::vector<Sample> samples_;
  std::vector<Run> runs_;
  BoxTree tree_;  ///< of the runs
};

}  // namespace octet
