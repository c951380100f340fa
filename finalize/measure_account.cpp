// SPDX-License-Identifier: BSD-3-Clause
// Volumes and areas of a mesh that is worked on in blocks: each block has its share of the errors.
#include "finalize/measure_account.h"

#include <algorithm>
#include <cmath>

#include "base/vec.h"
#include "mesh/quality.h"

namespace octet {
namespace {

/// 0 of nothing.
double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

}  // namespace

Measures measures_of(const Mesh& mesh, const Model& model) {
  Measures result{std::vector<double>(static_cast<std::size_t>(model.count(3)) + 1, 0.0),
                  std::vector<double>(static_cast<std::size_t>(model.count(2)) + 1, 0.0)};
  const auto& p = mesh.points;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& t = mesh.tets[i];
    result.volume[static_cast<std::size_t>(mesh.tet_in[i])] +=
        signed_volume(p[t[0]], p[t[1]], p[t[2]], p[t[3]]);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    result.area[static_cast<std::size_t>(mesh.triangle_on[i])] += triangle_area(p[t[0]], p[t[1]], p[t[2]]);
  }
  return result;
}

MeasureAccount::MeasureAccount(const Mesh& mesh, const Model& model, std::span<const double> volume_beyond)
    : model_(model), now_(measures_of(mesh, model)) {
  for (std::size_t r = 1; r < std::min(now_.volume.size(), volume_beyond.size()); ++r)
    now_.volume[r] += volume_beyond[r];
  goals_ = goals_of_model(model, now_);
}

std::vector<double> MeasureAccount::curved_areas(const Measures& measures) const {
  std::vector<double> areas(now_.volume.size(), 0.0);
  for (std::size_t f = 1; f < measures.area.size(); ++f) {
    if (measures.area[f] == 0.0 || model_.is_plane(static_cast<int>(f))) continue;
    for (const int region : model_.face(static_cast<int>(f)).region)
      if (region > 0) areas[static_cast<std::size_t>(region)] += measures.area[f];
  }
  return areas;
}

MeasureGoals MeasureAccount::goals_of(const Measures& block) const {
  MeasureGoals goals{block.volume, std::vector<double>(block.volume.size(), 0.0), block.area, 0.0};
  const std::vector<double> curved = curved_areas(now_), curved_here = curved_areas(block);
  for (std::size_t r = 1; r < goals.volume.size(); ++r) {
    const double part = share(curved_here[r], curved[r]);
    goals.volume[r] -= part * (now_.volume[r] - goals_.volume[r]);
    goals.volume_error[r] = part * goals_.volume_error[r];
  }
  double error = 0.0, error_here = 0.0, area = 0.0, area_here = 0.0;
  for (std::size_t f = 1; f < goals.area.size(); ++f) {
    if (now_.area[f] == 0.0) continue;
    const double off = now_.area[f] - goals_.area[f];
    const double part = share(block.area[f], now_.area[f]);
    goals.area[f] -= part * off;
    area += now_.area[f];
    area_here += block.area[f];
    error += std::abs(off);
    error_here += part * std::abs(off);
  }
  goals.area_error = goals_.area_error * (error > 0.0 ? share(error_here, error) : share(area_here, area));
  return goals;
}

void MeasureAccount::add(const Measures& before, const Measures& after) {
  for (std::size_t r = 0; r < now_.volume.size(); ++r) now_.volume[r] += after.volume[r] - before.volume[r];
  for (std::size_t f = 0; f < now_.area.size(); ++f) now_.area[f] += after.area[f] - before.area[f];
}

}  // namespace octet
