// SPDX-License-Identifier: BSD-3-Clause
// Sharp tips: model vertices in which faces wind about an axis and narrow to nothing, as a cone does at its
// apex.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "geom/model.h"
#include "octree/octree.h"

namespace octet {

/// Near its vertex a tip is too narrow for points at the local size: two across one another enclose nothing,
/// and tetrahedra about them are as flat as the tip is thin. So nothing is put between the vertex and a ring
/// of six points, where the faces leave a ball through the vertex about the axis, the first in which six have
/// room. The ball holds no other point of the faces: what lies between vertex and ring is Delaunay where no
/// octree vertex is in it. Seen along the axis the tip is about an ellipse.
struct Tip {
  int vertex = 0;
  std::vector<int> faces;            ///< those that narrow, ascending
  std::vector<int> faces_at_vertex;  ///< all that have the vertex, ascending
  Vec3 place = Vec3::Zero();         ///< of the vertex
  Vec3 along = Vec3::Zero();         ///< the axis, into the faces, unit
  Vec3 across = Vec3::Zero();        ///< the way in which the tip is wide, unit, perpendicular to the axis
  double taper = 0.0;                ///< half its width over the distance from the vertex
  double lesser_taper = 0.0;         ///< so in the direction in which it is narrow
  double reach = 0.0;                ///< diameter of the ball

  /// Distance of neighbours in the ring: the least.
  [[nodiscard]] double ring_step() const {
    return reach * std::hypot(0.5 * taper, std::sqrt(0.75) * lesser_taper);
  }
  /// Whether p is in the ball.
  [[nodiscard]] bool encloses(const Vec3& p) const;
  /// Whether p, a point of that face, lies between the vertex and the ring.
  [[nodiscard]] bool holds(int face, const Vec3& p) const;
  /// Whether the way from the vertex to p is along the tip: about as near to its axis as its faces are.
  [[nodiscard]] bool leads_to(const Vec3& p) const;
};

/// Cost: one look at all facets where the model has degenerate edges; a comparison a tip for each question.
class Tips {
 public:
  Tips() = default;  ///< none
  Tips(const Model& model, const Octree& tree);

  [[nodiscard]] const std::vector<Tip>& all() const { return tips_; }
  /// The tip that holds p, a point of that face; null for none.
  [[nodiscard]] const Tip* holder(int face, const Vec3& p) const;
  /// Whether p, a place off the boundary, lies in the ball of a tip, or so near that it is in its way.
  [[nodiscard]] bool are_beside(const Vec3& p) const;

 private:
  std::vector<Tip> tips_;
};

/// Six places of a tip's ring, about the axis, between which the faces turn as much and are as wide, by
/// turns. Where faces do not go all around they are those about the ellipse, and some lie on no face of the
/// tip.
[[nodiscard]] std::vector<Vec3> ring_places(const Model& model, const Tip& tip);
/// The point of the face on the tip's ring that is nearest to the way from the vertex to p; none beyond the
/// face's boundary.
[[nodiscard]] std::optional<Vec3> ring_point(const Model& model, const Tip& tip, int face, const Vec3& p);
/// Parameter at which an edge that ends in the tip's vertex passes the ring; none where it ends before, or is
/// not along the tip.
[[nodiscard]] std::optional<double> ring_parameter(const Model& model, const Tip& tip, int edge);
/// The local size at which the ring's six points just keep the spacing of points on faces.
[[nodiscard]] double ring_spacing(const Tip& tip);

}  // namespace octet
