// SPDX-License-Identifier: BSD-3-Clause
// Where the boundary of a mesh comes near to itself through the outside.
#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"
#include "octree/octree.h"

namespace octet {

/// The boundary vertices from which another sheet of the boundary is nearer, through the outside, than a
/// share of the size there; ascending. Nothing is between two such sheets that would keep their triangles
/// from crossing when either changes. None inside planar faces: their triangles stay in the plane. `around`:
/// no vertices but those within some sizes of these places are looked at; where there are none of these, or
/// thousands, all are.
[[nodiscard]] std::vector<Mesh::Index> vertices_at_gaps(const Mesh& mesh, const Model& model,
                                                        const std::function<double(const Vec3&)>& size_at,
                                                        std::span<const Vec3> around = {});

/// How far the boundary may come off the faces where two of its sheets, of which one is curved, face each
/// other through the outside, nearer than a share of the size: nothing is between them that would keep their
/// triangles from crossing, but they do not while what they are off is less than what is free. In a thin gap
/// one sheet is concave where the other is convex, so that the chords of only one come into it.
class GapRooms {
 public:
  /// Of the gaps at the boundary vertices of a mesh made of `tree`, which must outlive this.
  GapRooms(const Mesh& mesh, const Model& model, const Octree& tree);
  [[nodiscard]] bool empty() const { return room_.empty(); }
  /// At the narrowest gap in the octant there and those beside it; infinite where there is none. By many
  /// threads at once.
  [[nodiscard]] double at(const Vec3& p) const;

 private:
  const Octree& tree_;
  std::unordered_map<std::size_t, double> room_;  ///< by the octant's number
};

/// All vertices on the boundary; ascending.
[[nodiscard]] std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh);
/// Those within some sizes of the places, as `around` above.
[[nodiscard]] std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh,
                                                         const std::function<double(const Vec3&)>& size_at,
                                                         std::span<const Vec3> around);

}  // namespace octet
