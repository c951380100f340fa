// SPDX-License-Identifier: BSD-3-Clause
// A box hierarchy over boxes: finds those near a point.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geom/float_box.h"

namespace octet {

/// A flat binary tree, each part halved across the longest side of its boxes' centres.
///
/// Cost: building O(n log n), 32 bytes a node and 28 a box. Immutable, thread-safe.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Box3> boxes);

  /// Calls visit(number) for each box no farther than `radius` from p, and for some that are farther by no
  /// more than floats are rounded, in no order that means anything.
  template <class Visit>
  void visit_within(const Vec3& p, double radius, const Visit& visit) const;

 private:
  struct Node : FloatBox {
    std::uint32_t left = 0, right = 0;  ///< children, or a leaf's items from left to right
    bool leaf = false;
  };
  struct Item : FloatBox {
    std::uint32_t number = 0;
  };
  std::uint32_t build(std::span<const Box3> boxes, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<Item> items_;
  std::uint32_t root_ = 0;
};

template <class Visit>
void BoxTree::visit_within(const Vec3& p, double radius, const Visit& visit) const {
  if (nodes_.empty()) return;
  const double most = radius * radius;
  std::array<std::uint32_t, 64> stack;  // halves: no deeper than the logarithm of the items
  int size = 0;
  stack[size++] = root_;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (node.squared_distance(p) > most) continue;
    if (!node.leaf) {
      stack[size++] = node.right;
      stack[size++] = node.left;
      continue;
    }
    for (std::uint32_t i = node.left; i < node.right; ++i)
      if (items_[i].squared_distance(p) <= most) visit(items_[i].number);
  }
}

}  // namespace octet
