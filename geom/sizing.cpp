// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself asks for smaller elements: turning edges and faces, short edges, close edges.
#include "geom/sizing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "geom/facet_bvh.h"
#include "geom/size_wishes.h"

namespace octet {
namespace {

/// An edge walked in steps: points, parameters and chord lengths.
struct EdgeWalk {
  int edge = 0;
  std::vector<double> t;
  std::vector<Vec3> point, tangent;
};

EdgeWalk walk_edge(const Model& model, int tag, double step) {
  const ModelEdge& edge = model.edge(tag);
  const bool straight = std::string_view(model.curve(tag).kind()) == "line";
  const int least = straight ? 8 : 24;
  const int n = std::clamp(static_cast<int>(std::ceil(edge.length / step)), least, 4096);
  EdgeWalk walk;
  walk.edge = tag;
  for (int i = 0; i <= n; ++i) {
    const double t = i == n ? edge.t1 : edge.t0 + (edge.t1 - edge.t0) * i / n;
    walk.t.push_back(t);
    walk.point.push_back(model.edge_point(tag, t));
    const Vec3 d = model.edge_derivative(tag, t);
    const double speed = d.norm();
    walk.tangent.push_back(speed > 0.0 ? Vec3(d / speed) : Vec3::Zero());
  }
  return walk;
}

/// A curve's distance from its chord, as a multiple of that in its middle.
constexpr double kSagitta = 1.5;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// All walks as a hierarchy of chords, to find the nearest edge that is no neighbour: one that shares a
/// vertex, or comes nearer than `touching` somewhere.
class ChordIndex {
 public:
  ChordIndex(const Model& model, const std::vector<EdgeWalk>& walks, double touching)
      : model_(model), touched_(static_cast<std::size_t>(model.count(1)) + 1) {
    Facets chords;
    std::vector<double> sagittas;
    for (const EdgeWalk& walk : walks)
      for (std::size_t i = 0; i + 1 < walk.point.size(); ++i) {
        const auto n = static_cast<std::uint32_t>(chords.nodes.size());
        const Vec3 &from = walk.point[i], &to = walk.point[i + 1];
        const double middle = 0.5 * (walk.t[i] + walk.t[i + 1]);
        chords.nodes.push_back(from);
        chords.nodes.push_back(to);
        chords.triangles.push_back({n, n + 1, n + 1});
        chords.face.push_back(1);
        chord_.push_back({walk.edge, middle});
        sagittas.push_back(kSagitta * (model.edge_point(walk.edge, middle) - 0.5 * (from + to)).norm());
      }
    bvh_ = FacetBvh(chords, sagittas, 1);
    for (const EdgeWalk& walk : walks)
      for (const Vec3& p : walk.point) find_touched(walk.edge, p, touching);
  }

  /// Distance from p to the nearest edge that is no neighbour of `edge`, infinite beyond `limit`.
  [[nodiscard]] double gap(int edge, const Vec3& p, double limit) const {
    const auto stranger = [&](std::uint32_t c) { return !neighbours(edge, chord_[c].edge); };
    const auto near = bvh_.nearest_if(p, limit, 0, stranger);
    if (!near) return std::numeric_limits<double>::infinity();
    const Chord& c = chord_[near->triangle];
    return std::min(near->distance, model_.edge_project(c.edge, p, c.t).distance);
  }

 private:
  struct Chord {
    int edge;
    double t;
  };
  [[nodiscard]] bool neighbours(int a, int b) const {
    if (a == b) return true;
    for (const int v : model_.edge(a).vertex)
      for (const int w : model_.edge(b).vertex)
        if (v == w) return true;
    const std::vector<int>& touched = touched_[static_cast<std::size_t>(a)];
    return std::binary_search(touched.begin(), touched.end(), b);
  }
  void find_touched(int edge, const Vec3& p, double touching) {
    bvh_.visit_within(p, touching, 0, [&](const FacetFoot& foot) {
      const Chord& chord = chord_[foot.triangle];
      if (neighbours(edge, chord.edge)) return;
      if (model_.edge_project(chord.edge, p, chord.t).distance >= touching) return;
      add_touched(edge, chord.edge);
      add_touched(chord.edge, edge);
    });
  }
  void add_touched(int edge, int other) {
    std::vector<int>& touched = touched_[static_cast<std::size_t>(edge)];
    touched.insert(std::lower_bound(touched.begin(), touched.end(), other), other);
  }

  const Model& model_;
  FacetBvh bvh_;
  std::vector<Chord> chord_;
  std::vector<std::vector<int>> touched_;  ///< per edge: those that come near and share no vertex, ascending
};

/// Edges nearer than this share of the smallest size touch, and shorter ones are no edges worth a size: what
/// stands on a step so narrow is flat at any size above the smallest, and there is the more of it the finer
/// the octants are.
constexpr double kUnresolved = 1.0 / 32.0;

/// Turning per length between the steps gives the curvature without second derivatives, kinks included.
double turning_size(const EdgeWalk& walk, std::size_t step, double angle) {
  const double turn = angle_between(walk.tangent[step], walk.tangent[step + 1]);
  const double length = (walk.point[step + 1] - walk.point[step]).norm();
  return turn > 1e-9 ? angle * length / turn : std::numeric_limits<double>::infinity();
}

/// What is wished for between two steps of a walk, and why.
struct StepWish {
  double size;
  SizeReason why;
  void lower_to(double other, SizeReason reason) {
    if (other >= size) return;
    size = other;
    why = reason;
  }
};

void wish_along(const Model& model, const EdgeWalk& walk, const ChordIndex& index,
                const SizingOptions& options, Wishes& wishes) {
  const ModelEdge& edge = model.edge(walk.edge);
  const bool has_length = edge.vertex[0] != edge.vertex[1] && options.edge_share > 0.0 &&
                          edge.length >= kUnresolved * options.min_size;
  const auto gap_at = [&](std::size_t i) {
    if (!(options.edge_gap_elements > 0.0)) return std::numeric_limits<double>::infinity();
    const double limit = options.size * options.edge_gap_elements;
    return index.gap(walk.edge, walk.point[i], limit) / options.edge_gap_elements;
  };
  double gap = gap_at(0);
  for (std::size_t i = 0; i + 1 < walk.point.size(); ++i) {
    const double next_gap = gap_at(i + 1);
    StepWish wish{options.size, SizeReason::kGlobal};
    if (has_length) wish.lower_to(options.edge_share * edge.length, SizeReason::kShortEdge);
    wish.lower_to(std::min(gap, next_gap), SizeReason::kEdgeGap);
    if (options.curvature_angle > 0.0)
      wish.lower_to(std::max(turning_size(walk, i, options.curvature_angle), options.curvature_floor),
                    SizeReason::kCurvature);
    gap = next_gap;
    wish_on_edge(model, walk.edge, walk.t[i], walk.t[i + 1], wish.size, {model_edge(walk.edge), wish.why},
                 wishes);
  }
}

/// The largest turning per length from the corners of a facet to the middles of its sides, and from there to
/// its own; 0 when it turns by less than 0.03 radians in all. Facets are 1/2000 of the diagonal off or nearer
/// (geom/occt/tessellate), and on a radius where an element of the part's size would turn too much they turn
/// by more.
double turning_rate(const Model& model, int face, const std::array<Vec2, 3>& corners) {
  constexpr double kFlat = 0.03;
  struct Place {
    Vec3 point, normal;
  };
  const Surface& surface = model.surface(face);
  const auto at = [&](const Vec2& uv) { return Place{surface.evaluate(uv, 0).p, surface.normal(uv)}; };
  double all = 0.0, largest = 0.0;
  const auto add = [&](const Place& a, const Place& b) {
    if (a.normal.isZero() || b.normal.isZero()) return;
    const double turn = angle_between(a.normal, b.normal);
    const double length = (a.point - b.point).norm();
    all += turn;
    if (length > 0.0) largest = std::max(largest, turn / length);
  };
  const Place centre = at((corners[0] + corners[1] + corners[2]) / 3.0);
  const std::array<Place, 3> corner{at(corners[0]), at(corners[1]), at(corners[2])};
  for (std::size_t k = 0; k < 3; ++k) {
    const Place middle = at(0.5 * (corners[k] + corners[(k + 1) % 3]));
    add(corner[k], middle);
    add(middle, corner[(k + 1) % 3]);
    add(middle, centre);
  }
  return all < 2.0 * kFlat ? 0.0 : largest;
}

/// Of faces at nodes of their facets: the facets around a node ask for the same.
class NodeCurvatures {
 public:
  explicit NodeCurvatures(const Model& model) : model_(model), known_(model.facets().nodes.size()) {}

  double at(int face, std::uint32_t node, const Vec2& uv) {
    Known& known = known_[node];
    if (known.face != face || known.uv != uv) known = {face, uv, model_.face_curvature(face, uv)};
    return known.curvature;
  }

 private:
  struct Known {
    int face = 0;
    Vec2 uv = Vec2::Zero();
    double curvature = 0.0;
  };
  const Model& model_;
  std::vector<Known> known_;
};

/// The curvature at the corners, the largest, but no more than twice what the facet turns; 0 where it is no
/// more than `least`. Beside a side of no length derivatives of a patch of splines are small and wrong: its
/// curvature was that of 1e-30 to 0.2 mm where it is flat to 0.001 radians, at places that depended on how
/// the part was turned.
double facet_curvature(const Model& model, std::size_t facet, double least, NodeCurvatures& curvatures) {
  constexpr double kBelieved = 2.0;
  const int face = model.facets().face[facet];
  const std::array<Vec2, 3>& corners = model.facets().uv[facet];
  double curvature = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    curvature = std::max(curvature, curvatures.at(face, model.facets().triangles[facet][k], corners[k]));
  if (curvature <= least) return 0.0;
  return std::min(curvature, kBelieved * turning_rate(model, face, corners));
}

void wish_on_faces(const Model& model, const SizingOptions& options, Wishes& wishes) {
  const Facets& facets = model.facets();
  const double least = options.curvature_angle / options.size;  // what asks for no more than the size
  NodeCurvatures curvatures(model);
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const int face = facets.face[i];
    if (model.is_plane(face)) continue;
    const double curvature = facet_curvature(model, i, least, curvatures);
    if (curvature > 0.0)
      wish_on_triangle(facet_corners(facets, i),
                       std::max(options.curvature_angle / curvature, options.curvature_floor),
                       {model_face(face), SizeReason::kCurvature}, wishes);
  }
}

/// Elements along the diagonal of a compact part, ten along the side of a cube; and of a small one of many: a
/// ball of that size loses 3 % of its volume.
constexpr double kAlongPart = 17.0, kAlongRegion = 12.0;

}  // namespace

std::vector<SizeSample> feature_sizes(const Model& model, const SizingOptions& options) {
  Wishes wishes(options.size, options.min_size);
  std::vector<EdgeWalk> walks;
  for (int e = 1; e <= model.count(1); ++e)
    if (model.edge(e).use == EdgeUse::kReal) walks.push_back(walk_edge(model, e, 0.5 * options.size));
  const ChordIndex index(model, walks, kUnresolved * options.min_size);
  for (const EdgeWalk& walk : walks) wish_along(model, walk, index, options, wishes);
  if (options.curvature_angle > 0.0) wish_on_faces(model, options, wishes);
  return wishes.take();
}

// Twice the volume over the surface is the thickness of a plate and a third of a cube's side. The size is
// that thickness, but no coarser than what compact parts get, and no finer than an 85th of the diagonal, so
// that a thin sheet costs no more than about a hundred elements each way.
double default_size(const Model& model) {
  double volume = 0.0, area = 0.0;
  for (int r = 1; r <= model.count(3); ++r) volume += std::abs(model.region(r).volume);
  for (int f = 1; f <= model.count(2); ++f) area += std::abs(model.face(f).area);
  const double coarsest = model.diagonal() / kAlongPart, finest = model.diagonal() / 85.0;
  return area > 0.0 ? std::clamp(2.3 * volume / area, finest, coarsest) : coarsest;
}

std::vector<double> default_region_sizes(const Model& model) {
  const Facets& facets = model.facets();
  std::vector<Box3> boxes(static_cast<std::size_t>(model.count(3)) + 1);
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const int region : model.face(facets.face[t]).region)
      for (const std::uint32_t node : facets.triangles[t]) boxes[region].add(facets.nodes[node]);
  std::vector<double> sizes;
  for (const Box3& box : boxes) sizes.push_back(box.diagonal() / kAlongRegion);
  return sizes;
}

}  // namespace octet
