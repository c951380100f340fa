// SPDX-License-Identifier: BSD-3-Clause
// Directions from the normals of the walls, kept to what else a vertex is on.
#include "finalize/layer_columns.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace octet {
namespace {

/// The direction that goes away from all of the walls the most.
Vec3 away_from(const std::vector<Vec3>& normals) {
  constexpr int kRounds = 60;
  Vec3 direction = Vec3::Zero();
  for (const Vec3& n : normals) direction += n;
  for (int round = 0; round < kRounds; ++round) {
    if (direction.norm() < 1e-12) return Vec3::Zero();
    direction.normalize();
    const Vec3& least = *std::min_element(normals.begin(), normals.end(), [&](const Vec3& a, const Vec3& b) {
      return a.dot(direction) < b.dot(direction);
    });
    direction += 0.5 / (1.0 + round) * least;
  }
  return direction.normalized();
}

double least_cosine(const std::vector<Vec3>& normals, const Vec3& direction) {
  double least = 1.0;
  for (const Vec3& n : normals) least = std::min(least, n.dot(direction));
  return least;
}

}  // namespace

LayerWay::LayerWay(const Model& model, const Vec3& from, Along along, int tag, const Vec3& direction,
                   double stretch)
    : model_(&model), from_(from), direction_(direction), along_(along), tag_(tag), stretch_(stretch) {
  if (along == Along::kFace) bent_ = !model.is_plane(tag);
  if (along == Along::kEdge) {
    t_ = model.edge_closest(tag, from).t;
    sense_ = model.edge_derivative(tag, t_).dot(direction) < 0.0 ? -1.0 : 1.0;
  }
}

Vec3 LayerWay::at(double distance) const {
  const double length = stretch_ * distance;
  if (along_ == Along::kEdge)
    return model_->edge_point(tag_, model_->edge_parameter(tag_, t_, sense_ * length));
  const Vec3 p = from_ + length * direction_;
  return along_ == Along::kFace && bent_ ? model_->face_project(tag_, p).point : p;
}

std::array<Mesh::Index, 3> LayerWalls::inwards(const Mesh& mesh, const Model& model,
                                               std::uint32_t triangle) const {
  std::array<Mesh::Index, 3> v = mesh.triangles[triangle];
  // The normal points to region[1].
  if (model.face(mesh.triangle_on[triangle]).region[1] == 0) std::swap(v[1], v[2]);
  return v;
}

LayerWalls::LayerWalls(const Mesh& mesh, const Model& model, const std::vector<LayerWish>& wishes)
    : wish_of_face(static_cast<std::size_t>(model.count(2)) + 1, -1),
      wall_edge(static_cast<std::size_t>(model.count(1)) + 1, false) {
  for (std::size_t w = 0; w < wishes.size(); ++w)
    for (const int f : wishes[w].faces) {
      wish_of_face[static_cast<std::size_t>(f)] = static_cast<std::int32_t>(w);
      for (const FaceBoundary& side : model.face(f).boundary)
        wall_edge[static_cast<std::size_t>(side.edge)] = true;
    }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_wall(mesh.triangle_on[t])) continue;
    triangles.push_back(t);
    const auto v = inwards(mesh, model, t);
    const Vec3 normal =
        (mesh.points[v[1]] - mesh.points[v[0]]).cross(mesh.points[v[2]] - mesh.points[v[0]]).normalized();
    const auto wish = static_cast<std::size_t>(wish_of_face[static_cast<std::size_t>(mesh.triangle_on[t])]);
    for (const Mesh::Index i : v) {
      if (i >= columns.size()) columns.resize(i + 1);
      LayerColumn& column = columns[i];
      column.normals.push_back(normal);
      // Where two meet the thinner prevails.
      if (column.normals.size() == 1 || wishes[wish].heights.back() < wishes[column.wish].heights.back())
        column.wish = wish;
    }
  }
  // What else each is on: faces that are no walls, and edges that go inwards.
  std::vector<std::set<int>> faces(columns.size());
  std::vector<std::vector<std::pair<int, Vec3>>> edges(columns.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!is_wall(mesh.triangle_on[t]))
      for (const Mesh::Index v : mesh.triangles[t])
        if (v < columns.size()) faces[v].insert(mesh.triangle_on[t]);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (wall_edge[static_cast<std::size_t>(mesh.edge_on[e])]) continue;
    for (int end = 0; end < 2; ++end) {
      const Mesh::Index v = mesh.edges[e][static_cast<std::size_t>(end)],
                        other = mesh.edges[e][static_cast<std::size_t>(1 - end)];
      if (v < columns.size())
        edges[v].emplace_back(mesh.edge_on[e], (mesh.points[other] - mesh.points[v]).normalized());
    }
  }
  constexpr double kLeastCosine = 0.3;  // else the way goes along a wall
  for (std::size_t c = 0; c < columns.size(); ++c) {
    LayerColumn& column = columns[c];
    const Vec3 from = mesh.points[c];
    auto along = LayerWay::Along::kNothing;
    int tag = 0;
    Vec3 direction = away_from(column.normals);
    if (faces[c].size() == 1 && edges[c].empty()) {
      along = LayerWay::Along::kFace;
      tag = *faces[c].begin();
      const Vec3 normal = model.face_project(tag, from).normal;
      direction -= direction.dot(normal) * normal;
      if (direction.norm() > 0.0) direction.normalize();
    } else if (!faces[c].empty() && edges[c].size() == 1) {
      along = LayerWay::Along::kEdge;
      tag = edges[c][0].first;
      const double t = model.edge_closest(tag, from).t;
      const Vec3 tangent = model.edge_derivative(tag, t).normalized();
      direction = tangent.dot(edges[c][0].second) < 0.0 ? Vec3(-tangent) : tangent;
    } else if (!faces[c].empty() || !edges[c].empty()) {
      column.share = 0.0;
      continue;
    }
    const double cosine = least_cosine(column.normals, direction);
    if (!(cosine >= kLeastCosine)) {
      column.share = 0.0;
      continue;
    }
    column.way = LayerWay(model, from, along, tag, direction, 1.0 / cosine);
  }
}

void put_walls_first(Mesh& mesh, const std::vector<LayerWish>& wishes) {
  std::set<int> walls;
  for (const LayerWish& wish : wishes) walls.insert(wish.faces.begin(), wish.faces.end());
  std::vector<bool> first(mesh.points.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (walls.count(mesh.triangle_on[t]) != 0)
      for (const Mesh::Index v : mesh.triangles[t]) first[v] = true;
  std::vector<Mesh::Index> order(mesh.points.size()), number(mesh.points.size());
  std::iota(order.begin(), order.end(), Mesh::Index{0});
  std::stable_partition(order.begin(), order.end(), [&](Mesh::Index v) { return first[v]; });
  std::vector<Vec3> points;
  std::vector<ModelRef> on;
  for (const Mesh::Index v : order) {
    number[v] = static_cast<Mesh::Index>(points.size());
    points.push_back(mesh.points[v]);
    on.push_back(mesh.point_on[v]);
  }
  mesh.points = std::move(points);
  mesh.point_on = std::move(on);
  const auto renumber = [&](auto& elements) {
    for (auto& element : elements)
      for (Mesh::Index& v : element) v = number[v];
  };
  renumber(mesh.tets);
  renumber(mesh.triangles);
  renumber(mesh.edges);
}

}  // namespace octet
