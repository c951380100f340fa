// SPDX-License-Identifier: BSD-3-Clause
// Inside of the acceptance: what all claims look at, how a claim is put together, and the claims by file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "classify/acceptance.h"
#include "classify/tet_sweep.h"
#include "geom/facet_bvh.h"
#include "mesh/face_uses.h"

namespace octet {

/// A side of a mesh triangle.
struct TriangleSide {
  std::array<Mesh::Index, 2> v;  ///< ascending
  std::int32_t face = 0;
  bool forward = true;  ///< the triangle runs from v[0] to v[1]
  std::uint32_t triangle = 0;
};

/// A mesh edge on a model edge.
struct EdgePieceRef {
  std::array<Mesh::Index, 2> v;  ///< ascending
  bool forward = true;           ///< the piece runs from v[0] to v[1]
  std::uint32_t edge = 0;        ///< index into Mesh::edges
};

/// What the model says at a mesh vertex on an edge or face.
struct NodeFoot {
  double t = 0.0;              ///< on an edge
  Vec2 uv = Vec2::Zero();      ///< on a face
  double distance = 0.0;       ///< from its entity
  double curvature = 0.0;      ///< of the face there
  Vec3 normal = Vec3::Zero();  ///< of the face there
};

/// The feet of mesh vertices on edges and faces; others have the foot of one that is where it should be.
class NodeFeet {
 public:
  /// Asks foot(v) for each vertex v of `mesh` that is not inside a region, in parallel.
  template <class Foot>
  NodeFeet(const Mesh& mesh, const Foot& foot);
  [[nodiscard]] const NodeFoot& operator[](Mesh::Index v) const { return feet_[number_[v]]; }

 private:
  std::vector<std::uint32_t> number_;  ///< per vertex, 0 inside regions
  std::vector<NodeFoot> feet_;
};

/// What the model says at the centroid of a mesh triangle.
struct TriangleFoot {
  Vec3 normal = Vec3::Zero();  ///< of the face, zero where it has none
  double curvature = 0.0;      ///< largest at the centroid and at the corners inside the face
  double turn = 0.0;      ///< largest angle of the triangle's normal with the face's normals there, radians
  double distance = 0.0;  ///< of the centroid from the face
};

/// How far a node may lie from its entity: the entity's own tolerance, or what harms nobody, if that is more.
[[nodiscard]] double allowed_distance(const Model& model, ModelRef entity);

/// Everything the claims share, computed once. Requires that the claim `numbers` holds.
struct ClaimInput {
  ClaimInput(const Mesh& m, const Model& part);

  const Mesh& mesh;
  const Model& model;
  TetSweep sweep;
  FaceUses uses;  ///< all faces; where sweep.proves_pairs(), only those that may be anything but pairs
  std::vector<std::vector<std::uint32_t>> pieces_on;      ///< per model edge tag: mesh edges
  std::vector<std::vector<std::uint32_t>> triangles_on;   ///< per model face tag: mesh triangles
  std::vector<std::array<Mesh::Index, 3>> triangle_keys;  ///< each triangle's vertices ascending; sorted
  std::vector<TriangleSide> sides;                        ///< sorted by (v, face)
  std::vector<EdgePieceRef> pieces;                       ///< sorted by v
  FacetBvh surface;                                       ///< the mesh's triangles, grown by the tolerance
  NodeFeet node_foot;                                     ///< per mesh vertex
  std::vector<TriangleFoot> triangle_foot;                ///< per mesh triangle

  [[nodiscard]] const Vec3& point(Mesh::Index v) const { return mesh.points[v]; }
  [[nodiscard]] Vec3 centroid(const std::array<Mesh::Index, 3>& t) const {
    return (point(t[0]) + point(t[1]) + point(t[2])) / 3.0;
  }
  [[nodiscard]] Vec3 centroid(const std::array<Mesh::Index, 4>& t) const {
    return 0.25 * (point(t[0]) + point(t[1]) + point(t[2]) + point(t[3]));
  }
  [[nodiscard]] double volume(const std::array<Mesh::Index, 4>& t) const {
    return cross({t[0], t[1], t[2]}).dot(point(t[3]) - point(t[0])) / 6.0;
  }
  /// Twice the area vector.
  [[nodiscard]] Vec3 cross(const std::array<Mesh::Index, 3>& t) const {
    return (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
  }
  [[nodiscard]] double longest_side(const std::array<Mesh::Index, 3>& t) const;
  [[nodiscard]] double allowed_distance(ModelRef entity) const {
    return octet::allowed_distance(model, entity);
  }
};

/// Collects what is wrong; keeps the ten worst.
class ClaimBuilder {
 public:
  ClaimBuilder(std::string name, std::string statement);
  /// The larger the severity, the worse; equals keep their order.
  void fault(double severity, ModelRef entity, const Vec3& place, std::string cause, std::string advice);
  [[nodiscard]] std::size_t count() const { return count_; }
  /// A claim of the kind "there is none": `worst` is the number of faults, the limit 0.
  [[nodiscard]] Claim counted();
  /// A claim with a figure of its own; holds when there is no fault.
  [[nodiscard]] Claim measured(double worst, double limit);

 private:
  Claim claim_;
  std::vector<std::pair<double, Fault>> kept_;
  std::size_t count_ = 0;
};

/// The smallest item that `i` is joined to; halves the paths on its way.
[[nodiscard]] std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i);

/// What is told to do when the mesh itself is broken, not the part.
inline constexpr const char* kBadMesh =
    "The mesh is broken here: mesh again, and report the part if it stays.";
inline constexpr const char* kFiner = "Ask for a smaller size here.";

// claims_elements.cpp
[[nodiscard]] Claim claim_numbers(const Mesh& mesh, const Model& model);
[[nodiscard]] Claim claim_positive_volume(const ClaimInput& in);
[[nodiscard]] Claim claim_conforming(const ClaimInput& in);
[[nodiscard]] Claim claim_boundary_classified(const ClaimInput& in);
[[nodiscard]] Claim claim_interfaces_classified(const ClaimInput& in);
[[nodiscard]] Claim claim_regions_connected(const ClaimInput& in);
[[nodiscard]] Claim claim_orphan_nodes(const ClaimInput& in);
[[nodiscard]] Claim claim_duplicate_nodes(const ClaimInput& in);
// claims_topology.cpp
[[nodiscard]] Claim claim_closure(const ClaimInput& in);
[[nodiscard]] Claim claim_upward_counts(const ClaimInput& in);
[[nodiscard]] Claim claim_model_vertices(const ClaimInput& in);
// claims_edges.cpp
[[nodiscard]] Claim claim_edge_chains(const ClaimInput& in);
// claims_faces.cpp
[[nodiscard]] Claim claim_face_euler(const ClaimInput& in);
[[nodiscard]] Claim claim_face_borders(const ClaimInput& in);
[[nodiscard]] Claim claim_face_orientation(const ClaimInput& in);
// claims_measures.cpp
[[nodiscard]] Claim claim_nodes_on_entity(const ClaimInput& in);
[[nodiscard]] Claim claim_edge_length(const ClaimInput& in);
[[nodiscard]] Claim claim_face_area(const ClaimInput& in);
[[nodiscard]] Claim claim_region_volume(const ClaimInput& in);
// claims_overlap.cpp
[[nodiscard]] Claim claim_volumes_add_up(const ClaimInput& in);
[[nodiscard]] Claim claim_no_overlap(const ClaimInput& in);
// claims_second_order.cpp
[[nodiscard]] Claim claim_mid_nodes(const Mesh& mesh, const Model& model);
/// Requires that the claim above holds as to which nodes the elements have.
[[nodiscard]] Claim claim_curved_elements(const Mesh& mesh);
// claims_distance.cpp
[[nodiscard]] Claim claim_surface_distance(const ClaimInput& in);

}  // namespace octet
