// SPDX-License-Identifier: BSD-3-Clause
// A box hierarchy over the facets.
#include "geom/facet_bvh.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace octet {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double half_area(const Box3& box) {
  if (box.empty()) return 0.0;
  const Vec3 s = box.size();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

}  // namespace

FacetFoot closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto at = [&](double u, double v, double w) {
    FacetFoot foot;
    foot.point = u * a + v * b + w * c;
    foot.weights = Vec3(u, v, w);
    foot.distance = (p - foot.point).norm();
    return foot;
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return at(1, 0, 0);
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return at(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return at(1.0 - v, v, 0);
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return at(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return at(1.0 - w, 0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(0, 1.0 - w, w);
  }
  const double sum = va + vb + vc;
  return at(va / sum, vb / sum, vc / sum);
}

/// Builds the subtrees of the faces, then the tree that joins them: both by a binned surface area heuristic.
class FacetBvhBuilder {
 public:
  FacetBvhBuilder(FacetBvh& bvh, const Facets& facets, FacetBvh::Building building)
      : bvh_(bvh),
        facets_(facets),
        in_tasks_(building == FacetBvh::Building::kManyThreads && facets.triangles.size() > kTask) {}

  void build(int faces) {
    fill_leaves();
    bvh_.items_.resize(leaves_.size());
    bvh_.face_root_.assign(faces + 1, -1);
    std::vector<std::span<Leaf>> of_faces;
    for (std::size_t begin = 0, end = 0; begin < leaves_.size(); begin = end) {
      const int face = face_of(leaves_[begin]);
      while (end < leaves_.size() && face_of(leaves_[end]) == face) ++end;
      of_faces.push_back(std::span(leaves_).subspan(begin, end - begin));
    }
    std::vector<Branch> branches(of_faces.size());
    for_each(of_faces.size(), [&](std::size_t i) { branches[i] = branch(of_faces[i], 0); });
    Branch whole;
    std::vector<Leaf> tops;
    for (std::size_t i = 0; i < branches.size(); ++i) {
      const std::int32_t root = whole.append(branches[i]);
      bvh_.face_root_[face_of(of_faces[i].front())] = root;
      Box3 box;
      for (const Leaf& l : of_faces[i]) box.add(l.box);
      tops.push_back({box, box.centre(), static_cast<std::uint32_t>(root)});
    }
    if (!tops.empty()) {
      const auto root_of_face = [](std::span<Leaf> top, Branch&) {
        return static_cast<std::int32_t>(top[0].index);
      };
      bvh_.root_ = split(tops, root_of_face, 1, whole);
    }
    bvh_.nodes_ = std::move(whole.nodes);
  }

 private:
  struct Leaf {
    Box3 box;
    Vec3 centre;
    std::uint32_t index;  ///< of a triangle, or of a face's root node
  };
  /// A subtree with nodes of its own; the last one is its root.
  struct Branch {
    std::vector<FacetBvh::Node> nodes;

    std::int32_t add(std::span<const Leaf> leaves, std::int32_t first, std::int32_t second) {
      Box3 box;
      for (const Leaf& l : leaves) box.add(l.box);
      nodes.push_back({FloatBox::around(box), first, second});
      return static_cast<std::int32_t>(nodes.size() - 1);
    }
    /// Its root among the nodes here.
    std::int32_t append(const Branch& other) {
      const auto offset = static_cast<std::int32_t>(nodes.size());
      nodes.insert(nodes.end(), other.nodes.begin(), other.nodes.end());
      for (std::size_t i = offset; i < nodes.size(); ++i) {
        if (nodes[i].second < 0) continue;
        nodes[i].first += offset;
        nodes[i].second += offset;
      }
      return static_cast<std::int32_t>(nodes.size() - 1);
    }
  };
  /// Leaves built by one task.
  static constexpr std::size_t kTask = 8192;
  static constexpr std::size_t kMostItems = 4;  // of a leaf node
  static constexpr int kDeep = 40;

  template <class Body>
  void for_each(std::size_t n, const Body& body) const {
    if (in_tasks_) {
      tbb::parallel_for(std::size_t{0}, n, body);
    } else {
      for (std::size_t i = 0; i < n; ++i) body(i);
    }
  }

  [[nodiscard]] int face_of(const Leaf& leaf) const { return facets_.face[leaf.index]; }

  void fill_leaves() {
    leaves_.resize(facets_.triangles.size());
    for_each(leaves_.size(), [&](std::size_t i) {
      Box3 box;
      for (const auto node : facets_.triangles[i]) box.add(facets_.nodes[node]);
      leaves_[i] = {box.grown(bvh_.grow_[i]), box.centre(), static_cast<std::uint32_t>(i)};
    });
    for (const double grow : bvh_.grow_) bvh_.max_grow_ = std::max(bvh_.max_grow_, grow);
    std::stable_sort(leaves_.begin(), leaves_.end(),
                     [&](const Leaf& a, const Leaf& b) { return face_of(a) < face_of(b); });
  }

  Branch branch(std::span<Leaf> leaves, int depth) {
    Branch result;
    if (!in_tasks_ || leaves.size() <= kTask) {
      const auto items_of = [this](std::span<Leaf> few, Branch& nodes) { return make_items(few, nodes); };
      split(leaves, items_of, kMostItems, result, depth);
      return result;
    }
    const std::size_t middle = cut(leaves, depth);
    Branch right;
    tbb::parallel_invoke([&] { result = branch(leaves.first(middle), depth + 1); },
                         [&] { right = branch(leaves.subspan(middle), depth + 1); });
    const auto first = static_cast<std::int32_t>(result.nodes.size() - 1);
    const std::int32_t second = result.append(right);
    result.add(leaves, first, second);
    return result;
  }

  std::int32_t make_items(std::span<Leaf> leaves, Branch& branch) {
    const std::ptrdiff_t first = leaves.data() - leaves_.data();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const Leaf& l = leaves[i];
      const auto& t = facets_.triangles[l.index];
      FacetBvh::Item item{FloatBox::around(l.box),
                          facets_.nodes[t[0]],
                          facets_.nodes[t[1]],
                          facets_.nodes[t[2]],
                          Vec3::Zero(),
                          bvh_.grow_[l.index],
                          l.index};
      const Vec3 n = (item.b - item.a).cross(item.c - item.a);
      if (n.squaredNorm() > 0.0) item.normal = n.normalized();
      bvh_.items_[static_cast<std::size_t>(first) + i] = item;
    }
    return branch.add(leaves, static_cast<std::int32_t>(first), -static_cast<std::int32_t>(leaves.size()));
  }

  template <class MakeLeaf>
  static std::int32_t split(std::span<Leaf> leaves, const MakeLeaf& make_leaf, std::size_t most,
                            Branch& branch, int depth = 0) {
    if (leaves.size() <= most) return make_leaf(leaves, branch);
    const std::size_t middle = cut(leaves, depth);
    const std::int32_t left = split(leaves.first(middle), make_leaf, most, branch, depth + 1);
    const std::int32_t right = split(leaves.subspan(middle), make_leaf, most, branch, depth + 1);
    return branch.add(leaves, left, right);
  }

  /// Below some depth halving keeps the traversal stack bounded whatever the input.
  static std::size_t cut(std::span<Leaf> leaves, int depth) {
    return depth < kDeep ? cheapest_cut(leaves) : halve(leaves);
  }

  static int longest_axis(const Box3& box) {
    const Vec3 s = box.size();
    return s.x() >= s.y() && s.x() >= s.z() ? 0 : (s.y() >= s.z() ? 1 : 2);
  }

  static Box3 centres(std::span<const Leaf> leaves) {
    Box3 box;
    for (const Leaf& l : leaves) box.add(l.centre);
    return box;
  }

  static std::size_t halve(std::span<Leaf> leaves) {
    const int axis = longest_axis(centres(leaves));
    const std::size_t middle = leaves.size() / 2;
    std::nth_element(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(middle), leaves.end(),
                     [axis](const Leaf& a, const Leaf& b) {
                       return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                               : a.index < b.index;
                     });
    return middle;
  }

  static std::size_t cheapest_cut(std::span<Leaf> leaves) {
    constexpr int kBins = 16;
    const Box3 spread = centres(leaves);
    const int axis = longest_axis(spread);
    const double lo = spread.lo[axis], width = spread.size()[axis];
    if (!(width > 0.0)) return halve(leaves);
    const auto bin_of = [&](const Leaf& l) {
      return std::min(kBins - 1, static_cast<int>(kBins * ((l.centre[axis] - lo) / width)));
    };
    std::array<Box3, kBins> boxes;
    std::array<int, kBins> counts{};
    for (const Leaf& l : leaves) {
      boxes[bin_of(l)].add(l.box);
      ++counts[bin_of(l)];
    }
    std::array<double, kBins> right_cost{};
    Box3 right;
    for (int b = kBins - 1, n = 0; b > 0; --b) {
      right.add(boxes[b]);
      n += counts[b];
      right_cost[b] = n * half_area(right);
    }
    double best = kInfinity;
    int cut = 1;
    Box3 left;
    for (int b = 1, n = 0; b < kBins; ++b) {
      left.add(boxes[b - 1]);
      n += counts[b - 1];
      const double cost = n * half_area(left) + right_cost[b];
      if (cost < best) {
        best = cost;
        cut = b;
      }
    }
    const auto middle =
        std::stable_partition(leaves.begin(), leaves.end(), [&](const Leaf& l) { return bin_of(l) < cut; });
    const auto size = static_cast<std::size_t>(middle - leaves.begin());
    return size == 0 || size == leaves.size() ? halve(leaves) : size;
  }

  FacetBvh& bvh_;
  const Facets& facets_;
  bool in_tasks_;
  std::vector<Leaf> leaves_;
};

FacetBvh::FacetBvh(const Facets& facets, std::span<const double> grow, int faces, Building building)
    : grow_(grow.begin(), grow.end()) {
  OCTET_CHECK(grow.size() == facets.triangles.size());
  FacetBvhBuilder(*this, facets, building).build(faces);
}

FacetBvh::Probe::Probe(const Vec3& from, const Vec3& to)
    : p(from), q(to), box(FloatBox::around({from.cwiseMin(to), from.cwiseMax(to)})) {
  straight = (from.array() != to.array()).count() <= 1;
}

/// Separating axes of a segment and a box that meets the segment's box: the cross products of the segment
/// with the axes [Ericson 2005, 5.3.3].
bool FacetBvh::Probe::crosses(const FloatBox& b) const {
  const Vec3 middle = 0.5 * (p + q), half = 0.5 * (q - p);
  Vec3 c, e;
  for (int k = 0; k < 3; ++k) {
    const double l = b.lo[k], h = b.hi[k];
    e[k] = 0.5 * (h - l);
    c[k] = middle[k] - 0.5 * (l + h);
  }
  const Vec3 a = half.cwiseAbs();
  const double slack = 1e-15 * (a.sum() * (c.cwiseAbs().sum() + e.sum()));
  if (std::abs(c.y() * half.z() - c.z() * half.y()) > e.y() * a.z() + e.z() * a.y() + slack) return false;
  if (std::abs(c.z() * half.x() - c.x() * half.z()) > e.z() * a.x() + e.x() * a.z() + slack) return false;
  return std::abs(c.x() * half.y() - c.y() * half.x()) <= e.x() * a.y() + e.y() * a.x() + slack;
}

/// Separating axes of the segment and the triangle, which has `grow` around it: the normal and, the boxes
/// having told of the axes of space, the cross products of the segment with the sides [Ericson 2005, 5.2.1].
/// The last tell on which side of each side it passes: without them most triangles of a plane with holes are
/// candidates, for these are long and thin, and their boxes cover one another.
bool FacetBvh::meets(const Item& item, const Vec3& p, const Vec3& q) {
  const double hp = item.normal.dot(p - item.a), hq = item.normal.dot(q - item.a);
  if ((hp > item.grow && hq > item.grow) || (hp < -item.grow && hq < -item.grow)) return false;
  const Vec3 d = q - p;
  const auto passes = [&](const Vec3& from, const Vec3& to, const Vec3& opposite) {
    const Vec3 n = d.cross(to - from);
    const double inward = n.dot(opposite - from), at = n.dot(p - from);
    const double side = inward < 0.0 ? -at : at;
    return side < 0.0 && side * side > item.grow * item.grow * n.squaredNorm();
  };
  return !passes(item.a, item.b, item.c) && !passes(item.b, item.c, item.a) &&
         !passes(item.c, item.a, item.b);
}

void FacetBvh::near(const Vec3& p, double max_distance, int face, std::vector<FacetFoot>& feet) const {
  const std::int32_t root = root_of(face);
  if (root < 0) return;
  const std::size_t first = feet.size();
  double reach = max_distance;
  NearStack stack;
  stack.entry[stack.size++] = {root, nodes_[root].squared_distance(p)};
  while (stack.size > 0) {
    const auto [index, d2] = stack.entry[--stack.size];
    if (d2 > reach * reach) continue;
    const Node& node = nodes_[index];
    if (node.second >= 0) {
      stack.push(*this, node, p, reach * reach);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i) {
      const Item& item = items_[i];
      if (item.squared_distance(p) > reach * reach || item.height(p) > reach + item.grow) continue;
      const FacetFoot near = foot(item, p);
      if (near.distance > reach + item.grow) continue;
      feet.push_back(near);
      reach = std::min(reach, near.distance + item.grow);
    }
  }
  const auto too_far = [&](const FacetFoot& f) { return f.distance > reach + grow_[f.triangle]; };
  feet.erase(std::remove_if(feet.begin() + static_cast<std::ptrdiff_t>(first), feet.end(), too_far),
             feet.end());
}

FacetFoot FacetBvh::foot(const Item& item, const Vec3& p) {
  FacetFoot near = closest_on_triangle(p, item.a, item.b, item.c);
  near.triangle = item.triangle;
  return near;
}

bool FacetBvh::meets(const Item& item, const Box3& box) {
  if (item.apart(box)) return false;
  const double reach = item.normal.cwiseAbs().dot(0.5 * box.size()) + item.grow;
  return std::abs(item.normal.dot(box.centre() - item.a)) <= reach;
}

}  // namespace octet
