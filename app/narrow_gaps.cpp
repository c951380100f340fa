// SPDX-License-Identifier: BSD-3-Clause
// Each vertex asks for the point opposite to it, once for each face it is on.
#include "app/narrow_gaps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/sort_unique.h"
#include "geom/opposite.h"

namespace octet {
namespace {

/// Sheets within this share of the size may cross: chords leave a face by less than a tenth of their length.
constexpr double kNearAGap = 0.12;
/// Least cosine of the angle between sheets at a gap: concave corners of the common angles are none.
constexpr double kGap = 0.1;
/// How far a fault reaches, in sizes there: crossing triangles have vertices within two.
constexpr double kAround = 3.0;
/// Faults at more places than this are all over the part.
constexpr std::size_t kMostPlaces = 2000;
/// Sheets may come so much of a gap off their faces.
constexpr double kRoomPerGap = 0.8;
constexpr double kNoGap = std::numeric_limits<double>::infinity();

/// A boundary vertex and a face that it is on.
using VertexOnFace = std::pair<Mesh::Index, std::int32_t>;

/// All but those inside planar faces; ascending.
std::vector<VertexOnFace> vertices_on_faces(const Mesh& mesh, const Model& model) {
  std::vector<VertexOnFace> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const bool planar = model.is_plane(mesh.triangle_on[i]);
    for (const Mesh::Index v : mesh.triangles[i])
      if (!planar || mesh.point_on[v].dim < 2) all.emplace_back(v, mesh.triangle_on[i]);
  }
  sort_unique(all);
  return all;
}

/// Where a vertex stands on a face that has the outside on one side.
struct Outlook {
  FaceFoot foot;
  int side;  ///< of the outside, as opposite_point() has it
};

std::optional<Outlook> outlook(const Model& model, const Vec3& p, int face) {
  const std::array<int, 2>& region = model.face(face).region;
  if (region[0] != 0 && region[1] != 0) return std::nullopt;
  const FaceFoot foot = model.face_project(face, p);
  if (!foot.converged || foot.normal.isZero()) return std::nullopt;
  return Outlook{foot, region[1] == 0 ? 1 : -1};
}

bool is_near_another(const Model& model, const Vec3& p, int face, double near) {
  const std::optional<Outlook> out = outlook(model, p, face);
  if (!out) return false;
  const Vec3& normal = out->foot.normal;
  const std::optional<Foot> other = opposite_point(model, out->foot.point, face, normal, out->side, near);
  return other && cosine_between(out->foot.point, normal, *other) >= kGap;
}

/// The distance to a face that faces this one; infinite beyond `near`. A twentieth of what is_near_another()
/// costs, which finds edges and slanting sheets as well: vertices are held when this has not been enough.
double gap_at(const Model& model, const Vec3& p, int face, double near) {
  const std::optional<Outlook> out = outlook(model, p, face);
  if (!out) return kNoGap;
  const auto other = facing_point(model, out->foot.point, face, out->foot.normal, out->side, near);
  return other ? other->distance : kNoGap;
}

/// Balls of some sizes about the places; all of space where there are no places, or too many.
class Surroundings {
 public:
  Surroundings(const std::function<double(const Vec3&)>& size_at, std::span<const Vec3> places)
      : places_(places), everywhere_(places.empty() || places.size() > kMostPlaces) {
    if (!everywhere_)
      for (const Vec3& place : places) reach_.push_back(kAround * size_at(place));
  }
  [[nodiscard]] bool hold(const Vec3& p) const {
    for (std::size_t n = 0; n < reach_.size(); ++n)
      if ((p - places_[n]).squaredNorm() <= reach_[n] * reach_[n]) return true;
    return everywhere_;
  }

 private:
  std::span<const Vec3> places_;
  bool everywhere_;
  std::vector<double> reach_;
};

}  // namespace

std::vector<Mesh::Index> vertices_at_gaps(const Mesh& mesh, const Model& model,
                                          const std::function<double(const Vec3&)>& size_at,
                                          std::span<const Vec3> around) {
  const Surroundings surroundings(size_at, around);
  const std::vector<VertexOnFace> asked = vertices_on_faces(mesh, model);
  std::vector<char> near(asked.size(), 0);
  tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
    const Vec3& p = mesh.points[asked[i].first];
    if (surroundings.hold(p))
      near[i] = is_near_another(model, p, asked[i].second, kNearAGap * size_at(p)) ? 1 : 0;
  });
  std::vector<Mesh::Index> found;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (near[i] != 0 && (found.empty() || found.back() != asked[i].first)) found.push_back(asked[i].first);
  return found;
}

GapRooms::GapRooms(const Mesh& mesh, const Model& model, const Octree& tree) : tree_(tree) {
  const std::vector<VertexOnFace> asked = vertices_on_faces(mesh, model);
  std::vector<double> gap(asked.size());
  tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
    const Vec3& p = mesh.points[asked[i].first];
    gap[i] = gap_at(model, p, asked[i].second, kNearAGap * tree.spacing_at(p));
  });
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (gap[i] == kNoGap) continue;
    const Vec3& p = mesh.points[asked[i].first];
    const double step = tree.length_at(p);
    for (const double x : {-step, 0.0, step})
      for (const double y : {-step, 0.0, step})
        for (const double z : {-step, 0.0, step}) {
          double& room = room_.emplace(tree.find(p + Vec3(x, y, z)).index(), kNoGap).first->second;
          room = std::min(room, kRoomPerGap * gap[i]);
        }
  }
}

double GapRooms::at(const Vec3& p) const {
  const auto known = room_.find(tree_.find(p).index());
  return known == room_.end() ? kNoGap : known->second;
}

std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh) { return boundary_vertices(mesh, {}, {}); }

std::vector<Mesh::Index> boundary_vertices(const Mesh& mesh,
                                           const std::function<double(const Vec3&)>& size_at,
                                           std::span<const Vec3> around) {
  const Surroundings surroundings(size_at, around);
  std::vector<Mesh::Index> vertices;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.point_on[v].dim < 3 && surroundings.hold(mesh.points[v]))
      vertices.push_back(static_cast<Mesh::Index>(v));
  return vertices;
}

}  // namespace octet
