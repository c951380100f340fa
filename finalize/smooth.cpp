// SPDX-License-Identifier: BSD-3-Clause
// Node repositioning: the constrained Laplacian, and the line search for the worst element.
#include "finalize/smooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "finalize/cavity.h"
#include "finalize/shape.h"
#include "finalize/workshop.h"
#include "mesh/quality.h"

namespace octet {
namespace {

constexpr int kLineSearches = 6;
constexpr int kSections = 4;
/// What is within this factor of the worst (as a sine) is raised together with it.
constexpr double kNearlyWorst = 1.1;
constexpr std::size_t kMaxActive = 24;

/// What only the worst is asked of.
StarMeasure above(double worst) { return {worst, std::numeric_limits<double>::infinity()}; }

/// Gradients of the roots of the merits that are nearly the worst at `place`, where the star was measured
/// last.
void active_gradients(LocalStar& star, const Vec3& place, double worst, std::vector<Vec3>& gradients) {
  gradients.clear();
  const double limit = std::max(worst * kNearlyWorst * kNearlyWorst, 1e-8), root = std::sqrt(limit);
  const double* shapes = star.bases.shapes();
  for (std::size_t i = 0; i < star.bases.size(); ++i) {
    if (shapes[i] > limit) continue;
    const auto base = star.bases[i];
    const RootMerits merits = root_merits(base[0], base[1], base[2], place);
    star.work += 2;
    for (int e = 0; e < 7 && gradients.size() < kMaxActive; ++e)
      if (merits.value[e] <= root) gradients.push_back(merits.gradient[e]);
  }
}

/// The shortest vector of the convex hull of the gradients: the direction along which the least of them rises
/// fastest. Gilbert's algorithm; a few steps are enough for a direction.
Vec3 steepest_common_ascent(const std::vector<Vec3>& gradients) {
  Vec3 x = gradients[0];
  for (int step = 0; step < 24; ++step) {
    const Vec3* least = nullptr;
    double height = std::numeric_limits<double>::infinity();
    for (const Vec3& g : gradients) {
      const double of = g.dot(x);
      if (of >= height) continue;
      height = of;
      least = &g;
    }
    const Vec3 along = *least - x;
    const double gain = -along.dot(x);
    if (gain <= 1e-3 * x.squaredNorm()) break;
    x += std::min(1.0, gain / along.squaredNorm()) * along;
  }
  return x;
}

/// Directions in which the vertex can move: along its edge, in the tangent plane of its face.
void constrain(const Workshop& shop, const LocalStar& star, const Stand& stand,
               std::vector<Vec3>& gradients) {
  if (star.on.dim == 3) return;
  Vec3 axis;
  if (star.on.dim == 1) {
    axis = shop.model.edge_derivative(star.on.tag, stand.t).normalized();
  } else {
    axis = shop.guard.planar(star.on.tag) ? star.normals[0][0] : stand.seats[0].second.normal;
  }
  for (Vec3& g : gradients) {
    const Vec3 along = axis.dot(g) * axis;
    g = star.on.dim == 1 ? along : Vec3(g - along);
  }
}

/// Whether each place of the vertex costs a projection on a curved face.
bool projects_dearly(const Workshop& shop, const LocalStar& star) {
  return star.on.dim == 2 && !shop.guard.planar(star.on.tag);
}

}  // namespace

double probe(const Workshop& shop, LocalStar& star, const Stand& from, const Vec3& wish,
             const StarMeasure& bar, Stand& stand) {
  // The foot on a curved face is near to the wish: where that is far from good enough, spare the projection.
  constexpr double kHopeless = 0.7;
  const double hopeless = kHopeless * bar.worst;
  if (projects_dearly(shop, star) && measure(star, wish, hopeless).worst <= hopeless) return -1.0;
  if (!take_stand(shop, star, from, wish, stand)) return -1.0;
  const StarMeasure there = measure(star, stand.point, bar.worst);
  if (there.worst <= bar.worst || there.distortion >= bar.distortion) return -1.0;
  return take_seats(shop, star, from, stand) && triangles_fit(shop, star, stand) ? there.worst : -1.0;
}

namespace {

/// Half the curvature vector of the face in the direction, from how the normals turn towards the rim; zero
/// where projections are cheap.
Vec3 bend_along(const Workshop& shop, const LocalStar& star, const Stand& stand, const Vec3& direction) {
  if (!projects_dearly(shop, star)) return Vec3::Zero();
  const Vec3& normal = stand.seats[0].second.normal;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < star.rims.size(); ++i) {
    const Vec3 chord = star.rims[i][0] - stand.point;
    const double length = chord.squaredNorm();
    if (length == 0.0 || star.normals[i][0].isZero()) continue;
    const double weight = chord.dot(direction) * chord.dot(direction) / length;
    sum -= weight * (star.normals[i][0] - normal).dot(chord) / length;
    weights += weight;
  }
  return weights > 0.0 ? Vec3(0.5 * sum / weights * normal) : Vec3(Vec3::Zero());
}

/// Golden section along the line between 0 and `reach`; on a curved face along its osculating parabola, so
/// that only the place found is projected. Leaves the best place in `stand` and returns its shape.
double search_line(const Workshop& shop, LocalStar& star, const Vec3& direction, double worst, double reach,
                   Stand& stand) {
  constexpr double kGolden = 0.6180339887498949;
  const Stand from = stand;
  const Vec3 bend = bend_along(shop, star, from, direction);
  const bool dear = projects_dearly(shop, star) && !shop.thorough;
  const auto wish = [&](double s) -> Vec3 { return from.point + s * direction + s * s * bend; };
  Stand trial;
  double best = worst;
  const auto at = [&](double s) {
    const double value =
        dear ? measure(star, wish(s), best).worst : probe(shop, star, from, wish(s), above(best), trial);
    if (value <= best) return false;
    best = value;
    if (!dear) stand = trial;
    return true;
  };
  double s = reach;
  int halvings = 0;
  while (!at(s) && ++halvings < 8) s *= 0.4;
  if (halvings == 8) return best;
  // The optimum is unimodal along the line [Handbook 15.6.1]: bracket it by the tried points beside the best.
  double lo = 0.0, hi = halvings == 0 ? 2.0 * reach : s / 0.4;
  double peak = s;
  for (int i = 0; i < kSections; ++i) {
    const bool right = hi - peak > peak - lo;
    const double next = right ? peak + (1.0 - kGolden) * (hi - peak) : peak - (1.0 - kGolden) * (peak - lo);
    if (at(next)) {
      (right ? lo : hi) = peak;
      peak = next;
    } else {
      (right ? hi : lo) = next;
    }
  }
  if (!dear) return best;
  for (const double share : {1.0, 0.5}) {
    const double value = probe(shop, star, from, wish(share * peak), above(worst), trial);
    if (value <= worst) continue;
    stand = trial;
    return value;
  }
  return worst;
}

/// The average of the neighbours that the vertex may move towards: all of them inside a region, those on the
/// face's triangles on a face.
Vec3 neighbour_average(const LocalStar& star) {
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  if (star.on.dim == 3) {
    for (std::size_t i = 0; i < star.bases.size(); ++i) {
      const auto base = star.bases[i];
      sum += base[0] + base[1] + base[2];
      count += 3.0;
    }
  } else {
    for (const auto& rim : star.rims) {
      sum += rim[0] + rim[1];
      count += 2.0;
    }
  }
  return sum / count;
}

}  // namespace

std::vector<MeasureChange> changes_by_move(const Workshop& shop, VertexId v, std::span<const TetId> tets,
                                           const LocalStar& star, const Vec3& place) {
  std::vector<MeasureChange> changes;
  if (std::all_of(star.faces.begin(), star.faces.end(), [&](int face) { return shop.guard.planar(face); }))
    return changes;
  const Vec3& before = shop.mesh.points[v];
  const Vec3 sixth = (place - before) / 6.0;
  for (std::size_t i = 0; i < tets.size(); ++i)
    add_change(changes, model_region(shop.mesh.region[tets[i]]), star.bases.normal(i).dot(sixth));
  for (std::size_t i = 0; i < star.triangles.size(); ++i) {
    const auto& [x, y] = star.rims[i];
    add_change(changes, model_face(star.triangles[i].face),
               triangle_area(place, x, y) - triangle_area(before, x, y));
  }
  return changes;
}

bool commit_move(Workshop& shop, VertexId v, std::span<const TetId> tets, const Stand& stand,
                 std::span<const MeasureChange> changes, std::span<const double> shapes) {
  if (!shop.guard.admits(changes)) return false;
  std::vector<double> measured;
  if (shapes.empty()) {
    measured = shapes_at(shop.mesh, v, stand.point, tets);
    shapes = measured;
  }
  const int more =
      shop.flats.awake() ? FlatGuard::count_flat(shapes) - FlatGuard::count_flat(shop.mesh, tets) : 0;
  if (!shop.flats.admits(more, shop.mesh.tets.size()) ||
      !move_vertex(shop.mesh, v, stand.point, tets, shapes))
    return false;
  shop.flats.take(more);
  shop.guard.take(changes);
  record_stand(shop, v, stand);
  shop.made.assign(tets.begin(), tets.end());
  ++shop.report.smoothed;
  return true;
}

bool may_move(const WorkMesh& mesh, VertexId v) { return mesh.on[v].dim > 0 && !mesh.held(v); }

double raise_worst(const Workshop& shop, LocalStar& star, Stand& stand, double worst, double goal) {
  std::vector<Vec3> gradients;
  double reach = 0.3 * star.length;
  for (int i = 0; i < kLineSearches && worst < goal; ++i) {
    static_cast<void>(measure(star, stand.point, 0.0));
    active_gradients(star, stand.point, worst, gradients);
    if (gradients.empty()) break;
    constrain(shop, star, stand, gradients);
    const Vec3 direction = steepest_common_ascent(gradients);
    const double slope = direction.norm();
    if (slope * star.length < 1e-3) break;
    const Vec3 before = stand.point;
    const double raised = search_line(shop, star, direction / slope, worst, reach, stand);
    if (raised <= better_than(worst)) return std::max(raised, worst);
    worst = raised;
    reach = std::clamp(2.0 * (stand.point - before).norm(), 1e-3 * star.length, 0.3 * star.length);
  }
  return worst;
}

bool smooth_vertex(Workshop& shop, VertexId v, double goal) {
  if (!may_move(shop.mesh, v)) return false;
  std::vector<TetId> tets;
  star(shop.mesh, v, tets);
  const double before = worst_quality(shop.mesh, tets);
  if (before >= goal) return false;
  LocalStar& local = shop.star;
  local_star(shop, v, tets, local);
  Stand stand = current_stand(shop, v, local);
  double worst = before;
  Stand average;
  const double laplacian = probe(shop, local, stand, neighbour_average(local), above(worst), average);
  if (laplacian > worst) {
    worst = laplacian;
    stand = average;
  }
  worst = raise_worst(shop, local, stand, worst, goal);
  shop.work += local.work;
  return worst > better_than(before) &&
         commit_move(shop, v, tets, stand, changes_by_move(shop, v, tets, local, stand.point));
}

}  // namespace octet
