// SPDX-License-Identifier: BSD-3-Clause
// The sorted array of octants, its buckets, and the test of its invariants.
#include "octree/octree.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"

namespace octet {
namespace {

std::string named(const Octant& o) {
  return fmt::format("level {} at ({}, {}, {})", o.level, o.corner[0], o.corner[1], o.corner[2]);
}

std::string check_cover(const Octree& tree) {
  MortonKey expected = 0;
  for (const Octant& o : tree.octants()) {
    if (o.level < 0 || o.level > kDeepestLevel) return "no such level: " + named(o);
    for (const std::uint32_t x : o.corner) {
      if (x % o.extent() != 0 || x >= kLatticeExtent) return "corner off its own lattice: " + named(o);
    }
    if (morton_key(o.corner) != expected) return "gap, overlap or disorder before octant of " + named(o);
    expected += MortonKey{1} << (3 * (kLatticeLevels - o.level));
  }
  return expected == MortonKey{1} << (3 * kLatticeLevels) ? "" : "the octants end before the root does";
}

/// A finer neighbour sees the coarser one, so looking for neighbours that are too coarse is enough.
std::string check_one_level_difference(const Octree& tree) {
  for (const Octant& o : tree.octants()) {
    const auto e = static_cast<std::int64_t>(o.extent());
    for (int direction = 0; direction < 27; ++direction) {
      const std::array<int, 3> step{direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1};
      Lattice p{};
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t x = o.corner[axis] + step[axis] * e;
        inside = inside && x >= 0 && x < kLatticeExtent;
        p[axis] = static_cast<std::uint32_t>(x);
      }
      if (!inside) continue;
      const Octant& neighbour = tree[tree.find(p)];
      if (neighbour.level < o.level - 1) return named(o) + " has a neighbour of " + named(neighbour);
    }
  }
  return "";
}

}  // namespace

Octree::Octree(const Vec3& origin, double root_size, std::vector<Octant> sorted)
    : root_{origin, root_size}, octants_(std::move(sorted)) {
  OCTET_CHECK(!octants_.empty());
  keys_.resize(octants_.size());
  std::transform(octants_.begin(), octants_.end(), keys_.begin(),
                 [](const Octant& o) { return morton_key(o.corner); });
  int level = 0;
  while (level < kLatticeLevels && std::size_t{1} << (3 * (level + 1)) <= octants_.size()) ++level;
  bucket_shift_ = 3 * (kLatticeLevels - level);
  bucket_octant_.resize((std::size_t{1} << (3 * level)) + 1);
  std::uint32_t octant = 0;
  for (std::size_t bucket = 0; bucket + 1 < bucket_octant_.size(); ++bucket) {
    const MortonKey first = MortonKey{bucket} << bucket_shift_;
    while (octant + 1 < keys_.size() && keys_[octant + 1] <= first) ++octant;
    bucket_octant_[bucket] = octant;
  }
  bucket_octant_.back() = static_cast<std::uint32_t>(keys_.size() - 1);
}

OctantId Octree::find_key(MortonKey key) const {
  const std::size_t bucket = key >> bucket_shift_;
  OCTET_DCHECK(bucket + 1 < bucket_octant_.size());
  const auto first = keys_.begin() + bucket_octant_[bucket];
  const auto last = keys_.begin() + bucket_octant_[bucket + 1] + 1;
  return OctantId(static_cast<std::size_t>(std::upper_bound(first, last, key) - keys_.begin()) - 1);
}

std::string check_octree(const Octree& tree) {
  const std::string cover = check_cover(tree);
  return cover.empty() ? check_one_level_difference(tree) : cover;
}

std::optional<OctantId> Octree::across(OctantId o, int axis, bool upper) const {
  const Octant& octant = (*this)[o];
  Lattice p = octant.corner;
  if (upper ? p[axis] + octant.extent() == kLatticeExtent : p[axis] == 0) return std::nullopt;
  p[axis] = upper ? p[axis] + octant.extent() : p[axis] - octant.extent();
  const OctantId other = find(p);
  if ((*this)[other].level != octant.level) return std::nullopt;
  return other;
}

}  // namespace octet
