// SPDX-License-Identifier: BSD-3-Clause
// The interior that never enters the triangulation: tetrahedra between template octants, and the points that
// only these use.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "base/seed_points.h"
#include "classify/extract.h"
#include "octree/interior.h"
#include "octree/seeds.h"

namespace octet {

/// How the tetrahedra at an octant's faces come about. Those at a face belong to both octants there: the
/// lower role decides.
enum class OctantRole : std::uint8_t {
  kBand,  ///< by the triangulation, if it has any
  kNear,  ///< four a face, by the template; they go through finalization with the band's
  kDeep,  ///< the same, straight into the result
};

/// Faces of octants, a bit each, per octant.
class OctantFaces {
 public:
  explicit OctantFaces(std::size_t octants = 0) : bits_(octants, 0) {}

  [[nodiscard]] static std::uint8_t bit(int axis, bool upper) {
    return static_cast<std::uint8_t>(1U << (upper ? axis : 3 + axis));
  }
  [[nodiscard]] bool has(std::size_t octant, int axis, bool upper) const {
    return (bits_[octant] & bit(axis, upper)) != 0;
  }
  [[nodiscard]] bool any(std::size_t octant) const { return bits_[octant] != 0; }
  [[nodiscard]] bool all(std::size_t octant) const { return bits_[octant] == 0b11'1111; }
  /// From several threads at once.
  void add(std::size_t octant, int axis, bool upper) {
    std::atomic_ref(bits_[octant]).fetch_or(bit(axis, upper), std::memory_order_relaxed);
  }

 private:
  std::vector<std::uint8_t> bits_;
};

/// The points split into those of the band (triangulated) and those of the interior alone.
struct BandAndInterior {
  SeedPoints band;               ///< surface points first, as in the seeds, then band octree vertices
  std::vector<OctantRole> role;  ///< per octant
  OctantFaces near, deep;        ///< faces between template octants whose lower role is this
  std::size_t templates = 0;     ///< octants that are no band octants
  std::vector<std::uint32_t> band_point;  ///< per octree vertex: its number in `band`, UINT32_MAX where none
};

/// Near are the template octants that touch others: they give finalization room to move.
[[nodiscard]] BandAndInterior split_interior(const Model& model, const Octree& tree,
                                             const OctreeVertices& vertices, const OctreeLabels& labels,
                                             const Seeds& seeds, double length);

/// The near faces' tetrahedra over the joint numbering: appends the points that the band lacks to those of
/// the triangulated band (`points`, `on`). `first` of the result are the vertices that these or the band
/// share with deep tetrahedra. `tree` and `split` must outlive the result.
[[nodiscard]] ExtraTets near_tets(const Octree& tree, const OctreeVertices& vertices,
                                  const OctreeLabels& labels, const BandAndInterior& split,
                                  std::vector<Vec3>& points, std::vector<ModelRef>& on);

/// Volume of the deep tetrahedra, per region tag.
[[nodiscard]] std::vector<double> deep_volumes(const Octree& tree, const OctreeLabels& labels,
                                               const BandAndInterior& split, int regions);

/// Appends the deep faces' vertices and tetrahedra to a mesh whose first vertices are those that
/// near_tets() put first. Returns the number of tetrahedra appended. Cost: what it writes.
std::size_t append_deep(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, Mesh& mesh);

}  // namespace octet
