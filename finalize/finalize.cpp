// SPDX-License-Identifier: BSD-3-Clause
// Mesh finalization: the shapes of a valid classified mesh made good, on the exact geometry.
#include "finalize/finalize.h"

#include <algorithm>
#include <numbers>

#include "base/check.h"
#include "base/error.h"
#include "finalize/improve.h"
#include "finalize/relax.h"
#include "finalize/shape.h"
#include "mesh/forbidden.h"
#include "mesh/quality.h"

namespace octet {
namespace {

constexpr int kPasses = 8;
/// Sweeps of smoothing after each round of swaps for the mean.
constexpr int kSweeps = 2;
/// Nothing is made worse than this for the mean, and single tetrahedra below it are worked on (radians, 35
/// degrees): the tail of the shapes.
constexpr double kPolishAngle = 0.611;
/// The worst are chased with every operator up to here (radians, 32 degrees). Measured on three parts at 100
/// k: chasing to 20 left 18 to 25 degrees, to 28 left 28, to 32 left 30; to 35 costs four times as much and
/// gains nothing.
constexpr double kChaseAngle = 0.559;

DihedralRange dihedrals(const WorkMesh& mesh) {
  DihedralRange range{std::numbers::pi, 0.0};
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    const DihedralRange r =
        dihedral_range(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
    range.smallest = std::min(range.smallest, r.smallest);
    range.largest = std::max(range.largest, r.largest);
  }
  return range;
}

/// Counts what is below the target, and how much of it the part forbids.
void count_left(const Mesh& mesh, const FinalizeOptions& options, FinalizeReport& report) {
  std::vector<std::size_t> left;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    const DihedralRange r =
        dihedral_range(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
    if (r.smallest < options.target_dihedral) left.push_back(t);
  }
  report.below_target = left.size();
  if (left.empty()) return;
  std::vector<double> size;
  for (const Vec3& p : mesh.points) size.push_back(options.size_at(p));
  const std::vector<char> forbidding = forbidding_vertices(mesh, size);
  report.limited_by_geometry = static_cast<std::size_t>(std::count_if(
      left.begin(), left.end(), [&](std::size_t t) { return touches(mesh.tets[t], forbidding); }));
}

/// Works on what is below the target until nothing gives.
void chase(Workshop& shop, double target, double polish, Observer& observer) {
  forget_failures(shop);
  shop.thorough = true;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::size_t done = improve_worst_first(shop, target, Effort::kFull, observer);
    if (pass > 0 && done == 0) break;
    relax_around(shop, target, polish);
  }
  shop.thorough = false;
}

/// Swaps, then moves vertices, for the mean.
void raise_mean(Workshop& shop, double floor, Observer& observer) {
  if (observer.cancelled()) throw Cancelled();
  swap_for_mean(shop, floor);
  relax_for_mean(shop, floor, kSweeps);
  forget_failures(shop);
}

}  // namespace

FinalizeReport finalize(Mesh& mesh, const Model& model, const FinalizeOptions& options, Observer& observer) {
  OCTET_CHECK(static_cast<bool>(options.size_at));
  Workshop shop(to_work_mesh(mesh, options.fixed_vertices), model, options);
  const DihedralRange before = dihedrals(shop.mesh);
  const double polish = shape_of_angle(kPolishAngle);
  collapse_short_edges(shop);
  if (options.worst_only) {
    const double target = shape_of_angle(options.target_dihedral);
    improve_worst_first(shop, target, Effort::kPolish, observer);
    chase(shop, target, polish, observer);
  } else {
    const double chased = shape_of_angle(std::max(kChaseAngle, options.target_dihedral));
    raise_mean(shop, polish, observer);
    collapse_for_mean(shop, polish);
    raise_mean(shop, polish, observer);
    improve_worst_first(shop, std::max(polish, chased), Effort::kPolish, observer);
    chase(shop, chased, polish, observer);
    raise_mean(shop, polish, observer);
  }
  shop.report.min_dihedral_before = before.smallest;
  const DihedralRange after = dihedrals(shop.mesh);
  if (after.smallest < before.smallest) {
    // Shapes grow by the sine, which an obtuse angle may have won by: then the mesh given is the better one.
    shop.report = FinalizeReport{};
    shop.report.min_dihedral_before = shop.report.min_dihedral_after = before.smallest;
    shop.report.max_dihedral_after = before.largest;
  } else {
    shop.report.min_dihedral_after = after.smallest;
    shop.report.max_dihedral_after = after.largest;
    mesh = to_mesh(shop.mesh);
  }
  count_left(mesh, options, shop.report);
  return shop.report;
}

}  // namespace octet
