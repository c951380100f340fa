// SPDX-License-Identifier: BSD-3-Clause
// Finalization of a classified mesh from anywhere.
#include "app/improve_mesh.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <numeric>

#include "app/apart.h"
#include "app/measures.h"
#include "app/second_order.h"
#include "app/stage_clock.h"
#include "app/usable_threads.h"
#include "finalize/finalize.h"
#include "mesh/local_size.h"
#include "mesh/size_lookup.h"
#include "mesh/soundness.h"

namespace octet {
namespace {

/// The claims that finalization builds on; others may be broken, and are told at the end.
void require_claims(const Acceptance& acceptance, const Model& model) {
  for (const Claim& claim : acceptance.claims) {
    if (claim.holds) continue;
    std::string where;
    if (!claim.faults.empty()) {
      const Fault& fault = claim.faults.front();
      where = fmt::format(": {} at ({:.6g}, {:.6g}, {:.6g})", model.describe(fault.entity), fault.place.x(),
                          fault.place.y(), fault.place.z());
    }
    throw InputError(fmt::format(
        "the mesh is no right mesh of the part, claim {} ({}) does not hold{}; octet check tells all",
        claim.name, claim.statement, where));
  }
}

MeshResult improve(Mesh mesh, const Model& model, const ImproveOptions& options, Observer& observer) {
  const bool second_order = options.order == 2 || (options.order == 0 && !mesh.mid.empty());
  mesh.mid = {};  // made anew, where it is wanted, on the better mesh
  MeshResult result;
  StageClock clock;
  observer.stage("acceptance of the input", 0.0);
  if (const std::string fault = check_mesh_soundness(mesh); !fault.empty())
    throw InputError("the mesh is no sound classified mesh: " + fault);
  require_claims(accept_as_meshed(mesh, model), model);
  release_seams(mesh, model);
  result.report.times.push_back(clock.lap("acceptance of the input"));

  observer.stage("finalization", 0.3);
  FinalizeOptions finalize_options;
  const std::vector<double> sizes = vertex_sizes(mesh, element_edges(mesh));
  const SizeLookup lookup(mesh.points, sizes);
  finalize_options.size_at = [&](const Vec3& p) { return options.size > 0.0 ? options.size : lookup.at(p); };
  const FinalizeReport report = finalize(mesh, model, finalize_options, observer);
  observer.note(describe(report));
  result.report.times.push_back(clock.lap("finalization"));

  observer.stage("acceptance", 0.8);
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
  result.report.size = options.size > 0.0 ? options.size : mean;
  result.report.acceptance = accept_as_meshed(mesh, model);
  result.report.faults = faults_of_part(model);
  const std::vector<Fault> broken = faults_of(result.report.acceptance.claims);
  result.report.faults.insert(result.report.faults.end(), broken.begin(), broken.end());
  if (result.report.acceptance.holds() && result.report.faults.empty())
    result.report.status = MeshStatus::kComplete;
  measure_mesh(mesh, model, result.report);
  result.report.times.push_back(clock.lap("acceptance"));
  result.mesh = std::move(mesh);
  if (second_order) raise_order(result, model, observer);
  return result;
}

}  // namespace

void release_seams(Mesh& mesh, const Model& model) {
  const auto real = [&](std::int32_t edge) { return model.edge(edge).use == EdgeUse::kReal; };
  for (ModelRef& on : mesh.point_on) {
    if (on.dim == 1 && !real(on.tag)) on = model_face(model.edge(on.tag).faces.front());
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    if (!real(mesh.edge_on[i])) continue;
    mesh.edges[kept] = mesh.edges[i];
    mesh.edge_on[kept++] = mesh.edge_on[i];
  }
  mesh.edges.resize(kept);
  mesh.edge_on.resize(kept);
}

MeshResult improve_mesh(Mesh mesh, const Model& model, const ImproveOptions& options, Observer& observer) {
  if (!std::isfinite(options.size) || options.size < 0.0)
    throw InputError(fmt::format("the size must be a positive number, not {}", options.size));
  if (options.order < 0 || options.order > 2)
    throw InputError(fmt::format("the order of elements must be 1 or 2, not {}", options.order));
  MeshResult result;
  tbb::task_arena arena(usable_threads(options.threads));
  arena.execute([&] { result = improve(std::move(mesh), model, options, observer); });
  return result;
}

}  // namespace octet
