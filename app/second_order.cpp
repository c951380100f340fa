// SPDX-License-Identifier: BSD-3-Clause
// The order of a mesh's elements, raised once the mesh is made.
#include "app/second_order.h"

#include <oneapi/tbb/parallel_for.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "app/measures.h"
#include "app/stage_clock.h"
#include "finalize/curve.h"
#include "mesh/quadratic.h"

namespace octet {
namespace {

/// value(i) of all i, in parallel.
template <class Value>
std::vector<double> values_of(std::size_t n, const Value& value) {
  std::vector<double> values(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t i) { values[i] = value(i); });
  return values;
}

/// The sums per tag.
std::vector<double> sums_by(const std::vector<std::int32_t>& tags, const std::vector<double>& values,
                            int count) {
  std::vector<double> sums(static_cast<std::size_t>(count) + 1, 0.0);
  for (std::size_t i = 0; i < tags.size(); ++i) sums[static_cast<std::size_t>(tags[i])] += values[i];
  return sums;
}

}  // namespace

void raise_order(MeshResult& result, const Model& model, Observer& observer) {
  observer.stage("second order", 0.99);
  StageClock clock;
  MeshReport& report = result.report;
  const Mesh& mesh = result.mesh;
  report.curve = curve_mesh(result.mesh, model, observer);
  report.acceptance.filled = sums_by(
      mesh.tet_in, values_of(mesh.tets.size(), [&](std::size_t t) { return quadratic_volume(mesh, t); }),
      model.count(3));
  report.volume = std::accumulate(report.acceptance.filled.begin(), report.acceptance.filled.end(), 0.0);
  set_areas(sums_by(mesh.triangle_on,
                    values_of(mesh.triangles.size(), [&](std::size_t t) { return quadratic_area(mesh, t); }),
                    model.count(2)),
            model, report);
  const std::vector<Claim> claims = accept_second_order(mesh, model);
  const std::vector<Fault> broken = faults_of(claims);
  report.acceptance.claims.insert(report.acceptance.claims.end(), claims.begin(), claims.end());
  report.faults.insert(report.faults.end(), broken.begin(), broken.end());
  if (!broken.empty()) report.status = MeshStatus::kIncomplete;
  report.nodes = mesh.points.size() + mesh.mid.points.size();
  report.times.push_back(clock.lap("second order"));
}

}  // namespace octet
