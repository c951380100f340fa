// SPDX-License-Identifier: BSD-3-Clause
// A mesh of second order whose boundary follows the curved faces, and whose elements are proved not to turn
// over.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/model_ref.h"
#include "base/observer.h"
#include "base/vec.h"
#include "geom/model.h"
#include "mesh/mesh.h"

namespace octet {

/// Every element's determinant is at least this share of its largest, by its bounds (mesh/quadratic.h).
inline constexpr double kLeastScaledJacobian = 0.2;

/// A place of the curved mesh that is off the model entity it should lie on.
struct OffCad {
  ModelRef entity;
  Vec3 place = Vec3::Zero();
  double distance = 0.0;
};

struct CurveReport {
  std::size_t curved = 0;  ///< nodes that are off the middles of their edges
  std::vector<OffCad>
      held;  ///< nodes off their entity, the farthest first: elements would turn over, or the arc is too long
  std::optional<OffCad> farthest;  ///< between the nodes, too: at triangles' centres and quarters of edges
  double least_scaled_jacobian = 1.0;  ///< of all elements
};

/// Gives the mesh nodes in the middles of its edges: half-way along the curve on model edges, at the foot of
/// the chord's middle on faces, in the middle of the chord inside regions and where a model entity is
/// straight. Where an element would fall below kLeastScaledJacobian, the node that is most in the way goes
/// back towards the chord's middle, by a half each time, and all the way at last: an element without curved
/// edges is as good as it was. Requires positive tetrahedra. Linear in the elements; in parallel, the same
/// result for any number of threads. Throws Cancelled, LimitError. [Johnen, Remacle & Geuzaine 2013]
CurveReport curve_mesh(Mesh& mesh, const Model& model, Observer& observer);

}  // namespace octet
