// SPDX-License-Identifier: BSD-3-Clause
// Candidates from vertices; each is tried on all vertices, edges and faces.
#include "geom/motion_search.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/sort_unique.h"
#include "geom/facets.h"

namespace octet {
namespace {

/// Places that a motion has to take onto edges, of one edge, its ends left out.
std::array<Vec3, 3> quarters_of(const Model& model, int tag) {
  const ModelEdge& edge = model.edge(tag);
  std::array<Vec3, 3> places;
  for (std::size_t i = 0; i < 3; ++i)
    places[i] = model.edge_point(
        tag, model.edge_parameter(tag, edge.t0, edge.length * static_cast<double>(i + 1) / 4));
  return places;
}

/// The closure of some faces, and what a motion has to take elsewhere.
struct Closure {
  Closure(const Model& model, const std::vector<int>& the_faces)
      : faces(the_faces), vertices(vertices_of(model, faces)), edges(edges_of(model, faces)) {
    for (const int v : vertices) corners.push_back(model.vertex(v).point);
    for (const int e : edges)
      for (const Vec3& p : quarters_of(model, e)) on_edges.push_back(p);
    for (const int f : faces) within.push_back(points_within(model, f));
  }
  std::vector<int> faces, vertices, edges;
  std::vector<Vec3> corners, on_edges;
  std::vector<std::vector<Vec3>> within;  ///< per face
};

/// Whether a motion takes faces to their images.
class Trial {
 public:
  Trial(const Model& model, const Closure& from, const Closure& to, double tolerance)
      : model_(model), from_(from), to_(to), tolerance_(tolerance) {}

  /// The faces, each with its image.
  [[nodiscard]] std::optional<std::vector<std::pair<int, int>>> faces(const Motion& motion) const {
    const Motion back = motion.inverse();
    if (!all_on_edges(from_.corners, motion, to_) || !all_on_edges(to_.corners, back, from_) ||
        !all_on_edges(from_.on_edges, motion, to_) || !all_on_edges(to_.on_edges, back, from_))
      return std::nullopt;
    std::vector<std::pair<int, int>> pairs;
    std::vector<bool> taken(to_.faces.size(), false);
    for (std::size_t i = 0; i < from_.faces.size(); ++i) {
      std::size_t j = 0;
      while (j < to_.faces.size() && (taken[j] || !is_image(i, j, motion))) ++j;
      if (j == to_.faces.size()) return std::nullopt;
      taken[j] = true;
      pairs.emplace_back(from_.faces[i], to_.faces[j]);
    }
    return pairs;
  }

 private:
  [[nodiscard]] bool all_on_edges(const std::vector<Vec3>& places, const Motion& motion,
                                  const Closure& closure) const {
    return std::all_of(places.begin(), places.end(), [&](const Vec3& place) {
      const Vec3 p = motion(place);
      return std::any_of(closure.corners.begin(), closure.corners.end(),
                         [&](const Vec3& q) { return (p - q).norm() <= tolerance_; }) ||
             std::any_of(closure.edges.begin(), closure.edges.end(),
                         [&](int e) { return model_.edge_closest(e, p).distance <= tolerance_; });
    });
  }

  /// +1: the part is behind the face's normal; -1: before it; 0: on both sides.
  [[nodiscard]] int outward(int face) const {
    const auto& region = model_.face(face).region;
    return (region[1] == 0 ? 1 : 0) - (region[0] == 0 ? 1 : 0);
  }

  [[nodiscard]] bool is_image(std::size_t i, std::size_t j, const Motion& motion) const {
    constexpr double kSameArea = 1e-3;
    const int face = from_.faces[i], other = to_.faces[j];
    const double area = model_.face(face).area;
    if (std::abs(area - model_.face(other).area) > kSameArea * area) return false;
    const int sides = outward(face) * outward(other);
    return std::all_of(from_.within[i].begin(), from_.within[i].end(), [&](const Vec3& place) {
      const Foot foot = model_.face_closest(other, motion(place));
      if (foot.distance > tolerance_) return false;
      return sides == 0 ||
             sides * foot.normal.dot(motion.turn * model_.face_project(face, place).normal) < 0.0;
    });
  }

  const Model& model_;
  const Closure &from_, &to_;
  double tolerance_;
};

/// Of the places the one given, the one farthest from it, the one farthest from their line. None where they
/// lie on a line.
std::optional<std::array<Vec3, 3>> spanning(const std::vector<Vec3>& places, std::size_t first,
                                            double least) {
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(places.begin(), places.end(),
                             [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  };
  const Vec3 a = places[first];
  const Vec3 b = farthest([&](const Vec3& p) { return (p - a).norm(); });
  if ((b - a).norm() < least) return std::nullopt;
  const Vec3 along = (b - a).normalized();
  const auto off_line = [&](const Vec3& p) { return (p - a - along.dot(p - a) * along).norm(); };
  const Vec3 c = farthest(off_line);
  if (off_line(c) < least) return std::nullopt;
  return std::array<Vec3, 3>{a, b, c};
}

Eigen::Matrix3d frame_of(const std::array<Vec3, 3>& places) {
  const Vec3 x = (places[1] - places[0]).normalized();
  const Vec3 z = x.cross(places[2] - places[0]).normalized();
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

/// Motions that take three places to three of others, in the order of their angles.
std::vector<Motion> motions_to(const std::array<Vec3, 3>& places, const std::vector<Vec3>& others,
                               double tolerance) {
  std::vector<std::pair<double, Motion>> found;
  const auto fits = [&](const Vec3& p, const Vec3& q, std::size_t i, std::size_t j) {
    return std::abs((p - q).norm() - (places[i] - places[j]).norm()) <= 2.0 * tolerance;
  };
  for (const Vec3& a : others)
    for (const Vec3& b : others) {
      if (!fits(a, b, 0, 1)) continue;
      for (const Vec3& c : others) {
        if (!fits(a, c, 0, 2) || !fits(b, c, 1, 2)) continue;
        Motion motion;
        motion.turn = frame_of({a, b, c}) * frame_of(places).transpose();
        motion.shift = (a + b + c) / 3.0 - motion.turn * (places[0] + places[1] + places[2]) / 3.0;
        found.emplace_back(Eigen::AngleAxisd(motion.turn).angle(), motion);
      }
    }
  constexpr double kSameAngle = 1e-6;
  std::stable_sort(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return std::floor(a.first / kSameAngle) < std::floor(b.first / kSameAngle);
  });
  std::vector<Motion> motions;
  motions.reserve(found.size());
  for (const auto& one : found) motions.push_back(one.second);
  return motions;
}

/// The mean of the closures' extents along an axis, as a translation.
Motion along(int axis, const Closure& from, const Closure& to) {
  const auto place = [&](const Closure& closure) {
    double sum = 0.0;
    for (const Vec3& p : closure.corners) sum += p[axis];
    return closure.corners.empty() ? 0.0 : sum / static_cast<double>(closure.corners.size());
  };
  Motion motion;
  motion.shift[axis] = place(to) - place(from);
  return motion;
}

std::string listed(const Model& model, const std::vector<int>& faces) {
  constexpr std::size_t kTold = 4;
  std::string words;
  for (std::size_t i = 0; i < std::min(kTold, faces.size()); ++i)
    words += (i == 0 ? "" : ", ") + model.describe(model_face(faces[i]));
  return faces.size() > kTold ? words + " and " + std::to_string(faces.size() - kTold) + " more" : words;
}

/// Rounding spread over all vertices that are taken to vertices.
Motion refined(const Motion& motion, const Closure& from, const Closure& to, double tolerance) {
  std::vector<std::pair<Vec3, Vec3>> pairs;
  for (const Vec3& p : from.corners)
    for (const Vec3& q : to.corners)
      if ((motion(p) - q).norm() <= tolerance) pairs.emplace_back(p, q);
  if (pairs.empty()) return motion;
  if (motion.turn == Eigen::Matrix3d::Identity() || pairs.size() < 3) return motion;
  Vec3 from_mean = Vec3::Zero(), to_mean = Vec3::Zero();
  for (const auto& [p, q] : pairs) {
    from_mean += p / static_cast<double>(pairs.size());
    to_mean += q / static_cast<double>(pairs.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero(), both = Eigen::Matrix3d::Zero();
  for (const auto& [p, q] : pairs) {
    spread += (p - from_mean) * (p - from_mean).transpose();
    both += (q - to_mean) * (p - from_mean).transpose();
  }
  // Vertices on a line tell no rotation.
  constexpr double kLine = 1e-3;  // square root of a moment, of all
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(spread, Eigen::EigenvaluesOnly);
  if (moments.eigenvalues()[1] < kLine * kLine * spread.trace()) return motion;
  // The rotation of least squares, and no reflection where all lie in a plane.
  const Eigen::JacobiSVD<Eigen::Matrix3d> axes(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double hand = axes.matrixU().determinant() * axes.matrixV().determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix3d turn =
      axes.matrixU() * Eigen::DiagonalMatrix<double, 3>(1.0, 1.0, hand) * axes.matrixV().transpose();
  return {turn, to_mean - turn * from_mean};
}

}  // namespace

std::vector<int> vertices_of(const Model& model, const std::vector<int>& faces) {
  std::vector<int> vertices;
  for (const int f : faces)
    vertices.insert(vertices.end(), model.face(f).vertices.begin(), model.face(f).vertices.end());
  sort_unique(vertices);
  return vertices;
}

std::vector<int> edges_of(const Model& model, const std::vector<int>& faces) {
  std::vector<int> edges;
  for (const int f : faces)
    for (const FaceBoundary& side : model.face(f).boundary)
      if (model.edge(side.edge).use == EdgeUse::kReal) edges.push_back(side.edge);
  sort_unique(edges);
  return edges;
}

std::vector<Vec3> points_within(const Model& model, int face) {
  constexpr std::size_t kPoints = 5;
  const Facets& facets = model.facets();
  std::vector<std::size_t> own;
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    if (facets.face[t] == face) own.push_back(t);
  std::vector<Vec3> points;
  const std::size_t n = std::min(kPoints, own.size());
  for (std::size_t i = 0; i < n; ++i) {
    const auto corners = facet_corners(facets, own[i * own.size() / n]);
    const FaceFoot foot = model.face_project(face, (corners[0] + corners[1] + corners[2]) / 3.0);
    if (foot.converged) points.push_back(foot.point);
  }
  return points;
}

MotionFound find_motion(const Model& model, const std::vector<int>& faces, const std::vector<int>& images,
                        int axis, double tolerance) {
  MotionFound found;
  const Closure from(model, faces), to(model, images);
  const Trial trial(model, from, to, tolerance);
  const auto is_it = [&](const Motion& motion) {
    auto pairs = trial.faces(motion);
    if (!pairs) return false;
    found.motion = refined(motion, from, to, tolerance);
    found.faces = *std::move(pairs);
    return true;
  };
  const auto is_translation = [&] {
    for (const Vec3& p : from.corners)
      for (const Vec3& q : to.corners) {
        Motion motion;
        motion.shift = q - p;
        if (is_it(motion)) return true;
      }
    return false;
  };
  // Vertices of seams have no images: other three may do, and where there are few, the quarters of edges.
  const auto is_rotation = [&] {
    constexpr std::size_t kStarts = 8;
    std::vector<Vec3> marks = from.corners, others = to.corners;
    for (const bool with_edges : {false, true}) {
      if (with_edges) {
        marks.insert(marks.end(), from.on_edges.begin(), from.on_edges.end());
        others.insert(others.end(), to.on_edges.begin(), to.on_edges.end());
      }
      for (std::size_t i = 0; i < std::min(kStarts, marks.size()); ++i) {
        const auto places = spanning(marks, i, 10.0 * tolerance);
        if (!places) continue;
        for (const Motion& motion : motions_to(*places, others, tolerance))
          if (is_it(motion)) return true;
      }
    }
    return false;
  };
  if (faces.size() != images.size()) {
    found.reason = listed(model, faces) + " and " + listed(model, images) + " are not as many";
  } else if (axis >= 0 ? !is_it(along(axis, from, to)) : !is_translation() && !is_rotation()) {
    found.reason = "no " +
                   (axis >= 0 ? std::string("translation along ") + "xyz"[axis] : std::string("motion")) +
                   " takes " + listed(model, faces) + " to " + listed(model, images) +
                   ", their edges to edges and what is inside to what is outside";
  }
  return found;
}

}  // namespace octet
