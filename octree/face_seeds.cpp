// SPDX-License-Identifier: BSD-3-Clause
// Points on model faces: the exact cuts of octant edges, thinned by spacing, in matched pairs and columns.
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/blocks.h"
#include "base/error.h"
#include "geom/face_match.h"
#include "geom/facet_bvh.h"
#include "geom/opposite.h"
#include "octree/even_walls.h"
#include "octree/seed_state.h"

namespace octet {
namespace {

struct FacePoint {
  Vec3 p;
  int face;
  double size;
};

/// What else is seeded at the same time.
enum class Beside { kNothing, kBlocks };

/// Puts points on faces into a list of its own, and reads `state` alone: several can be beside one another.
class FaceSeeder {
 public:
  /// Faces of `given`, if there is any, get no points.
  FaceSeeder(const SeedState& state, const GivenPoints* given)
      : state_(state),
        model_(state.model),
        given_(given),
        own_grid_(state.tree.origin(), state.tree.root_size()) {}

  /// The partners of points that are given to faces, as far as there is room.
  void match_given() {
    const SeedPoints& points = state_.seeds.points;
    for (std::size_t n = 0; n < points.size(); ++n) {
      if (points.on[n].dim != 2) continue;
      const FacePoint a{points.position[n], points.on[n].tag, points.spacing[n]};
      const Vec3 normal = model_.face_project(a.face, a.p).normal;
      for (const FacePoint& b : partners_of(a, normal, may_be_in_stack(a, normal)))
        if (is_free(b)) add(b);
    }
  }

  /// A vertex or edge that comes close to a face it does not bound gets a partner on that face.
  void match_vertices_and_edges() {
    for (int v = 1; v <= model_.count(0); ++v) match(state_.seeds.model_vertex[v], Vec3::Zero());
    for (const EdgePiece& piece : state_.seeds.pieces)
      if (state_.seeds.points.on[piece.b].dim == 1)
        match(piece.b, model_.edge_derivative(piece.edge, piece.tb));
  }

  /// The rings of sharp tips.
  void add_rings() {
    for (const Tip& tip : state_.seeds.tips.all())
      for (const Vec3& place : ring_places(model_, tip))
        for (const int face : tip.faces) {
          const std::optional<Vec3> p = ring_point(model_, tip, face, place);
          if (!p) continue;
          const FacePoint a{*p, face, ring_spacing(tip)};
          if (is_free(a)) add(a);
        }
  }

  /// A cut through a face, with its partners, if all of them are free: they go in whole or not at all.
  /// `spacing`: the octree's there. Whether it has been dealt with: not one of a stack where it is to be
  /// beside others, for a stack may be thicker than a block.
  bool offer(const Hit& hit, double spacing, Beside beside) {
    const FacePoint a{hit.point, hit.on.tag, spacing};
    if (is_given(a.face) || !is_free(a) ||
        (model_.is_plane(a.face) && is_crowded(a, kWideSpacing, Among::kFace) && has_room(a, hit.normal)))
      return true;
    const bool in_stack = may_be_in_stack(a, hit.normal);
    if (in_stack && beside == Beside::kBlocks) return false;
    const std::vector<FacePoint> partners = partners_of(a, hit.normal, in_stack);
    if (!std::all_of(partners.begin(), partners.end(), [&](const FacePoint& b) { return is_free(b); }))
      return true;
    add(a);
    for (const FacePoint& b : partners)
      if (is_free(b)) add(b);
    return true;
  }

  [[nodiscard]] const std::vector<FacePoint>& own() const { return own_; }

 private:
  void match(std::uint32_t point, const Vec3& tangent) {
    const ModelRef on = state_.seeds.points.on[point];
    const Vec3 a = state_.seeds.points.position[point];
    const double size = state_.tree.spacing_at(a);
    for (const FacePartner& partner : face_partners(model_, on, a, tangent, kMatchDistance * size)) {
      const FacePoint b{partner.point, partner.face, size};
      if (is_free(b)) add(b);
    }
  }

  [[nodiscard]] bool is_given(int face) const { return given_ != nullptr && given_->has_face(face); }

  void add(const FacePoint& a) {
    if (is_given(a.face)) return;
    own_grid_.add(static_cast<std::uint32_t>(own_.size()), a.p, a.size);
    own_.push_back(a);
  }

  /// Far enough from the points of the same face's closure, and outside the diametral ball of every edge
  /// piece.
  [[nodiscard]] bool is_free(const FacePoint& a) const {
    if (is_given(a.face)) return true;  // and stays without
    if (is_crowded(a, model_.is_plane(a.face) ? kPlaneSpacing : kFaceSpacing, Among::kClosure)) return false;
    const SeedPoints& points = state_.seeds.points;
    const auto is_within = [&](std::uint32_t n) {
      const EdgePiece& piece = state_.seeds.pieces[n];
      return (a.p - points.position[piece.a]).dot(a.p - points.position[piece.b]) < 0.0;
    };
    return !state_.piece_grid.any_around(a.p, a.size, [&](std::uint32_t n, double) {
      return is_within(n);
    }) && std::none_of(state_.long_pieces.begin(), state_.long_pieces.end(), is_within);
  }

  /// Which points keep another out of a face.
  enum class Among { kFace, kClosure };

  /// Whether one of these points is within this share of the spacing.
  [[nodiscard]] bool is_crowded(const FacePoint& a, double share, Among among) const {
    const ModelRef face = model_face(a.face);
    const double spacing = share * a.size;
    const SeedPoints& points = state_.seeds.points;
    const auto keeps_out = [&](ModelRef on, const Vec3& p) {
      return on == face ? !are_sheets(a, p) : among == Among::kClosure && model_.in_closure(on, face);
    };
    return own_grid_.any_within(a.p, spacing, [&](std::uint32_t n, double) {
      return own_[n].face == a.face && !are_sheets(a, own_[n].p);
    }) || state_.points_grid.any_within(a.p, spacing, [&](std::uint32_t n, double) {
      return keeps_out(points.on[n], points.position[n]);
    });
  }

  /// Whether no other face comes near and octants in the material are of one size, so that cuts are dense and
  /// the elements behind them as large.
  [[nodiscard]] bool has_room(const FacePoint& a, const Vec3& normal) const {
    constexpr double kRoom = 2.2;  // in spacings: layers of one or two elements want smaller triangles
    const double octant = a.size / kSpacingPerOctant;
    for (const int side : {-1, 1}) {
      const Vec3 across = side * normal;
      const auto is_alike = [&](double octants) {
        return state_.tree.spacing_at(a.p + octants * octant * across) == a.size;
      };
      const bool is_open = model_.face(a.face).region[side > 0 ? 1 : 0] == 0;
      if (!is_open && !(is_alike(0.5) && is_alike(1.5))) return false;
      bool met = false;
      const Vec3 end = a.p + kRoom * a.size * across;
      model_.bvh().visit_segment(
          a.p, end, [&](std::uint32_t) { met = true; }, a.face);
      if (met) return false;
    }
    return true;
  }

  /// Whether the point and p are on two sheets of the face that face each other, of one that meets itself: as
  /// two faces' they do not count to one another.
  [[nodiscard]] bool are_sheets(const FacePoint& a, const Vec3& p) const {
    constexpr double kMostCosine = -0.5;
    if (!state_.folded[a.face]) return false;
    return model_.face_project(a.face, a.p).normal.dot(model_.face_project(a.face, p).normal) < kMostCosine;
  }

  /// The points across from `a`: of a stack of sheets all, else those of sheets within kMatchDistance.
  [[nodiscard]] std::vector<FacePoint> partners_of(const FacePoint& a, const Vec3& normal,
                                                   bool in_stack) const {
    constexpr int kMostSheets = 256;
    std::vector<FacePoint> partners;
    const double reach = (in_stack ? kThinWall : kMatchDistance) * a.size;
    for (const int side : {-1, 1}) add_sheets(a, normal, side, reach, in_stack ? kMostSheets : 1, partners);
    if (partners.size() == 1 && (partners.front().p - a.p).norm() > kMatchDistance * a.size) partners.clear();
    return partners;
  }

  /// Whether facets of another face are within a thin wall's thickness, on either side of `a`, and of two
  /// within twice that.
  [[nodiscard]] bool may_be_in_stack(const FacePoint& a, const Vec3& normal) const {
    const auto meets = [&](double length, int faces) {
      int first = 0, met = 0;
      model_.bvh().visit_segment(
          a.p - length * normal, a.p + length * normal,
          [&](std::uint32_t facet) {
            const int face = model_.facets().face[facet];
            if (face == first) return;
            if (first == 0) first = face;
            ++met;
          },
          a.face);
      return met >= faces;
    };
    return meets(kThinWall * a.size, 1) && meets(2.0 * kThinWall * a.size, 2);
  }

  /// The points across from `a` on one side, from sheet to sheet, each no farther than `reach` from the one
  /// before.
  void add_sheets(const FacePoint& a, Vec3 normal, int side, double reach, int most,
                  std::vector<FacePoint>& points) const {
    FacePoint from = a;
    double near = reach;
    for (int sheet = 0; sheet < most; ++sheet) {
      std::optional<Foot> foot = facing_point(model_, from.p, from.face, normal, side, near);
      if (!foot && near < reach) foot = facing_point(model_, from.p, from.face, normal, side, reach);
      if (!foot) return;
      near = std::min(reach, 2.0 * foot->distance);  // sheets of a stack are about as thick
      from = {foot->point, foot->on.tag, a.size};
      points.push_back(from);
      side = side * normal.dot(foot->normal) > 0.0 ? 1 : -1;
      normal = foot->normal;
    }
  }

  const SeedState& state_;
  const Model& model_;
  const GivenPoints* given_;
  std::vector<FacePoint> own_;
  PointGrid own_grid_;
};

/// Per cut the octree's spacing there; 0 where it is no candidate for a point.
std::vector<double> candidate_spacings(const SeedState& state, const std::vector<OctantEdgeCut>& cuts) {
  std::vector<double> spacings(cuts.size(), 0.0);
  tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t i) {
    const Hit& hit = cuts[i].hit;
    if (hit.on.dim == 2 && hit.kind == HitKind::kTransversal &&
        state.seeds.tips.holder(hit.on.tag, hit.point) == nullptr)
      spacings[i] = state.tree.spacing_at(hit.point);
  });
  return spacings;
}

/// Successive cuts in one block of space.
struct CutRun {
  std::uint64_t block;
  std::size_t first, last;
};

/// Cuts in blocks of space of eight colours. Two blocks of a colour are a block's length apart, which is
/// farther than a cut and its partners reach: none of the one keeps out any of the other.
class CutBlocks {
 public:
  /// `spacings`: candidate_spacings(), referred to.
  CutBlocks(const Octree& tree, const std::vector<OctantEdgeCut>& cuts, const std::vector<double>& spacings);

  /// Whether a cut with this spacing reaches too far for blocks; such cuts are in none.
  [[nodiscard]] bool is_large(double spacing) const { return kReach * spacing > length_; }
  /// A colour's blocks, each with its runs in the order of the cuts.
  [[nodiscard]] const std::vector<std::vector<CutRun>>& of_colour(std::size_t colour) const {
    return blocks_[colour];
  }

 private:
  static constexpr int kBits = 20;  ///< for a block's place along an axis
  /// In spacings of the cut in the middle, were they in the order of spacings.
  static constexpr double kLength = 24.0;
  /// In spacings: two partners' distances, and what keeps a partner out, with room for rounding.
  static constexpr double kReach =
      2.0 * kMatchDistance + std::max({kFaceSpacing, kPlaneSpacing, kWideSpacing}) + 0.1;

  /// The colour in front, so that blocks sorted are in the order of colours.
  [[nodiscard]] std::uint64_t block_of(const Vec3& p) const;

  Vec3 origin_;
  double length_;
  std::array<std::vector<std::vector<CutRun>>, 8> blocks_;
};

/// In the middle of those that are not zero; 0 where all are.
double median(std::vector<double> spacings) {
  std::erase(spacings, 0.0);
  if (spacings.empty()) return 0.0;
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

CutBlocks::CutBlocks(const Octree& tree, const std::vector<OctantEdgeCut>& cuts,
                     const std::vector<double>& spacings)
    : origin_(tree.origin()),
      length_(std::max(kLength * median(spacings), std::ldexp(tree.root_size(), -kBits + 1))) {
  std::vector<CutRun> runs = joined(
      map_blocks<std::vector<CutRun>>(cuts.size(), kScanBlock, [&](std::size_t first, std::size_t last) {
        std::vector<CutRun> found;
        for (std::size_t i = first; i < last; ++i) {
          if (spacings[i] == 0.0 || is_large(spacings[i])) continue;
          const std::uint64_t block = block_of(cuts[i].hit.point);
          if (found.empty() || found.back().block != block || found.back().last != i)
            found.push_back({block, i, i});
          found.back().last = i + 1;
        }
        return found;
      }));
  std::stable_sort(runs.begin(), runs.end(),
                   [](const CutRun& a, const CutRun& b) { return a.block < b.block; });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::vector<CutRun>>& blocks = blocks_[runs[i].block >> 3 * kBits];
    if (i == 0 || runs[i - 1].block != runs[i].block) blocks.emplace_back();
    blocks.back().push_back(runs[i]);
  }
}

std::uint64_t CutBlocks::block_of(const Vec3& p) const {
  const Vec3 x = (p - origin_) / length_;
  std::uint64_t colour = 0, block = 0;
  for (int k = 0; k < 3; ++k) {
    const auto along = static_cast<std::uint64_t>(std::max(0.0, x[k]));
    colour |= (along & 1) << k;
    block = block << kBits | along;
  }
  return colour << 3 * kBits | block;
}

}  // namespace

void seed_model_faces(SeedState& state, const std::vector<OctantEdgeCut>& cuts, const SeedOptions& options) {
  constexpr std::size_t kCutsAQuestion = 4096;
  const auto ask = [&] {
    if (options.cancelled && options.cancelled()) throw Cancelled();
  };
  const GivenPoints* given = options.periodic == nullptr ? nullptr : &options.periodic->given;
  for (int f = 1; given != nullptr && f <= state.model.count(2); ++f)
    if (given->has_face(f))
      for (const Vec3& p : *given->on_face[static_cast<std::size_t>(f)])
        state.add(p, model_face(f), state.tree.spacing_at(p));
  const auto add_all = [&](const std::vector<FacePoint>& points) {
    for (const FacePoint& a : points) state.add(a.p, model_face(a.face), a.size);
  };
  FaceSeeder seeder(state, given);
  if (given != nullptr) seeder.match_given();
  seeder.match_vertices_and_edges();
  seeder.add_rings();
  const std::vector<double> spacings = candidate_spacings(state, cuts);
  std::optional<CutBlocks> blocks;
  if (cuts.size() >= kCutsInBlocks) blocks.emplace(state.tree, cuts, spacings);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (i % kCutsAQuestion == 0) ask();
    if (spacings[i] > 0.0 && (!blocks || blocks->is_large(spacings[i])))
      seeder.offer(cuts[i].hit, spacings[i], Beside::kNothing);
  }
  add_all(seeder.own());
  struct Placed {
    std::vector<FacePoint> points;
    std::vector<std::size_t> in_stacks;  ///< cuts left for afterwards
  };
  std::vector<std::size_t> in_stacks;
  for (std::size_t colour = 0; blocks && colour < 8; ++colour) {
    ask();
    const std::vector<std::vector<CutRun>>& own = blocks->of_colour(colour);
    const auto placed = map_blocks<Placed>(own.size(), 1, [&](std::size_t b, std::size_t) {
      FaceSeeder beside(state, given);
      Placed result;
      for (const CutRun& run : own[b])
        for (std::size_t i = run.first; i < run.last; ++i)
          if (!beside.offer(cuts[i].hit, spacings[i], Beside::kBlocks)) result.in_stacks.push_back(i);
      result.points = beside.own();
      return result;
    });
    for (const Placed& result : placed) {
      add_all(result.points);
      in_stacks.insert(in_stacks.end(), result.in_stacks.begin(), result.in_stacks.end());
    }
  }
  std::sort(in_stacks.begin(), in_stacks.end());
  FaceSeeder last(state, given);
  for (std::size_t n = 0; n < in_stacks.size(); ++n) {
    if (n % kCutsAQuestion == 0) ask();
    last.offer(cuts[in_stacks[n]].hit, spacings[in_stacks[n]], Beside::kNothing);
  }
  add_all(last.own());
}

}  // namespace octet
