// SPDX-License-Identifier: BSD-3-Clause
// The classified mesh: the product that classify makes, finalize improves and io writes.
#pragma once

#include <array>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"

namespace octet {

/// Nodes in the middles of a mesh's edges, which make its elements of second order; without any the mesh is
/// of first order.
///
/// Invariants: one node for every edge of the elements and no other, in the order of their ends; elements
/// that share an edge share its node; a node is on the model entity of least dimension that holds the edge.
struct MidNodes {
  using Index = std::uint32_t;

  std::vector<Vec3> points;                        ///< model units
  std::vector<ModelRef> on;                        ///< entity that holds the edge
  std::vector<std::array<Index, 2>> between;       ///< the edge's vertices, ascending
  std::vector<Index> of_edges;                     ///< per mesh edge on a model edge
  std::vector<std::array<Index, 3>> of_triangles;  ///< of the sides from vertex 0, from 1 and from 2
  std::vector<std::array<Index, 6>> of_tets;       ///< in the order of kTetEdge (mesh/tet_mesh.h)

  [[nodiscard]] bool empty() const { return points.empty(); }
};

/// Vertices, edges, triangles and tetrahedra, each with the model entity it lies on.
///
/// Invariants (tested by `check_mesh_soundness` in mesh/soundness.h):
///  1. all indices are in range; no vertex is unused; no element is given twice.
///  2. every tetrahedron has positive volume (orient3d > 0).
///  3. a face of the tetrahedra is shared by at most two; every face that has one tetrahedron, or two of
///     different regions, is a triangle of the mesh, once.
///  4. every triangle is oriented as its model face: its normal by the right-hand rule points as the face's.
///  5. edges hold only what is classified on model edges; triangles only what is classified on model faces.
struct Mesh {
  using Index = std::uint32_t;

  std::vector<Vec3> points;                     ///< model units (millimetre)
  std::vector<ModelRef> point_on;               ///< entity of least dimension that holds the vertex
  std::vector<std::array<Index, 2>> edges;      ///< mesh edges on model edges, in the edge's direction
  std::vector<std::int32_t> edge_on;            ///< model edge tag
  std::vector<std::array<Index, 3>> triangles;  ///< mesh faces on model faces
  std::vector<std::int32_t> triangle_on;        ///< model face tag
  std::vector<std::array<Index, 4>> tets;       ///< positive
  std::vector<std::int32_t> tet_in;             ///< model region tag
  MidNodes mid;                                 ///< of a mesh of second order; else empty
};

}  // namespace octet
