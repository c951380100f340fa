// SPDX-License-Identifier: BSD-3-Clause
// Each vertex asks for the point opposite to it, once for each face it is on.
#include "app/narrow_gaps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geom/opposite.h"

namespace octet {
namespace {

/// Sheets within this share of the size may cross: chords leave a face by less than a tenth of their length.
constexpr double kNear = 0.12;
/// Least cosine of the angle between sheets at a gap: concave corners of the common angles are none.
constexpr double kGap = 0.1;
/// How far a fault reaches, in sizes there: crossing triangles have vertices within two.
constexpr double kAround = 3.0;
/// Faults at more places than this are all over the part.
constexpr std::size_t kMostPlaces = 2000;

bool is_near_another(const Model& model, const Vec3& p, int face, double near) {
  const std::array<int, 2>& region = model.face(face).region;
  if (region[0] != 0 && region[1] != 0) return false;
  const FaceFoot foot = model.face_project(face, p);
  if (!foot.converged || foot.normal.isZero()) return false;
  const std::optional<Foot> other =
      opposite_point(model, foot.point, face, foot.normal, region[1] == 0 ? 1 : -1, near);
  return other && cosine_between(foot.point, foot.normal, *other) >= kGap;
}

}  // namespace

std::vector<Mesh::Index> vertices_at_gaps(const Mesh& mesh, const Model& model,
                                          const std::function<double(const Vec3&)>& size_at,
                                          std::span<const Vec3> around) {
  const bool everywhere = around.empty() || around.size() > kMostPlaces;
  std::vector<double> reach;
  if (!everywhere)
    for (const Vec3& place : around) reach.push_back(kAround * size_at(place));
  const auto is_looked_at = [&](const Vec3& p) {
    if (everywhere) return true;
    for (std::size_t n = 0; n < around.size(); ++n)
      if ((p - around[n]).squaredNorm() <= reach[n] * reach[n]) return true;
    return false;
  };
  std::vector<std::pair<Mesh::Index, std::int32_t>> asked;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const bool planar = model.is_plane(mesh.triangle_on[i]);
    for (const Mesh::Index v : mesh.triangles[i])
      if (!planar || mesh.point_on[v].dim < 2) asked.emplace_back(v, mesh.triangle_on[i]);
  }
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  std::vector<char> near(asked.size(), 0);
  tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
    const Vec3& p = mesh.points[asked[i].first];
    if (is_looked_at(p)) near[i] = is_near_another(model, p, asked[i].second, kNear * size_at(p)) ? 1 : 0;
  });
  std::vector<Mesh::Index> found;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (near[i] != 0 && (found.empty() || found.back() != asked[i].first)) found.push_back(asked[i].first);
  return found;
}

}  // namespace octet
