// SPDX-License-Identifier: BSD-3-Clause
// The linear octree: a sorted array of terminal octants over an integer lattice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/ids.h"
#include "base/size_sample.h"
#include "base/vec.h"
#include "base/vertex_order.h"
#include "geom/model.h"

namespace octet {

/// A lattice point: coordinates 0..2^kLatticeLevels over the root.
using Lattice = std::array<std::uint32_t, 3>;

/// A terminal octant: its lower corner on the lattice and its level (root = 0).
struct Octant {
  Lattice corner{};
  std::int8_t level = 0;

  /// Edge length on the lattice.
  [[nodiscard]] std::uint32_t extent() const { return std::uint32_t{1} << (kLatticeLevels - level); }
  bool operator==(const Octant&) const = default;
};

/// Invariants: octants are sorted in Morton order of their corners, cover the root without overlap, and
/// octants that share a face, an edge or a corner differ by at most one level (`check_octree`). Cost: 16
/// bytes an octant; find is O(log n).
class Octree {
 public:
  Octree(const Vec3& origin, double root_size, std::vector<Octant> sorted);

  [[nodiscard]] std::size_t size() const { return octants_.size(); }
  [[nodiscard]] const Octant& operator[](OctantId o) const { return octants_[o.index()]; }
  [[nodiscard]] std::span<const Octant> octants() const { return octants_; }
  [[nodiscard]] double root_size() const { return root_size_; }
  [[nodiscard]] const Vec3& origin() const { return origin_; }
  /// Edge length of an octant of that level, model units.
  [[nodiscard]] double length(int level) const { return root_size_ / static_cast<double>(1u << level); }
  [[nodiscard]] Vec3 position(const Lattice& p) const;
  [[nodiscard]] Box3 box(OctantId o) const;
  /// The octant that holds p (lower faces included); points outside the root are clamped into it.
  [[nodiscard]] OctantId find(const Vec3& p) const;
  /// The octant that holds the lattice point (its cell [p, p+1)).
  [[nodiscard]] OctantId find(const Lattice& p) const;
  /// Length of the octant that holds p.
  [[nodiscard]] double size_at(const Vec3& p) const { return length((*this)[find(p)].level); }

 private:
  Vec3 origin_;
  double root_size_;
  std::vector<Octant> octants_;
};

struct OctreeRequest {
  double size = 0.0;                     ///< h; the root is scaled so that h is exactly a level
  std::size_t max_octants = 50'000'000;  ///< LimitError beyond
};

/// Builds the tree [Schroeder & Shephard 1990, "Tree building"; Handbook 15.4]: every octant that meets the
/// model's inside or boundary has at most length h; every octant that holds a size sample and meets the model
/// has at most the sample's size; then the one-level difference over 26 neighbours. The root is shifted by an
/// irrational share of h so that model planes do not fall on octant planes. LimitError past max_octants.
[[nodiscard]] Octree build_octree(const Model& model, const OctreeRequest& request,
                                  std::span<const SizeSample> samples);

/// Refines the given octants once each and restores the one-level difference.
[[nodiscard]] Octree refine(const Octree& tree, std::span<const OctantId> octants);

/// Empty when the invariants hold, else one line that says where they do not.
[[nodiscard]] std::string check_octree(const Octree& tree);

}  // namespace octet
