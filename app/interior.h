// SPDX-License-Identifier: BSD-3-Clause
// The interior that never enters the triangulation: tetrahedra between template octants, and the points that
// only these use.
#pragma once

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

/// The points split into those of the band (triangulated) and those of the interior alone.
struct BandAndInterior {
  SeedPoints band;               ///< surface points first, as in the seeds, then band octree vertices
  std::vector<OctantRole> role;  ///< per octant
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
