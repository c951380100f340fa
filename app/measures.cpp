// SPDX-License-Identifier: BSD-3-Clause
// What the report tells of a mesh beside its claims.
#include "app/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.h"

namespace octet {

void measure_mesh(const Mesh& mesh, const Model& model, MeshReport& report) {
  report.quality = quality_summary(mesh);
  report.nodes = mesh.points.size();
  report.tets = mesh.tets.size();
  report.triangles = mesh.triangles.size();
  report.volume = report.quality.volume;
  std::vector<double> area_on(static_cast<std::size_t>(model.count(2)) + 1, 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    area_on[static_cast<std::size_t>(mesh.triangle_on[i])] +=
        triangle_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  }
  for (int r = 1; r <= model.count(3); ++r) report.cad_volume += model.region(r).volume;
  set_areas(area_on, model, report);
}

void set_areas(const std::vector<double>& area_on, const Model& model, MeshReport& report) {
  report.area = std::accumulate(area_on.begin(), area_on.end(), 0.0);
  report.cad_area = report.area_off = 0.0;
  for (int f = 1; f <= model.count(2); ++f) {
    if (model.is_outside(f)) continue;
    report.cad_area += model.face(f).area;
    report.area_off += std::abs(area_on[static_cast<std::size_t>(f)] - model.face(f).area);
  }
}

std::optional<Farthest> farthest_from_cad(const MeshReport& report) {
  if (!report.curve) return report.acceptance.farthest();
  const std::optional<OffCad>& off = report.curve->farthest;
  return off ? std::optional(Farthest{off->entity, off->place, off->distance}) : std::nullopt;
}

std::size_t fault_count(const MeshReport& report) {
  std::size_t count = report.faults.size();
  for (const Claim& claim : report.acceptance.claims) count += claim.places.size() - claim.faults.size();
  return count;
}

std::vector<Vec3> places_at_fault(const Acceptance& acceptance, const OwnFrame& frame) {
  std::vector<Vec3> places;
  for (const Claim& claim : acceptance.claims)
    for (const Vec3& place : claim.places) places.push_back(frame.to_model(place));
  std::sort(places.begin(), places.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::string describe(const FinalizeReport& report) {
  return fmt::format("finalization: smallest dihedral {:.2f} -> {:.2f} degrees, {} below target",
                     report.min_dihedral_before * kInDegrees, report.min_dihedral_after * kInDegrees,
                     report.below_target);
}

}  // namespace octet
