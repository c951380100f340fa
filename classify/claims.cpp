// SPDX-License-Identifier: BSD-3-Clause
// The costly questions to the model (feet of nodes and centroids) are asked once, here.
#include "classify/claims.h"

#include <oneapi/tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "base/blocks.h"
#include "base/bucket_sort.h"

namespace octet {
namespace {

constexpr std::size_t kFaultsKept = 10;
// A node that is off its entity by less than this share of the diagonal harms nobody.
constexpr double kNodeShare = 1e-7;
/// Feet a task.
constexpr std::size_t kFeet = 128;

NodeFoot foot_of_node(const ClaimInput& in, Mesh::Index v) {
  const ModelRef ref = in.mesh.point_on[v];
  const Vec3& p = in.point(v);
  NodeFoot foot;
  if (ref.dim == 0) foot.distance = (in.model.vertex(ref.tag).point - p).norm();
  if (ref.dim == 1 && in.model.edge(ref.tag).use != EdgeUse::kDegenerate) {
    const EdgeFoot near = in.model.edge_closest(ref.tag, p);
    foot.t = near.t;
    foot.distance = near.distance;
  }
  if (ref.dim == 2) {
    const FaceFoot near = in.model.face_project(ref.tag, p);
    foot.uv = near.uv;
    foot.distance = (near.point - p).norm();
    foot.curvature = in.model.face_curvature(ref.tag, near.uv);
    foot.normal = near.normal;
    // Outside the trim in (u, v) may still be on the face within tolerance: ask for the distance itself.
    if (!near.converged || in.model.face_side(ref.tag, near.uv) == TrimSide::kOut)
      foot.distance = in.model.face_closest(ref.tag, p).distance;
  }
  return foot;
}

/// 0 when one of them is none (a pole, an apex).
double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

TriangleFoot foot_of_triangle(const ClaimInput& in, std::uint32_t t) {
  const std::int32_t face = in.mesh.triangle_on[t];
  const auto& triangle = in.mesh.triangles[t];
  const Vec3 centre = in.centroid(triangle);
  TriangleFoot result;
  const NodeFoot* seed = nullptr;
  for (const Mesh::Index v : triangle)
    if (in.mesh.point_on[v] == model_face(face)) {
      result.curvature = std::max(result.curvature, in.node_foot[v].curvature);
      if (seed == nullptr) seed = &in.node_foot[v];
    }
  FaceFoot foot;
  if (seed != nullptr) foot = in.model.face_project(face, centre, seed->uv);
  if (!foot.converged) foot = in.model.face_project(face, centre);
  const Vec3 own = in.cross(triangle);
  // Where the face bends sharply the way down from a corner may lead to its other side: the nearest counts.
  if (seed != nullptr && own.dot(foot.normal) < 0.0) {
    const FaceFoot other = in.model.face_project(face, centre);
    if (other.converged && (other.point - centre).norm() < (foot.point - centre).norm()) foot = other;
  }
  // Beyond its trim a surface may fold back and offer a foot that is not the face's.
  if (own.dot(foot.normal) < 0.0 && in.model.face_side(face, foot.uv) == TrimSide::kOut) {
    const Foot trimmed = in.model.face_closest(face, centre);
    foot.point = trimmed.point;
    foot.uv = trimmed.uv;
    foot.normal = trimmed.normal;
  }
  result.normal = foot.normal;
  result.distance = (foot.point - centre).norm();
  result.turn = angle_between(own, foot.normal);
  for (const Mesh::Index v : triangle)
    if (in.mesh.point_on[v] == model_face(face))
      result.turn = std::max(result.turn, angle_between(own, in.node_foot[v].normal));
  result.curvature = std::max(result.curvature, in.model.face_curvature(face, foot.uv));
  return result;
}

std::vector<std::array<Mesh::Index, 3>> sorted_keys(const Mesh& mesh) {
  std::vector<std::array<Mesh::Index, 3>> keys;
  keys.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) keys.push_back(sorted_face(t).v);
  bucket_sort(
      keys, mesh.points.size(), [](const auto& key) { return key[0]; }, std::less<>());
  return keys;
}

std::vector<TriangleSide> sorted_sides(const Mesh& mesh) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Mesh::Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, mesh.triangle_on[t], a < b, t});
    }
  bucket_sort(
      sides, mesh.points.size(), [](const TriangleSide& side) { return side.v[0]; },
      [](const TriangleSide& a, const TriangleSide& b) {
        return std::tie(a.v, a.face, a.triangle) < std::tie(b.v, b.face, b.triangle);
      });
  return sides;
}

/// The triangles are exact, but what stands for places within the tolerance is found as well.
FacetBvh surface_tree(const Mesh& mesh, const Model& model) {
  Facets surface;
  surface.nodes = mesh.points;
  for (const auto& t : mesh.triangles) surface.triangles.push_back({t[0], t[1], t[2]});
  surface.face = mesh.triangle_on;
  return {surface, std::vector<double>(surface.triangles.size(), model.tolerance()), model.count(2),
          FacetBvh::Building::kManyThreads};
}

std::vector<EdgePieceRef> sorted_pieces(const Mesh& mesh) {
  std::vector<EdgePieceRef> pieces;
  pieces.reserve(mesh.edges.size());
  for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
    const auto [a, b] = mesh.edges[e];
    pieces.push_back({{std::min(a, b), std::max(a, b)}, a < b, e});
  }
  std::sort(pieces.begin(), pieces.end(), [](const EdgePieceRef& a, const EdgePieceRef& b) {
    return std::tie(a.v, a.edge) < std::tie(b.v, b.edge);
  });
  return pieces;
}

std::vector<std::vector<std::uint32_t>> by_tag(const std::vector<std::int32_t>& on, int tags) {
  std::vector<std::vector<std::uint32_t>> lists(static_cast<std::size_t>(tags) + 1);
  for (std::uint32_t i = 0; i < on.size(); ++i) lists[on[i]].push_back(i);
  return lists;
}

}  // namespace

template <class Foot>
NodeFeet::NodeFeet(const Mesh& mesh, const Foot& foot) : number_(mesh.points.size(), 0), feet_(1) {
  std::vector<Mesh::Index> asked;
  for (Mesh::Index v = 0; v < mesh.points.size(); ++v) {
    if (mesh.point_on[v].dim == 3) continue;
    asked.push_back(v);
    number_[v] = static_cast<std::uint32_t>(asked.size());
  }
  feet_.resize(asked.size() + 1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, asked.size(), kFeet), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) feet_[i + 1] = foot(asked[i]);
  });
}

ClaimInput::ClaimInput(const Mesh& m, const Model& part)
    : mesh(m),
      model(part),
      sweep(sweep_tets(m, part)),
      uses(sweep.proves_pairs() ? FaceUses(m, sweep.on_surface, sweep.outer) : FaceUses(m)),
      pieces_on(by_tag(m.edge_on, part.count(1))),
      triangles_on(by_tag(m.triangle_on, part.count(2))),
      triangle_keys(sorted_keys(m)),
      sides(sorted_sides(m)),
      pieces(sorted_pieces(m)),
      surface(surface_tree(m, part)),
      node_foot(m, [this](Mesh::Index v) { return foot_of_node(*this, v); }),
      triangle_foot(m.triangles.size()) {
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, m.triangles.size(), kFeet), [&](const auto& range) {
    for (std::uint32_t t = range.begin(); t != range.end(); ++t)
      triangle_foot[t] = foot_of_triangle(*this, t);
  });
}

double ClaimInput::longest_side(const std::array<Mesh::Index, 3>& t) const {
  return std::sqrt(
      std::max({(point(t[0]) - point(t[1])).squaredNorm(), (point(t[1]) - point(t[2])).squaredNorm(),
                (point(t[2]) - point(t[0])).squaredNorm()}));
}

double allowed_distance(const Model& model, ModelRef entity) {
  return std::max(model.tolerance_of(entity), kNodeShare * model.diagonal());
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

ClaimBuilder::ClaimBuilder(std::string name, std::string statement) {
  claim_.name = std::move(name);
  claim_.statement = std::move(statement);
}

void ClaimBuilder::fault(double severity, ModelRef entity, const Vec3& place, std::string cause,
                         std::string advice) {
  ++count_;
  claim_.places.push_back(place);
  const auto at = std::upper_bound(kept_.begin(), kept_.end(), severity,
                                   [](double s, const auto& kept) { return s > kept.first; });
  if (at == kept_.end() && kept_.size() == kFaultsKept) return;
  kept_.insert(at, {severity, {entity, place, std::move(cause), std::move(advice)}});
  if (kept_.size() > kFaultsKept) kept_.pop_back();
}

Claim ClaimBuilder::counted() { return measured(static_cast<double>(count_), 0.0); }

Claim ClaimBuilder::measured(double worst, double limit) {
  claim_.holds = count_ == 0;
  claim_.worst = worst;
  claim_.limit = limit;
  for (auto& [severity, fault] : kept_) claim_.faults.push_back(std::move(fault));
  return std::move(claim_);
}

}  // namespace octet
