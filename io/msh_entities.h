// SPDX-License-Identifier: BSD-3-Clause
// What the writers need: elements and nodes grouped by model entity, and physical groups by name.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/model_ref.h"
#include "base/vec.h"
#include "mesh/mesh.h"
#include "mesh/model_outline.h"

namespace octet {

/// Nodes of a mesh: its vertices, then those in the middles of its edges.
[[nodiscard]] std::size_t node_count(const Mesh& mesh);
[[nodiscard]] const Vec3& node_point(const Mesh& mesh, std::uint32_t node);

/// Items (nodes or elements of one kind) of each model entity, ascending within it.
using ItemsOn = std::map<ModelRef, std::vector<std::uint32_t>>;
[[nodiscard]] ItemsOn group_nodes(const Mesh& mesh);
/// All elements with their entities; nodes on model vertices are elements of dimension 0.
struct ElementGroups {
  std::vector<std::uint32_t> vertex_nodes;  ///< nodes on model vertices, ascending
  std::uint64_t first_tag[4] = {};          ///< per dimension: tag of element 0
  std::uint64_t total = 0;
  ItemsOn items;  ///< indices into vertex_nodes, edges, triangles, tets
};
[[nodiscard]] ElementGroups group_elements(const Mesh& mesh);
/// Those of all the group's entities, ascending.
[[nodiscard]] std::vector<std::uint32_t> items_of(const ElementGroups& groups, const OutlineGroup& group);

/// MSH's numbers of elements by order and dimension: point, line, triangle, tetrahedron.
inline constexpr int kMshType[2][4] = {{15, 1, 2, 4}, {15, 8, 9, 11}};
[[nodiscard]] inline int msh_type(const Mesh& mesh, int dim) {
  return kMshType[mesh.mid.empty() ? 0 : 1][dim];
}

/// Where the edges of kTetEdge, in which MidNodes::of_tets has its nodes, stand in the formats' elements of
/// second order; lines and triangles are the same in all.
inline constexpr std::size_t kMshTetMid[6] = {0, 3, 1, 2, 5, 4};
inline constexpr std::size_t kVtkTetMid[6] = {0, 3, 1, 2, 4, 5};  ///< and those of Abaqus, Medit
/// The most nodes of an element.
inline constexpr std::size_t kMostNodes = 10;

/// Nodes of element `i` of a dimension, as tags from 1; returns their count. Middles of a tetrahedron's edges
/// are in the order of `tet_mid`.
int element_nodes(const Mesh& mesh, const ElementGroups& groups, int dim, std::uint32_t i,
                  std::uint64_t nodes[kMostNodes], const std::size_t (&tet_mid)[6] = kMshTetMid);

/// Nodes of these elements of a dimension, each once, as tags from 1, ascending.
[[nodiscard]] std::vector<std::uint64_t> nodes_of_elements(const Mesh& mesh, const ElementGroups& groups,
                                                           int dim, const std::vector<std::uint32_t>& items);

/// What formats that number node sets of faces, edges and vertices alike add to the tags of vertices, edges
/// and faces: a face keeps its tag, those of edges go on from the largest, those of vertices from there. The
/// last number is before those of sets of several entities.
[[nodiscard]] std::array<int, 4> before_node_sets(const ElementGroups& groups);

/// Names of the physical groups by entity: every entity that has elements or a name is one, by its name or
/// as `Face12`, for some readers skip what is in no group, and some take files in which all is or nothing.
/// Names are unique, at most 127 bytes, free of quotes and control characters. The number of a group is its
/// entity's tag.
[[nodiscard]] std::map<ModelRef, std::string> physical_names(const ModelOutline& outline,
                                                             const ElementGroups& groups);

/// What stands beside these as physical groups of several entities: the outline's groups, and the entities of
/// a dimension that have one name; by names that no other has. Their numbers go on from the dimension's
/// largest tag.
struct PhysicalSet : OutlineGroup {
  int number = 0;
};
[[nodiscard]] std::vector<PhysicalSet> physical_sets(const ModelOutline& outline, const ElementGroups& groups,
                                                     const std::map<ModelRef, std::string>& names);

/// The $PhysicalNames section, empty when there is none.
[[nodiscard]] std::string physical_names_section(const std::map<ModelRef, std::string>& names,
                                                 const std::vector<PhysicalSet>& sets = {});

/// The outline's entities and those that only the mesh names; boxes the CAD does not give are the mesh's.
/// Bounding entities that do not exist are dropped.
[[nodiscard]] ModelOutline complete_outline(const ModelOutline& outline, const Mesh& mesh);

/// The motion of a link, row by row, in the file's unit.
[[nodiscard]] std::array<double, 16> scaled_motion(const PeriodicLink& link, double scale);

/// A name without quotes and control characters.
[[nodiscard]] std::string printable(std::string name);

/// A node's entity: those on none count as inside region 0.
[[nodiscard]] ModelRef node_entity(const Mesh& mesh, std::uint32_t node);

}  // namespace octet
