// SPDX-License-Identifier: BSD-3-Clause
// Faces that are each other's images under a rigid motion, for meshes that fit there: unit cells, sectors.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "geom/model.h"
#include "geom/motion.h"

namespace octet {

/// What is asked for: one motion takes all `faces` to all `images`.
struct PeriodicFaces {
  std::string words;  ///< the user's, for messages
  std::vector<int> faces, images;
  int axis = -1;  ///< 0..2: a translation along it; -1: any motion
};

/// A vertex or face of an orbit.
struct OrbitMember {
  int tag = 0;
  Motion motion;  ///< of the orbit's first to this one
};

/// A piece of an edge, of an orbit of such.
struct PieceMember {
  int edge = 0;
  double t0 = 0.0, t1 = 0.0;  ///< its parameters
  Motion motion;              ///< of the orbit's first to this one
};

/// What is taken to what: the faces with their closures. An edge may be the image of several, or a vertex
/// that of no vertex, as where booleans leave the seam of a cylinder: edges go in pieces that end where
/// others' vertices come to lie.
class Periodicity {
 public:
  /// Finds the motions: translations before rotations, the least angle before others, of boundary faces such
  /// as take what is inside at the one to what is outside at the other. InputError, with the user's words,
  /// where there is none, where faces are asked for twice, and where an entity would be its own image in
  /// another place.
  Periodicity(const Model& model, const std::vector<PeriodicFaces>& wishes);
  Periodicity() = default;

  /// The same of the model with every point p at turn * p.
  [[nodiscard]] Periodicity turned(const Eigen::Matrix3d& turn) const;

  [[nodiscard]] bool empty() const { return faces_.empty(); }
  /// Faces that are taken to one another; the first is none's image, where there is such a one.
  [[nodiscard]] const std::vector<std::vector<OrbitMember>>& faces() const { return faces_; }
  /// The same of all vertices that have vertices for images alone.
  [[nodiscard]] const std::vector<std::vector<OrbitMember>>& vertices() const { return vertices_; }
  /// And of the pieces of all real edges in the faces' closures.
  [[nodiscard]] const std::vector<std::vector<PieceMember>>& pieces() const { return pieces_; }
  /// Whether an edge is one piece, as are all its images.
  [[nodiscard]] bool is_whole(const std::vector<PieceMember>& orbit) const;
  /// Whether the face is paired, or the edge is in the closure of one that is.
  [[nodiscard]] bool holds(ModelRef entity) const;
  /// The orbits of an edge's pieces, in the order of their parameters.
  [[nodiscard]] const std::vector<std::size_t>& pieces_of(int edge) const {
    return pieces_of_[static_cast<std::size_t>(edge)];
  }
  /// Where a point of an edge, or else of a face, is taken: the others of its orbit, each with the motion
  /// there.
  [[nodiscard]] std::vector<OrbitMember> images_on_edges(int edge, double t) const;
  [[nodiscard]] std::vector<OrbitMember> images_on_faces(int face) const;
  /// How far an image may be off (model units).
  [[nodiscard]] double tolerance() const { return tolerance_; }

 private:
  std::vector<std::vector<OrbitMember>> vertices_, faces_;
  std::vector<std::vector<PieceMember>> pieces_;
  std::vector<std::vector<std::size_t>> pieces_of_;  ///< per edge tag
  std::vector<std::size_t> orbit_of_face_;           ///< per tag: its number from 1; 0: none
  double tolerance_ = 0.0;
};

/// The faces that lie in the least and in the greatest plane across a coordinate axis (0..2) that the model
/// reaches. InputError where one of these planes holds no face.
[[nodiscard]] PeriodicFaces faces_across(const Model& model, int axis);

}  // namespace octet
