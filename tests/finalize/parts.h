// SPDX-License-Identifier: BSD-3-Clause
// Analytic parts with lattice meshes of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "finalize/workshop.h"
#include "geom/analytic.h"
#include "tests/finalize/builders.h"

namespace octet::testing {

struct Part {
  Model model;
  Mesh mesh;
};

/// A box with n cells along each side; `turned` rotates it so that its coordinates are not exact.
[[nodiscard]] Part box_part(const Vec3& size, int nx, int ny, int nz, bool turned = false);
/// Two boxes of 1 x 1 x 1 that share a face, n cells along each side of each.
[[nodiscard]] Part two_boxes_part(int n);
/// The cube's lattice blown up to the unit ball.
[[nodiscard]] Part ball_part(int n);
/// One layer of cells between the spheres of radius 1 and `inner`.
[[nodiscard]] Part shell_part(int n, double inner);
/// The cube's lattice drawn to a cylinder of radius 1 and height 2.
[[nodiscard]] Part cylinder_part(int n);
/// The part with the vertices of its mesh moved at random (see `jitter`).
[[nodiscard]] Part jittered(Part part, double amount, std::uint64_t seed);
/// n tetrahedra around the axis of the unit ball, n at least 3: two poles and a rim on the equator.
[[nodiscard]] Part spindle_part(int n);

/// Cells about the z axis, each by the signs of x and y.
using Cells = std::vector<std::array<double, 2>>;
/// 2 x 2 x 3 cells about the edge x = y = 0 of a box, without some in the middle layer: without two of them
/// the rest touches itself along that edge from z = 1 to 2, and is one above and below. Only what meets this
/// piece is classified.
[[nodiscard]] Part cells_about_edge(const Cells& without);

/// Options with a constant local size.
[[nodiscard]] FinalizeOptions options_of_size(double size);

/// Number of the vertex nearest to p.
[[nodiscard]] VertexId vertex_near(const WorkMesh& mesh, const Vec3& p);

/// "" when the mesh is sound, its faces have the Euler characteristics `euler`, and its vertices lie on their
/// entities; else what is wrong.
[[nodiscard]] std::string faults_of(const Mesh& mesh, const Model& model, const std::vector<int>& euler);

}  // namespace octet::testing
