// SPDX-License-Identifier: BSD-3-Clause
// Where the nodes of walls go to make room for layers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "finalize/layers.h"

namespace octet {

/// The way of one vertex of a wall into the part.
class LayerWay {
 public:
  /// What it keeps to.
  enum class Along { kNothing, kFace, kEdge };

  LayerWay() = default;
  LayerWay(const Model& model, const Vec3& from, Along along, int tag, const Vec3& direction, double stretch);

  /// The place at this distance from the walls.
  [[nodiscard]] Vec3 at(double distance) const;
  [[nodiscard]] Along along() const { return along_; }
  [[nodiscard]] int tag() const { return tag_; }

 private:
  const Model* model_ = nullptr;
  Vec3 from_ = Vec3::Zero(), direction_ = Vec3::Zero();
  Along along_ = Along::kNothing;
  int tag_ = 0;
  double stretch_ = 1.0;  ///< of the way to the distance from the walls
  double t_ = 0.0;        ///< where it starts on an edge
  double sense_ = 1.0;
  bool bent_ = false;  ///< the face is no plane
};

/// What becomes of a vertex of a wall.
struct LayerColumn {
  std::size_t wish = 0;
  LayerWay way;
  double share = 1.0;         ///< of the heights asked for; 0: it stays
  std::vector<Vec3> normals;  ///< of the triangles of walls there, inwards
};

/// What of a mesh is wall. Its vertices on walls are its first: see put_walls_first().
struct LayerWalls {
  LayerWalls(const Mesh& mesh, const Model& model, const std::vector<LayerWish>& wishes);

  std::vector<std::int32_t> wish_of_face;  ///< per face tag: its number; -1: it is no wall
  std::vector<bool> wall_edge;             ///< per edge tag: in the closure of a wall
  std::vector<std::uint32_t> triangles;    ///< of walls
  std::vector<LayerColumn> columns;        ///< of the mesh's first vertices

  [[nodiscard]] bool is_wall(std::int32_t face) const {
    return wish_of_face[static_cast<std::size_t>(face)] >= 0;
  }
  /// The wall's triangle, its normal inwards.
  [[nodiscard]] std::array<Mesh::Index, 3> inwards(const Mesh& mesh, const Model& model,
                                                   std::uint32_t triangle) const;
};

/// Gives the vertices on the wishes' faces the first numbers, in their order; others follow in theirs.
void put_walls_first(Mesh& mesh, const std::vector<LayerWish>& wishes);

}  // namespace octet
