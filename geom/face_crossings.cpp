// SPDX-License-Identifier: BSD-3-Clause
// Facets that pierce others give seeds; Newton's method on both surfaces decides, or on both places of one.
#include "geom/face_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/bucket_sort.h"
#include "geom/facet_bvh.h"
#include "geom/model_data.h"
#include "geom/surface.h"

namespace octet {
namespace {

/// Least sine of the angle between surfaces that cross: below, edges that are a little off look the same.
constexpr double kLeastSine = 0.02;

/// Places tried for a pair of faces: the deepest of so many is deep enough to tell.
constexpr std::size_t kTries = 64;

constexpr std::array<std::string_view, 5> kClosedForms{"plane", "cylinder", "cone", "sphere", "torus"};

/// Where a side of one facet goes through another.
struct Piercing {
  std::uint32_t of = 0, through = 0;  ///< facets
  Vec3 place = Vec3::Zero();
};

/// The deeper of two; the first of those as deep.
void keep_deeper(FaceCrossing& deepest, const FaceCrossing& other) {
  if (other.depth > deepest.depth) deepest = other;
}

class CrossingFinder {
 public:
  explicit CrossingFinder(const Model& model) : model_(model), facets_(model.facets()) {}

  std::vector<FaceCrossing> run() {
    const std::vector<Side> sides = all_sides();
    for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
      while (next < sides.size() && sides[next].low == sides[first].low &&
             sides[next].high == sides[first].high)
        ++next;
      look_along(std::span(sides).subspan(first, next - first));
    }
    std::vector<FaceCrossing> found;
    for (const auto& [faces, piercings] : piercings_) {
      const FaceCrossing crossing = faces[0] == faces[1] ? deepest_of_itself(faces[0], piercings)
                                                         : deepest_of(faces[0], faces[1], piercings);
      if (crossing.depth > 0.0) found.push_back(crossing);
    }
    return found;
  }

 private:
  /// A side of a facet, by its nodes.
  struct Side {
    std::uint32_t low = 0, high = 0, triangle = 0;
  };

  /// Each with the others of the same nodes: by the lower node, of which there are few. In this thread alone:
  /// crossings are looked for between two readings, and a process with more threads could not fork then.
  [[nodiscard]] std::vector<Side> all_sides() const {
    std::vector<Side> sides;
    sides.reserve(3 * facets_.triangles.size());
    for (std::uint32_t t = 0; t < facets_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(facets_.triangles[t][k], facets_.triangles[t][(k + 1) % 3]);
        sides.push_back({low, high, t});
      }
    bucket_sort(
        sides, facets_.nodes.size(), [](const Side& side) { return side.low; },
        [](const Side& a, const Side& b) {
          return std::pair(a.high, a.triangle) < std::pair(b.high, b.triangle);
        },
        Sorting::kOneThread);
    return sides;
  }

  /// `sides`: one side, once for each facet that has it.
  void look_along(std::span<const Side> sides) {
    const std::uint32_t a = sides.front().low, b = sides.front().high;
    const Vec3 &p = facets_.nodes[a], &q = facets_.nodes[b];
    const auto look_at = [&](std::uint32_t u) {
      const auto& corners = facets_.triangles[u];
      for (const std::uint32_t c : corners)
        if (c == a || c == b) return;
      const std::optional<Vec3> at = piercing(p, q, facet_corners(facets_, u));
      if (!at) return;
      for (const Side& side : sides) {
        const int f = facets_.face[side.triangle], g = facets_.face[u];
        if (f != g || is_free_form(f))
          piercings_[{std::min(f, g), std::max(f, g)}].push_back({side.triangle, u, *at});
      }
    };
    const int face = facets_.face[sides.front().triangle];
    const bool within_face = std::all_of(
        sides.begin(), sides.end(), [&](const Side& side) { return facets_.face[side.triangle] == face; });
    model_.bvh().visit_segment(p, q, look_at, within_face && !is_free_form(face) ? face : 0);
  }

  /// Others cross themselves nowhere, but for tori through their own axis (geom/occt/pinched_faces).
  [[nodiscard]] bool is_free_form(int face) const {
    const std::string_view kind = model_.surface(face).kind();
    return std::none_of(kClosedForms.begin(), kClosedForms.end(),
                        [&](std::string_view form) { return kind == form; });
  }

  /// Where a segment goes through a triangle, its corners and sides included.
  static std::optional<Vec3> piercing(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& c) {
    const Vec3 d = q - p, e1 = c[1] - c[0], e2 = c[2] - c[0], h = d.cross(e2), s = p - c[0], r = s.cross(e1);
    const double det = e1.dot(h);
    if (det == 0.0) return std::nullopt;
    const double u = s.dot(h) / det, v = d.dot(r) / det, at = e2.dot(r) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || at < 0.0 || at > 1.0) return std::nullopt;
    return p + at * d;
  }

  /// The middle of what two triangles have in common, a segment with an end at `end`. An end on the face's
  /// own edge proves nothing, and where faces are large facets all ends may be on edges.
  [[nodiscard]] Vec3 middle_of_common(std::uint32_t t, std::uint32_t u, const Vec3& end) const {
    const std::array<Vec3, 3> c = facet_corners(facets_, t), d = facet_corners(facets_, u);
    const Vec3 n = (c[1] - c[0]).cross(c[2] - c[0]), m = (d[1] - d[0]).cross(d[2] - d[0]), way = n.cross(m);
    if (way.squaredNorm() == 0.0) return end;
    double from = -std::numeric_limits<double>::infinity(), to = -from;
    clip(c, n, end, way, from, to);
    clip(d, m, end, way, from, to);
    return to > from && std::isfinite(to - from) ? Vec3(end + 0.5 * (from + to) * way) : end;
  }

  /// The part of the line end + s * way that lies in the triangle of normal n.
  static void clip(const std::array<Vec3, 3>& c, const Vec3& n, const Vec3& end, const Vec3& way,
                   double& from, double& to) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 inward = n.cross(c[(k + 1) % 3] - c[k]);
      const double height = inward.dot(end - c[k]), slope = inward.dot(way);
      if (slope > 0.0) from = std::max(from, -height / slope);
      if (slope < 0.0) to = std::min(to, -height / slope);
    }
  }

  /// Of piercings evenly among all, two places of each: where one proves nothing, those beside it may not,
  /// either.
  [[nodiscard]] FaceCrossing deepest_of(int f, int g, const std::vector<Piercing>& piercings) const {
    FaceCrossing deepest;
    const std::size_t tried = std::min(kTries / 2, piercings.size());
    for (std::size_t i = 0; i < tried; ++i) {
      const Piercing& p = piercings[i * piercings.size() / tried];
      for (const Vec3& seed : {p.place, middle_of_common(p.of, p.through, p.place)})
        keep_deeper(deepest, crossing_near(f, g, seed));
    }
    return deepest;
  }

  /// Of the piercings between which the face goes farthest away. Along the rims of a fold its sheets meet at
  /// no angle, and facets that pierce one another there prove nothing, as many as there are.
  [[nodiscard]] FaceCrossing deepest_of_itself(int face, const std::vector<Piercing>& piercings) const {
    constexpr int kPieces = 4;  // to put them in order
    std::vector<std::pair<double, std::size_t>> far;
    for (std::size_t i = 0; i < piercings.size(); ++i) {
      const Piercing& p = piercings[i];
      far.emplace_back(-way_between(face, uv_at(p.of, p.place), uv_at(p.through, p.place), p.place, kPieces),
                       i);
    }
    std::sort(far.begin(), far.end());
    far.resize(std::min(kTries, far.size()));
    FaceCrossing deepest;
    for (const auto& [way, i] : far) {
      const Piercing& p = piercings[i];
      keep_deeper(deepest,
                  crossing_of_itself(face, uv_at(p.of, p.place), uv_at(p.through, p.place), p.place));
    }
    return deepest;
  }

  /// (u,v) of a place on a facet.
  [[nodiscard]] Vec2 uv_at(std::uint32_t t, const Vec3& p) const {
    const std::array<Vec3, 3> c = facet_corners(facets_, t);
    const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
    const double b = (p - c[0]).cross(c[2] - c[0]).dot(normal) / normal.squaredNorm();
    const double d = (c[1] - c[0]).cross(p - c[0]).dot(normal) / normal.squaredNorm();
    const auto& uv = facets_.uv[t];
    return uv[0] + b * (uv[1] - uv[0]) + d * (uv[2] - uv[0]);
  }

  /// A place on two sheets.
  struct Meeting {
    Vec3 place = Vec3::Zero();
    Vec2 here = Vec2::Zero(), there = Vec2::Zero();  ///< (u,v) on either
    double sine = 0.0;                               ///< of their angle
  };

  /// Steps from p to the nearest point of the sheets' tangent planes at the feet of p on them. None where the
  /// sheets do not prove to cross, within f and g.
  template <class FootHere, class FootThere>
  [[nodiscard]] std::optional<Meeting> meeting(int f, int g, Vec3 p, const FootHere& foot_here,
                                               const FootThere& foot_there) const {
    constexpr int kSteps = 12;
    const double close = 4.0 * model_.tolerance();
    for (int step = 0; step < kSteps; ++step) {
      const FaceFoot a = foot_here(p), b = foot_there(p);
      if (!a.converged || !b.converged) return std::nullopt;
      const double cosine = a.normal.dot(b.normal), sine = a.normal.cross(b.normal).norm();
      if (sine < kLeastSine) return std::nullopt;
      if ((a.point - p).norm() <= close && (b.point - p).norm() <= close) {
        if (model_.face_side(f, a.uv) != TrimSide::kIn || model_.face_side(g, b.uv) != TrimSide::kIn)
          return std::nullopt;
        return Meeting{p, a.uv, b.uv, sine};
      }
      const double off_a = (a.point - p).dot(a.normal), off_b = (b.point - p).dot(b.normal);
      const double det = 1.0 - cosine * cosine;
      p += ((off_a - cosine * off_b) / det) * a.normal + ((off_b - cosine * off_a) / det) * b.normal;
    }
    return std::nullopt;
  }

  /// Depth 0: the surfaces do not prove to cross.
  [[nodiscard]] FaceCrossing crossing_near(int f, int g, const Vec3& seed) const {
    const auto met = meeting(
        f, g, seed, [&](const Vec3& p) { return model_.face_project(f, p); },
        [&](const Vec3& p) { return model_.face_project(g, p); });
    if (!met) return {{f, g}, seed, 0.0};
    const Vec3& p = met->place;
    return {
        {f, g}, p, std::min(clear_of_edges(f, p, met->sine), clear_of_edges(g, p, met->sine)) * met->sine};
  }

  /// The same from two places of one face. It goes no deeper than the part of the face between the two
  /// reaches away, along the straight way in (u,v): a fold may be far from all edges, and small.
  [[nodiscard]] FaceCrossing crossing_of_itself(int face, Vec2 here, Vec2 there, const Vec3& seed) const {
    const auto follow = [&](Vec2& uv) {
      return [this, face, &uv](const Vec3& p) {
        const FaceFoot foot = model_.face_project(face, p, uv);
        uv = foot.uv;
        return foot;
      };
    };
    const auto met = meeting(face, face, seed, follow(here), follow(there));
    if (!met) return {{face, face}, seed, 0.0};
    constexpr int kPieces = 32;
    const double depth = std::min(clear_of_edges(face, met->place, met->sine),
                                  way_between(face, met->here, met->there, met->place, kPieces));
    return {{face, face}, met->place, depth * met->sine};
  }

  /// How far the face goes away from p between two places that are both there.
  [[nodiscard]] double way_between(int face, const Vec2& here, const Vec2& there, const Vec3& p,
                                   int pieces) const {
    double most = 0.0;
    for (int i = 1; i < pieces; ++i)
      most = std::max(most, (model_.face_jet(face, here + (there - here) * i / pieces, 0).p - p).norm());
    return most;
  }

  /// Distance to the face's edges, 0 where they are so near that their own gaps may be what crosses.
  [[nodiscard]] double clear_of_edges(int face, const Vec3& p, double sine) const {
    double least = model_.diagonal();
    for (const FaceBoundary& b : model_.face(face).boundary) {
      const double distance = model_.edge_closest(b.edge, p).distance;
      const double gap = 4.0 * (model_.edge(b.edge).tolerance + model_.face(face).tolerance) / sine;
      if (distance <= gap) return 0.0;
      least = std::min(least, distance);
    }
    return least;
  }

  const Model& model_;
  const Facets& facets_;
  std::map<std::array<int, 2>, std::vector<Piercing>> piercings_;
};

}  // namespace

const std::vector<FaceCrossing>& Model::crossings() const {
  std::call_once(data_->crossings_begun, [this] { data_->crossings = CrossingFinder(*this).run(); });
  return data_->crossings;
}

}  // namespace octet
