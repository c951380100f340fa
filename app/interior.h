// SPDX-License-Identifier: BSD-3-Clause
// The interior that never enters the triangulation: template octants, and the points that only they use.
#pragma once

#include <cstdint>
#include <vector>

#include "base/seed_points.h"
#include "classify/extract.h"
#include "octree/interior.h"
#include "octree/seeds.h"

namespace octet {

/// How an octant's tetrahedra come about.
enum class OctantRole : std::uint8_t {
  kBand,  ///< by the triangulation, if it has any
  kNear,  ///< by a template, and they go through finalization with the band's
  kDeep,  ///< by one of the two templates of octants without hanging vertices, straight into the result
};

/// The points split into those of the band (triangulated) and those of the interior alone.
struct BandAndInterior {
  SeedPoints band;               ///< surface points first, as in the seeds, then band octree vertices
  std::vector<OctantRole> role;  ///< per octant
  std::size_t templates = 0;     ///< octants that are no band octants
  std::vector<std::uint32_t> band_point;  ///< per octree vertex: its number in `band`, UINT32_MAX where none
};

/// Near are the octants with hanging vertices, whose templates have angles down to 17 degrees, and those
/// around them, which give finalization room to move.
[[nodiscard]] BandAndInterior split_interior(const Model& model, const Octree& tree,
                                             const OctreeVertices& vertices, const OctreeLabels& labels,
                                             const Seeds& seeds, double length);

/// The near octants' tetrahedra over the joint numbering: appends the points that the band lacks to those of
/// the triangulated band (`points`, `on`). `first` of the result are the vertices that near or band octants
/// share with deep ones. `tree` and `split` must outlive the result.
[[nodiscard]] ExtraTets near_tets(const Octree& tree, const OctreeVertices& vertices,
                                  const OctreeLabels& labels, const BandAndInterior& split,
                                  std::vector<Vec3>& points, std::vector<ModelRef>& on);

/// Volume of the deep octants, per region tag.
[[nodiscard]] std::vector<double> deep_volumes(const Octree& tree, const OctreeLabels& labels,
                                               const BandAndInterior& split, int regions);

/// Appends the deep octants' vertices and tetrahedra to a mesh whose first vertices are those that
/// near_tets() put first. Returns the number of tetrahedra appended. Cost: what it writes.
std::size_t append_deep(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, Mesh& mesh);

}  // namespace octet
