// SPDX-License-Identifier: BSD-3-Clause
// Small valid classified meshes, made for the tests.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet::testing {

/// Numbers in [0, 1), the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  double roll();

 private:
  std::uint64_t state_;
};

/// n^3 cells over [0,1]^3, six tetrahedra each (along one diagonal), mapped by `place`. Not classified.
[[nodiscard]] Mesh lattice(int nx, int ny, int nz, const std::function<Vec3(const Vec3&)>& place);

/// Outward faces with one tetrahedron, and one side of faces between two regions.
[[nodiscard]] std::vector<std::array<Mesh::Index, 3>> walls(const Mesh& mesh);

/// Classifies the boundary of the tetrahedra on the model by nearness: vertices, triangles, edge pieces.
/// Every tetrahedron is in region 1 unless tet_in says otherwise.
void classify_by_nearness(Mesh& mesh, const Model& model);

/// Moves all vertices but the model's at random on their own entities, by at most `amount`, where all
/// tetrahedra stay positive.
void jitter(Mesh& mesh, const Model& model, double amount, Dice& dice);

/// Glues noise-flat tetrahedra onto pairs of coplanar triangles of one planar face, where the exact sign
/// allows; returns how many. The surface's diagonal flips.
int glue_flat_tets(Mesh& mesh, const Model& model);

/// Volume of all tetrahedra.
[[nodiscard]] double total_volume(const Mesh& mesh);

/// Euler characteristic of the mesh of each model face, by tag.
[[nodiscard]] std::vector<int> face_euler(const Mesh& mesh, int faces);

/// Largest distance of a vertex from the entity it is classified on.
[[nodiscard]] double largest_misplacement(const Mesh& mesh, const Model& model);

}  // namespace octet::testing
