// SPDX-License-Identifier: BSD-3-Clause
// From a tree to a classified band, step by step.
#include "app/attempt.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/blocks.h"
#include "base/predicates.h"
#include "base/sort_unique.h"
#include "base/vertex_order.h"
#include "octree/even_walls.h"
#include "octree/tips.h"

namespace octet {
namespace {

/// The least side of the box around a face.
double least_extent(const Model& model, int face) {
  const Facets& facets = model.facets();
  Box3 box;
  for (std::size_t n = 0; n < facets.triangles.size(); ++n) {
    if (facets.face[n] != face) continue;
    for (const Vec3& corner : facet_corners(facets, n)) box.add(corner);
  }
  return box.size().minCoeff();
}

/// A face whose radius of curvature at a point is less than this share of the octants there is a bore or a
/// pin narrower than they: its points see one another across it, and no triangle of theirs lies on it.
constexpr double kNarrowShare = 0.25;
/// Places along narrow faces at which octants are refined at once; longer ones wait for further attempts.
constexpr std::size_t kMostNarrowPlaces = 50'000;

double radius_at(const Model& model, int face, const Vec2& uv) {
  const double curvature = model.face_curvature(face, uv);
  return curvature > 0.0 ? 1.0 / curvature : model.diagonal();
}

double radius_at(const Model& model, int face, const Vec3& place) {
  const FaceFoot foot = model.face_project(face, place);
  return foot.converged ? radius_at(model, face, foot.uv) : model.diagonal();
}

/// A place, and the longest octant that is wanted there.
struct SizedPlace {
  Vec3 place;
  double longest;
};

/// Places on the sides of a face's facets where its radius of curvature is narrow for the tree's octants, no
/// farther apart along a side than that radius; where it is less than `least`, that is taken.
std::vector<SizedPlace> narrow_places(const Model& model, int face, const Octree& tree, double least) {
  const Facets& facets = model.facets();
  std::vector<SizedPlace> places;
  for (std::size_t n = 0; n < facets.triangles.size(); ++n) {
    if (facets.face[n] != face) continue;
    const std::array<Vec3, 3> corner = facet_corners(facets, n);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vec3 way = corner[next] - corner[k];
      const Vec2 uv_way = facets.uv[n][next] - facets.uv[n][k];
      // Not from the corner itself, which may be a pole, where derivatives are nought.
      double step = least / way.norm();
      for (double t = std::min(0.5, 0.5 * step); t < 1.0 && places.size() < kMostNarrowPlaces; t += step) {
        const Vec3 place = corner[k] + t * way;
        const double radius = std::max(least, radius_at(model, face, Vec2(facets.uv[n][k] + t * uv_way)));
        if (radius <= kNarrowShare * tree.length_at(place)) places.push_back({place, radius});
        step = radius / way.norm();
      }
    }
  }
  return places;
}

/// Octants of a tree that are to be refined; none becomes shorter than half of `finest`.
class Subdivision {
 public:
  Subdivision(const Octree& tree, double finest) : tree_(tree), finest_(finest) {}

  void take(OctantId o, double longest) {
    if (tree_.length(tree_[o].level) > longest * (1.0 + 1e-9) && tree_[o].level < kDeepestLevel)
      octants_.push_back(o);
  }
  /// The octant that holds a place, and those beside it.
  void take_around(const Vec3& place) { take_around(place, finest_); }

  /// False, and nothing done, when no octant was taken.
  bool refine_taken() {
    if (octants_.empty()) return false;
    sort_unique(octants_);
    tree_ = refine(tree_, octants_);
    octants_.clear();
    return true;
  }
  /// Octants around each place no longer than it says; all at once, for each refinement goes over the whole
  /// tree.
  void refine_to(const std::vector<SizedPlace>& places) {
    do
      for (const SizedPlace& wanted : places) take_around(wanted.place, std::max(wanted.longest, finest_));
    while (refine_taken());
  }
  [[nodiscard]] Octree tree() && { return std::move(tree_); }

 private:
  void take_around(const Vec3& place, double longest) {
    const double half = 0.5 * tree_.length_at(place);
    for (int i = 0; i < 27; ++i)
      take(tree_.find(place + half * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)), longest);
  }

  Octree tree_;
  double finest_;
  std::vector<OctantId> octants_;
};

/// Points are triangulated at places rounded to 2^-40 of the root. Along the axes planes are then exactly
/// flat and boxes of points exactly boxes, in parts that are turned as well: their axes are only as exact as
/// doubles are, and where noise decides on diagonals there are flat tetrahedra and shapes are worse.
constexpr int kPlaceBits = 40;

Vec3 rounded(const Vec3& p, double unit) {
  return {std::round(p.x() / unit) * unit, std::round(p.y() / unit) * unit, std::round(p.z() / unit) * unit};
}

/// A point of a face that lies in a sharp tip goes to the tip's ring.
std::optional<OtherPlace> out_of_tips(const Model& model, const Tips& tips, int face, const Vec3& p) {
  constexpr double kClear = 0.5;  // of the ring's step
  const Tip* tip = tips.holder(face, p);
  if (tip == nullptr) return std::nullopt;
  const std::optional<Vec3> on_ring = ring_point(model, *tip, face, p);
  if (!on_ring) return std::nullopt;
  return OtherPlace{*on_ring, kClear * tip->ring_step()};
}

/// Gives the memory back, which `list = {}` does not.
template <class T>
void release(std::vector<T>& list) {
  std::vector<T>().swap(list);
}

}  // namespace

int Attempt::region_of(const Model& model, const Vec3& p) const {
  const Vec3 x = p - tree.origin();
  if ((x.array() < 0.0).any() || (x.array() > tree.root_size()).any()) return 0;
  const OctantId o = tree.find(p);
  switch (labels.type[o.index()]) {
    case OctantType::kOut:
      return 0;
    case OctantType::kIn:
      return labels.region[o.index()];
    default:
      return model.region_at(p);
  }
}

void Attempt::forget_band() {
  band.reset();
  chains.reset();
  triangulation = Triangulation();
  release(on);
  release(pieces);
  tips = {};
  split.band = {};
}

void cut_tree(Attempt& attempt, const Model& model, const std::function<bool()>& cancelled) {
  OctantTypes& types = attempt.labels;
  run_both([&] { attempt.vertices = octree_vertices(attempt.tree); },
           [&] { types = octant_types(model, attempt.tree); });
  attempt.edges = boundary_octant_edges(attempt.tree, attempt.vertices, types);
  attempt.cuts = cut_octant_edges(model, attempt.tree, attempt.vertices, attempt.edges, cancelled);
}

void place_points(Attempt& attempt, const Model& model, const SeedOptions& options) {
  Seeder seeder(model, attempt.tree, options);
  OctreeLabels labels;
  run_both([&] { seeder.seed_boundary(attempt.cuts); },
           [&] {
             labels = label_vertices(model, attempt.tree, attempt.vertices, attempt.labels, attempt.edges,
                                     attempt.cuts);
           });
  attempt.labels = std::move(labels);
  release(attempt.edges);
  release(attempt.cuts);
  Seeds seeds = seeder.seed_octree(attempt.vertices, attempt.labels);
  attempt.split = split_interior(model, attempt.tree, attempt.vertices, attempt.labels, seeds, options.size);
  attempt.seed_points = seeds.points.size();
  attempt.surface_points = seeds.surface_points;
  attempt.pieces = std::move(seeds.pieces);
  attempt.tips = std::move(seeds.tips);
}

void triangulate(Attempt& attempt, const Model& model, const std::function<bool()>& cancelled) {
  const SeedPoints& band = attempt.split.band;
  const double unit = std::exp2(std::ilogb(attempt.tree.root_size()) - kPlaceBits);
  std::vector<Vec3> places = band.position;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!is_octree_vertex_rank(band.order[i])) places[i] = rounded(places[i], unit);
  attempt.triangulation.insert_all(places, band.order, cancelled);
  attempt.on = attempt.split.band.on;
  attempt.chains = std::make_unique<EdgeChains>(attempt.pieces);
  attempt.band = std::make_unique<Band>(
      model, [&attempt, &model](const Vec3& p) { return attempt.region_of(model, p); });
}

void classify(Attempt& attempt) {
  const TetMesh& mesh = attempt.triangulation.mesh();
  std::vector<TetId> all;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    if (mesh.alive(TetId(i))) all.emplace_back(i);
  attempt.band->update(mesh, attempt.on, all);
}

void close_holes(Attempt& attempt, const Model& model, double size, AttributeLimits limits,
                 Observer& observer) {
  const EdgeIndex edges(model, size);
  limits.cell_at = [&](const Vec3& p) { return std::size_t{attempt.tree.find(p).index()}; };
  limits.elsewhere = [&](int face, const Vec3& p) { return out_of_tips(model, attempt.tips, face, p); };
  attempt.closed =
      close_gaps(attempt.triangulation, *attempt.band, *attempt.chains, attempt.on, edges, limits, observer);
}

void find_all_gaps(Attempt& attempt) {
  attempt.closed.gaps =
      find_gaps(*attempt.band, attempt.triangulation.mesh(), attempt.on, *attempt.chains, GapScope::kAll);
}

std::vector<Vec3> points_of(const Attempt& attempt) {
  const TetMesh& tets = attempt.triangulation.mesh();
  const std::vector<Vec3>& own = attempt.split.band.position;
  std::vector<Vec3> points = tets.points.values();
  std::copy(own.begin(), own.end(), points.begin());
  const auto find_turned = [&] {
    return collect<TetId>(tets.tets.size(), [&](std::size_t i, std::vector<TetId>& found) {
      const TetId t(i);
      if (!tets.alive(t) || tets.ghost(t)) return;
      const auto& v = tets.tets[t];
      if (!(orient3d(points[v[0].index()], points[v[1].index()], points[v[2].index()], points[v[3].index()]) >
            0))
        found.push_back(t);
    });
  };
  for (std::vector<TetId> turned = find_turned(); !turned.empty(); turned = find_turned())
    for (const TetId t : turned)
      for (const VertexId w : tets.tets[t]) points[w.index()] = tets.points[w];
  return points;
}

std::optional<Octree> subdivide_at_gaps(const Attempt& attempt, const Model& model, double finest) {
  Subdivision subdivision(attempt.tree, finest);
  for (const Gap& gap : attempt.closed.gaps) subdivision.take_around(gap.place);
  for (const std::size_t cell : attempt.closed.crowded) subdivision.take(OctantId(cell), finest);
  if (!subdivision.refine_taken()) return std::nullopt;
  std::set<int> narrow;
  std::vector<SizedPlace> wanted;
  for (const Gap& gap : attempt.closed.gaps) {
    if (gap.kind == GapKind::kBareFace)
      wanted.push_back({gap.place, 0.5 * least_extent(model, gap.entity.tag)});
    if (gap.kind != GapKind::kBareVertex || gap.entity.dim != 2 || narrow.count(gap.entity.tag) > 0) continue;
    const double radius = radius_at(model, gap.entity.tag, gap.place);
    if (radius > kNarrowShare * attempt.tree.length_at(gap.place)) continue;
    narrow.insert(gap.entity.tag);
    const std::vector<SizedPlace> places = narrow_places(model, gap.entity.tag, attempt.tree, radius);
    wanted.insert(wanted.end(), places.begin(), places.end());
  }
  subdivision.refine_to(wanted);
  return with_even_walls(model, std::move(subdivision).tree());
}

std::optional<Octree> subdivide_at(const Octree& tree, const Model& model, const std::vector<Vec3>& places,
                                   double finest) {
  Subdivision subdivision(tree, finest);
  for (const Vec3& place : places) subdivision.take_around(place);
  if (!subdivision.refine_taken()) return std::nullopt;
  return with_even_walls(model, std::move(subdivision).tree());
}

Openness openness(const std::vector<Gap>& gaps) {
  const bool lacks_pieces = std::any_of(gaps.begin(), gaps.end(),
                                        [](const Gap& gap) { return gap.kind == GapKind::kMissingPiece; });
  return {lacks_pieces, gaps.size()};
}

bool clearly_less(const Openness& a, const Openness& b) {
  constexpr double kFewer = 0.9;
  if (a.lacks_pieces != b.lacks_pieces) return b.lacks_pieces;
  return static_cast<double>(a.gaps) < kFewer * static_cast<double>(b.gaps);
}

bool crosses_all_over(const Attempt& attempt) {
  constexpr std::size_t kPointsPerConflict = 20;
  return attempt.closed.gaps.size() > kHopelessGaps ||
         kPointsPerConflict * attempt.labels.conflicts.size() > attempt.surface_points;
}

}  // namespace octet
