// SPDX-License-Identifier: BSD-3-Clause
// Points of one mesh for the next.
#include "app/periodic_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "app/watched_observer.h"
#include "classify/periodic.h"

namespace octet {
namespace {

using Index = Mesh::Index;

/// How often a mesh is made: for the points on edges, for those on faces, and for itself; more where these do
/// not fit.
constexpr int kLeast = 3, kMakings = 7;

/// Points are moved by up to this share of the way to their neighbours: four on a circle, of which rounding
/// would choose the diagonal, on the face one and on its image the other, are on none then.
constexpr double kNudge = 1e-3;

/// -1..1, the same for the same number.
double noise(std::uint64_t n) {
  n = (n ^ n >> 30) * 0xbf58476d1ce4e5b9u;
  n = (n ^ n >> 27) * 0x94d049bb133111ebu;
  n ^= n >> 31;
  return std::ldexp(static_cast<double>(n >> 11), -52) - 1.0;
}

/// On the face, where it is the image of another place that is on its own.
Vec3 place_on(const Model& model, int face, const Vec3& p) {
  if (model.is_plane(face)) return p;
  const FaceFoot foot = model.face_project(face, p);
  return foot.converged ? foot.point : p;
}

class Giver {
 public:
  Giver(const Mesh& mesh, const Model& model, const Periodicity& periodicity)
      : mesh_(mesh),
        model_(model),
        periodicity_(periodicity),
        on_edge_(static_cast<std::size_t>(model.count(1)) + 1),
        on_face_(static_cast<std::size_t>(model.count(2)) + 1),
        nearest_(mesh.points.size(), std::numeric_limits<double>::infinity()) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const ModelRef on = mesh.point_on[v];
      if (!periodicity.holds(on)) continue;
      const auto tag = static_cast<std::size_t>(on.tag);
      if (on.dim == 1)
        on_edge_[tag].push_back({static_cast<Index>(v), model.edge_closest(on.tag, mesh.points[v]).t});
      else
        on_face_[tag].push_back(static_cast<Index>(v));
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (periodicity.holds(model_face(mesh.triangle_on[t])))
        for (std::size_t i = 0; i < 3; ++i) shorten(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
  }

  /// Whether these have been given what the mesh has there.
  [[nodiscard]] bool has_all(const GivenPoints& given) const {
    const auto has = [](const auto& points, const auto& on) { return points.size() == on.size(); };
    for (std::size_t e = 1; e < on_edge_.size(); ++e)
      if (given.has_edge(static_cast<int>(e)) && !has(*given.on_edge[e], on_edge_[e])) return false;
    for (std::size_t f = 1; f < on_face_.size(); ++f)
      if (given.has_face(static_cast<int>(f)) && !has(*given.on_face[f], on_face_[f])) return false;
    return true;
  }

  /// `nudge`: which noise; none: the points stay where they are, and those that others of an orbit have
  /// besides come to them.
  GivenPoints run(std::optional<int> nudge, bool with_faces) {
    nudge_ = nudge ? kNudge : 0.0;
    seed_ = static_cast<std::uint64_t>(nudge.value_or(0)) << 40;
    given_.on_edge.resize(on_edge_.size());
    given_.on_face.resize(on_face_.size());
    for (const auto& orbit : periodicity_.pieces()) give_pieces(orbit);
    for (auto& parameters : given_.on_edge) {
      if (!parameters) continue;
      std::sort(parameters->begin(), parameters->end());
      parameters->erase(std::unique(parameters->begin(), parameters->end()), parameters->end());
    }
    if (with_faces)
      for (const auto& orbit : periodicity_.faces()) give_faces(orbit);
    return std::move(given_);
  }

 private:
  struct OnEdge {
    Index v;
    double t;
  };

  void shorten(Index a, Index b) {
    const double length = (mesh_.points[a] - mesh_.points[b]).norm();
    nearest_[a] = std::min(nearest_[a], length);
    nearest_[b] = std::min(nearest_[b], length);
  }

  /// The vertices between the ends of a piece.
  [[nodiscard]] std::vector<Index> within(const PieceMember& piece) const {
    const Vec3 a = model_.edge_point(piece.edge, piece.t0), b = model_.edge_point(piece.edge, piece.t1);
    const double near = 4.0 * periodicity_.tolerance();
    std::vector<Index> vertices;
    for (const auto& [v, t] : on_edge_[static_cast<std::size_t>(piece.edge)])
      if (t > piece.t0 && t < piece.t1 && (mesh_.points[v] - a).norm() > near &&
          (mesh_.points[v] - b).norm() > near)
        vertices.push_back(v);
    return vertices;
  }

  /// What each member of an orbit has; and the one that has most: where sizes or holes ask for points on one,
  /// they are worth having on all.
  template <class Member, class Points>
  std::size_t richest(const std::vector<Member>& orbit, const Points& points) {
    own_.clear();
    for (const Member& member : orbit) own_.push_back(points(member));
    return static_cast<std::size_t>(
        std::max_element(own_.begin(), own_.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
        own_.begin());
  }

  /// Where other members than the source have points, as holes ask for them, and it has none near by.
  template <class Member>
  [[nodiscard]] std::vector<Vec3> others_on(const std::vector<Member>& orbit, std::size_t source) const {
    std::vector<Vec3> others;
    if (nudge_ > 0.0) return others;
    constexpr double kNear = 0.2;  // of the way to the next
    for (std::size_t i = 0; i < orbit.size(); ++i) {
      if (i == source) continue;
      const Motion motion = orbit[source].motion.after(orbit[i].motion.inverse());
      for (const Index v : own_[i]) {
        const Vec3 p = motion(mesh_.points[v]);
        const double near = kNear * nearest_[v];
        const auto is_near = [&](const Vec3& q) { return (p - q).norm() < near; };
        if (std::none_of(own_[source].begin(), own_[source].end(),
                         [&](Index w) { return is_near(mesh_.points[w]); }) &&
            std::none_of(others.begin(), others.end(), is_near))
          others.push_back(p);
      }
    }
    return others;
  }

  void give_pieces(const std::vector<PieceMember>& orbit) {
    const std::size_t most = richest(orbit, [&](const PieceMember& member) { return within(member); });
    const PieceMember& source = orbit[most];
    std::vector<Vec3> places = others_on(orbit, most);
    for (const Index v : own_[most]) {
      const EdgeFoot foot = model_.edge_closest(source.edge, mesh_.points[v]);
      const double speed = model_.edge_derivative(source.edge, foot.t).norm();
      const double step = nudge_ * noise(seed_ + v) * nearest_[v];
      const double t = speed > 0.0 && std::isfinite(step) ? foot.t + step / speed : foot.t;
      places.push_back(model_.edge_point(source.edge, std::clamp(t, source.t0, source.t1)));
    }
    for (const PieceMember& member : orbit) {
      const Motion motion = member.motion.after(source.motion.inverse());
      auto& parameters = given_.on_edge[static_cast<std::size_t>(member.edge)];
      if (!parameters) parameters.emplace();
      for (const Vec3& p : places) parameters->push_back(model_.edge_closest(member.edge, motion(p)).t);
      if (member.t1 < model_.edge(member.edge).t1) parameters->push_back(member.t1);
    }
  }

  void give_faces(const std::vector<OrbitMember>& orbit) {
    const std::size_t most = richest(
        orbit, [&](const OrbitMember& member) { return on_face_[static_cast<std::size_t>(member.tag)]; });
    const OrbitMember& source = orbit[most];
    const std::vector<Ball> balls = balls_beside(source.tag);
    const auto is_in_ball = [&](const Vec3& p) {
      return std::any_of(balls.begin(), balls.end(),
                         [&](const Ball& ball) { return (p - ball.a).dot(p - ball.b) < 0.0; });
    };
    std::vector<Vec3> places = others_on(orbit, most);
    for (const Index v : own_[most]) {
      const FaceFoot foot = model_.face_project(source.tag, mesh_.points[v]);
      const Vec3 across = foot.normal.unitOrthogonal();
      const double reach = nudge_ * nearest_[v];
      const Vec3 moved = mesh_.points[v] + reach * noise(seed_ + 2 * v) * across +
                         reach * noise(seed_ + 2 * v + 1) * foot.normal.cross(across);
      const FaceFoot place = model_.face_project(source.tag, moved, foot.uv);
      if (place.converged && !(nudge_ > 0.0 && is_in_ball(place.point))) places.push_back(place.point);
    }
    for (const OrbitMember& member : orbit) {
      const Motion motion = member.motion.after(source.motion.inverse());
      std::vector<Vec3> images;
      for (const Vec3& p : places) images.push_back(place_on(model_, member.tag, motion(p)));
      given_.on_face[static_cast<std::size_t>(member.tag)] = std::move(images);
    }
  }

  /// Of which the piece from a to b is a diameter.
  struct Ball {
    Vec3 a, b;
  };

  /// Those of the pieces that a face's edges will have.
  [[nodiscard]] std::vector<Ball> balls_beside(int face) const {
    std::vector<Ball> balls;
    for (const FaceBoundary& side : model_.face(face).boundary) {
      const ModelEdge& edge = model_.edge(side.edge);
      const auto& given = given_.on_edge[static_cast<std::size_t>(side.edge)];
      if (edge.use != EdgeUse::kReal || !given) continue;
      Vec3 last = model_.edge_point(side.edge, edge.t0);
      std::vector<double> ends = *given;
      ends.push_back(edge.t1);
      for (const double t : ends) {
        const Vec3 next = model_.edge_point(side.edge, t);
        balls.push_back({last, next});
        last = next;
      }
    }
    return balls;
  }

  const Mesh& mesh_;
  const Model& model_;
  const Periodicity& periodicity_;
  double nudge_ = 0.0;
  std::uint64_t seed_ = 0;
  std::vector<std::vector<OnEdge>> on_edge_;  ///< vertices by tag
  std::vector<std::vector<Index>> on_face_;
  std::vector<double> nearest_;          ///< per vertex on a periodic face: its shortest edge there
  std::vector<std::vector<Index>> own_;  ///< per member of an orbit
  GivenPoints given_;
};

Eigen::Matrix3d turn_of(const OwnFrame& frame) {
  Eigen::Matrix3d turn;
  for (int i = 0; i < 3; ++i) turn.col(i) = frame.to_model(Vec3::Unit(i));
  return turn;
}

void turn_over(GivenPoints& given, const OwnFrame& frame) {
  for (auto& points : given.on_face)
    if (points)
      for (Vec3& p : *points) p = frame.to_model(p);
}

}  // namespace

void take_match(MeshResult& result, const Model& model, const Periodicity& periodicity) {
  MeshReport& report = result.report;
  if (!report.acceptance.holds("numbers")) return;  // nothing else can be asked
  PeriodicMatch match = match_periodic(result.mesh, model, periodicity);
  const std::vector<Fault> faults = faults_of({match.claim});
  report.acceptance.claims.push_back(std::move(match.claim));
  report.faults.insert(report.faults.end(), faults.begin(), faults.end());
  if (!report.faults.empty()) report.status = MeshStatus::kIncomplete;
  report.links = std::move(match.links);
}

MeshResult mesh_periodic(const OwnFrame& frame, const MeshOptions& options, const Periodicity& periodicity,
                         const PeriodicMaking& make, Observer& observer) {
  PeriodicSeeds seeds{periodicity.turned(turn_of(frame)), {}};
  std::optional<MeshResult> best;
  MeshOptions quick = options;
  if (quick.scope == FinalizeScope::kAll) quick.scope = FinalizeScope::kFast;
  for (int making = 0; making < kMakings; ++making) {
    const double from = std::min(making, kLeast - 1) / static_cast<double>(kLeast);
    WatchedObserver part(observer, options.cancelled, from, from + 1.0 / kLeast);
    MeshResult result = make(making == 0 ? quick : options, making == 0 ? nullptr : &seeds, part);
    take_match(result, frame.part(), periodicity);
    const MeshReport& report = result.report;
    const bool fits = report.acceptance.holds(kPeriodicClaim);
    if ((!fits || making == 0) && making + 1 < kMakings) {
      observer.note("periodic faces: once more with the points there given");
      Giver giver(result.mesh, frame.part(), periodicity);
      const bool is_new = making <= 1 || giver.has_all(seeds.given);
      seeds.given = giver.run(is_new ? std::optional(making) : std::nullopt, making > 0);
      turn_over(seeds.given, frame);
    }
    if (!best || report.faults.size() <= best->report.faults.size()) best = std::move(result);
    if (fits && making > 0) break;  // the first is quick, and there for its points
  }
  return *std::move(best);
}

std::function<std::vector<ImagePoint>(ModelRef, const Vec3&)> image_points(const PeriodicSeeds* seeds,
                                                                           const Model& model) {
  if (seeds == nullptr) return {};
  return [seeds, &model](ModelRef on, const Vec3& p) {
    std::vector<ImagePoint> images;
    if (on.dim == 2 && !seeds->given.has_face(on.tag)) return images;
    const Periodicity& periodicity = seeds->periodicity;
    if (on.dim == 1)
      for (const OrbitMember& member : periodicity.images_on_edges(on.tag, model.edge_closest(on.tag, p).t)) {
        const EdgeFoot foot = model.edge_closest(member.tag, member.motion(p));
        images.push_back({model_edge(member.tag), foot.point, foot.t});
      }
    else
      for (const OrbitMember& member : periodicity.images_on_faces(on.tag))
        images.push_back({model_face(member.tag), place_on(model, member.tag, member.motion(p)), 0.0});
    return images;
  };
}

std::vector<Mesh::Index> with_periodic(std::vector<Mesh::Index> held, const Mesh& mesh,
                                       const PeriodicSeeds* seeds) {
  if (seeds == nullptr) return held;
  std::vector<bool> keep(mesh.points.size(), false);
  for (const Mesh::Index v : held) keep[v] = true;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.point_on[v].dim == 1 && seeds->periodicity.holds(mesh.point_on[v])) keep[v] = true;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (seeds->given.has_face(mesh.triangle_on[t]))
      for (const Mesh::Index v : mesh.triangles[t]) keep[v] = true;
  held.clear();
  for (std::size_t v = 0; v < keep.size(); ++v)
    if (keep[v]) held.push_back(static_cast<Mesh::Index>(v));
  return held;
}

}  // namespace octet
