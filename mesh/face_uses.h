// SPDX-License-Identifier: BSD-3-Clause
// Which tetrahedra have a face: the faces of a mesh's tetrahedra, sorted by their vertices.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// One tetrahedron's use of a face.
struct FaceUse {
  std::array<Mesh::Index, 3> v;  ///< ascending
  Mesh::Index tet = 0;
  bool even = false;  ///< v, by the right-hand rule, points out of the (positive) tetrahedron
};

/// Faces of tetrahedra, sorted by (v, tet); O(tets), 24 bytes a face. Requires indices in range.
class FaceUses {
 public:
  /// All faces.
  explicit FaceUses(const Mesh& mesh);
  /// Faces whose three vertices are all flagged.
  FaceUses(const Mesh& mesh, std::span<const std::uint8_t> flagged);
  /// Of these tetrahedra (ascending) alone.
  FaceUses(const Mesh& mesh, std::span<const std::uint8_t> flagged, std::span<const Mesh::Index> tets);
  [[nodiscard]] const std::vector<FaceUse>& all() const { return uses_; }
  /// The uses of the face with these vertices, in any order.
  [[nodiscard]] std::span<const FaceUse> find(const std::array<Mesh::Index, 3>& face) const;
  /// The uses that begin at position i of all() and share one face.
  [[nodiscard]] std::span<const FaceUse> group(std::size_t i) const;

 private:
  /// `for_each_tet(visit)` visits the same tetrahedra in the same order each time.
  template <class ForEachTet, class Wanted>
  void fill(const Mesh& mesh, const ForEachTet& for_each_tet, const Wanted& wanted);

  std::vector<FaceUse> uses_;
  std::vector<Mesh::Index> first_;  ///< per vertex: where the faces whose least vertex it is begin
};

/// The vertices ascending, and whether that order is an even permutation of the given one.
struct SortedFace {
  std::array<Mesh::Index, 3> v;
  bool even = true;
};
[[nodiscard]] SortedFace sorted_face(const std::array<Mesh::Index, 3>& face);

}  // namespace octet
