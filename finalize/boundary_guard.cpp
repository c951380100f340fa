// SPDX-License-Identifier: BSD-3-Clause
// Keeps the boundary of the mesh by the exact geometry while it is changed.
#include "finalize/boundary_guard.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/check.h"
#include "base/sort_unique.h"
#include "mesh/quality.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

/// Triangles may turn by 30 degrees from the exact normals at their vertices: an element that spans the 45
/// degrees of the default curvature sizing turns by 22.5, more across its longer diagonal.
constexpr double kTurnBound = 0.134;
/// Sagitta allowed at most, as a share of the local size: 37 degrees over one element. With 0.1, which the 45
/// degrees of the default curvature sizing make, largest distances grew by an eighth (0.12 in place of 0.08
/// of an edge on a cone); with 0.065 single angles get worse (a torus: 29 in place of 32 degrees).
constexpr double kSagBound = 0.08;
/// Sagitta always allowed, as a share of the local size: 14 degrees over one element. With less, slivers
/// beside gently curved faces stay (0.01: 17 degrees in place of 21 on a plug of cylinders; 0.02: 14.8 in
/// place of 15.8 on a mount).
constexpr double kFlatSag = 0.03;
/// What was farther from the face may get farther by this factor, up to that factor of the farthest that the
/// face had at first. Where one element spans a fillet all edges across it are as far but for rounding and
/// shear, and any nearer bound refuses half of all swaps there (a plug's rounded rim: 12 degrees in place of
/// 31).
constexpr double kFitGrowth = 1.05;
constexpr double kNothing = -1.0;  // a bound of sagittae
/// Error allowed of a region's volume and of all faces' areas, as a share of it, or of the error that was
/// there: where the chords of round faces alone err by more, any smaller bound would refuse half of all moves
/// (a torus stayed at 18 degrees in place of 29). A share of 2e-3 made no better shapes, and errors of 2.6e-4
/// grew to it.
constexpr double kMeasureBound = 1e-4;
constexpr double kMeasureGrowth = 1.1;

std::uint64_t rim_key(VertexId v, int face) {
  return (static_cast<std::uint64_t>(v.index()) << 32) | static_cast<std::uint32_t>(face);
}

}  // namespace

MeasureGoals goals_of_model(const Model& model, const Measures& now) {
  const auto bound = [](double exact, double error) {
    return std::max(kMeasureBound * std::abs(exact), kMeasureGrowth * error);
  };
  MeasureGoals goals{std::vector<double>(now.volume.size(), 0.0), std::vector<double>(now.volume.size(), 0.0),
                     std::vector<double>(now.area.size(), 0.0), 0.0};
  for (std::size_t r = 1; r < now.volume.size(); ++r) {
    goals.volume[r] = model.region(static_cast<int>(r)).volume;
    goals.volume_error[r] = bound(goals.volume[r], std::abs(now.volume[r] - goals.volume[r]));
  }
  double all = 0.0, error = 0.0;
  for (std::size_t f = 1; f < now.area.size(); ++f) {
    if (now.area[f] == 0.0) continue;  // not in the mesh
    goals.area[f] = model.face(static_cast<int>(f)).area;
    all += goals.area[f];
    error += std::abs(now.area[f] - goals.area[f]);
  }
  goals.area_error = bound(all, error);
  return goals;
}

void WorstFits::add(const WorstFits& other) {
  face.resize(std::max(face.size(), other.face.size()));
  for (std::size_t f = 0; f < other.face.size(); ++f) face[f].add(other.face[f]);
  sag = std::max(sag, other.sag);
}

void add_change(std::vector<MeasureChange>& changes, ModelRef of, double change) {
  auto it = std::find_if(changes.begin(), changes.end(), [&](const MeasureChange& c) { return c.of == of; });
  if (it == changes.end()) it = changes.insert(it, MeasureChange{of, 0.0});
  it->change += change;
}

BoundaryGuard::BoundaryGuard(const Model& model, const WorkMesh& mesh, std::span<const double> volume_beyond)
    : model_(&model),
      planar_(static_cast<std::size_t>(model.count(2)) + 1, 0),
      plane_normal_(planar_.size(), Vec3::Zero()),
      on_face_(mesh.points.size()),
      on_face_known_(mesh.points.size(), 0),
      parameter_(mesh.points.size(), 0.0),
      measures_{std::vector<double>(static_cast<std::size_t>(model.count(3)) + 1, 0.0),
                std::vector<double>(planar_.size(), 0.0)} {
  at_first_.face.resize(planar_.size());
  for (int face = 1; face <= model.count(2); ++face) {
    const std::size_t i = static_cast<std::size_t>(face);
    planar_[i] = model.is_plane(face);
    if (planar_[i]) plane_normal_[i] = model.face_normal(face, Vec2::Zero());
  }
  measure_volumes(mesh, volume_beyond);
  measure_areas(mesh);
  goals_ = goals_of_model(model, measures_);
  area_error_ = sum_area_errors();
  seat_all(mesh);
  measure_faces(mesh);
  measure_pieces(mesh);
}

void BoundaryGuard::measure_volumes(const WorkMesh& mesh, std::span<const double> volume_beyond) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    measures_.volume[static_cast<std::size_t>(mesh.region[t])] +=
        signed_volume(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
  }
  for (std::size_t r = 1; r < std::min(measures_.volume.size(), volume_beyond.size()); ++r)
    measures_.volume[r] += volume_beyond[r];
}

void BoundaryGuard::measure_areas(const WorkMesh& mesh) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    for (int f = 0; f < 4; ++f) {
      const std::int32_t tag = mesh.face_on[t][f];
      if (tag == 0 || (tag < 0 && mesh.neighbours[t][f].valid())) continue;
      const auto& v = kTetFace[f];
      measures_.area[static_cast<std::size_t>(std::abs(tag))] +=
          triangle_area(mesh.point(t, v[0]), mesh.point(t, v[1]), mesh.point(t, v[2]));
    }
  }
}

double BoundaryGuard::sum_area_errors() const {
  double sum = 0.0;
  for (std::size_t face = 1; face < measures_.area.size(); ++face)
    sum += std::abs(measures_.area[face] - goals_.area[face]);
  return sum;
}

void BoundaryGuard::aim_at(const MeasureGoals& goals, const WorstFits& at_first) {
  OCTET_CHECK(goals.volume.size() == measures_.volume.size() && goals.area.size() == measures_.area.size());
  OCTET_CHECK(at_first.face.size() == at_first_.face.size());
  goals_ = goals;
  at_first_ = at_first;
  area_error_ = sum_area_errors();
}

template <class Visit>
void BoundaryGuard::for_each_curved_triangle(const WorkMesh& mesh, const Visit& visit) const {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    for (int f = 0; f < 4; ++f) {
      const int face = std::abs(mesh.face_on[t][f]);
      if (face == 0 || planar(face)) continue;
      std::array<VertexId, 3> v;
      for (int c = 0; c < 3; ++c) v[c] = mesh.tets[t][kTetFace[f][c]];
      if (mesh.face_on[t][f] < 0) std::swap(v[1], v[2]);
      visit(face, v);
    }
  }
}

void BoundaryGuard::measure_faces(const WorkMesh& mesh) {
  for_each_curved_triangle(mesh, [&](int face, const std::array<VertexId, 3>& v) {
    at_first_.face[static_cast<std::size_t>(face)].add(fit(mesh, face, v));
  });
  for (const Fit& fit : at_first_.face) at_first_.sag = std::max(at_first_.sag, kFitGrowth * fit.sag);
}

void BoundaryGuard::measure_pieces(const WorkMesh& mesh) {
  for (const auto& [key, tag] : mesh.pieces) {
    const auto [a, b] = piece_ends(key);
    at_first_.sag = std::max(at_first_.sag, kFitGrowth * piece_sag(mesh, a, b, tag));
  }
}

OnEdge BoundaryGuard::on_edge(const WorkMesh& mesh, VertexId v, int edge, bool last) const {
  if (mesh.on[v].dim == 1) return {mesh.points[v], parameter(v)};
  const ModelEdge& model_edge = model_->edge(edge);
  return {mesh.points[v], last ? model_edge.t1 : model_edge.t0};
}

double BoundaryGuard::piece_sag(int edge, const OnEdge& from, const OnEdge& to) const {
  const Vec3 chord = to.point - from.point;
  const Vec3 middle = model_->edge_point(edge, 0.5 * (from.t + to.t)) - from.point;
  return chord.cross(middle).norm() / chord.norm();
}

double BoundaryGuard::piece_sag(const WorkMesh& mesh, VertexId a, VertexId b, std::int32_t tag) const {
  const int edge = std::abs(tag);
  return piece_sag(edge, on_edge(mesh, a, edge, tag < 0), on_edge(mesh, b, edge, tag > 0));
}

Seat BoundaryGuard::project(const WorkMesh& mesh, VertexId v, int face) const {
  const FaceFoot foot = model_->face_project(face, mesh.points[v]);
  return {foot.uv, foot.normal};
}

void BoundaryGuard::seat_all(const WorkMesh& mesh) {
  std::vector<std::pair<VertexId, int>> wanted;  // on curved faces
  for_each_curved_triangle(mesh, [&](int face, const std::array<VertexId, 3>& v) {
    for (const VertexId corner : v) wanted.emplace_back(corner, face);
  });
  sort_unique(wanted);
  std::vector<Seat> seats(wanted.size());
  tbb::parallel_for(std::size_t{0}, wanted.size(),
                    [&](std::size_t i) { seats[i] = project(mesh, wanted[i].first, wanted[i].second); });
  for (std::size_t i = 0; i < wanted.size(); ++i) set_seat(mesh, wanted[i].first, wanted[i].second, seats[i]);
  tbb::parallel_for(std::size_t{0}, mesh.points.size(), [&](std::size_t i) {
    const VertexId v(i);
    if (mesh.on[v].dim == 1) parameter_[i] = model_->edge_closest(mesh.on[v].tag, mesh.points[v]).t;
  });
}

Seat BoundaryGuard::seat(const WorkMesh& mesh, VertexId v, int face) const {
  if (planar(face)) return {Vec2::Zero(), plane_normal_[static_cast<std::size_t>(face)]};
  if (mesh.on[v].dim == 2) {
    if (v.index() < on_face_known_.size() && on_face_known_[v.index()]) return on_face_[v.index()];
  } else if (const auto it = on_rim_.find(rim_key(v, face)); it != on_rim_.end()) {
    return it->second;
  }
  return project(mesh, v, face);
}

void BoundaryGuard::set_seat(const WorkMesh& mesh, VertexId v, int face, const Seat& seat) {
  if (mesh.on[v].dim != 2) {
    const auto [it, fresh] = on_rim_.try_emplace(rim_key(v, face));
    if (journal_.open) journal_.on_rim.push_back({it->first, !fresh, it->second});
    it->second = seat;
    return;
  }
  if (v.index() >= on_face_.size()) {
    on_face_.resize(v.index() + 1);
    on_face_known_.resize(v.index() + 1, 0);
  }
  if (journal_.open && on_face_known_[v.index()]) journal_.on_face.emplace_back(v, on_face_[v.index()]);
  on_face_[v.index()] = seat;
  on_face_known_[v.index()] = 1;
}

void BoundaryGuard::set_parameter(VertexId v, double t) {
  if (v.index() >= parameter_.size()) parameter_.resize(v.index() + 1, 0.0);
  if (journal_.open) journal_.parameter.emplace_back(v, parameter_[v.index()]);
  parameter_[v.index()] = t;
}

Fit BoundaryGuard::fit(const WorkMesh& mesh, int face, const std::array<VertexId, 3>& v) const {
  const std::array<Vec3, 3> points{mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]};
  if (planar(face)) {
    const Vec3& n = plane_normal_[static_cast<std::size_t>(face)];
    return fit(points, {n, n, n});
  }
  Fit result = fit(
      points, {seat(mesh, v[0], face).normal, seat(mesh, v[1], face).normal, seat(mesh, v[2], face).normal});
  result.turn_at_first = at_first_.face[static_cast<std::size_t>(face)].turn;
  result.sag_at_first = at_first_.face[static_cast<std::size_t>(face)].sag;
  return result;
}

Fit BoundaryGuard::fit(const std::array<Vec3, 3>& points, const std::array<Vec3, 3>& normals) {
  Fit result;
  const Vec3 cross = (points[1] - points[0]).cross(points[2] - points[0]);
  const double length = cross.norm();
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (normals[i].isZero()) continue;
    result.turn = std::max(result.turn, length > 0.0 ? 1.0 - cross.dot(normals[i]) / length : 2.0);
    if (normals[j].isZero()) continue;
    const Vec3 edge = points[j] - points[i];
    const double rise = (normals[j] - normals[i]).dot(edge);
    sum += rise / 8.0;
    result.sag = std::max(result.sag, std::abs(rise) / 8.0);
    result.bend = std::max(result.bend, std::abs(rise) / edge.squaredNorm());
  }
  // A quadratic that is zero at the corners and s_ij at the edges' middles is 4/9 of their sum at the
  // centroid.
  result.sag = std::max(result.sag, 4.0 / 9.0 * std::abs(sum));
  return result;
}

Fit BoundaryGuard::bound(const Fit& before, double size, double room) const {
  const double chord = std::clamp(before.bend * size * size / 8.0, kFlatSag * size, kSagBound * size);
  const auto grown = [](double from, double at_first) {
    return std::max(from, kFitGrowth * std::min(from, at_first));
  };
  const double sag = std::max(grown(before.sag, before.sag_at_first), std::min(chord, at_first_.sag));
  return {std::max(grown(before.turn, before.turn_at_first), kTurnBound),
          before.sag > room ? kNothing : std::min(sag, room)};
}

double BoundaryGuard::piece_bound(double before, double room) const {
  return before > room ? kNothing : std::min(std::max(at_first_.sag, before), room);
}

double BoundaryGuard::area_error_by(const MeasureChange& c) const {
  const double off =
      measures_.area[static_cast<std::size_t>(c.of.tag)] - goals_.area[static_cast<std::size_t>(c.of.tag)];
  return std::abs(off + c.change) - std::abs(off);
}

bool BoundaryGuard::admits(std::span<const MeasureChange> changes) const {
  double off = area_error_;
  for (const MeasureChange& c : changes) {
    if (c.of.dim == 2) {
      off += area_error_by(c);
      continue;
    }
    const std::size_t r = static_cast<std::size_t>(c.of.tag);
    const double error = std::abs(measures_.volume[r] - goals_.volume[r]);
    const double after = std::abs(measures_.volume[r] + c.change - goals_.volume[r]);
    if (after > std::max(error, goals_.volume_error[r])) return false;
  }
  return !areas_guarded_ || off <= std::max(area_error_, goals_.area_error);
}

void BoundaryGuard::take(std::span<const MeasureChange> changes) {
  for (const MeasureChange& c : changes) {
    if (c.of.dim == 2) area_error_ += area_error_by(c);
    double& value = measure(c.of);
    if (journal_.open) journal_.measure.emplace_back(c.of, value);
    value += c.change;
  }
}

void BoundaryGuard::open_journal(std::size_t vertices) {
  OCTET_CHECK(!journal_.open);
  journal_.open = true;
  journal_.vertices = vertices;
  journal_.on_face.clear();
  journal_.on_rim.clear();
  journal_.parameter.clear();
  journal_.measure.clear();
  journal_.area_error = area_error_;
}

void BoundaryGuard::take_back() {
  OCTET_CHECK(journal_.open);
  journal_.open = false;
  for (auto s = journal_.on_face.rbegin(); s != journal_.on_face.rend(); ++s)
    on_face_[s->first.index()] = s->second;
  for (std::size_t i = journal_.vertices; i < on_face_known_.size(); ++i) on_face_known_[i] = 0;
  for (auto s = journal_.on_rim.rbegin(); s != journal_.on_rim.rend(); ++s) {
    if (s->known) {
      on_rim_[s->key] = s->seat;
    } else {
      on_rim_.erase(s->key);
    }
  }
  for (auto p = journal_.parameter.rbegin(); p != journal_.parameter.rend(); ++p)
    parameter_[p->first.index()] = p->second;
  for (auto m = journal_.measure.rbegin(); m != journal_.measure.rend(); ++m) measure(m->first) = m->second;
  area_error_ = journal_.area_error;
}

}  // namespace octet
