// SPDX-License-Identifier: BSD-3-Clause
// A box hierarchy over the facets: finds candidates and seeds for the exact queries.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geom/facets.h"
#include "geom/float_box.h"

namespace octet {

/// Nearest point of a facet.
struct FacetFoot {
  std::uint32_t triangle = 0;
  double distance = 0.0;
  Vec3 point = Vec3::Zero();
  Vec3 weights = Vec3::Zero();  ///< barycentric, exactly 0 off the interior
};

/// Closest point of triangle abc to p, by Voronoi regions [Ericson 2005, 5.1.5].
[[nodiscard]] FacetFoot closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// A flat binary tree. Every face has its own subtree; the upper part joins the faces.
///
/// Invariants: each box holds its triangles grown by their `grow`, rounded outward to float; so whatever
/// exact boundary lies within `grow` of a facet lies in the boxes above that facet.
/// Cost: 32 bytes a node, 136 bytes a triangle. Immutable, thread-safe.
class FacetBvh {
 public:
  /// A segment as boxes are asked about it.
  struct Probe {
    Probe(const Vec3& from, const Vec3& to);
    /// Whether it meets the box, as far as their extents along the axes tell.
    [[nodiscard]] bool beside(const FloatBox& b) const { return !b.apart(box); }
    [[nodiscard]] bool meets(const FloatBox& b) const {
      return beside(b) && (straight || b.holds(box) || crosses(b));
    }
    [[nodiscard]] bool crosses(const FloatBox& b) const;
    Vec3 p, q;
    FloatBox box;   ///< its own
    bool straight;  ///< parallel to an axis: it is its box
  };

  /// A box as triangles are asked about it.
  struct BoxProbe {
    explicit BoxProbe(const Box3& b)
        : box(b), outer(FloatBox::around(b)), centre(b.centre()), half(0.5 * b.size()) {}
    Box3 box;
    FloatBox outer;  ///< rounded outward
    Vec3 centre, half;
  };

  FacetBvh() = default;
  /// Reading a part starts no threads: with one alone its child process is forked.
  enum class Building { kOneThread, kManyThreads };
  /// `grow`: per triangle, how far the exact boundary may lie from it. Faces are numbered 1..faces. The tree
  /// is the same whatever the building.
  FacetBvh(const Facets& facets, std::span<const double> grow, int faces,
           Building building = Building::kOneThread);

  /// Calls visit(triangle) for each triangle that the segment meets, grown; a few more near its corners; none
  /// of the face `but`.
  template <class Visit>
  void visit_segment(const Vec3& p, const Vec3& q, const Visit& visit, int but = 0) const;
  /// Calls visit(foot) for each triangle within `radius` plus its growth; `face` 0 means all.
  template <class Visit>
  void visit_within(const Vec3& p, double radius, int face, const Visit& visit) const;
  /// Whether accept(triangle) for one of the triangles whose grown box and grown plane meet the box; none is
  /// asked after that.
  template <class Accept>
  bool any_in_box(const Box3& box, const Accept& accept) const {
    return any_item_in_box(box, [&](std::uint32_t item) { return accept(triangle(item)); });
  }
  /// The same among those in boxes of the tree for which not misses(box), a FloatBox.
  template <class Misses, class Accept>
  bool any_in_box(const Box3& box, const Misses& misses, const Accept& accept) const {
    return any_item_in_box(box, misses, [&](std::uint32_t item) { return accept(triangle(item)); });
  }
  /// The same for the triangles' places in the tree's order.
  template <class Accept>
  bool any_item_in_box(const Box3& box, const Accept& accept) const {
    return any_item_in_box(
        box, [](const FloatBox&) { return false; }, accept);
  }
  template <class Misses, class Accept>
  bool any_item_in_box(const Box3& box, const Misses& misses, const Accept& accept) const;
  /// Appends the triangles that may hold the boundary's nearest point to p, which is no farther than
  /// `max_distance`: each triangle's distance, less its growth, is at most the least distance plus growth.
  void near(const Vec3& p, double max_distance, int face, std::vector<FacetFoot>& feet) const;
  /// Whether a triangle's grown box and grown plane meet the box.
  [[nodiscard]] bool meets(const Box3& box) const {
    return any_in_box(box, [](std::uint32_t) { return true; });
  }
  /// Nearest triangle of the face (0: of all), none when farther than `max_distance`. Ties: the lowest
  /// triangle, up to rounding.
  [[nodiscard]] std::optional<FacetFoot> nearest(const Vec3& p, double max_distance, int face = 0) const {
    return nearest_if(p, max_distance, face, [](std::uint32_t) { return true; });
  }
  /// The same among the triangles for which accept(triangle).
  template <class Accept>
  [[nodiscard]] std::optional<FacetFoot> nearest_if(const Vec3& p, double max_distance, int face,
                                                    const Accept& accept) const;

  /// Triangles in the tree's order, so that neighbours are near in memory, too.
  [[nodiscard]] std::uint32_t items() const { return static_cast<std::uint32_t>(items_.size()); }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t item) const { return items_[item].triangle; }
  /// Around the triangle, grown.
  [[nodiscard]] const FloatBox& box_of(std::uint32_t item) const { return items_[item]; }
  /// Whether the triangle's grown box and grown plane meet the box.
  [[nodiscard]] bool item_meets(std::uint32_t item, const Box3& box) const {
    return meets(items_[item], box, box.centre(), 0.5 * box.size());
  }
  [[nodiscard]] bool item_meets(std::uint32_t item, const Probe& probe) const {
    return probe.beside(items_[item]) && meets(items_[item], probe.p, probe.q);
  }

  [[nodiscard]] double grow(std::uint32_t triangle) const { return grow_[triangle]; }
  [[nodiscard]] double max_grow() const { return max_grow_; }

 private:
  struct Node : FloatBox {
    std::int32_t first = 0;   ///< leaf: first item; else left child
    std::int32_t second = 0;  ///< leaf: -(number of items); else right child
  };
  struct Item : FloatBox {
    Vec3 a, b, c;
    Vec3 normal;  ///< unit, zero for a degenerate triangle
    double grow = 0.0;
    std::uint32_t triangle = 0;
    /// Distance from the triangle's plane: a lower bound, reckoned a little small against rounding.
    [[nodiscard]] double height(const Vec3& p) const { return std::abs(normal.dot(p - a)) * (1.0 - 1e-12); }
  };
  struct Stack {
    std::array<std::int32_t, 128> node;
    int size = 0;
    void push(std::int32_t n) { node[size++] = n; }
    std::int32_t pop() { return node[--size]; }
  };
  /// Nodes still to visit, the nearer child of each pair on top.
  struct NearStack {
    struct Entry {
      std::int32_t node;
      double d2;
    };
    std::array<Entry, 128> entry;
    int size = 0;
    void push(const FacetBvh& bvh, const Node& parent, const Vec3& p, double most) {
      Entry near{parent.first, bvh.nodes_[parent.first].squared_distance(p)};
      Entry far{parent.second, bvh.nodes_[parent.second].squared_distance(p)};
      if (far.d2 < near.d2) std::swap(near, far);
      if (far.d2 <= most) entry[size++] = far;
      if (near.d2 <= most) entry[size++] = near;
    }
  };

  friend class FacetBvhBuilder;
  [[nodiscard]] std::int32_t root_of(int face) const { return face == 0 ? root_ : face_root_[face]; }
  /// What is left to ask where the boxes meet.
  [[nodiscard]] static bool meets(const Item& item, const Vec3& p, const Vec3& q);
  [[nodiscard]] static bool meets(const Item& item, const Box3& box, const Vec3& centre, const Vec3& half) {
    if (item.apart(box)) return false;
    const double reach = item.normal.cwiseAbs().dot(half) + item.grow;
    return std::abs(item.normal.dot(centre - item.a)) <= reach;
  }
  [[nodiscard]] static FacetFoot foot(const Item& item, const Vec3& p);

  std::vector<Node> nodes_;
  std::vector<Item> items_;
  std::vector<std::int32_t> face_root_;  ///< -1: a face without facets
  std::vector<double> grow_;
  std::int32_t root_ = -1;
  double max_grow_ = 0.0;
};

template <class Visit>
void FacetBvh::visit_segment(const Vec3& p, const Vec3& q, const Visit& visit, int but) const {
  if (root_ < 0) return;
  const Probe probe(p, q);
  const std::int32_t none = but == 0 ? -1 : face_root_[but];
  const auto meets = [&](std::int32_t node) { return node != none && probe.meets(nodes_[node]); };
  Stack stack;
  if (meets(root_)) stack.push(root_);
  while (stack.size > 0) {
    const Node& node = nodes_[stack.pop()];
    if (node.second >= 0) {
      if (meets(node.second)) stack.push(node.second);
      if (meets(node.first)) stack.push(node.first);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i)
      if (item_meets(static_cast<std::uint32_t>(i), probe)) visit(items_[i].triangle);
  }
}

template <class Misses, class Accept>
bool FacetBvh::any_item_in_box(const Box3& box, const Misses& misses, const Accept& accept) const {
  if (root_ < 0) return false;
  const BoxProbe probe(box);
  const auto passes = [&](const FloatBox& b) { return b.apart(probe.outer) || misses(b); };
  Stack stack;
  if (!passes(nodes_[root_])) stack.push(root_);
  while (stack.size > 0) {
    const Node& node = nodes_[stack.pop()];
    if (node.second >= 0) {
      if (!passes(nodes_[node.second])) stack.push(node.second);
      if (!passes(nodes_[node.first])) stack.push(node.first);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i)
      if (!passes(items_[i]) && meets(items_[i], probe.box, probe.centre, probe.half) &&
          accept(static_cast<std::uint32_t>(i)))
        return true;
  }
  return false;
}

template <class Visit>
void FacetBvh::visit_within(const Vec3& p, double radius, int face, const Visit& visit) const {
  if (root_of(face) < 0) return;
  const double r2 = radius * radius;
  Stack stack;
  stack.push(root_of(face));
  while (stack.size > 0) {
    const Node& node = nodes_[stack.pop()];
    if (node.squared_distance(p) > r2) continue;
    if (node.second >= 0) {
      stack.push(node.second);
      stack.push(node.first);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i) {
      if (items_[i].height(p) > radius + items_[i].grow) continue;
      const FacetFoot near = foot(items_[i], p);
      if (near.distance <= radius + items_[i].grow) visit(near);
    }
  }
}

template <class Accept>
std::optional<FacetFoot> FacetBvh::nearest_if(const Vec3& p, double max_distance, int face,
                                              const Accept& accept) const {
  const std::int32_t root = root_of(face);
  if (root < 0) return std::nullopt;
  FacetFoot best;
  best.distance = max_distance;
  bool found = false;
  double best2 = max_distance < 1e150 ? max_distance * max_distance : std::numeric_limits<double>::infinity();
  NearStack stack;
  stack.entry[stack.size++] = {root, nodes_[root].squared_distance(p)};
  while (stack.size > 0) {
    const auto [index, d2] = stack.entry[--stack.size];
    if (d2 > best2) continue;
    const Node& node = nodes_[index];
    if (node.second >= 0) {
      stack.push(*this, node, p, best2);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i) {
      const double height = items_[i].height(p);
      if (height * height > best2 || items_[i].squared_distance(p) > best2 || !accept(items_[i].triangle))
        continue;
      const FacetFoot near = foot(items_[i], p);
      const bool better = near.distance < best.distance ||
                          (near.distance == best.distance && (!found || near.triangle < best.triangle));
      if (!better) continue;
      best = near;
      best2 = near.distance * near.distance;
      found = true;
    }
  }
  return found ? std::optional(best) : std::nullopt;
}

}  // namespace octet
