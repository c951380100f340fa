// SPDX-License-Identifier: BSD-3-Clause
// Elements of second order: their measures, and a proof that they are not turned over anywhere.
#pragma once

#include <array>

#include "base/vec.h"
#include "mesh/mesh.h"

namespace octet {

/// The four corners, then the nodes in the middles of the edges in the order of kTetEdge.
using QuadraticTet = std::array<Vec3, 10>;

/// The nodes of tetrahedron t of a mesh of second order.
[[nodiscard]] QuadraticTet quadratic_tet(const Mesh& mesh, std::size_t t);

/// Whether all nodes of tetrahedron t are in the very middles of its edges, so that it is as it was without.
[[nodiscard]] bool has_straight_edges(const Mesh& mesh, std::size_t t);

/// The determinant of the Jacobian of the map from the reference tetrahedron, a cubic polynomial, by its
/// Bernstein coefficients: it lies between the least and the largest of them, and is the first four at the
/// corners. All of them are six times the volume where the edges are straight and the nodes in their middles.
/// [Johnen, Remacle & Geuzaine 2013]
struct JacobianForm {
  std::array<double, 20> coefficient{};

  [[nodiscard]] double least() const;    ///< no less than this anywhere
  [[nodiscard]] double largest() const;  ///< no more than this anywhere
  [[nodiscard]] double volume() const;   ///< exact
};
[[nodiscard]] JacobianForm jacobian_form(const QuadraticTet& tet);

/// A lower bound of the determinant, no more than `accuracy` below its least value: the form is halved until
/// it tells, or is a sixteenth as long in all directions. Requires accuracy > 0.
[[nodiscard]] double least_jacobian(const JacobianForm& form, double accuracy);

/// The bound over the largest coefficient: 1 where straight, 0 or less where the element may be turned over.
[[nodiscard]] double scaled_jacobian(const JacobianForm& form);

/// Volume of tetrahedron t of a mesh of second order.
[[nodiscard]] double quadratic_volume(const Mesh& mesh, std::size_t t);

/// Area of triangle t of a mesh of second order, by a quadrature of degree five.
[[nodiscard]] double quadratic_area(const Mesh& mesh, std::size_t t);

}  // namespace octet
