// SPDX-License-Identifier: BSD-3-Clause
// How narrow tips are, which way they point, and how far from their ends a ring of points has room.
#include "octree/tips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "octree/seed_state.h"
#include "octree/tip_section.h"

namespace octet {
namespace {

/// Points of a ring, and its radius in local sizes.
constexpr int kRing = 6;
constexpr double kLeastRing = 0.7;
/// A tip reaches over no more than this share of its faces.
constexpr double kMostReach = 0.5;
/// Octree vertices keep out of the tip's ball, so much larger.
constexpr double kBallGrowth = 1.1;
/// Edges and other faces that start at the vertex are along the tip within so many of its radii of the axis.
constexpr double kAlong = 1.5;

/// Faces about one vertex that point the same way.
struct Sides {
  int vertex = 0;
  std::vector<int> faces;  ///< ascending
  TipSides shape;

  void join(int face, const TipSides& other) {
    faces.push_back(face);
    shape.add(other);
  }
};

/// Those at the vertex that point as the shape does; null: none.
Sides* like(std::vector<Sides>& sides, int vertex, const TipSides& shape) {
  const auto same = std::find_if(sides.begin(), sides.end(), [&](const Sides& other) {
    return other.vertex == vertex && other.shape.point_as(shape);
  });
  return same == sides.end() ? nullptr : &*same;
}

/// How large a ball a ring of points has room in.
double reach_of(Tip tip, double length, const Octree& tree) {
  constexpr double kStep = 1.05;
  const double most = kMostReach * length;
  tip.reach = tip.taper * tree.spacing_at(tip.place);
  while (tip.reach < most &&
         tip.ring_step() < kLeastRing * tree.spacing_at(tip.place + tip.reach * tip.along))
    tip.reach *= kStep;
  return std::min(tip.reach, most);
}

/// By vertex and face: what narrows to nothing there.
using Shapes = std::map<std::pair<int, int>, TipSides>;

Shapes shapes_at_poles(const Model& model) {
  Shapes shapes;
  std::vector<std::vector<int>> poles(static_cast<std::size_t>(model.count(2)) + 1);
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.use != EdgeUse::kDegenerate) continue;
    for (const int face : edge.faces)
      if (shapes.try_emplace({edge.vertex[0], face}).second) poles[face].push_back(edge.vertex[0]);
  }
  if (shapes.empty()) return shapes;
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const int vertex : poles[facets.face[t]])
      shapes.at({vertex, facets.face[t]}).add(model, t, model.vertex(vertex).point);
  return shapes;
}

/// Evenly about the tip's ellipse, where it leaves the ball.
std::vector<Vec3> places_about(const Tip& tip, int count) {
  const Vec3 third = tip.along.cross(tip.across);
  std::vector<Vec3> places;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    const Vec3 way =
        tip.along + tip.taper * std::cos(angle) * tip.across + tip.lesser_taper * std::sin(angle) * third;
    places.emplace_back(tip.place + tip.reach / way.squaredNorm() * way);
  }
  return places;
}

}  // namespace

Tips::Tips(const Model& model, const Octree& tree) {
  std::vector<Sides> sides;
  for (const auto& found : shapes_at_poles(model)) {
    const auto [vertex, face] = found.first;
    const TipSides& shape = found.second;
    if (!section_of(shape)) continue;
    if (Sides* same = like(sides, vertex, shape))
      same->join(face, shape);
    else
      sides.push_back({vertex, {face}, shape});
  }
  for (const Sides& of : sides) {
    const std::optional<TipSection> section = section_of(of.shape);
    if (!section || !section->winds) continue;
    Tip tip;
    tip.vertex = of.vertex;
    tip.faces = of.faces;
    tip.place = model.vertex(of.vertex).point;
    tip.along = section->along;
    tip.across = section->across;
    tip.taper = section->taper;
    tip.lesser_taper = section->lesser_taper;
    tip.reach = reach_of(tip, of.shape.length, tree);
    for (int f = 1; f <= model.count(2); ++f) {
      const std::vector<int>& vertices = model.face(f).vertices;
      if (std::binary_search(vertices.begin(), vertices.end(), tip.vertex)) tip.faces_at_vertex.push_back(f);
    }
    tips_.push_back(std::move(tip));
  }
}

bool Tip::encloses(const Vec3& p) const {
  constexpr double kRounding = 1e-6;
  const Vec3 away = p - place;
  return away.squaredNorm() < reach * (1.0 - kRounding) * away.dot(along);
}

bool Tip::holds(int face, const Vec3& p) const {
  if (!encloses(p)) return false;
  if (std::binary_search(faces.begin(), faces.end(), face)) return true;
  return std::binary_search(faces_at_vertex.begin(), faces_at_vertex.end(), face) && leads_to(p);
}

bool Tip::leads_to(const Vec3& p) const {
  const Vec3 away = p - place;
  const double height = away.dot(along);
  return (away - height * along).norm() < kAlong * taper * height;
}

const Tip* Tips::holder(int face, const Vec3& p) const {
  const auto tip = std::find_if(tips_.begin(), tips_.end(), [&](const Tip& t) { return t.holds(face, p); });
  return tip == tips_.end() ? nullptr : &*tip;
}

bool Tips::are_beside(const Vec3& p) const {
  return std::any_of(tips_.begin(), tips_.end(), [&](const Tip& tip) {
    const double radius = 0.5 * tip.reach;
    return (p - tip.place - radius * tip.along).norm() < kBallGrowth * radius;
  });
}

std::optional<Vec3> ring_point(const Model& model, const Tip& tip, int face, const Vec3& p) {
  constexpr int kSteps = 20;
  constexpr double kExact = 1e-9;
  Vec3 way = (p - tip.place).normalized();
  for (int step = 0; step < kSteps; ++step) {
    const double aim = tip.reach * way.dot(tip.along);
    const FaceFoot foot = model.face_project(face, tip.place + aim * way);
    way = foot.point - tip.place;
    const double distance = way.norm();
    if (!foot.converged || distance == 0.0) return std::nullopt;
    way /= distance;
    if (std::abs(distance - tip.reach * way.dot(tip.along)) > kExact * tip.reach) continue;
    if (model.face_side(face, foot.uv) == TrimSide::kOut) return std::nullopt;
    return foot.point;
  }
  return std::nullopt;
}

std::vector<Vec3> ring_places(const Model& model, const Tip& tip) {
  constexpr int kSamples = 48;
  const std::vector<Vec3> round = places_about(tip, kSamples);
  std::vector<Vec3> places;
  for (const Vec3& place : round) {
    std::optional<Vec3> found;
    for (std::size_t f = 0; f < tip.faces.size() && !found; ++f)
      found = ring_point(model, tip, tip.faces[f], place);
    if (!found) return places_about(tip, kRing);
    places.push_back(*found);
  }
  // At each place the length there and the turn of its sides, as shares of the whole.
  std::vector<double> length, turn;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 before = places[i] - places[(i + kSamples - 1) % kSamples];
    const Vec3 behind = places[(i + 1) % kSamples] - places[i];
    length.push_back(0.5 * (before.norm() + behind.norm()));
    turn.push_back(std::atan2(before.cross(behind).norm(), before.dot(behind)));
  }
  const double all_length = std::accumulate(length.begin(), length.end(), 0.0);
  const double all_turn = std::accumulate(turn.begin(), turn.end(), 0.0);
  const auto first = std::max_element(turn.begin(), turn.end()) - turn.begin();
  std::vector<Vec3> chosen;
  double gone = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const auto at = static_cast<std::size_t>((first + i) % kSamples);
    if (gone >= static_cast<double>(chosen.size()) / kRing - 1e-9) chosen.push_back(places[at]);
    const auto next = (at + 1) % kSamples;
    gone += 0.25 * ((length[at] + length[next]) / all_length + (turn[at] + turn[next]) / all_turn);
  }
  return chosen;
}

std::optional<double> ring_parameter(const Model& model, const Tip& tip, int edge) {
  constexpr int kHalvings = 60;
  const ModelEdge& e = model.edge(edge);
  if (e.vertex[0] == e.vertex[1]) return std::nullopt;
  double near = e.vertex[0] == tip.vertex ? e.t0 : e.t1, far = e.vertex[0] == tip.vertex ? e.t1 : e.t0;
  const auto lies_before = [&](double t) { return tip.encloses(model.edge_point(edge, t)); };
  if (lies_before(far)) return std::nullopt;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (near + far);
    (lies_before(middle) ? near : far) = middle;
  }
  return tip.leads_to(model.edge_point(edge, far)) ? std::optional(far) : std::nullopt;
}

double ring_spacing(const Tip& tip) {
  constexpr double kRoom = 1.2;  // the face bulges between them, and may be no ellipse
  return tip.ring_step() / (kRoom * kFaceSpacing);
}

}  // namespace octet
