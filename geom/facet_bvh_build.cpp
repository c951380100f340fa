// SPDX-License-Identifier: BSD-3-Clause
// Building the hierarchy over the facets, by faces, in tasks.
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

#include "base/check.h"
#include "base/constants.h"
#include "geom/facet_bvh.h"

namespace octet {
namespace {

double half_area(const Box3& box) {
  if (box.empty()) return 0.0;
  const Vec3 s = box.size();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

}  // namespace

/// Builds the subtrees of the faces, then the tree that joins them: both by a binned surface area heuristic.
/// What is parted is a list of numbers; the leaves stay where they are.
class FacetBvhBuilder {
 public:
  FacetBvhBuilder(FacetBvh& bvh, const Facets& facets, FacetBvh::Building building)
      : bvh_(bvh),
        facets_(facets),
        in_tasks_(building == FacetBvh::Building::kManyThreads && facets.triangles.size() > kTask) {}

  void build(int faces) {
    fill_leaves();
    const std::vector<Part> of_faces = part_by_faces(faces);
    bvh_.items_.resize(leaves_.size());
    bvh_.face_root_.assign(faces + 1, -1);
    std::vector<Branch> branches(of_faces.size());
    for_each(of_faces.size(), [&](std::size_t i) { branches[i] = branch(of_faces[i], 0); });
    Branch whole;
    std::vector<Leaf> tops;
    std::vector<std::int32_t> roots;
    for (std::size_t i = 0; i < branches.size(); ++i) {
      roots.push_back(whole.append(branches[i]));
      bvh_.face_root_[facets_.face[of_faces[i].order[0]]] = roots.back();
      Box3 box;
      for (const std::uint32_t n : of_faces[i].order) box.add(leaves_[n].box);
      tops.push_back({box, box.centre()});
    }
    if (!tops.empty()) {
      std::vector<std::uint32_t> order(tops.size()), scratch(tops.size());
      std::iota(order.begin(), order.end(), 0u);
      const auto root_of_face = [&](const Part& top, Branch&) { return roots[top.order[0]]; };
      bvh_.root_ = split({tops.data(), order, scratch}, root_of_face, 1, whole);
    }
    bvh_.nodes_ = std::move(whole.nodes);
  }

 private:
  struct Leaf {
    Box3 box;
    Vec3 centre;
  };
  /// Some of the leaves, by their numbers.
  struct Part {
    const Leaf* leaf;
    std::span<std::uint32_t> order, scratch;
    [[nodiscard]] std::size_t size() const { return order.size(); }
    [[nodiscard]] const Leaf& operator[](std::size_t i) const { return leaf[order[i]]; }
    [[nodiscard]] Part first(std::size_t n) const { return {leaf, order.first(n), scratch.first(n)}; }
    [[nodiscard]] Part from(std::size_t n) const { return {leaf, order.subspan(n), scratch.subspan(n)}; }
  };
  /// A subtree with nodes of its own; the last one is its root.
  struct Branch {
    std::vector<FacetBvh::Node> nodes;

    std::int32_t add(const FloatBox& box, std::int32_t first, std::int32_t second) {
      nodes.push_back({box, first, second});
      return static_cast<std::int32_t>(nodes.size() - 1);
    }
    std::int32_t join(std::int32_t first, std::int32_t second) {
      FloatBox box = nodes[first];
      const FloatBox& other = nodes[second];
      for (int k = 0; k < 3; ++k) {
        box.lo[k] = std::min(box.lo[k], other.lo[k]);
        box.hi[k] = std::max(box.hi[k], other.hi[k]);
      }
      return add(box, first, second);
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

  void fill_leaves() {
    leaves_.resize(facets_.triangles.size());
    for_each(leaves_.size(), [&](std::size_t i) {
      Box3 box;
      for (const auto node : facets_.triangles[i]) box.add(facets_.nodes[node]);
      leaves_[i] = {box.grown(bvh_.grow_[i]), box.centre()};
    });
    for (const double grow : bvh_.grow_) bvh_.max_grow_ = std::max(bvh_.max_grow_, grow);
  }

  /// Of the faces that have any leaves.
  std::vector<Part> part_by_faces(int faces) {
    std::vector<std::size_t> end(static_cast<std::size_t>(faces) + 2, 0);
    for (const auto face : facets_.face) ++end[static_cast<std::size_t>(face) + 1];
    for (std::size_t f = 1; f < end.size(); ++f) end[f] += end[f - 1];
    order_.resize(leaves_.size());
    scratch_.resize(leaves_.size());
    for (std::size_t i = 0; i < leaves_.size(); ++i)
      order_[end[static_cast<std::size_t>(facets_.face[i])]++] = static_cast<std::uint32_t>(i);
    const Part all{leaves_.data(), order_, scratch_};
    std::vector<Part> parts;
    for (std::size_t f = 0, begin = 0; f + 1 < end.size(); begin = end[f++])
      if (end[f] > begin) parts.push_back(all.from(begin).first(end[f] - begin));
    return parts;
  }

  Branch branch(const Part& part, int depth) {
    Branch result;
    if (!in_tasks_ || part.size() <= kTask) {
      const auto items_of = [this](const Part& few, Branch& nodes) { return make_items(few, nodes); };
      split(part, items_of, kMostItems, result, depth);
      return result;
    }
    const std::size_t middle = cut(part, depth);
    Branch right;
    tbb::parallel_invoke([&] { result = branch(part.first(middle), depth + 1); },
                         [&] { right = branch(part.from(middle), depth + 1); });
    const auto first = static_cast<std::int32_t>(result.nodes.size() - 1);
    const std::int32_t second = result.append(right);
    result.join(first, second);
    return result;
  }

  std::int32_t make_items(const Part& part, Branch& branch) {
    const std::ptrdiff_t first = part.order.data() - order_.data();
    Box3 box;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::uint32_t n = part.order[i];
      const auto& t = facets_.triangles[n];
      FacetBvh::Item item{FloatBox::around(part[i].box),
                          facets_.nodes[t[0]],
                          facets_.nodes[t[1]],
                          facets_.nodes[t[2]],
                          Vec3::Zero(),
                          bvh_.grow_[n],
                          n};
      const Vec3 normal = (item.b - item.a).cross(item.c - item.a);
      if (normal.squaredNorm() > 0.0) item.normal = normal.normalized();
      bvh_.items_[static_cast<std::size_t>(first) + i] = item;
      box.add(part[i].box);
    }
    return branch.add(FloatBox::around(box), static_cast<std::int32_t>(first),
                      -static_cast<std::int32_t>(part.size()));
  }

  template <class MakeLeaf>
  static std::int32_t split(const Part& part, const MakeLeaf& make_leaf, std::size_t most, Branch& branch,
                            int depth = 0) {
    if (part.size() <= most) return make_leaf(part, branch);
    const std::size_t middle = cut(part, depth);
    const std::int32_t left = split(part.first(middle), make_leaf, most, branch, depth + 1);
    const std::int32_t right = split(part.from(middle), make_leaf, most, branch, depth + 1);
    return branch.join(left, right);
  }

  /// Below some depth halving keeps the traversal stack bounded whatever the input.
  static std::size_t cut(const Part& part, int depth) {
    return depth < kDeep ? cheapest_cut(part) : halve(part);
  }

  static int longest_axis(const Box3& box) {
    const Vec3 s = box.size();
    return s.x() >= s.y() && s.x() >= s.z() ? 0 : (s.y() >= s.z() ? 1 : 2);
  }

  static Box3 centres(const Part& part) {
    Box3 box;
    for (const std::uint32_t n : part.order) box.add(part.leaf[n].centre);
    return box;
  }

  static std::size_t halve(const Part& part) {
    const int axis = longest_axis(centres(part));
    const std::size_t middle = part.size() / 2;
    std::nth_element(part.order.begin(), part.order.begin() + static_cast<std::ptrdiff_t>(middle),
                     part.order.end(), [&](std::uint32_t a, std::uint32_t b) {
                       const double at = part.leaf[a].centre[axis], bt = part.leaf[b].centre[axis];
                       return at != bt ? at < bt : a < b;
                     });
    return middle;
  }

  static std::size_t cheapest_cut(const Part& part) {
    constexpr int kBins = 16;
    const Box3 spread = centres(part);
    const int axis = longest_axis(spread);
    const double lo = spread.lo[axis], width = spread.size()[axis];
    if (!(width > 0.0)) return halve(part);
    std::array<Box3, kBins> boxes;
    std::array<int, kBins> counts{};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Leaf& l = part[i];
      const int bin = std::min(kBins - 1, static_cast<int>(kBins * ((l.centre[axis] - lo) / width)));
      boxes[bin].add(l.box);
      ++counts[bin];
      part.scratch[i] = static_cast<std::uint32_t>(bin);
    }
    std::array<double, kBins> right_cost{};
    Box3 right;
    for (int b = kBins - 1, n = 0; b > 0; --b) {
      right.add(boxes[b]);
      n += counts[b];
      right_cost[b] = n * half_area(right);
    }
    double best = kInfinity;
    std::uint32_t cut = 1;
    Box3 left;
    for (int b = 1, n = 0; b < kBins; ++b) {
      left.add(boxes[b - 1]);
      n += counts[b - 1];
      const double cost = n * half_area(left) + right_cost[b];
      if (cost < best) {
        best = cost;
        cut = static_cast<std::uint32_t>(b);
      }
    }
    const std::size_t size = bins_below_first(part, cut);
    return size == 0 || size == part.size() ? halve(part) : size;
  }

  /// Leaves whose bins, in `scratch`, are below `cut` before the others, each in their order; how many.
  static std::size_t bins_below_first(const Part& part, std::uint32_t cut) {
    std::size_t below = 0, above = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::uint32_t n = part.order[i];
      const bool is_below = part.scratch[i] < cut;
      part.order[below] = part.scratch[above] = n;
      below += is_below ? 1 : 0;
      above += is_below ? 0 : 1;
    }
    std::copy_n(part.scratch.begin(), above, part.order.begin() + static_cast<std::ptrdiff_t>(below));
    return below;
  }

  FacetBvh& bvh_;
  const Facets& facets_;
  bool in_tasks_;
  std::vector<Leaf> leaves_;                    ///< per triangle
  std::vector<std::uint32_t> order_, scratch_;  ///< of the leaves
};

FacetBvh::FacetBvh(const Facets& facets, std::span<const double> grow, int faces, Building building)
    : grow_(grow.begin(), grow.end()) {
  OCTET_CHECK(grow.size() == facets.triangles.size());
  FacetBvhBuilder(*this, facets, building).build(faces);
}

}  // namespace octet
