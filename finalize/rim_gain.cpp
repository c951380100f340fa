// SPDX-License-Identifier: BSD-3-Clause
// What the removal of an edge with few tetrahedra can win for the mean, told before it is planned.
#include "finalize/rim_gain.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/lane_vec.h"
#include "finalize/mean_shape.h"

namespace octet {
namespace {

/// `merit` of four tetrahedra.
OCTET_LANEWISE Lanes merits(const LaneVec3& x, const LaneVec3& y, const LaneVec3& z, const LaneVec3& p) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const LaneVec3 xy = y - x, xz = z - x, yz = z - y, px = p - x, py = p - y, pz = p - z;
  const Lanes volume = dot(cross(xy, xz), px);
  const Lanes squares = dot(xy, xy) + dot(xz, xz) + dot(yz, yz) + dot(px, px) + dot(py, py) + dot(pz, pz);
  const Lanes merit = kOrdinaryDistortion - kDistortionUnit * squares * root(squares) / volume;
  return volume > 0.0 ? merit : Lanes{kNone, kNone, kNone, kNone};
}

/// The points at four places of the list.
OCTET_LANEWISE LaneVec3 pick(const Vec3* const* points, const std::array<std::size_t, kLanes>& places) {
  LaneVec3 result;
  for (std::size_t lane = 0; lane < kLanes; ++lane) result.set(lane, *points[places[lane]]);
  return result;
}

}  // namespace

// The work of the function below, on the points alone.
namespace rim_lanes {

/// Around edge ab stand `tets` tetrahedra, on a rim of `count` vertices, of which the first is repeated.
OCTET_WIDE_CLONES double most_gain(const Vec3& on_a, const Vec3& on_b, const Vec3* const* rim,
                                   std::size_t count, std::size_t tets) {
  const Vec3* const ends[] = {&on_a, &on_b};
  const LaneVec3 a = pick(ends, {0, 0, 0, 0}), b = pick(ends, {1, 1, 1, 1});
  // The triangles of the one way to fill a rim of four are the first two lanes, of the other the last two.
  const LaneVec3 x = pick(rim, {0, 0, 1, 0}), y = pick(rim, {1, 2, 2, 1}), z = pick(rim, {2, 3, 3, 3});
  const Lanes made = merits(x, y, z, b) + merits(x, z, y, a);
  const double best = count == 3 ? made[0] : std::max(made[0] + made[1], made[2] + made[3]);
  const LaneVec3 from = pick(rim, {0, 1, 2, 3}), to = pick(rim, {1, 2, 3, 4});
  const Lanes there = merits(from, to, a, b);
  double before = 0.0;
  for (std::size_t i = 0; i < tets; ++i) before += there[i];
  return best - before;
}

}  // namespace rim_lanes

double most_gain_of_removal(const WorkMesh& mesh, const EdgeRing& ring) {
  std::array<const Vec3*, kSmallRim + 1> rim;
  const std::size_t count = ring.rim.size();
  for (std::size_t i = 0; i < rim.size(); ++i) rim[i] = &mesh.points[ring.rim[i % count]];
  return rim_lanes::most_gain(mesh.points[ring.a], mesh.points[ring.b], rim.data(), count, ring.tets.size());
}

}  // namespace octet
