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

/// What narrows to nothing about a pole, by ways that lead from the pole along it.
struct Shape {
  double length = 0.0;      ///< from the pole to the farthest point
  std::vector<Vec3> sides;  ///< unit

  /// Those of a face, by the exact face beside its facets at the pole.
  void add(const Model& model, std::size_t facet, const Vec3& pole) {
    const Facets& facets = model.facets();
    const int face = facets.face[facet];
    const double none = model.tolerance() + model.tolerance_of(model_face(face));
    const std::array<Vec3, 3> corner = facet_corners(facets, facet);
    std::array<double, 3> distance;
    for (int i = 0; i < 3; ++i) distance[i] = (corner[i] - pole).norm();
    length = std::max(length, *std::max_element(distance.begin(), distance.end()));
    const auto nearest = std::min_element(distance.begin(), distance.end()) - distance.begin();
    if (distance[nearest] > none) return;
    const std::array<Vec2, 3>& uv = facets.uv[facet];
    const SurfaceJet jet = model.face_jet(face, uv[nearest], 1);
    const int inwards = jet.du.norm() < jet.dv.norm() ? 1 : 0;
    const Vec2 a = uv[(nearest + 1) % 3], b = uv[(nearest + 2) % 3];
    constexpr int kSteps = 4;
    for (int k = 0; k <= kSteps; ++k) {
      constexpr double kNear = 1.0 / 16.0;  // of a facet's length
      Vec2 at = a + (b - a) * k / kSteps;
      at[inwards] = uv[nearest][inwards] + kNear * (at[inwards] - uv[nearest][inwards]);
      const Vec3 way = model.face_jet(face, at, 0).p - pole;
      if (way.norm() > none) sides.push_back(way.normalized());
    }
  }
  void add(const Shape& other) {
    length = std::min(length, other.length);
    sides.insert(sides.end(), other.sides.begin(), other.sides.end());
  }
  [[nodiscard]] Vec3 mean() const {
    return std::accumulate(sides.begin(), sides.end(), Vec3(Vec3::Zero())).normalized();
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
  /// Whether the sides wind about an axis: those of half a cone spread by a third of its taper in their
  /// lesser direction, of a quarter by a tenth, as much as those of fillets that run out in a point, which
  /// gain nothing from a ring.
  [[nodiscard]] bool winds(double taper) const {
    constexpr double kLeastSpread = 0.2;
    const Eigen::Vector3d squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread()).eigenvalues();
    return squares[1] >= std::pow(kLeastSpread * taper, 2);
  }
};

/// A tip as seen along its axis, at the distance 1 from its end.
struct Section {
  Vec3 along = Vec3::Zero(), across = Vec3::Zero();
  double taper = 0.0, lesser_taper = 0.0;
};

/// The sides in the plane at the distance 1 from the pole across `along`.
struct Trace {
  Vec3 x, y;
  std::vector<Vec2> places;
  double size = 0.0;  ///< that of the farthest

  Trace(const std::vector<Vec3>& sides, const Vec3& along) : x(along.unitOrthogonal()), y(along.cross(x)) {
    for (const Vec3& side : sides) {
      places.emplace_back(Vec2(side.dot(x), side.dot(y)) / side.dot(along));
      size = std::max(size, places.back().norm());
    }
  }
};

struct Ellipse {
  Vec2 centre, wide;  ///< `wide`: unit
  double a = 0.0, b = 0.0;
};

/// The ellipse on which the places lie: through part of it as well. None where they lie on no ellipse.
std::optional<Ellipse> ellipse_through(const Trace& trace) {
  constexpr double kOff = 0.3;  // of the ellipse
  constexpr double kFlattest = 0.1;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(trace.places.size()), 6);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Vec2 p = trace.places[static_cast<std::size_t>(i)] / trace.size;
    rows.row(i) << p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y(), 1.0;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const Eigen::VectorXd c = svd.matrixV().col(5);
  Eigen::Matrix2d square;
  square << c[0], 0.5 * c[1], 0.5 * c[1], c[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(square);
  const Vec2 values = solver.eigenvalues();
  if (!(values[0] * values[1] > std::pow(kFlattest, 4) * values.squaredNorm())) return std::nullopt;
  const Vec2 centre = -0.5 * square.inverse() * Vec2(c[3], c[4]);
  const double level = -(c[5] + 0.5 * Vec2(c[3], c[4]).dot(centre));
  if (!(level * values[0] > 0.0)) return std::nullopt;
  const int widest = std::abs(values[0]) < std::abs(values[1]) ? 0 : 1;
  for (const Vec2& place : trace.places) {
    const Vec2 p = place / trace.size - centre;
    if (std::abs(std::sqrt(std::max(0.0, p.dot(square * p) / level)) - 1.0) > kOff) return std::nullopt;
  }
  return Ellipse{trace.size * centre, solver.eigenvectors().col(widest),
                 trace.size * std::sqrt(level / values[widest]),
                 trace.size * std::sqrt(level / values[1 - widest])};
}

/// In the box of the places along their principal directions.
Ellipse ellipse_about(const Trace& trace) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : trace.places) mean += p / static_cast<double>(trace.places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& p : trace.places) spread += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix2d ways = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors();
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec2& p : trace.places) {
    low = low.cwiseMin(ways.transpose() * p);
    high = high.cwiseMax(ways.transpose() * p);
  }
  return {ways * (0.5 * (low + high)), ways.col(1), 0.5 * (high - low).y(), 0.5 * (high - low).x()};
}

/// None where the tip is blunt.
std::optional<Section> section_of(const Shape& shape) {
  constexpr double kRound = 0.9;  // b / a of an ellipse that is taken for a circle
  constexpr int kSteps = 3;  // the middle of a cone's section is on its axis where the plane is across that
  constexpr double kWidest = 4.0 * kSharp;
  if (shape.sides.empty()) return std::nullopt;
  Section section;
  section.along = shape.mean();
  for (int step = 0; step < kSteps; ++step) {
    for (const Vec3& side : shape.sides)
      if (!(side.cross(section.along).norm() < kWidest * side.dot(section.along))) return std::nullopt;
    const Trace trace(shape.sides, section.along);
    const std::optional<Ellipse> fitted = ellipse_through(trace);
    const Ellipse ellipse = fitted ? *fitted : ellipse_about(trace);
    section.along =
        (section.along + ellipse.centre.x() * trace.x + ellipse.centre.y() * trace.y).normalized();
    const Vec3 wide = ellipse.wide.x() * trace.x + ellipse.wide.y() * trace.y;
    section.across = (wide - wide.dot(section.along) * section.along).normalized();
    section.taper = ellipse.a;
    section.lesser_taper = ellipse.b;
  }
  if (section.taper > kSharp) return std::nullopt;
  if (section.lesser_taper >= kRound * section.taper) {
    section.across = section.along.unitOrthogonal();
    section.lesser_taper = section.taper;
  }
  return section;
}

/// Faces about one vertex that point the same way.
struct Sides {
  int vertex = 0;
  std::vector<int> faces;  ///< ascending
  Shape shape;

  [[nodiscard]] bool are_of(const Shape& other) const {
    constexpr double kSame = 2.0 * kSharp;
    return shape.mean().dot(other.mean()) > 0.0 && shape.mean().cross(other.mean()).norm() <= kSame;
  }
  void join(int face, const Shape& other) {
    faces.push_back(face);
    shape.add(other);
  }
};

/// Those at the vertex that point as the shape does; null: none.
Sides* like(std::vector<Sides>& sides, int vertex, const Shape& shape) {
  const auto same = std::find_if(sides.begin(), sides.end(), [&](const Sides& other) {
    return other.vertex == vertex && other.are_of(shape);
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
    if (!section_of(shape)) continue;
    if (Sides* same = like(sides, vertex, shape))
      same->join(face, shape);
    else
      sides.push_back({vertex, {face}, shape});
  }
  for (const Sides& of : sides) {
    const std::optional<Section> section = section_of(of.shape);
    if (!section || !of.shape.winds(section->taper)) continue;
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

namespace {

/// Evenly about the ellipse.
std::vector<Vec3> ring_places(const Tip& tip, int count) {
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
  const std::vector<Vec3> round = ring_places(tip, kSamples);
  std::vector<Vec3> places;
  for (const Vec3& place : round) {
    std::optional<Vec3> found;
    for (std::size_t f = 0; f < tip.faces.size() && !found; ++f)
      found = ring_point(model, tip, tip.faces[f], place);
    if (!found) return ring_places(tip, kRing);
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
