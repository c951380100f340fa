// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself asks for smaller elements: turning edges and faces, short edges, close edges.
#include "geom/sizing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

#include "base/blocks.h"
#include "base/error.h"
#include "geom/facet_bvh.h"
#include "geom/size_wishes.h"

namespace octet {
namespace {

/// An edge walked in steps: points, parameters and unit tangents.
struct EdgeWalk {
  int edge = 0;
  std::vector<double> t;
  std::vector<Vec3> point, tangent;
};

/// Where the walk of an edge in n steps is after i of them.
double step_at(const ModelEdge& edge, std::size_t i, std::size_t n) {
  return i == n ? edge.t1 : edge.t0 + (edge.t1 - edge.t0) * static_cast<double>(i) / static_cast<double>(n);
}

EdgeWalk walk_edge(const Model& model, int tag, double step) {
  const ModelEdge& edge = model.edge(tag);
  const bool straight = std::string_view(model.curve(tag).kind()) == "line";
  const double least = straight ? 8.0 : 24.0;
  const auto n = static_cast<std::size_t>(std::clamp(std::ceil(edge.length / step), least, 4096.0));
  EdgeWalk walk;
  walk.edge = tag;
  for (std::size_t i = 0; i <= n; ++i) {
    const double t = step_at(edge, i, n);
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

/// Edges, chords and facets that one task works on: few, for what one costs varies.
constexpr std::size_t kEdgeBlock = 16, kChordBlock = 512, kFacetBlock = 1024;

/// map_blocks(), and between some blocks the question whether to go on, from the calling thread.
template <class Result, class Body>
std::vector<Result> map_asking(std::size_t n, std::size_t block, const SizingOptions& options,
                               const Body& body) {
  constexpr std::size_t kBlocksAQuestion = 16;
  std::vector<Result> all;
  for (std::size_t begin = 0; begin < n; begin += kBlocksAQuestion * block) {
    if (options.cancelled && options.cancelled()) throw Cancelled();
    const std::size_t size = std::min(kBlocksAQuestion * block, n - begin);
    for (Result& result : map_blocks<Result>(size, block, [&](std::size_t first, std::size_t last) {
           return body(begin + first, begin + last);
         }))
      all.push_back(std::move(result));
  }
  return all;
}

/// All walks as a hierarchy of chords, to find the nearest edge that is no neighbour: one that shares a
/// vertex, or comes nearer than `touching` somewhere.
class ChordIndex {
 public:
  ChordIndex(const Model& model, const std::vector<EdgeWalk>& walks, double touching)
      : model_(model), touched_(static_cast<std::size_t>(model.count(1)) + 1) {
    Facets chords;
    for (const EdgeWalk& walk : walks)
      for (std::size_t i = 0; i + 1 < walk.point.size(); ++i) {
        const auto n = static_cast<std::uint32_t>(chords.nodes.size());
        chords.nodes.push_back(walk.point[i]);
        chords.nodes.push_back(walk.point[i + 1]);
        chords.triangles.push_back({n, n + 1, n + 1});
        chords.face.push_back(1);
        chord_.push_back({walk.edge, 0.5 * (walk.t[i] + walk.t[i + 1])});
      }
    const auto sagittas = collect<double>(
        chord_.size(),
        [&](std::size_t c, std::vector<double>& list) {
          const Vec3 middle = 0.5 * (chords.nodes[2 * c] + chords.nodes[2 * c + 1]);
          list.push_back(kSagitta * (model.edge_point(chord_[c].edge, chord_[c].t) - middle).norm());
        },
        kChordBlock);
    bvh_ = FacetBvh(chords, sagittas, 1);
    const auto near = collect<std::array<int, 2>>(
        walks.size(),
        [&](std::size_t w, std::vector<std::array<int, 2>>& pairs) {
          find_touched(walks[w], touching, pairs);
        },
        kEdgeBlock);
    for (const auto& [edge, other] : near) {
      add_touched(edge, other);
      add_touched(other, edge);
    }
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
  /// True of an edge and itself, too.
  [[nodiscard]] bool share_vertex(int a, int b) const {
    if (a == b) return true;
    for (const int v : model_.edge(a).vertex)
      for (const int w : model_.edge(b).vertex)
        if (v == w) return true;
    return false;
  }
  [[nodiscard]] bool neighbours(int a, int b) const {
    if (share_vertex(a, b)) return true;
    const std::vector<int>& touched = touched_[static_cast<std::size_t>(a)];
    return std::binary_search(touched.begin(), touched.end(), b);
  }
  /// Appends the edge of the walk and another that comes near and shares no vertex, once for each.
  void find_touched(const EdgeWalk& walk, double touching, std::vector<std::array<int, 2>>& pairs) const {
    const auto own = pairs.size();
    for (const Vec3& p : walk.point)
      bvh_.visit_within(p, touching, 0, [&](const FacetFoot& foot) {
        const Chord& chord = chord_[foot.triangle];
        const std::array<int, 2> pair{walk.edge, chord.edge};
        if (share_vertex(walk.edge, chord.edge)) return;
        if (std::find(pairs.begin() + static_cast<std::ptrdiff_t>(own), pairs.end(), pair) != pairs.end())
          return;
        if (model_.edge_project(chord.edge, p, chord.t).distance < touching) pairs.push_back(pair);
      });
  }
  void add_touched(int edge, int other) {
    std::vector<int>& touched = touched_[static_cast<std::size_t>(edge)];
    const auto place = std::lower_bound(touched.begin(), touched.end(), other);
    if (place == touched.end() || *place != other) touched.insert(place, other);
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

/// What a walk tells of an edge, whatever is asked for about curvature: at each end of a step the size that
/// the nearest strange edge asks for, and of each step the turning and the length. Turning per length gives
/// the curvature without second derivatives, kinks included.
struct EdgeSteps {
  int edge = 0;
  std::vector<double> gap, turn, length;
};

EdgeSteps steps_of(const EdgeWalk& walk, const ChordIndex& index, const SizingOptions& options) {
  EdgeSteps steps;
  steps.edge = walk.edge;
  const double limit = options.size * options.edge_gap_elements;
  for (const Vec3& p : walk.point)
    steps.gap.push_back(options.edge_gap_elements > 0.0
                            ? index.gap(walk.edge, p, limit) / options.edge_gap_elements
                            : std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i + 1 < walk.point.size(); ++i) {
    steps.turn.push_back(angle_between(walk.tangent[i], walk.tangent[i + 1]));
    steps.length.push_back((walk.point[i + 1] - walk.point[i]).norm());
  }
  return steps;
}

std::vector<EdgeSteps> steps_of_edges(const Model& model, const SizingOptions& options) {
  std::vector<int> edges;
  for (int e = 1; e <= model.count(1); ++e)
    if (model.edge(e).use == EdgeUse::kReal) edges.push_back(e);
  const auto walks = map_asking<EdgeWalk>(edges.size(), 1, options, [&](std::size_t i, std::size_t /*next*/) {
    return walk_edge(model, edges[i], 0.5 * options.size);
  });
  const ChordIndex index(model, walks, kUnresolved * options.min_size);
  return map_asking<EdgeSteps>(walks.size(), 1, options, [&](std::size_t i, std::size_t /*next*/) {
    return steps_of(walks[i], index, options);
  });
}

void wish_along(const Model& model, const EdgeSteps& steps, const SizingOptions& options, Wishes& wishes) {
  const ModelEdge& edge = model.edge(steps.edge);
  const bool has_length = edge.vertex[0] != edge.vertex[1] && options.edge_share > 0.0 &&
                          edge.length >= kUnresolved * options.min_size;
  const std::size_t n = steps.length.size();
  for (std::size_t i = 0; i < n; ++i) {
    StepWish wish{options.size, SizeReason::kGlobal};
    if (has_length) wish.lower_to(options.edge_share * edge.length, SizeReason::kShortEdge);
    wish.lower_to(std::min(steps.gap[i], steps.gap[i + 1]), SizeReason::kEdgeGap);
    if (options.curvature_angle > 0.0 && steps.turn[i] > 1e-9)
      wish.lower_to(
          std::max(options.curvature_angle * steps.length[i] / steps.turn[i], options.curvature_floor),
          SizeReason::kCurvature);
    wish_on_edge(model, steps.edge, step_at(edge, i, n), step_at(edge, i + 1, n), wish.size,
                 {model_edge(steps.edge), wish.why}, wishes);
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

/// Of faces at nodes of their facets: the facets around a node ask for the same, one soon after the other.
class NodeCurvatures {
 public:
  explicit NodeCurvatures(const Model& model) : model_(model), known_(kKept) {}

  double at(int face, std::uint32_t node, const Vec2& uv) {
    Known& known = known_[node % kKept];
    if (known.face != face || known.uv != uv) known = {face, uv, model_.face_curvature(face, uv)};
    return known.curvature;
  }

 private:
  static constexpr std::uint32_t kKept = 2048;
  struct Known {
    int face = 0;
    Vec2 uv = Vec2::Zero();
    double curvature = 0.0;
  };
  const Model& model_;
  std::vector<Known> known_;
};

/// The largest of a facet's corners; 0 on planes.
std::vector<double> corner_curvatures(const Model& model) {
  const Facets& facets = model.facets();
  return joined(map_blocks<std::vector<double>>(
      facets.triangles.size(), kFacetBlock, [&](std::size_t first, std::size_t last) {
        std::vector<double> list(last - first, 0.0);
        NodeCurvatures curvatures(model);
        for (std::size_t i = first; i < last; ++i) {
          if (model.is_plane(facets.face[i])) continue;
          for (std::size_t k = 0; k < 3; ++k)
            list[i - first] = std::max(
                list[i - first], curvatures.at(facets.face[i], facets.triangles[i][k], facets.uv[i][k]));
        }
        return list;
      }));
}

/// A turning that is not known yet.
constexpr double kUnknown = -1.0;

/// The curvature at the corners, but no more than twice what the facet turns, which is found where it is
/// kUnknown. Beside a side of no length derivatives of a patch of splines are small and wrong: its curvature
/// was that of 1e-30 to 0.2 mm where it is flat to 0.001 radians, at places that depended on how the part was
/// turned.
void wish_on_facet(const Model& model, std::size_t facet, double at_corners, double& turning,
                   const SizingOptions& options, Wishes& wishes) {
  constexpr double kBelieved = 2.0;
  const double least = options.curvature_angle / options.size;  // what asks for no more than the size
  if (at_corners <= least) return;
  const Facets& facets = model.facets();
  const int face = facets.face[facet];
  if (turning == kUnknown) turning = turning_rate(model, face, facets.uv[facet]);
  const double curvature = std::min(at_corners, kBelieved * turning);
  if (curvature > 0.0)
    wish_on_triangle(facet_corners(facets, facet),
                     std::max(options.curvature_angle / curvature, options.curvature_floor),
                     {model_face(face), SizeReason::kCurvature}, wishes);
}

/// What visit(i, wishes) wishes for each i of [0, n), in their order. Blocks in parallel.
template <class Visit>
std::vector<SizeSample> wishes_of(std::size_t n, std::size_t block, const SizingOptions& options,
                                  const Visit& visit) {
  return joined(
      map_asking<std::vector<SizeSample>>(n, block, options, [&](std::size_t first, std::size_t last) {
        Wishes wishes(options.size, options.min_size);
        for (std::size_t i = first; i < last; ++i) visit(i, wishes);
        return wishes.take();
      }));
}

/// Elements along the diagonal of a compact part, ten along the side of a cube; and of a small one of many: a
/// ball of that size loses 3 % of its volume.
constexpr double kAlongPart = 17.0, kAlongRegion = 12.0;

}  // namespace

struct FeatureMemo::Edges {
  double size, min_size, gap_elements;  ///< of the question
  std::vector<EdgeSteps> steps;
};

struct FeatureMemo::Faces {
  std::vector<double> at_corners;  ///< per facet: the largest curvature; 0 on planes
  std::vector<double> turning;     ///< per facet: turning_rate(), or kUnknown
};

FeatureMemo::FeatureMemo() = default;
FeatureMemo::~FeatureMemo() = default;

std::vector<SizeSample> FeatureMemo::sizes(const Model& model, const SizingOptions& options) {
  if (!edges_ || std::tie(edges_->size, edges_->min_size, edges_->gap_elements) !=
                     std::tie(options.size, options.min_size, options.edge_gap_elements))
    edges_.reset(
        new Edges{options.size, options.min_size, options.edge_gap_elements, steps_of_edges(model, options)});
  std::vector<SizeSample> samples =
      wishes_of(edges_->steps.size(), kEdgeBlock, options,
                [&](std::size_t i, Wishes& wishes) { wish_along(model, edges_->steps[i], options, wishes); });
  if (!(options.curvature_angle > 0.0)) return samples;
  const std::size_t facets = model.facets().triangles.size();
  if (!faces_) faces_.reset(new Faces{corner_curvatures(model), std::vector<double>(facets, kUnknown)});
  const std::vector<SizeSample> on_faces =
      wishes_of(facets, kFacetBlock, options, [&](std::size_t i, Wishes& wishes) {
        wish_on_facet(model, i, faces_->at_corners[i], faces_->turning[i], options, wishes);
      });
  samples.insert(samples.end(), on_faces.begin(), on_faces.end());
  return samples;
}

std::vector<SizeSample> feature_sizes(const Model& model, const SizingOptions& options) {
  return FeatureMemo().sizes(model, options);
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
