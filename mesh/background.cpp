// SPDX-License-Identifier: BSD-3-Clause
// A tree of boxes; each node knows the smallest size below it, so that searches end early.
#include "mesh/background.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/error.h"

namespace octet {
namespace {

/// A point (all corners the same) or a tetrahedron, with its size.
struct Item {
  std::array<Vec3, 4> corner;
  double size = 0.0;

  [[nodiscard]] Box3 box() const {
    Box3 box;
    for (const Vec3& p : corner) box.add(p);
    return box;
  }
};

/// Whether a tetrahedron meets a box, by the box's axes and the tetrahedron's faces: touching counts, and
/// near edges a little more than the truth.
bool meets(const Item& item, const Box3& box) {
  if (!item.box().overlaps(box)) return false;
  const Vec3 centre = box.centre(), half = 0.5 * box.size();
  for (int f = 0; f < 4; ++f) {
    const Vec3 &a = item.corner[(f + 1) % 4], &b = item.corner[(f + 2) % 4], &c = item.corner[(f + 3) % 4];
    Vec3 normal = (b - a).cross(c - a);
    if (normal.dot(item.corner[f] - a) > 0.0) normal = -normal;  // outwards
    if (normal.dot(centre - a) > normal.cwiseAbs().dot(half)) return false;
  }
  return true;
}

class SizeTree {
 public:
  SizeTree(std::vector<Item> items, bool are_points) : items_(std::move(items)), are_points_(are_points) {
    nodes_.reserve(2 * items_.size() / kLeaf + 2);
    if (!items_.empty()) build(0, items_.size());
  }

  [[nodiscard]] double smallest(const Box3& box) const {
    if (items_.empty()) return kNoSize;
    double least = kNoSize;
    search(0, box, least);
    if (least < kNoSize || !are_points_) return least;
    // No point in the box: the nearest one speaks for it, as far as the points reach.
    if (nodes_[0].box.squared_distance(box.centre()) > box.size().squaredNorm()) return kNoSize;
    double distance2 = std::numeric_limits<double>::infinity();
    nearest(0, box.centre(), distance2, least);
    return least;
  }

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Node {
    Box3 box;
    double least = kNoSize;
    std::size_t begin = 0, end = 0;
    std::size_t right = 0;  ///< second child; 0: a leaf. The first child follows its parent.
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({});
    Node node;
    node.begin = begin;
    node.end = end;
    for (std::size_t i = begin; i < end; ++i) {
      node.box.add(items_[i].box());
      node.least = std::min(node.least, items_[i].size);
    }
    if (end - begin > kLeaf) {
      int axis = 0;
      node.box.size().maxCoeff(&axis);
      const auto first = items_.begin();
      const auto middle = static_cast<std::ptrdiff_t>(begin + (end - begin) / 2);
      std::nth_element(first + static_cast<std::ptrdiff_t>(begin), first + middle,
                       first + static_cast<std::ptrdiff_t>(end), [axis](const Item& a, const Item& b) {
                         return a.corner[0][axis] < b.corner[0][axis];
                       });
      build(begin, static_cast<std::size_t>(middle));
      node.right = build(static_cast<std::size_t>(middle), end);
    }
    nodes_[at] = node;
    return at;
  }

  void search(std::size_t at, const Box3& box, double& least) const {
    const Node& node = nodes_[at];
    if (node.least >= least || !node.box.overlaps(box)) return;
    if (node.right != 0) {
      search(at + 1, box, least);
      search(node.right, box, least);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      if (items_[i].size < least && (are_points_ ? box.contains(items_[i].corner[0]) : meets(items_[i], box)))
        least = items_[i].size;
  }

  /// Of points equally near the one with the smallest size.
  void nearest(std::size_t at, const Vec3& p, double& distance2, double& size) const {
    const Node& node = nodes_[at];
    if (node.box.squared_distance(p) > distance2) return;
    if (node.right != 0) {
      const bool first = nodes_[at + 1].box.squared_distance(p) <= nodes_[node.right].box.squared_distance(p);
      nearest(first ? at + 1 : node.right, p, distance2, size);
      nearest(first ? node.right : at + 1, p, distance2, size);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const double d2 = (items_[i].corner[0] - p).squaredNorm();
      if (d2 > distance2 || (d2 == distance2 && items_[i].size >= size)) continue;
      distance2 = d2;
      size = items_[i].size;
    }
  }

  std::vector<Item> items_;
  std::vector<Node> nodes_;
  bool are_points_;
};

bool is_size(double size) { return size > 0.0 && std::isfinite(size); }

void require_fit(const Background& field) {
  const bool by_tets = !field.tets.empty() && !field.tet_size.empty();
  if (by_tets && field.tet_size.size() != field.tets.size())
    throw InputError(
        fmt::format("a field has {} sizes for {} tetrahedra", field.tet_size.size(), field.tets.size()));
  if (!by_tets && field.point_size.size() != field.points.size())
    throw InputError(
        fmt::format("a field has {} sizes for {} points", field.point_size.size(), field.points.size()));
  for (const auto& tet : field.tets)
    if (*std::max_element(tet.begin(), tet.end()) >= field.points.size())
      throw InputError(fmt::format("a tetrahedron of a field names point {} of {}",
                                   *std::max_element(tet.begin(), tet.end()), field.points.size()));
}

}  // namespace

Background scaled(Background field, double factor) {
  for (Vec3& p : field.points) p *= factor;
  for (double& size : field.tet_size) size *= factor;
  for (double& size : field.point_size) size *= factor;
  return field;
}

SizeField background_field(const Background& background) {
  require_fit(background);
  std::vector<Item> items;
  const auto& [points, tets, tet_size, point_size] = background;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    Item item;
    item.size = tet_size.empty() ? kNoSize : tet_size[t];
    for (std::size_t i = 0; i < 4; ++i) {
      const Mesh::Index v = tets[t][i];
      item.corner[i] = points[v];
      if (tet_size.empty() && is_size(point_size[v])) item.size = std::min(item.size, point_size[v]);
    }
    if (is_size(item.size)) items.push_back(item);
  }
  if (tets.empty()) {
    for (std::size_t v = 0; v < points.size(); ++v)
      if (is_size(point_size[v]))
        items.push_back({{points[v], points[v], points[v], points[v]}, point_size[v]});
  }
  const auto tree = std::make_shared<const SizeTree>(std::move(items), tets.empty());
  return [tree](const Box3& box) { return tree->smallest(box); };
}

}  // namespace octet
