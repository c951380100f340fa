// SPDX-License-Identifier: BSD-3-Clause
// All roots of a segment and a free-form surface, by subdivision down to patches with one root at most.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "geom/surface.h"

namespace octet {

/// A rectangle of the (u,v) plane.
struct UvCell {
  Vec2 lo = Vec2::Zero(), hi = Vec2::Zero();
  [[nodiscard]] Vec2 size() const { return hi - lo; }
  [[nodiscard]] Vec2 centre() const { return 0.5 * (lo + hi); }
};

/// Leaves are nearly flat patches of the surface with boxes that hold them, below a flat binary tree.
///
/// Invariants: the cells of the leaves tile the (u,v) box; |Suu|, |Suv|, |Svv| stay below the leaf's bounds
/// (sampled, then inflated: not a proof), so that a patch lies within (hu^2 |Suu| + hv^2 |Svv|) / 8 of the
/// hull of its corners. Halves of leaves are the same for all segments: they are made when a segment first
/// asks for them, and the first of them are kept. Memory: about 350 bytes a leaf or kept half. Thread-safe.
class PatchTree {
 public:
  using Evaluate = std::function<SurfaceJet(const Vec2& uv, int derivatives)>;

  /// `u_breaks` and `v_breaks`: ascending, both ends of the box and all knots between.
  PatchTree(Evaluate evaluate, const std::vector<double>& u_breaks, const std::vector<double>& v_breaks);

  /// Appends the roots of segment p..q in the (u,v) box. Two roots closer than rounding that cross in the
  /// same direction are one; a root that touches is `tangent`.
  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const;

  /// Middle of the leaf nearest to p, by its box, then by its middle: a start for a foot point. Cost: some
  /// twice the depth of the tree.
  [[nodiscard]] Vec2 near(const Vec3& p) const;

  /// Box of the whole surface.
  [[nodiscard]] const Box3& box() const { return nodes_.front().box; }
  [[nodiscard]] std::size_t leaf_count() const { return leaves_.size(); }

 private:
  struct Patch {
    UvCell cell;
    Vec3 second = Vec3::Zero();  ///< bounds of |Suu|, |Suv|, |Svv|
    Box3 box;
    SurfaceJet middle;  ///< at the cell's middle, with first derivatives
    /// How far the patch lies off the parallelogram of the middle's derivatives, at most [Taylor].
    [[nodiscard]] double bend() const;
  };
  struct Halves;
  /// A leaf or a part of one.
  struct Part {
    explicit Part(const Patch& p) : patch(p) {}
    ~Part();
    Patch patch;
    mutable std::atomic<const Halves*> kept{nullptr};  ///< its own halves
  };
  struct Node {
    Box3 box;
    std::int32_t left = -1, right = -1;  ///< children; a leaf has left = -1 and its patch in right
  };
  struct Segment;
  struct Found;
  struct Search;
  struct Crossing {
    SurfaceRoot root;
    Vec3 point;   ///< on the surface
    double sine;  ///< of the segment's angle with the surface, positive along du x dv
  };

  void refine(const UvCell& cell, int depth);
  [[nodiscard]] Patch measured(const UvCell& cell) const;
  std::int32_t build(std::vector<std::int32_t>& order, std::size_t begin, std::size_t end);
  void solve(const Segment& segment, const Part& leaf, std::vector<Found>& roots) const;
  [[nodiscard]] static bool misses(const Segment& segment, const Patch& patch);
  [[nodiscard]] static bool is_unique(const Segment& segment, const Patch& patch);
  [[nodiscard]] static bool touch(const Segment& segment, const Patch& patch, SurfaceRoot& root);
  [[nodiscard]] Patch part_of(const Patch& whole, const UvCell& cell) const;
  [[nodiscard]] Halves halved(const Patch& patch, int depth) const;
  [[nodiscard]] const Halves& kept_halves(const Part& part, int depth) const;
  void halve(Search& search, const Part& part, int depth) const;
  void solve_part(Search& search, const Part& part, int depth) const;
  bool newton(const Segment& segment, const Patch& patch, SurfaceRoot& root) const;
  bool coincide(const Segment& segment, const Patch& leaf, std::vector<Found>& roots) const;
  [[nodiscard]] Crossing crossing_of(const Segment& segment, const Found& found) const;
  void add(const Segment& segment, const Found& found, std::vector<Crossing>& crossings) const;

  Evaluate evaluate_;
  UvCell range_;
  double tolerance_ = 0.0;  ///< rounding of the coordinates
  std::deque<Part> leaves_;
  std::vector<Node> nodes_;
};

}  // namespace octet
