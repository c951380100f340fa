// SPDX-License-Identifier: BSD-3-Clause
// Partners of a point on a model edge on other edges that run close by.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geom/model.h"

namespace octet {

/// A point on another edge, symmetric about the local medial axis of the two curves.
struct EdgePartner {
  int edge = 0;
  double t = 0.0;
  Vec3 point = Vec3::Zero();
};

/// The real edges of a model, sampled into a hash grid of the given cell length.
///
/// Cost: one sample each half cell along the edges; a look-up visits 27 cells. Immutable, thread-safe.
class EdgeIndex {
 public:
  EdgeIndex(const Model& model, double cell);

  /// Points b on the edges other than `edge` with |b - a| <= max_distance (and <= the cell length) for which
  /// the chord a-b makes equal angles with both curves: straight across between parallel edges, at a's
  /// distance from the common vertex on edges that meet there. Interior points only, at most one an edge,
  /// ascending by edge tag.
  [[nodiscard]] std::vector<EdgePartner> partners(int edge, double t, double max_distance) const;

  /// The nearest point of each edge that comes closer to p than max_distance (<= the cell length), ascending
  /// by tag.
  [[nodiscard]] std::vector<EdgePartner> feet(const Vec3& p, double max_distance) const;

 private:
  struct Sample {
    int edge;
    double t;
    Vec3 point;
  };
  /// Of each edge that may come within `reach` of p the sample nearest to p, ascending by edge tag.
  [[nodiscard]] std::vector<Sample> nearest_samples(const Vec3& p, double reach) const;
  [[nodiscard]] std::uint64_t key(const Vec3& p, int dx, int dy, int dz) const;
  [[nodiscard]] bool mirror(const Vec3& a, const Vec3& tangent, const Sample& start, EdgePartner& out) const;

  const Model* model_;
  double cell_;
  std::vector<Box3> around_;  ///< per edge tag
  std::unordered_map<std::uint64_t, std::vector<Sample>> cells_;
};

}  // namespace octet
