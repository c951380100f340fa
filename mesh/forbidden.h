// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements of the size asked for.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace octet {

/// A wedge between model faces, or a corner between model edges, that closes at less than this (radians, 35
/// degrees) has no room for good elements, whatever their size.
inline constexpr double kSharpAngle = 0.611;
/// Share of the local size below which two model edges or vertices leave no room for an element.
inline constexpr double kNarrow = 0.35;

/// Per vertex whether it lies on what forbids good elements, told from the classified mesh alone:
///  1. a mesh edge on a model edge where the angle within a region, from wall to wall, is below kSharpAngle;
///  2. a model vertex where two mesh edges on model edges meet at less than that;
///  3. a wall under one element: straight in from a boundary triangle another model face, or another part of
///     the same, is met within the local size, facing the first to within kSharpAngle;
///  4. vertices of two model edges or vertices that an edge joins, or a vertex of one and a piece of the
///  other
///     that a triangle joins, nearer to each other than kNarrow of the size: a face or a step narrower than
///     that.
/// An element is limited by the geometry when it has such a vertex. `size` is the local size per vertex,
/// model units. Requires the invariants of Mesh.
[[nodiscard]] std::vector<char> forbidding_vertices(const Mesh& mesh, std::span<const double> size);

/// Whether the element has one of the flagged vertices.
[[nodiscard]] bool touches(const std::array<Mesh::Index, 4>& tet, const std::vector<char>& flagged);

}  // namespace octet
