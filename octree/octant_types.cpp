// SPDX-License-Identifier: BSD-3-Clause
// Types of octants by descent over the sorted array and flood fill over subtrees.
#include "octree/octant_types.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "base/bucket_sort.h"

namespace octet {
namespace {

/// A subtree, whose octants stand side by side in the array.
struct Block {
  Octant root;
  std::uint32_t first = 0, last = 0;  ///< octants [first, last)
  bool boundary = false;
};

std::array<Block, 8> children_of(const Octree& tree, const Block& parent) {
  std::array<Block, 8> children;
  const bool are_octants = parent.last - parent.first == children.size();
  const int level = parent.root.level + 1;
  const std::uint32_t e = parent.root.extent() / 2;
  std::uint32_t first = parent.first;
  for (std::uint32_t c = 0; c < 8; ++c) {
    Block& child = children[c];
    const Lattice& at = parent.root.corner;
    child.root = {{at[0] + (c & 1) * e, at[1] + (c >> 1 & 1) * e, at[2] + (c >> 2) * e},
                  static_cast<std::int8_t>(level)};
    child.first = first;
    child.last = parent.last;
    if (are_octants) {
      child.last = first + 1;
    } else if (c < 7) {
      const MortonKey end = morton_key(child.root.corner) + (MortonKey{1} << (3 * (kLatticeLevels - level)));
      child.last = tree.find(lattice_of(end)).index();
    }
    first = child.last;
  }
  return children;
}

/// The largest subtrees that the boundary does not meet, and single octants that it meets; in array order.
std::vector<Block> blocks_of(const Model& model, const Octree& tree) {
  std::vector<Block> blocks;
  std::vector<Block> open{{Octant{}, 0, static_cast<std::uint32_t>(tree.size()), false}};
  while (!open.empty()) {
    tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
      open[i].boundary = model.near_boundary(tree.root().box(open[i].root));
    });
    std::vector<Block> next;
    for (const Block& block : open) {
      if (block.boundary && block.last - block.first > 1) {
        const std::array<Block, 8> children = children_of(tree, block);
        next.insert(next.end(), children.begin(), children.end());
      } else {
        blocks.push_back(block);
      }
    }
    open = std::move(next);
  }
  const auto by_first = [](const Block& a, const Block& b) { return a.first < b.first; };
  bucket_sort(
      blocks, tree.size(), [](const Block& block) { return block.first; }, by_first);
  return blocks;
}

/// Sets of blocks; the representative is the lowest number, whatever the order of the unions.
class Components {
 public:
  explicit Components(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t b) {
    while (parent_[b] != b) b = parent_[b] = parent_[parent_[b]];
    return b;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Joins blocks off the boundary that share a face. A block looks only at neighbours that are not finer: a
/// finer one finds it in turn.
void join_neighbours(const Octree& tree, const std::vector<Block>& blocks, Components& components) {
  std::vector<std::uint32_t> block_of(tree.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    std::fill(block_of.begin() + blocks[b].first, block_of.begin() + blocks[b].last,
              static_cast<std::uint32_t>(b));
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].boundary) continue;
    const Octant& o = blocks[b].root;
    for (int side = 0; side < 6; ++side) {
      Lattice p = o.corner;
      p[side / 2] += side % 2 == 0 ? o.extent() : 0u - o.extent();  // wraps past the root's lower faces
      if (p[side / 2] >= kLatticeExtent) continue;
      const std::uint32_t n = block_of[tree.find(p).index()];
      if (!blocks[n].boundary && blocks[n].root.level <= o.level)
        components.unite(static_cast<std::uint32_t>(b), n);
    }
  }
}

/// Per block: the region of its component, asked for at the centre of the component's largest block, which is
/// farthest from the boundary.
std::vector<std::int32_t> block_regions(const Model& model, const Octree& tree,
                                        const std::vector<Block>& blocks, Components& components) {
  std::vector<std::uint32_t> largest(blocks.size(), 0);  // per representative
  std::vector<std::uint32_t> representatives;
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].boundary) continue;
    const std::uint32_t r = components.find(b);
    if (r == b) {
      representatives.push_back(r);
      largest[r] = r;
    } else if (blocks[b].root.level < blocks[largest[r]].root.level) {
      largest[r] = b;
    }
  }
  std::vector<std::int32_t> region(blocks.size(), 0);
  tbb::parallel_for(std::size_t{0}, representatives.size(), [&](std::size_t i) {
    const std::uint32_t r = representatives[i];
    region[r] = model.region_at(tree.root().box(blocks[largest[r]].root).centre());
  });
  for (std::uint32_t b = 0; b < blocks.size(); ++b) {
    if (!blocks[b].boundary) region[b] = region[components.find(b)];
  }
  return region;
}

}  // namespace

OctantTypes octant_types(const Model& model, const Octree& tree) {
  const std::vector<Block> blocks = blocks_of(model, tree);
  Components components(blocks.size());
  join_neighbours(tree, blocks, components);
  const std::vector<std::int32_t> region = block_regions(model, tree, blocks, components);
  OctantTypes result{std::vector<OctantType>(tree.size(), OctantType::kBoundary),
                     std::vector<std::int32_t>(tree.size(), 0)};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].boundary) continue;
    const OctantType type = region[b] != 0 ? OctantType::kIn : OctantType::kOut;
    std::fill(result.type.begin() + blocks[b].first, result.type.begin() + blocks[b].last, type);
    std::fill(result.region.begin() + blocks[b].first, result.region.begin() + blocks[b].last, region[b]);
  }
  return result;
}

}  // namespace octet
