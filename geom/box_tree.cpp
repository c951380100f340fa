// SPDX-License-Identifier: BSD-3-Clause
// Building a box hierarchy by medians.
#include "geom/box_tree.h"

#include <algorithm>

namespace octet {
namespace {

constexpr std::uint32_t kLeaf = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].empty()) items_.push_back({FloatBox::around(boxes[i]), static_cast<std::uint32_t>(i)});
  if (!items_.empty()) root_ = build(boxes, 0, static_cast<std::uint32_t>(items_.size()));
}

std::uint32_t BoxTree::build(std::span<const Box3> boxes, std::uint32_t begin, std::uint32_t end) {
  Box3 around, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Box3& box = boxes[items_[i].number];
    around.add(box);
    centres.add(box.centre());
  }
  Node node{FloatBox::around(around), begin, end, end - begin <= kLeaf};
  if (!node.leaf) {
    int axis = 0;
    centres.size().maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto before = [&](const Item& a, const Item& b) {
      const double x = boxes[a.number].centre()[axis], y = boxes[b.number].centre()[axis];
      return x != y ? x < y : a.number < b.number;
    };
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end, before);
    node.left = build(boxes, begin, middle);
    node.right = build(boxes, middle, end);
  }
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size()) - 1;
}

}  // namespace octet
