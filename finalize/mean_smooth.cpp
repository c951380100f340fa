// SPDX-License-Identifier: BSD-3-Clause
// Node repositioning for the mean: the sum of the distortions of a star is brought to its minimum.
#include "finalize/mean_smooth.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "finalize/mean_shape.h"
#include "finalize/smooth.h"

namespace octet {
namespace {

/// Steps below this share of the mean edge are not worth a move.
constexpr double kLeastStep = 0.01;
/// Steps are no longer than this share of the mean edge.
constexpr double kLongestStep = 0.5;

/// Rounding may not stop a vertex whose worst tetrahedron stays as it is.
constexpr double kNotWorse = 0.9999;

/// The Newton step within what the entity leaves free: space, the tangent plane, the tangent.
Vec3 newton_step(const Workshop& shop, VertexId v, const Distortion& sum) {
  const ModelRef on = shop.mesh.on[v];
  const Mat3 hessian = sum.hessian.selfadjointView<Eigen::Upper>();
  if (on.dim == 3) return -hessian.inverse() * sum.gradient;
  if (on.dim == 1) {
    const Vec3 t = shop.model.edge_derivative(on.tag, shop.guard.parameter(v)).normalized();
    return -t.dot(sum.gradient) / t.dot(hessian * t) * t;
  }
  const Vec3 normal = shop.guard.seat(shop.mesh, v, on.tag).normal;
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = normal.unitOrthogonal();
  plane.col(1) = normal.cross(plane.col(0));
  const Eigen::Matrix2d flat = plane.transpose() * hessian * plane;
  return -plane * (flat.inverse() * (plane.transpose() * sum.gradient));
}

}  // namespace

MeanMove mean_move(const Workshop& shop, VertexId v, std::span<const TetId> tets, double floor,
                   LocalStar& star) {
  MeanMove move;
  if (!may_move(shop.mesh, v)) return move;
  double worst = 1.0;
  for (const TetId t : tets) worst = std::min(worst, shop.mesh.quality[t]);
  local_bases(shop.mesh, v, tets, star);
  Distortion sum;
  move.work = 3 * star.bases.size();
  if (!star.bases.differentiate(shop.mesh.points[v], sum)) return move;
  Vec3 step = newton_step(shop, v, sum);
  const double length = step.norm() / star.length;
  if (!(length > kLeastStep)) return move;
  if (length > kLongestStep) step *= kLongestStep / length;
  if (star.on.dim == 2 && shop.guard.planar(star.on.tag)) {
    leave_out_triangles(star);
  } else {
    local_triangles(shop, v, tets, star);
  }
  const Stand from = current_stand(shop, v, star);
  const StarMeasure bar{std::min(floor, kNotWorse * worst), sum.value};
  for (const double share : {1.0, 0.5, 0.25}) {
    if (probe(shop, star, from, from.point + share * step, bar, move.stand) < 0.0) continue;
    move.step = share * std::min(length, kLongestStep);
    move.changes = changes_by_move(shop, v, tets, star, move.stand.point);
    if (!move.changes.empty()) move.shapes.assign(star.bases.shapes(), star.bases.shapes() + tets.size());
    break;
  }
  move.work += star.work;
  return move;
}

}  // namespace octet
