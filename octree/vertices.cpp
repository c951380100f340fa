// SPDX-License-Identifier: BSD-3-Clause
// Unique vertices without sorting them all, and the vertices around one octant.
//
// A vertex that does not hang and does not lie on the root's far faces is the lower corner of the octant that
// holds its cell, and octants are sorted already. Only the others (a surface's worth) need a sort.
#include "octree/vertices.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "base/blocks.h"
#include "base/sort_unique.h"

namespace octet {
namespace {

using Corners = std::vector<std::array<std::uint32_t, 8>>;

Lattice corner_of(const Octant& o, int corner) {
  const std::uint32_t e = o.extent();
  return {o.corner[0] + (corner & 1) * e, o.corner[1] + (corner >> 1 & 1) * e,
          o.corner[2] + (corner >> 2) * e};
}

/// The octant that has p as its lower corner, kNoVertex when there is none; `guess` is looked at first.
std::uint32_t octant_at(const Octree& tree, const Lattice& p, std::size_t guess) {
  if (guess < tree.size() && tree[OctantId(guess)].corner == p) return static_cast<std::uint32_t>(guess);
  if (std::max({p[0], p[1], p[2]}) == kLatticeExtent) return kNoVertex;
  const OctantId found = tree.find(p);
  return tree[found].corner == p ? found.index() : kNoVertex;
}

/// Per octant and corner: the octant that has that point as its lower corner, kNoVertex when there is none.
/// Half of those at the corners along the axes are siblings. The other corners are corners along the axes of
/// those octants, where these are of the same level.
Corners octants_at_corners(const Octree& tree) {
  Corners owner(tree.size());
  const auto fill = [&](const auto& corners_of) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.size()), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) corners_of(i, tree[OctantId(i)]);
    });
  };
  fill([&](std::size_t i, const Octant& o) {
    owner[i][0] = static_cast<std::uint32_t>(i);
    for (const int axis : {1, 2, 4})
      owner[i][axis] = octant_at(tree, corner_of(o, axis), i + static_cast<std::size_t>(axis));
  });
  const auto by_way_of = [&](std::size_t i, const Octant& o, int beside, int axis) {
    const std::uint32_t other = owner[i][beside];
    return other != kNoVertex && tree[OctantId(other)].level == o.level
               ? owner[other][axis]
               : octant_at(tree, corner_of(o, beside + axis), tree.size());
  };
  fill([&](std::size_t i, const Octant& o) {
    owner[i][3] = by_way_of(i, o, 1, 2);
    owner[i][5] = by_way_of(i, o, 1, 4);
    owner[i][6] = by_way_of(i, o, 2, 4);
    owner[i][7] = by_way_of(i, o, 3, 4);
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
  sort_unique(keys);
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

/// Calls visit(place, vertex) for each vertex that hangs on the octant.
template <class Visit>
void find_hanging(const Octree& tree, const OctreeVertices& vertices, OctantId octant, const Visit& visit) {
  static constexpr auto kCornerMasks = corner_masks();
  const Octant& o = tree[octant];
  const auto& corners = vertices.corners[octant.index()];
  // A finer neighbour across an edge or a face has children at all of its corners.
  std::uint8_t finer = 0;
  for (int c = 0; c < 8; ++c)
    if (vertices.finest_level[corners[c]] > o.level) finer |= static_cast<std::uint8_t>(1u << c);
  if ((finer & (finer - 1)) == 0) return;
  const std::uint32_t half = o.extent() / 2;
  for (std::uint32_t place = 0; place < kCornerMasks.size(); ++place) {
    const std::uint8_t between = kCornerMasks[place];
    const bool is_corner_or_centre = (between & (between - 1)) == 0 || between == 0xff;
    if (is_corner_or_centre || (between & ~finer) != 0) continue;
    const std::array<int, 3> at = steps_of(static_cast<int>(place));
    const std::uint32_t v = find_near(
        tree, vertices, {o.corner[0] + at[0] * half, o.corner[1] + at[1] * half, o.corner[2] + at[2] * half});
    if (v != kNoVertex) visit(place, v);
  }
}

/// Once, for octants are asked for their vertices again and again.
void list_hanging(const Octree& tree, OctreeVertices& vertices) {
  vertices.hanging_begin.assign(tree.size() + 1, 0);
  vertices.hanging = collect<OctreeVertices::Hanging>(
      tree.size(), [&](std::size_t i, std::vector<OctreeVertices::Hanging>& hanging) {
        const std::size_t before = hanging.size();
        find_hanging(tree, vertices, OctantId(i), [&](std::uint32_t place, std::uint32_t v) {
          hanging.push_back({v, place});
        });
        vertices.hanging_begin[i + 1] = static_cast<std::uint32_t>(hanging.size() - before);
      });
  for (std::size_t i = 0; i < tree.size(); ++i) vertices.hanging_begin[i + 1] += vertices.hanging_begin[i];
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
  list_hanging(tree, vertices);
  return vertices;
}

OctantLattice octant_lattice(const OctreeVertices& vertices, OctantId octant) {
  const auto& corners = vertices.corners[octant.index()];
  OctantLattice lattice;
  lattice.fill(kNoVertex);
  lattice[13] = vertices.centre(octant);
  for (int c = 0; c < 8; ++c) lattice[2 * (c & 1) + 6 * (c >> 1 & 1) + 18 * (c >> 2)] = corners[c];
  for (const OctreeVertices::Hanging& h : vertices.hanging_on(octant)) lattice[h.place] = h.vertex;
  return lattice;
}

}  // namespace octet
