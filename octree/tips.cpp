// SPDX-License-Identifier: BSD-3-Clause
// How narrow tips are, which way they point, and how far from their ends a ring of points has room.
#include "octree/tips.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "octree/seed_state.h"

namespace octet {
namespace {

/// Tips are sharp whose radius is at most this share of the distance from their end; beyond it, a ring of
/// points has room at three spacings from the end.
constexpr double kSharp = 0.25;
/// Points of a ring, and its radius in local sizes.
constexpr int kRing = 6;
constexpr double kLeastRing = 0.7;
/// A tip reaches over no more than this share of its faces.
constexpr double kMostReach = 0.5;
/// Octree vertices keep out of the tip's ball, so much larger.
constexpr double kBallGrowth = 1.1;
/// Edges and other faces that start at the vertex are along the tip within so many of its radii of the axis.
constexpr double kAlong = 1.5;

/// A face about a pole, from its facets. A cone's curvature at the distance s from its apex is 1 / (s tan a).
struct Shape {
  double taper = 0.0;       ///< as in Tip
  double length = 0.0;      ///< from the pole to the farthest point
  std::vector<Vec3> sides;  ///< directions from the pole along the face, unit

  [[nodiscard]] Vec3 mean() const {
    return std::accumulate(sides.begin(), sides.end(), Vec3(Vec3::Zero())).normalized();
  }
  /// Whether the sides wind about an axis: those of half a cone spread by a third of its taper in their
  /// lesser direction, of a quarter by a tenth, as much as those of fillets that run out in a point, which
  /// gain nothing from a ring.
  [[nodiscard]] bool winds() const {
    constexpr double kLeastSpread = 0.2;
    const Eigen::Vector3d squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread()).eigenvalues();
    return squares[1] >= std::pow(kLeastSpread * taper, 2);
  }
  /// Covariance of the sides' ends.
  [[nodiscard]] Eigen::Matrix3d spread() const {
    const double share = 1.0 / static_cast<double>(sides.size());
    Vec3 centre = Vec3::Zero();
    for (const Vec3& side : sides) centre += share * side;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Vec3& side : sides) sum += share * (side - centre) * (side - centre).transpose();
    return sum;
  }
  void add(const Model& model, std::size_t facet, const Vec3& pole) {
    const Facets& facets = model.facets();
    const int face = facets.face[facet];
    const double none = model.tolerance() + model.tolerance_of(model_face(face));
    const std::array<Vec3, 3> corner = facet_corners(facets, facet);
    std::array<double, 3> distance;
    for (int i = 0; i < 3; ++i) distance[i] = (corner[i] - pole).norm();
    length = std::max(length, *std::max_element(distance.begin(), distance.end()));
    if (*std::min_element(distance.begin(), distance.end()) > none) return;
    for (int i = 0; i < 3; ++i) {
      if (distance[i] <= none) continue;
      const double turn = model.face_curvature(face, facets.uv[facet][i]) * distance[i];
      taper = std::max(taper, turn > 0.0 ? 1.0 / turn : std::numeric_limits<double>::infinity());
      sides.push_back((corner[i] - pole) / distance[i]);
    }
  }
};

/// The direction that has the same angle with all sides: their ends lie in a plane across it. Where it is not
/// to be told from a few sides, their mean.
Vec3 axis_of(const Shape& shape) {
  constexpr double kMostTilt = 1.5;  // of a taper, the mean of the sides against their axis
  const Vec3 mean = shape.mean();
  Vec3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(shape.spread()).eigenvectors().col(0);
  if (axis.dot(mean) < 0.0) axis = -axis;
  return axis.cross(mean).norm() <= kMostTilt * shape.taper ? axis : mean;
}

/// Faces about one vertex that point the same way.
struct Sides {
  int vertex = 0;
  std::vector<int> faces;  ///< ascending
  Shape shape;

  [[nodiscard]] bool are_of(const Shape& other) const {
    return shape.mean().dot(other.mean()) > 0.0 &&
           shape.mean().cross(other.mean()).norm() <= 2.0 * std::max(shape.taper, other.taper);
  }
  void join(int face, const Shape& other) {
    faces.push_back(face);
    shape.taper = std::max(shape.taper, other.taper);
    shape.length = std::min(shape.length, other.length);
    shape.sides.insert(shape.sides.end(), other.sides.begin(), other.sides.end());
  }
};

/// Those at the vertex that point as the shape does; null: none.
Sides* like(std::vector<Sides>& sides, int vertex, const Shape& shape) {
  const auto same = std::find_if(sides.begin(), sides.end(), [&](const Sides& other) {
    return other.vertex == vertex && other.are_of(shape);
  });
  return same == sides.end() ? nullptr : &*same;
}

/// How far from the pole a ring of points has room.
double reach_of(const Tip& tip, double length, const Octree& tree) {
  constexpr double kStep = 1.05;
  const double most = kMostReach * length;
  double reach = tip.taper * tree.spacing_at(tip.place);
  while (reach < most && tip.taper * reach < kLeastRing * tree.spacing_at(tip.place + reach * tip.along))
    reach *= kStep;
  return std::min(reach, most);
}

/// By vertex and face: what narrows to nothing there.
using Shapes = std::map<std::pair<int, int>, Shape>;

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

}  // namespace

Tips::Tips(const Model& model, const Octree& tree) {
  std::vector<Sides> sides;
  for (const auto& found : shapes_at_poles(model)) {
    const auto [vertex, face] = found.first;
    const Shape& shape = found.second;
    if (shape.taper <= 0.0 || shape.taper > kSharp) continue;
    if (Sides* same = like(sides, vertex, shape))
      same->join(face, shape);
    else
      sides.push_back({vertex, {face}, shape});
  }
  for (const Sides& of : sides) {
    if (!of.shape.winds()) continue;
    Tip tip{of.vertex, of.faces, {}, model.vertex(of.vertex).point, axis_of(of.shape), of.shape.taper, 0.0};
    tip.reach = reach_of(tip, of.shape.length, tree);
    for (int f = 1; f <= model.count(2); ++f) {
      const std::vector<int>& vertices = model.face(f).vertices;
      if (std::binary_search(vertices.begin(), vertices.end(), tip.vertex)) tip.faces_at_vertex.push_back(f);
    }
    tips_.push_back(std::move(tip));
  }
}

bool Tip::holds(int face, const Vec3& p) const {
  constexpr double kRounding = 1e-6;
  const Vec3 away = p - place;
  if (away.norm() >= reach * (1.0 - kRounding)) return false;
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
    const double radius = 0.5 * tip.reach * std::hypot(1.0, tip.taper);
    return (p - tip.place - radius * tip.along).norm() < kBallGrowth * radius;
  });
}

std::vector<Vec3> ring_places(const Tip& tip) {
  const Vec3 across = tip.along.unitOrthogonal(), third = tip.along.cross(across);
  std::vector<Vec3> places;
  for (int k = 0; k < kRing; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRing;
    places.emplace_back(tip.place + tip.reach * (tip.along + tip.taper * (std::cos(angle) * across +
                                                                          std::sin(angle) * third)));
  }
  return places;
}

std::optional<Vec3> ring_point(const Model& model, const Tip& tip, int face, const Vec3& p) {
  constexpr int kSteps = 20;
  constexpr double kExact = 1e-9;
  Vec3 aim = p - tip.place;
  for (int step = 0; step < kSteps; ++step) {
    const FaceFoot foot = model.face_project(face, tip.place + tip.reach * aim.normalized());
    aim = foot.point - tip.place;
    if (!foot.converged || aim.norm() == 0.0) return std::nullopt;
    if (std::abs(aim.norm() - tip.reach) > kExact * tip.reach) continue;
    if (model.face_side(face, foot.uv) == TrimSide::kOut) return std::nullopt;
    return foot.point;
  }
  return std::nullopt;
}

std::optional<double> ring_parameter(const Model& model, const Tip& tip, int edge) {
  constexpr int kHalvings = 60;
  const ModelEdge& e = model.edge(edge);
  if (e.vertex[0] == e.vertex[1]) return std::nullopt;
  double near = e.vertex[0] == tip.vertex ? e.t0 : e.t1, far = e.vertex[0] == tip.vertex ? e.t1 : e.t0;
  const auto lies_before = [&](double t) {
    return (model.edge_point(edge, t) - tip.place).norm() < tip.reach;
  };
  if (lies_before(far)) return std::nullopt;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (near + far);
    (lies_before(middle) ? near : far) = middle;
  }
  return tip.leads_to(model.edge_point(edge, far)) ? std::optional(far) : std::nullopt;
}

double ring_spacing(const Tip& tip) {
  constexpr double kRoom = 1.03;  // the face bulges between them
  return tip.ring_radius() / (kRoom * kFaceSpacing);
}

}  // namespace octet
