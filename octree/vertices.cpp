// SPDX-License-Identifier: BSD-3-Clause
// Unique vertices without sorting them all, and the vertices around one octant.
//
// A vertex that does not hang and does not lie on the root's far faces is the lower corner of the octant that
// holds its cell, and octants are sorted already. Only the others (a surface's worth) need a sort.
#include "octree/vertices.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace octet {
namespace {

using Corners = std::vector<std::array<std::uint32_t, 8>>;

Lattice corner_of(const Octant& o, int corner) {
  const std::uint32_t e = o.extent();
  return {o.corner[0] + (corner & 1) * e, o.corner[1] + (corner >> 1 & 1) * e,
          o.corner[2] + (corner >> 2) * e};
}

/// Per octant and corner: the octant that has that point as its lower corner, kNoVertex when there is none.
Corners octants_at_corners(const Octree& tree) {
  Corners owner(tree.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size()), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Octant& o = tree[OctantId(i)];
      owner[i][0] = static_cast<std::uint32_t>(i);
      for (int c = 1; c < 8; ++c) {
        const Lattice p = corner_of(o, c);
        owner[i][c] = kNoVertex;
        if (std::max({p[0], p[1], p[2]}) == kLatticeExtent) continue;
        const OctantId found = tree.find(p);
        const Lattice& at = tree[found].corner;
        if (at[0] == p[0] && at[1] == p[1] && at[2] == p[2]) owner[i][c] = found.index();
      }
    }
  });
  return owner;
}

/// The points that are no octant's lower corner, in Morton order, once each.
std::vector<MortonKey> ownerless(const Octree& tree, const Corners& owner) {
  std::vector<MortonKey> keys;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    for (int c = 1; c < 8; ++c) {
      if (owner[i][c] == kNoVertex) keys.push_back(morton_key(corner_of(tree[OctantId(i)], c)));
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// The lattice offsets (0, 1, 2 per axis) of local place 0..26, in half extents.
constexpr std::array<int, 3> steps_of(int place) { return {place % 3, place / 3 % 3, place / 9}; }

/// Bits of the octant's corners between which a local place lies (the place itself for a corner).
constexpr std::array<std::uint8_t, 27> corner_masks() {
  std::array<std::uint8_t, 27> masks{};
  for (int place = 0; place < 27; ++place) {
    const std::array<int, 3> at = steps_of(place);
    for (int corner = 0; corner < 8; ++corner) {
      bool between = true;
      for (int axis = 0; axis < 3; ++axis)
        between = between && (at[axis] == 1 || at[axis] == 2 * (corner >> axis & 1));
      if (between) masks[place] |= static_cast<std::uint8_t>(1u << corner);
    }
  }
  return masks;
}

}  // namespace

std::uint32_t OctreeVertices::find(const Lattice& p) const {
  const auto end = at.begin() + static_cast<std::ptrdiff_t>(corner_count());
  const auto it = std::lower_bound(at.begin(), end, p, morton_less);
  return it != end && *it == p ? static_cast<std::uint32_t>(it - at.begin()) : kNoVertex;
}

OctreeVertices octree_vertices(const Octree& tree) {
  Corners owner = octants_at_corners(tree);
  const std::vector<MortonKey> others = ownerless(tree, owner);
  // Merge two sorted lists, keeping for each item its place in the result.
  OctreeVertices vertices;
  vertices.at.reserve(2 * tree.size() + others.size());
  std::vector<std::uint32_t> octant_to_vertex(tree.size()), other_to_vertex(others.size());
  std::size_t next = 0;
  const auto take_others_below = [&](MortonKey end) {
    for (; next < others.size() && others[next] < end; ++next) {
      other_to_vertex[next] = static_cast<std::uint32_t>(vertices.at.size());
      vertices.at.push_back(lattice_of(others[next]));
    }
  };
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Lattice& corner = tree[OctantId(i)].corner;
    take_others_below(morton_key(corner));
    octant_to_vertex[i] = static_cast<std::uint32_t>(vertices.at.size());
    vertices.at.push_back(corner);
  }
  take_others_below(~MortonKey{0});

  vertices.finest_level.assign(vertices.at.size(), 0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Octant& o = tree[OctantId(i)];
    for (int c = 0; c < 8; ++c) {
      std::uint32_t& v = owner[i][c];
      if (v != kNoVertex) {
        v = octant_to_vertex[v];
      } else {
        const MortonKey key = morton_key(corner_of(o, c));
        v = other_to_vertex[std::lower_bound(others.begin(), others.end(), key) - others.begin()];
      }
      vertices.finest_level[v] = std::max(vertices.finest_level[v], o.level);
    }
  }
  for (const Octant& o : tree.octants()) {
    vertices.at.push_back(o.centre());
    vertices.finest_level.push_back(o.level);
  }
  vertices.corners = std::move(owner);
  return vertices;
}

namespace {

/// As OctreeVertices::find, by way of the octant that holds p: between its lower corner and the next octant's
/// stand few other vertices.
std::uint32_t find_near(const Octree& tree, const OctreeVertices& vertices, const Lattice& p) {
  if (std::max({p[0], p[1], p[2]}) >= kLatticeExtent) return vertices.find(p);
  const std::size_t o = tree.find(p).index();
  const auto first = vertices.at.begin() + vertices.corners[o][0];
  const auto last =
      vertices.at.begin() + (o + 1 < tree.size() ? vertices.corners[o + 1][0] : vertices.centre(OctantId(0)));
  const auto it = std::lower_bound(first, last, p, morton_less);
  return it != last && *it == p ? static_cast<std::uint32_t>(it - vertices.at.begin()) : kNoVertex;
}

}  // namespace

OctantLattice octant_lattice(const Octree& tree, const OctreeVertices& vertices, OctantId octant) {
  static constexpr auto kCornerMasks = corner_masks();
  const Octant& o = tree[octant];
  const auto& corners = vertices.corners[octant.index()];
  OctantLattice lattice;
  lattice.fill(kNoVertex);
  lattice[13] = vertices.centre(octant);
  // A finer neighbour across an edge or a face has children at all of its corners.
  std::uint8_t finer = 0;
  for (int c = 0; c < 8; ++c) {
    lattice[2 * (c & 1) + 6 * (c >> 1 & 1) + 18 * (c >> 2)] = corners[c];
    if (vertices.finest_level[corners[c]] > o.level) finer |= static_cast<std::uint8_t>(1u << c);
  }
  if ((finer & (finer - 1)) == 0) return lattice;
  const std::uint32_t half = o.extent() / 2;
  for (int place = 0; place < 27; ++place) {
    if (lattice[place] != kNoVertex || (kCornerMasks[place] & ~finer) != 0) continue;
    const std::array<int, 3> at = steps_of(place);
    lattice[place] = find_near(
        tree, vertices, {o.corner[0] + at[0] * half, o.corner[1] + at[1] * half, o.corner[2] + at[2] * half});
  }
  return lattice;
}

}  // namespace octet
