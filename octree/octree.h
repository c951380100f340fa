// SPDX-License-Identifier: BSD-3-Clause
// The linear octree: a sorted array of terminal octants over an integer lattice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/ids.h"
#include "base/size_field.h"
#include "base/size_sample.h"
#include "base/vec.h"
#include "geom/model.h"
#include "octree/octant.h"
#include "octree/root.h"

namespace octet {

/// Mean edge length of the finished mesh over the length of the octants it was made from, where these are
/// uniform: in the lattice of their vertices and centres 0.923 (three edges, three lines between centres and
/// eight from a centre to a vertex an octant); 0.92 to 0.94 in thick parts, 0.96 in plates. A mesh of size h
/// needs octants of length h / kEdgePerOctant.
inline constexpr double kEdgePerOctant = 0.925;

/// Spacing of points on the boundary over the length of octants: what makes triangles there as large as the
/// tetrahedra inside.
inline constexpr double kSpacingPerOctant = 0.75;

/// Invariants: octants are sorted in Morton order of their corners, cover the root without overlap, and
/// octants that share a face, an edge or a corner differ by at most one level (`check_octree`). Consequences:
/// the children of one octant are neighbours in the array, and an octant's faces and edges hold at most one
/// level of hanging vertices. Cost: 24 bytes an octant and at most 4 for the buckets that make find O(1)
/// where the tree is uniform, O(log n) at worst.
class Octree {
 public:
  Octree(const Vec3& origin, double root_size, std::vector<Octant> sorted);

  [[nodiscard]] std::size_t size() const { return octants_.size(); }
  [[nodiscard]] const Octant& operator[](OctantId o) const { return octants_[o.index()]; }
  [[nodiscard]] std::span<const Octant> octants() const { return octants_; }
  [[nodiscard]] const Root& root() const { return root_; }
  [[nodiscard]] double root_size() const { return root_.size; }
  [[nodiscard]] const Vec3& origin() const { return root_.origin; }
  /// Edge length of an octant of that level, model units.
  [[nodiscard]] double length(int level) const { return root_.length(level); }
  [[nodiscard]] Vec3 position(const Lattice& p) const { return root_.position(p); }
  [[nodiscard]] Box3 box(OctantId o) const { return root_.box((*this)[o]); }
  /// The octant that holds p (lower faces included); points outside the root are clamped into it.
  [[nodiscard]] OctantId find(const Vec3& p) const { return find(root_.cell_of(p)); }
  /// The octant that holds the lattice point (its cell [p, p+1)). Requires p below 2^kLatticeLevels.
  [[nodiscard]] OctantId find(const Lattice& p) const { return find_key(morton_key(p)); }
  /// The octant across that face (axis 0..2, upper or lower) if it is of the same level.
  [[nodiscard]] std::optional<OctantId> across(OctantId o, int axis, bool upper) const;
  /// Whether there are octants of the same level across all six faces, and all of them are such.
  template <class Test>
  [[nodiscard]] bool all_across(OctantId o, const Test& test) const {
    for (int face = 0; face < 6; ++face) {
      const std::optional<OctantId> other = across(o, face / 2, face % 2 != 0);
      if (!other || !test(*other)) return false;
    }
    return true;
  }
  /// Length of the octant that holds p.
  [[nodiscard]] double length_at(const Vec3& p) const { return length((*this)[find(p)].level); }
  /// Spacing of points on the boundary where p is, and the unit of their distances.
  [[nodiscard]] double spacing_at(const Vec3& p) const { return kSpacingPerOctant * length_at(p); }

 private:
  [[nodiscard]] OctantId find_key(MortonKey key) const;

  Root root_;
  std::vector<Octant> octants_;
  std::vector<MortonKey> keys_;               // of the octants' corners
  std::vector<std::uint32_t> bucket_octant_;  // per key prefix: the octant that holds its first cell
  int bucket_shift_ = 0;
};

struct OctreeRequest {
  double size = 0.0;  ///< octant length: a level of the tree, up to place_root()'s rounding
  std::size_t max_octants = 50'000'000;  ///< LimitError beyond
  std::vector<double> region_size = {};  ///< octant length per region tag, infinite for none; may be empty
  SizeField field = {};                  ///< octant lengths over space; may be empty
  int layers = 1;                        ///< octants of a level side by side before they may double
  std::array<double, 3> shift = kRootShift;  ///< of the part's box in the lattice, as in place_root()
  std::size_t max_within = 50'000'000;       ///< octants inside or on the boundary; LimitError beyond
  std::function<bool()> cancelled = {};      ///< asked often; true ends with Cancelled; may be empty
};

/// The sizes of a request, or of samples, need more octants than it allows.
class TooManyOctants : public LimitError {
 public:
  TooManyOctants(const std::string& message, std::optional<Box3> finest)
      : LimitError(message), finest_(finest) {}
  /// The octant for which a field wants the smallest size so far; none where all were still to have the
  /// request's own size or regions'.
  [[nodiscard]] const std::optional<Box3>& finest() const { return finest_; }

 private:
  std::optional<Box3> finest_;
};

/// A sample wants smaller octants than there are.
class TooFine : public LimitError {
 public:
  TooFine(const std::string& message, const SizeSample& sample, double finest)
      : LimitError(message), sample_(sample), finest_(finest) {}
  [[nodiscard]] const SizeSample& sample() const { return sample_; }
  [[nodiscard]] double finest() const { return finest_; }  ///< length of octants

 private:
  SizeSample sample_;
  double finest_;
};

/// Builds the tree [Schroeder & Shephard 1990, "Tree building"; Handbook 15.4]: every octant that meets the
/// model's inside or boundary has at most length h; every octant that holds a size sample has at most the
/// sample's size; every octant inside or on the boundary at most what region and field want in it; then the
/// one-level difference over 26 neighbours, or slower growth (octree/gradation). Outside, octants are as
/// large as that allows. TooManyOctants past max_octants or max_within, before memory is taken for them
/// (within a second where the volume alone exceeds it); TooFine for samples past kDeepestLevel levels,
/// LimitError for a size past them; InputError for a size, also one of the field, that is no positive number.
/// The field may be infinite.
[[nodiscard]] Octree build_octree(const Model& model, const OctreeRequest& request,
                                  std::span<const SizeSample> samples);

/// Splits the given octants once each and restores the one-level difference. Octants of the finest level stay
/// as they are.
[[nodiscard]] Octree refine(const Octree& tree, std::span<const OctantId> octants);

/// Empty when the invariants hold, else one line that says where they do not.
[[nodiscard]] std::string check_octree(const Octree& tree);

}  // namespace octet
