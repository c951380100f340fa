// SPDX-License-Identifier: BSD-3-Clause
// Segment against the model: facets find the faces, exact kernels give the roots, edges and vertices
// gather the events that several faces report.
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geom/facet_trim.h"
#include "geom/model_data.h"

namespace octet {
namespace {

struct Segment {
  Vec3 p, d;
  double length;
  [[nodiscard]] Vec3 at(double t) const { return p + t * d; }
  [[nodiscard]] double foot(const Vec3& x) const {
    return std::clamp((x - p).dot(d) / d.squaredNorm(), 0.0, 1.0);
  }
};

/// An event on an edge or vertex, with what the faces around it said.
struct JointEvent {
  ModelRef on;
  double t = 0.0;
  Vec3 point = Vec3::Zero();
  double edge_t = 0.0;
  int face = 0;
  Vec2 uv = Vec2::Zero();
  Vec3 normal = Vec3::Zero();
  bool forth = false, back = false;  ///< some face is crossed along / against its normal
  bool grazed = false;               ///< some face is crossed nearly along its tangent plane
};

struct Chord {
  Vec3 a, b;
};

/// Whether the chord's box is farther than `reach` from the box low..high along some axis.
bool boxes_apart(const Chord& c, const Vec3& low, const Vec3& high, double reach) {
  return ((c.a.cwiseMax(c.b) - low).array() < -reach).any() ||
         ((c.a.cwiseMin(c.b) - high).array() > reach).any();
}

bool within(const Vec3& a, const Vec3& b, double reach) { return (a - b).squaredNorm() <= reach * reach; }

/// Nearest parameters of a segment and a chord [Ericson 2005, 5.1.9].
std::pair<double, double> nearest_parameters(const Segment& s, const Chord& c) {
  const Vec3 e = c.b - c.a, r = s.p - c.a;
  const double a = s.d.squaredNorm(), ee = e.squaredNorm(), f = e.dot(r), g = s.d.dot(r), b = s.d.dot(e);
  if (ee == 0.0) return {std::clamp(-g / a, 0.0, 1.0), 0.0};
  const double denominator = a * ee - b * b;
  double t = denominator > 1e-14 * a * ee ? std::clamp((b * f - g * ee) / denominator, 0.0, 1.0) : 0.0;
  double u = (b * t + f) / ee;
  if (u < 0.0 || u > 1.0) {
    u = std::clamp(u, 0.0, 1.0);
    t = std::clamp((b * u - g) / a, 0.0, 1.0);
  }
  return {t, u};
}

}  // namespace

/// One intersection query: the state shared by its steps.
class SegmentQuery {
 public:
  SegmentQuery(const Model::Data& data, const Vec3& p, const Vec3& q)
      : data_(data), segment_{p, q - p, (q - p).norm()}, low_(p.cwiseMin(q)), high_(p.cwiseMax(q)) {}

  /// `doubtful` gets the indices of hits whose kind does not follow from the faces' normals.
  void run(std::vector<Hit>& hits, std::vector<std::size_t>& doubtful) {
    if (!(segment_.length > 0.0)) return;
    find_triangles();
    if (triangles_.empty()) return;
    const std::size_t first = hits.size();
    meet_edges();
    for (std::size_t begin = 0, end = 0; begin < triangles_.size(); begin = end) {
      const int face = data_.facets().face[triangles_[begin]];
      while (end < triangles_.size() && data_.facets().face[triangles_[end]] == face) ++end;
      meet_face(face, std::span(triangles_).subspan(begin, end - begin), hits);
    }
    const std::size_t on_faces = hits.size();
    for (JointEvent& joint : joints_)
      if (joint.face != 0 || !stands_for_another(joint, std::span(hits).subspan(first, on_faces - first)))
        hits.push_back(joint_hit(joint));
    std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), [](const Hit& a, const Hit& b) {
      if (a.t != b.t) return a.t < b.t;
      return a.on != b.on ? a.on < b.on : a.face < b.face;
    });
    for (std::size_t i = first; i < hits.size(); ++i) {
      const bool chance =
          hits[i].kind == HitKind::kCoincident && hits[i].on.dim < 2 && !runs_in_face_beside(hits, first, i);
      if (chance) hits[i].kind = HitKind::kTangent;
      if (is_doubtful(hits[i])) doubtful.push_back(i);
    }
  }

 private:
  [[nodiscard]] Chord chord(const BorderSide& side) const {
    return {data_.facets().nodes[side.a], data_.facets().nodes[side.b]};
  }

  /// Face by face.
  void find_triangles() {
    const FacetBvh& bvh = data_.bvh;
    const Vec3 q = segment_.at(1.0);
    const FacetBvh::Probe probe(segment_.p, q);
    const bool few = data_.grid().visit_segment(segment_.p, q, [&](std::uint32_t item) {
      if (bvh.item_meets(item, probe)) triangles_.push_back(bvh.triangle(item));
    });
    if (!few) bvh.visit_segment(segment_.p, q, [&](std::uint32_t t) { triangles_.push_back(t); });
    std::sort(triangles_.begin(), triangles_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const int fa = data_.facets().face[a], fb = data_.facets().face[b];
      return fa != fb ? fa < fb : a < b;
    });
    triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
  }

  /// Edges that pass the segment within their tolerance, whether or not a face has a root there: so a
  /// segment through a crack between two faces is an event too.
  void meet_edges() {
    for (const std::uint32_t triangle : triangles_) {
      for (int k = 0; k < 3; ++k) {
        const std::int32_t side = data_.border.of_triangle[triangle][k];
        if (side >= 0 && std::find(sides_.begin(), sides_.end(), side) == sides_.end()) {
          sides_.push_back(side);
          meet_edge(data_.border.sides[side]);
        }
        const std::int32_t v = data_.border.node_vertex[data_.facets().triangles[triangle][k]];
        if (v > 0) meet_vertex(v);
      }
    }
  }

  void meet_vertex(int v) {
    const Vec3& x = data_.parts.vertices[v].point;
    const double t = segment_.foot(x);
    if ((segment_.at(t) - x).norm() <= data_.vertex_reach(v)) joint_at({0, v}, t, x, 0.0);
  }

  void meet_edge(const BorderSide& side) {
    const Chord c = chord(side);
    if (boxes_apart(c, low_, high_, side.reach)) return;
    const double reach = data_.edge_reach(side.edge);
    const auto [t, u] = nearest_parameters(segment_, c);
    const double apart = (segment_.at(t) - (c.a + u * (c.b - c.a))).norm();
    if (apart > side.reach) return;
    const Vec3 e = c.b - c.a;
    const double sine = segment_.d.cross(e).norm() / (segment_.length * e.norm());
    if (sine * std::min(segment_.length, e.norm()) <= reach) {
      // The segment runs along the edge: both ends of the common stretch.
      for (const double end : {segment_.foot(c.a), segment_.foot(c.b)}) refine(side, end, reach);
    } else {
      refine(side, t, reach);
    }
  }

  /// Alternating projection from parameter t of the segment onto the curve and back.
  void refine(const BorderSide& side, double t, double reach) {
    const Curve& curve = data_.curve(side.edge);
    double hint = side.t;
    Vec3 on_curve = Vec3::Zero();
    for (int i = 0; i < 24; ++i) {
      hint = curve.project(segment_.at(t), hint);
      on_curve = curve.point(hint);
      const double next = crossing(curve, hint, on_curve);
      if (std::abs(next - t) * segment_.length <= 0.01 * data_.tolerance) {
        t = next;
        break;
      }
      t = next;
    }
    if ((segment_.at(t) - on_curve).norm() > reach) return;
    joint_on_edge(side.edge, hint, t, on_curve);
  }

  /// Parameter of the segment nearest to the curve's tangent line at `x`: converges faster than the foot.
  [[nodiscard]] double crossing(const Curve& curve, double edge_t, const Vec3& x) const {
    const Vec3 tangent = curve.derivative(edge_t);
    const double tt = tangent.squaredNorm(), dd = segment_.d.squaredNorm(), dt = segment_.d.dot(tangent);
    const double denominator = dd * tt - dt * dt;
    if (denominator <= 1e-6 * dd * tt) return segment_.foot(x);
    const Vec3 r = segment_.p - x;
    const double t = (dt * tangent.dot(r) - segment_.d.dot(r) * tt) / denominator;
    return std::clamp(t, 0.0, 1.0);
  }

  /// The event of edge e there, or of the vertex at its end when that is within tolerance.
  JointEvent& joint_on_edge(int e, double edge_t, double t, const Vec3& point) {
    for (const int v : data_.parts.edges[e].vertex) {
      const Vec3& x = data_.parts.vertices[v].point;
      if ((point - x).norm() <= data_.vertex_reach(v)) return joint_at({0, v}, segment_.foot(x), x, 0.0);
    }
    return joint_at({1, e}, t, point, edge_t);
  }

  JointEvent& joint_at(ModelRef on, double t, const Vec3& point, double edge_t) {
    const double reach = on.dim == 0 ? data_.vertex_reach(on.tag) : data_.edge_reach(on.tag);
    for (JointEvent& joint : joints_)
      if (joint.on == on && (joint.point - point).norm() <= 4.0 * reach) return joint;
    JointEvent joint;
    joint.on = on;
    joint.t = t;
    joint.point = point;
    joint.edge_t = edge_t;
    joints_.push_back(joint);
    return joints_.back();
  }

  void meet_face(int face, std::span<const std::uint32_t> triangles, std::vector<Hit>& hits) {
    roots_.clear();
    // A little longer at both ends, so that a root at an end is found whatever the rounding.
    const double extra = data_.tolerance / segment_.length;
    data_.surface(face).intersect(segment_.at(-extra), segment_.at(1.0 + extra), roots_);
    for (const SurfaceRoot& root : roots_) {
      if (root.coincident && (coincident_.empty() || coincident_.back() != face)) coincident_.push_back(face);
      const double t = std::clamp(root.t * (1.0 + 2.0 * extra) - extra, 0.0, 1.0);
      place_root(face, triangles, root, t, hits);
    }
  }

  void place_root(int face, std::span<const std::uint32_t> triangles, const SurfaceRoot& root, double t,
                  std::vector<Hit>& hits) {
    const Vec3 x = segment_.at(t);
    if (JointEvent* joint = joint_near(x, triangles)) {
      gather(*joint, face, root, triangles.front());
      return;
    }
    if (!in_face(face, x, root.uv, triangles)) return;
    Hit hit;
    hit.t = t;
    hit.point = x;
    hit.on = model_face(face);
    hit.face = face;
    hit.uv = root.uv;
    hit.normal = data_.normal(face, root.uv, triangles.front());
    hit.kind = root.coincident ? HitKind::kCoincident
               : root.tangent  ? HitKind::kTangent
                               : HitKind::kTransversal;
    hit.end_point = at_end(t);
    hits.push_back(hit);
  }

  [[nodiscard]] bool in_face(int face, const Vec3& x, const Vec2& uv,
                             std::span<const std::uint32_t> triangles) const {
    const auto id = [](std::uint32_t t) { return t; };
    if (clearly_in_facets(data_, x, uv, triangles.begin(), triangles.end(), id)) return true;
    const TrimSide side = data_.parts.trims[face]->side(uv);
    return side == TrimSide::kIn || (side == TrimSide::kOn && left_of_border(face, x, triangles));
  }

  /// The edge or vertex event within whose tolerance x lies, among those of the triangles.
  JointEvent* joint_near(const Vec3& x, std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t triangle : triangles) {
      for (int k = 0; k < 3; ++k) {
        const std::int32_t v = data_.border.node_vertex[data_.facets().triangles[triangle][k]];
        if (v > 0 && within(data_.parts.vertices[v].point, x, data_.vertex_reach(v))) {
          const Vec3& point = data_.parts.vertices[v].point;
          return &joint_at({0, v}, segment_.foot(point), point, 0.0);
        }
      }
    }
    for (const std::uint32_t triangle : triangles) {
      for (const std::int32_t s : data_.border.of_triangle[triangle]) {
        if (s < 0) continue;
        const BorderSide& side = data_.border.sides[s];
        const double reach = data_.edge_reach(side.edge);
        if (boxes_apart(chord(side), x, x, side.reach) || chord_distance(data_, side, x) > side.reach)
          continue;
        const double edge_t = data_.curve(side.edge).project(x, side.t);
        const Vec3 on_curve = data_.curve(side.edge).point(edge_t);
        if ((on_curve - x).norm() <= reach)
          return &joint_on_edge(side.edge, edge_t, segment_.foot(on_curve), on_curve);
      }
    }
    return nullptr;
  }

  /// The trim cannot tell: the side of the nearest edge in space does. Without an edge nearby the border is
  /// a seam, and x is in.
  [[nodiscard]] bool left_of_border(int face, const Vec3& x, std::span<const std::uint32_t> triangles) const {
    const BorderSide* nearest = nullptr;
    double best = 0.0;
    for (const std::uint32_t triangle : triangles)
      for (const std::int32_t s : data_.border.of_triangle[triangle]) {
        if (s < 0) continue;
        const double d = chord_distance(data_, data_.border.sides[s], x);
        if (nearest != nullptr && d >= best) continue;
        nearest = &data_.border.sides[s];
        best = d;
      }
    if (nearest == nullptr) return true;
    int sense = 0;
    for (const FaceBoundary& b : data_.parts.faces[face].boundary)
      if (b.edge == nearest->edge) sense += b.sense;
    if (sense == 0) return true;  // a slit: the face lies on both sides
    const Curve& curve = data_.curve(nearest->edge);
    const double t = curve.project(x, nearest->t);
    const Vec3 left = data_.facet_normal(triangles.front()).cross(curve.derivative(t));
    return (x - curve.point(t)).dot(left) * sense >= 0.0;
  }

  void gather(JointEvent& joint, int face, const SurfaceRoot& root, std::uint32_t triangle) const {
    const Vec3 normal = data_.normal(face, root.uv, triangle);
    if (joint.face == 0) {
      joint.face = face;
      joint.uv = root.uv;
      joint.normal = normal;
    }
    note_direction(joint, normal);
  }

  void note_direction(JointEvent& joint, const Vec3& normal) const {
    constexpr double kGrazing = 1e-6;
    const double along = normal.dot(segment_.d);
    joint.forth |= along > 0.0;
    joint.back |= along < 0.0;
    joint.grazed |= std::abs(along) <= kGrazing * segment_.length;
  }

  /// At a vertex, at an edge of more or less than two faces, or where a face is grazed.
  [[nodiscard]] bool is_doubtful(const Hit& hit) const {
    if (hit.on.dim == 2 || hit.kind == HitKind::kCoincident || hit.end_point) return false;
    if (hit.on.dim == 0 || data_.parts.edges[hit.on.tag].faces.size() != 2) return true;
    return std::any_of(joints_.begin(), joints_.end(),
                       [&](const JointEvent& j) { return j.grazed && j.on == hit.on && j.t == hit.t; });
  }

  /// Whether an event that no face reported is a face's hit nearby, seen again within the tolerance.
  [[nodiscard]] bool stands_for_another(const JointEvent& joint, std::span<const Hit> on_faces) const {
    const double reach =
        joint.on.dim == 0 ? data_.vertex_reach(joint.on.tag) : data_.edge_reach(joint.on.tag);
    return std::any_of(on_faces.begin(), on_faces.end(), [&](const Hit& hit) {
      const ModelFace& face = data_.parts.faces[hit.face];
      const bool around = joint.on.dim == 0
                              ? std::binary_search(face.vertices.begin(), face.vertices.end(), joint.on.tag)
                              : std::any_of(face.boundary.begin(), face.boundary.end(),
                                            [&](const FaceBoundary& b) { return b.edge == joint.on.tag; });
      return around && (hit.point - joint.point).norm() <= 4.0 * reach;
    });
  }

  /// Whether the segment runs within the surface of a face around the edge or vertex.
  [[nodiscard]] bool runs_in_a_face(ModelRef on) const {
    return std::any_of(coincident_.begin(), coincident_.end(), [&](int face) {
      const auto& around = on.dim == 1 ? data_.parts.edges[on.tag].faces : data_.parts.faces[face].vertices;
      return std::binary_search(around.begin(), around.end(), on.dim == 1 ? face : on.tag);
    });
  }

  /// Whether a face whose surface holds the segment reaches to the next or the last event: it may also touch
  /// the segment's line in the event alone.
  [[nodiscard]] bool runs_in_face_beside(const std::vector<Hit>& hits, std::size_t first,
                                         std::size_t i) const {
    const double last = i > first ? hits[i - 1].t : 0.0, next = i + 1 < hits.size() ? hits[i + 1].t : 1.0;
    for (const double t : {0.5 * (last + hits[i].t), 0.5 * (hits[i].t + next)}) {
      const Vec3 x = segment_.at(t);
      for (const int face : coincident_) {
        const SurfaceFoot foot = data_.surface(face).project(x, hits[i].uv);
        if (data_.parts.trims[face]->side(foot.uv) != TrimSide::kOut) return true;
      }
    }
    return false;
  }

  /// At an edge of two faces the segment crosses from region to region when it goes the same way through
  /// both, and touches otherwise, at convex and at concave edges alike. Where more faces meet the kind is a
  /// hint in the same sense.
  Hit joint_hit(JointEvent& joint) const {
    if (joint.on.dim == 1) {
      for (const int face : data_.parts.edges[joint.on.tag].faces) look_at(joint, face);
    } else if (joint.face == 0) {
      for (const std::uint32_t triangle : triangles_) {
        const int face = data_.facets().face[triangle];
        const auto& vertices = data_.parts.faces[face].vertices;
        if (std::binary_search(vertices.begin(), vertices.end(), joint.on.tag)) look_at(joint, face);
      }
    }
    Hit hit;
    hit.t = joint.t;
    hit.point = joint.point;
    hit.on = joint.on;
    hit.face = joint.face;
    hit.uv = joint.uv;
    hit.normal = joint.normal;
    hit.kind = runs_in_a_face(joint.on)    ? HitKind::kCoincident
               : joint.forth == joint.back ? HitKind::kTangent
                                           : HitKind::kTransversal;
    hit.end_point = at_end(joint.t);
    return hit;
  }

  void look_at(JointEvent& joint, int face) const {
    std::uint32_t triangle = 0;
    const auto mine = std::find_if(triangles_.begin(), triangles_.end(),
                                   [&](std::uint32_t t) { return data_.facets().face[t] == face; });
    if (mine != triangles_.end()) {
      triangle = *mine;
    } else if (const auto near = data_.bvh.nearest(joint.point, data_.diagonal, face)) {
      triangle = near->triangle;
    } else {
      return;
    }
    const Vec2 uv = data_.surface(face).project(joint.point, data_.seed(triangle)).uv;
    const Vec3 normal = data_.normal(face, uv, triangle);
    if (joint.face == 0) {
      joint.face = face;
      joint.uv = uv;
      joint.normal = normal;
    }
    note_direction(joint, normal);
  }

  [[nodiscard]] bool at_end(double t) const {
    return std::min(t, 1.0 - t) * segment_.length <= data_.tolerance;
  }

  const Model::Data& data_;
  Segment segment_;
  Vec3 low_, high_;  ///< the segment's box
  std::vector<std::uint32_t> triangles_;
  std::vector<std::int32_t> sides_;
  std::vector<JointEvent> joints_;
  std::vector<SurfaceRoot> roots_;
  std::vector<int> coincident_;  ///< faces whose surface holds the segment
};

void intersect_unsettled(const Model::Data& data, const Vec3& p, const Vec3& q, std::vector<Hit>& hits) {
  std::vector<std::size_t> doubtful;
  SegmentQuery(data, p, q).run(hits, doubtful);
}

/// A doubtful event crosses when the regions before and behind it differ: asked half way to its neighbours,
/// far from the boundary.
void Model::intersect(const Vec3& p, const Vec3& q, std::vector<Hit>& hits) const {
  make_grid_once();
  const std::size_t first = hits.size();
  std::vector<std::size_t> doubtful;
  SegmentQuery(*data_, p, q).run(hits, doubtful);
  const double least = 8.0 * data_->tolerance / std::max((q - p).norm(), data_->tolerance);
  for (const std::size_t i : doubtful) {
    const bool has_last = i > first, has_next = i + 1 < hits.size();
    if ((has_last && hits[i - 1].kind == HitKind::kCoincident) ||
        (has_next && hits[i + 1].kind == HitKind::kCoincident))
      continue;
    const double last = has_last ? hits[i - 1].t : 0.0, next = has_next ? hits[i + 1].t : 1.0;
    if (hits[i].t - last <= least || next - hits[i].t <= least) continue;
    const int before = region_at(p + 0.5 * (last + hits[i].t) * (q - p));
    const int behind = region_at(p + 0.5 * (hits[i].t + next) * (q - p));
    hits[i].kind = before == behind ? HitKind::kTangent : HitKind::kTransversal;
  }
}

}  // namespace octet
