// SPDX-License-Identifier: BSD-3-Clause
// Sizes given on the elements of a mesh or at points, as a field over space.
#pragma once

#include <array>
#include <vector>

#include "base/size_field.h"
#include "mesh/mesh.h"

namespace octet {

/// Sizes at places: those of tetrahedra (the whole element has its size), of the vertices of tetrahedra, or
/// of points alone.
struct Background {
  std::vector<Vec3> points;
  std::vector<std::array<Mesh::Index, 4>> tets;  ///< may be empty
  std::vector<double> tet_size;                  ///< per tetrahedron; or empty
  std::vector<double> point_size;                ///< per point; or empty
};

/// Places and sizes multiplied: from one unit of length to another.
[[nodiscard]] Background scaled(Background field, double factor);

/// The field, read by boxes: of the elements that meet a box the smallest size; of points the smallest in the
/// box, or that of the nearest one where the box holds none. Vertex sizes are not interpolated: an element
/// has the smallest size of its vertices. Outside, farther from all elements (or from the box around all
/// points) than the box's own diagonal, nothing is wanted. Sizes that are not positive and finite are left
/// out.
///
/// InputError where tet_size or point_size do not fit, or a tetrahedron names a point that is not there.
/// Cost: O(log n) a box where sizes vary slowly; 60 bytes an element.
[[nodiscard]] SizeField background_field(const Background& background);

}  // namespace octet
