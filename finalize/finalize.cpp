// SPDX-License-Identifier: BSD-3-Clause
// Mesh finalization: the shapes of a valid classified mesh made good, on the exact geometry.
#include "finalize/finalize.h"

#include <algorithm>
#include <numbers>

#include "base/check.h"
#include "base/error.h"
#include "finalize/improve.h"
#include "finalize/limits.h"
#include "finalize/shape.h"
#include "mesh/quality.h"

namespace octet {
namespace {

constexpr int kPasses = 8;
constexpr int kSweeps = 2;
/// Sweeps and the last pass work towards this angle (radians, 35 degrees), to lift the tail of the shapes.
constexpr double kPolishAngle = 0.611;

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

void count_left(Workshop& shop) {
  const WorkMesh& mesh = shop.mesh;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.quality[t] >= shape_of_angle(shop.options.target_dihedral)) continue;
    const DihedralRange r =
        dihedral_range(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
    if (r.smallest >= shop.options.target_dihedral) continue;
    ++shop.report.below_target;
    shop.report.limited_by_geometry += limited_by_geometry(shop, t);
  }
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

}  // namespace

FinalizeReport finalize(Mesh& mesh, const Model& model, const FinalizeOptions& options, Observer& observer) {
  OCTET_CHECK(static_cast<bool>(options.size_at));
  Workshop shop(to_work_mesh(mesh, options.fixed_vertices), model, options);
  const DihedralRange before = dihedrals(shop.mesh);
  const double target = shape_of_angle(options.target_dihedral), polish = shape_of_angle(kPolishAngle);
  collapse_short_edges(shop);
  for (int sweep = 0; sweep < kSweeps; ++sweep) smooth_sweep(shop, polish);
  improve_worst_first(shop, target, Effort::kPolish, observer);
  chase(shop, target, polish, observer);
  forget_failures(shop);
  improve_worst_first(shop, std::max(target, polish), Effort::kPolish, observer);
  chase(shop, target, polish, observer);
  shop.report.min_dihedral_before = before.smallest;
  const DihedralRange after = dihedrals(shop.mesh);
  if (after.smallest < before.smallest) {
    // Shapes grow by the sine, which an obtuse angle may have won by: then the mesh given is the better one.
    shop.mesh = to_work_mesh(mesh, options.fixed_vertices);
    shop.report = FinalizeReport{};
    shop.report.min_dihedral_before = shop.report.min_dihedral_after = before.smallest;
    shop.report.max_dihedral_after = before.largest;
  } else {
    shop.report.min_dihedral_after = after.smallest;
    shop.report.max_dihedral_after = after.largest;
    mesh = to_mesh(shop.mesh);
  }
  count_left(shop);
  return shop.report;
}

}  // namespace octet
