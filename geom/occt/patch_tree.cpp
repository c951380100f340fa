// SPDX-License-Identifier: BSD-3-Clause
// All roots of a segment and a free-form surface, by subdivision down to patches with one root at most.
#include "geom/occt/patch_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace octet {
namespace {

constexpr int kSamples = 4;             // per direction: resolves the second derivatives of a bicubic span
constexpr double kInflateBounds = 1.5;  // sampled bounds to bounds
constexpr double kFlat = 0.02;          // deviation / size of a leaf: about 0.16 radians of turning
constexpr int kMaxDepth = 14;           // of a leaf below its knot span
constexpr int kMaxBisections = 48;      // of a leaf while roots are isolated
constexpr int kKeptDepth = 8;           // of a leaf, from where on halves are made anew for each segment
constexpr int kBudget = 4000;           // cells looked at in one leaf before the rest is taken as touching
constexpr double kUnique = 0.7;         // a contraction: Newton from the centre converges to the only root

/// The part of the segment inside a box, as an interval of t.
std::optional<std::pair<double, double>> clip(const Vec3& p, const Vec3& d, const Box3& box) {
  double lo = 0.0, hi = 1.0;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0) {
      if (p[i] < box.lo[i] || p[i] > box.hi[i]) return std::nullopt;
      continue;
    }
    double a = (box.lo[i] - p[i]) / d[i], b = (box.hi[i] - p[i]) / d[i];
    if (a > b) std::swap(a, b);
    lo = std::max(lo, a);
    hi = std::min(hi, b);
    if (lo > hi) return std::nullopt;
  }
  return std::make_pair(lo, hi);
}

Vec3 cross_of(const SurfaceJet& jet) { return jet.du.cross(jet.dv); }

}  // namespace

struct PatchTree::Segment {
  Vec3 p, d;
  double length, tolerance;
};

struct PatchTree::Found {
  SurfaceRoot root;
  UvCell cell;  ///< where it was found
};

/// Of a part, across the longer of its directions.
struct PatchTree::Halves {
  Part left, right;
};

PatchTree::Part::~Part() { delete kept.load(); }

/// The parts of one leaf.
struct PatchTree::Search {
  const Segment& segment;
  double leaf_size;
  std::vector<Found>& roots;
  int budget = kBudget;
};

double PatchTree::Patch::bend() const {
  const Vec2 h = cell.size();
  return (h.x() * h.x() * second[0] + 2.0 * h.x() * h.y() * second[1] + h.y() * h.y() * second[2]) / 8.0;
}

PatchTree::PatchTree(Evaluate evaluate, const std::vector<double>& u_breaks,
                     const std::vector<double>& v_breaks)
    : evaluate_(std::move(evaluate)) {
  range_ = {{u_breaks.front(), v_breaks.front()}, {u_breaks.back(), v_breaks.back()}};
  for (std::size_t i = 0; i + 1 < u_breaks.size(); ++i)
    for (std::size_t j = 0; j + 1 < v_breaks.size(); ++j)
      refine({{u_breaks[i], v_breaks[j]}, {u_breaks[i + 1], v_breaks[j + 1]}}, 0);
  std::vector<std::int32_t> order(leaves_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
  nodes_.reserve(2 * leaves_.size());
  build(order, 0, order.size());
  const Box3& all = box();
  tolerance_ = 1e-13 * all.diagonal() + 2e-15 * all.lo.cwiseAbs().cwiseMax(all.hi.cwiseAbs()).maxCoeff();
}

PatchTree::Patch PatchTree::measured(const UvCell& cell) const {
  Patch patch;
  patch.cell = cell;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const Vec2 share(i / (kSamples - 1.0), j / (kSamples - 1.0));
      const SurfaceJet jet = evaluate_(cell.lo + share.cwiseProduct(cell.size()), 2);
      patch.second = patch.second.cwiseMax(Vec3(jet.duu.norm(), jet.duv.norm(), jet.dvv.norm()));
      patch.box.add(jet.p);
    }
  patch.second *= kInflateBounds;
  return patch;
}

void PatchTree::refine(const UvCell& cell, int depth) {
  Patch patch = measured(cell);
  const Vec2 h = cell.size();
  const double bend_u = h.x() * h.x() * patch.second[0] / 8.0, bend_v = h.y() * h.y() * patch.second[2] / 8.0;
  if (bend_u + bend_v > kFlat * patch.box.diagonal() && depth < kMaxDepth) {
    const int axis = bend_u >= bend_v ? 0 : 1;
    UvCell left = cell, right = cell;
    left.hi[axis] = right.lo[axis] = cell.centre()[axis];
    refine(left, depth + 1);
    refine(right, depth + 1);
    return;
  }
  patch.box = patch.box.grown(bend_u + bend_v);
  patch.middle = evaluate_(cell.centre(), 1);
  leaves_.emplace_back(patch);
}

std::int32_t PatchTree::build(std::vector<std::int32_t>& order, std::size_t begin, std::size_t end) {
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) box.add(leaves_[order[i]].patch.box);
  nodes_[index].box = box;
  if (end - begin == 1) {
    nodes_[index].right = order[begin];
    return index;
  }
  Eigen::Index axis = 0;
  box.size().maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int a, int b) {
    const double ca = leaves_[a].patch.box.centre()[axis], cb = leaves_[b].patch.box.centre()[axis];
    return ca != cb ? ca < cb : a < b;
  });
  const std::int32_t left = build(order, begin, middle);
  const std::int32_t right = build(order, middle, end);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

void PatchTree::intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const {
  Segment segment{p, q - p, (q - p).norm(), tolerance_};
  segment.tolerance += 1e-15 * (p.cwiseAbs().maxCoeff() + q.cwiseAbs().maxCoeff());
  if (segment.length == 0.0) return;
  std::vector<Found> found;
  const Box3 near = Box3{p.cwiseMin(q), p.cwiseMax(q)}.grown(segment.tolerance);
  std::array<std::int32_t, 128> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    if (!node.box.overlaps(near)) continue;
    if (node.left < 0) {
      solve(segment, leaves_[node.right], found);
      continue;
    }
    stack[top++] = node.left;
    stack[top++] = node.right;
  }
  if (found.size() <= 1) {
    for (const Found& f : found) roots.push_back(f.root);
    return;
  }
  // Touches first: they absorb what is found of them elsewhere.
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.root.tangent != b.root.tangent ? a.root.tangent : a.root.t < b.root.t;
  });
  std::vector<Crossing> crossings;
  for (const Found& f : found) add(segment, f, crossings);
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.root.t < b.root.t; });
  for (const Crossing& c : crossings) roots.push_back(c.root);
}

Vec2 PatchTree::near(const Vec3& p) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::tuple<double, double, std::int32_t> best(kFar, kFar, 0);
  std::array<std::pair<double, std::int32_t>, 128> stack;
  std::size_t top = 0;
  stack[top++] = {nodes_.front().box.squared_distance(p), 0};
  while (top > 0) {
    const auto [distance, index] = stack[--top];
    if (distance > std::get<0>(best)) continue;
    const Node& node = nodes_[index];
    if (node.left < 0) {
      const Box3& box = leaves_[node.right].patch.box;
      best = std::min(best, std::make_tuple(distance, (box.centre() - p).squaredNorm(), node.right));
      continue;
    }
    std::pair left(nodes_[node.left].box.squared_distance(p), node.left);
    std::pair right(nodes_[node.right].box.squared_distance(p), node.right);
    if (left.first < right.first) std::swap(left, right);  // the nearer one is looked at first
    stack[top++] = left;
    stack[top++] = right;
  }
  return leaves_[std::get<2>(best)].patch.cell.centre();
}

/// Whether the segment stays clear of the patch: of its box, or, within that, of the layer about the plane of
/// its middle that it bends in. Most segments that graze a leaf's box are told so.
bool PatchTree::misses(const Segment& segment, const Patch& patch) {
  constexpr double kCloseBy = 16.0;  // tolerances within which a segment runs in the surface (coincide)
  constexpr double kLeastSine = 1e-6;
  const auto part = clip(segment.p, segment.d, patch.box.grown(segment.tolerance));
  if (!part) return true;
  const SurfaceJet& middle = patch.middle;
  const Vec3 n = cross_of(middle);
  const double size = n.norm();
  if (size <= kLeastSine * middle.du.norm() * middle.dv.norm()) return false;
  const double reach = (patch.bend() + kCloseBy * segment.tolerance) * size;
  const double start = n.dot(segment.p - middle.p), way = n.dot(segment.d);
  const double a = start + part->first * way, b = start + part->second * way;
  return (a > reach && b > reach) || (a < -reach && b < -reach);
}

/// The surface seen along the segment is a map of the plane; where its derivative varies less over the cell
/// than its inverse allows, the map is one-to-one there.
bool PatchTree::is_unique(const Segment& segment, const Patch& patch) {
  const SurfaceJet& jet = patch.middle;
  const Vec2 h = patch.cell.size();
  const Vec3 along = segment.d / segment.length;
  const Vec3 a = (jet.du - jet.du.dot(along) * along) * h.x(),
             b = (jet.dv - jet.dv.dot(along) * along) * h.y();
  const double det = std::abs(a.cross(b).dot(along));
  const double da = h.x() * 0.5 * (h.x() * patch.second[0] + h.y() * patch.second[1]);
  const double db = h.y() * 0.5 * (h.x() * patch.second[1] + h.y() * patch.second[2]);
  return std::sqrt((a.squaredNorm() + b.squaredNorm()) * (da * da + db * db)) < kUnique * det;
}

/// At a cell too small to be split: a root if the segment comes within rounding.
bool PatchTree::touch(const Segment& segment, const Patch& patch, SurfaceRoot& root) {
  const SurfaceJet& jet = patch.middle;
  const double t = std::clamp((jet.p - segment.p).dot(segment.d) / segment.d.squaredNorm(), 0.0, 1.0);
  const Vec2 h = patch.cell.size();
  const double size = jet.du.norm() * h.x() + jet.dv.norm() * h.y();
  const Vec3 n = cross_of(jet);
  const Vec3 r = segment.p + t * segment.d - jet.p;
  const double height = n.norm() > 0.0 ? std::abs(n.dot(r)) / n.norm() : r.norm();
  if (height > 4.0 * segment.tolerance || r.norm() > size + 4.0 * segment.tolerance) return false;
  const bool flat = std::abs(n.dot(segment.d)) <= 1e-3 * n.norm() * segment.length;
  root = {t, patch.cell.centre(), flat, false};
  return true;
}

void PatchTree::solve(const Segment& segment, const Part& leaf, std::vector<Found>& roots) const {
  const Patch& patch = leaf.patch;
  if (misses(segment, patch)) return;
  if (is_unique(segment, patch)) {
    SurfaceRoot root;
    if (newton(segment, patch, root)) roots.push_back({root, patch.cell});
    return;
  }
  if (coincide(segment, patch, roots)) return;
  Search search{segment, patch.box.diagonal(), roots};
  halve(search, leaf, 0);
}

/// With the bounds of the whole, and a box that follows from them.
PatchTree::Patch PatchTree::part_of(const Patch& whole, const UvCell& cell) const {
  Patch part;
  part.cell = cell;
  part.second = whole.second;
  part.middle = evaluate_(cell.centre(), 1);
  const Vec2 half = 0.5 * cell.size();
  const Vec3 reach = half.x() * part.middle.du.cwiseAbs() + half.y() * part.middle.dv.cwiseAbs();
  part.box.add(part.middle.p - reach);
  part.box.add(part.middle.p + reach);
  part.box = part.box.grown(part.bend());
  return part;
}

PatchTree::Halves PatchTree::halved(const Patch& patch, int depth) const {
  const Vec2 h = patch.cell.size();
  const auto extent = [&](int axis, const Vec3& along) {
    return along.norm() * h[axis] + h[axis] * h[axis] * patch.second[2 * axis] / 8.0;
  };
  const int axis = extent(0, patch.middle.du) >= extent(1, patch.middle.dv) ? 0 : 1;
  // Towards a pole the second derivatives vanish with the cell: bounds of the whole leaf would split for
  // ever.
  Patch here = patch;
  if (depth % 4 == 3) here.second = patch.second.cwiseMin(measured(patch.cell).second);
  UvCell left = patch.cell, right = patch.cell;
  left.hi[axis] = right.lo[axis] = patch.cell.centre()[axis];
  return {Part(part_of(here, left)), Part(part_of(here, right))};
}

const PatchTree::Halves& PatchTree::kept_halves(const Part& part, int depth) const {
  const Halves* kept = part.kept.load(std::memory_order_acquire);
  if (kept != nullptr) return *kept;
  std::unique_ptr<const Halves> made(new Halves(halved(part.patch, depth)));
  // Another thread may have made the same ones meanwhile.
  return part.kept.compare_exchange_strong(kept, made.get(), std::memory_order_acq_rel) ? *made.release()
                                                                                        : *kept;
}

void PatchTree::halve(Search& search, const Part& part, int depth) const {
  const auto solve_both = [&](const Halves& halves) {
    solve_part(search, halves.left, depth + 1);
    solve_part(search, halves.right, depth + 1);
  };
  if (depth < kKeptDepth)
    solve_both(kept_halves(part, depth));
  else
    solve_both(halved(part.patch, depth));
}

void PatchTree::solve_part(Search& search, const Part& part, int depth) const {
  const Patch& patch = part.patch;
  if (--search.budget < 0 || misses(search.segment, patch)) return;
  SurfaceRoot root;
  if (is_unique(search.segment, patch)) {
    if (newton(search.segment, patch, root)) search.roots.push_back({root, patch.cell});
    return;
  }
  // A patch that bends less than rounding holds nothing that a further bisection could tell apart.
  const bool is_tiny =
      patch.bend() <= 0.25 * search.segment.tolerance && patch.box.diagonal() <= 1e-3 * search.leaf_size;
  if (depth < kMaxBisections && !is_tiny) return halve(search, part, depth);
  if (touch(search.segment, patch, root)) search.roots.push_back({root, patch.cell});
}

/// Newton on S(u,v) = p + t d from the cell's middle; fails when it leaves the cell's neighbourhood.
bool PatchTree::newton(const Segment& segment, const Patch& patch, SurfaceRoot& root) const {
  constexpr double kMostSlack = 1e-4;
  const UvCell& cell = patch.cell;
  Vec2 uv = cell.centre();
  const Vec2 reach = 1.5 * cell.size();
  double t = 0.0;
  double last = std::numeric_limits<double>::infinity();
  SurfaceJet jet = patch.middle;
  for (int iteration = 0; iteration < 16; ++iteration) {
    if (iteration > 0) jet = evaluate_(uv, 1);
    const Vec3 n = cross_of(jet), r = jet.p - segment.p;
    const double nd = n.dot(segment.d);
    if (nd == 0.0) return false;
    t = n.dot(r) / nd;
    const Vec3 w = segment.p + t * segment.d - jet.p;  // in the tangent plane
    const double nn = n.squaredNorm();
    const Vec2 step(w.cross(jet.dv).dot(n) / nn, jet.du.cross(w).dot(n) / nn);
    uv += step;
    const double length = w.norm();
    if (length <= 0.1 * segment.tolerance || (length < 1e3 * segment.tolerance && length >= last)) break;
    if (((uv - cell.centre()).cwiseAbs().array() > reach.array()).any()) return false;
    last = length;
  }
  // Beyond the range by no more than rounding, which is worth more of a parameter towards a pole.
  const double off_u = segment.tolerance / jet.du.norm(), off_v = segment.tolerance / jet.dv.norm();
  const Vec2 slack = 1e-9 * range_.size() + Vec2(off_u, off_v).cwiseMin(kMostSlack * range_.size());
  if (((uv - range_.lo + slack).array() < 0.0).any() || ((range_.hi - uv + slack).array() < 0.0).any())
    return false;
  uv = uv.cwiseMax(range_.lo).cwiseMin(range_.hi);
  const double end = segment.tolerance / segment.length;
  if (t < -end || t > 1.0 + end) return false;
  t = std::clamp(t, 0.0, 1.0);
  const double miss = (evaluate_(uv, 0).p - segment.p - t * segment.d).norm();
  if (!(miss <= 1e3 * segment.tolerance)) return false;
  root = {t, uv, false, false};
  return true;
}

/// Whether the segment runs in the surface across the leaf: its clipped ends and points between are all on
/// it.
bool PatchTree::coincide(const Segment& segment, const Patch& leaf, std::vector<Found>& roots) const {
  const auto part = clip(segment.p, segment.d, leaf.box);
  if (!part || (part->second - part->first) * segment.length < 0.1 * leaf.box.diagonal()) return false;
  constexpr double kSteep = 0.9, kOff = 1e4;
  std::array<SurfaceRoot, 5> at;
  for (int i = 0; i < 5; ++i) {
    const double t = part->first + (0.02 + 0.24 * i) * (part->second - part->first);
    const Vec3 goal = segment.p + t * segment.d;
    Vec2 uv = leaf.cell.centre();
    for (int iteration = 0; iteration < 12; ++iteration) {
      const SurfaceJet jet = evaluate_(uv, 1);
      const Vec3 n = cross_of(jet), w = goal - jet.p;
      const double nn = n.squaredNorm();
      if (nn == 0.0) return false;
      // From a leaf, which turns little, places on the surface are seen along it.
      const double height = n.dot(w);
      if (height * height > kSteep * kSteep * nn * w.squaredNorm() && w.norm() > kOff * segment.tolerance)
        return false;
      const Vec2 step(w.cross(jet.dv).dot(n) / nn, jet.du.cross(w).dot(n) / nn);
      uv = (uv + step).cwiseMax(range_.lo).cwiseMin(range_.hi);
      if (iteration > 2 && w.norm() <= segment.tolerance) break;
    }
    if ((evaluate_(uv, 0).p - goal).norm() > 16.0 * segment.tolerance) return false;
    at[i] = {t, uv, false, true};
  }
  roots.push_back({at.front(), leaf.cell});
  roots.push_back({at.back(), leaf.cell});
  return true;
}

/// How the segment crosses there, seen from within the cell: at a crease each side has its own normal.
PatchTree::Crossing PatchTree::crossing_of(const Segment& segment, const Found& found) const {
  constexpr double kInwards = 1e-6;
  const Vec2 uv = found.root.uv + kInwards * (found.cell.centre() - found.root.uv);
  const Vec3 n = cross_of(evaluate_(uv, 1));
  const double size = n.norm() * segment.length;
  return {found.root, evaluate_(found.root.uv, 0).p, size > 0.0 ? n.dot(segment.d) / size : 0.0};
}

void PatchTree::add(const Segment& segment, const Found& found, std::vector<Crossing>& crossings) const {
  const Crossing here = crossing_of(segment, found);
  for (std::size_t i = crossings.size(); i-- > 0;) {
    Crossing& other = crossings[i];
    if (other.root.coincident != here.root.coincident) continue;
    const double apart = std::abs(here.root.t - other.root.t) * segment.length;
    const bool tangent = here.root.tangent || other.root.tangent;
    // Where the segment grazes, rounding across it moves the root along it; twice as far to both sides.
    const double sine = std::abs(here.sine);
    const double near = tangent ? 256.0 * segment.tolerance / std::max(sine, 1e-7)
                                : 64.0 * segment.tolerance / std::max(sine, 1e-5);
    if (apart > near || (here.point - other.point).norm() > 2.0 * near) continue;
    const bool same_way = tangent || here.sine * other.sine >= 0.0;
    // In by one side of a crease and out by the other within rounding: a touch.
    const bool touches_crease = !same_way && apart <= 16.0 * segment.tolerance;
    if (!same_way && !touches_crease) continue;
    other.root.tangent = tangent || touches_crease;
    return;
  }
  crossings.push_back(here);
}

}  // namespace octet
