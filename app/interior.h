// SPDX-License-Identifier: BSD-3-Clause
// The interior that never enters the triangulation: template octants, and the points that only they use.
#pragma once

#include <vector>

#include "base/seed_points.h"
#include "classify/extract.h"
#include "octree/interior.h"
#include "octree/seeds.h"

namespace octet {

/// The points split into those of the band (triangulated) and those of the interior alone.
struct BandAndInterior {
  SeedPoints band;  ///< surface points first, as in the seeds, then band octree vertices
  std::vector<TemplateOctant> templates;
  std::vector<std::uint32_t> interior_vertex;  ///< octree vertex numbers that no band tetrahedron uses
  std::vector<std::uint32_t> band_point;  ///< per octree vertex: its number in `band`, UINT32_MAX where none
};

[[nodiscard]] BandAndInterior split_interior(const Model& model, const Octree& tree,
                                             const OctreeVertices& vertices, const OctreeLabels& labels,
                                             const Seeds& seeds);

/// Appends the interior's points to those of the triangulated band (`points`, `on`) and gives the template
/// octants' tetrahedra over the joint numbering. `tree`, `labels` and `split` must outlive the result.
[[nodiscard]] ExtraTets template_tets(const Octree& tree, const OctreeVertices& vertices,
                                      const OctreeLabels& labels, const BandAndInterior& split,
                                      std::vector<Vec3>& points, std::vector<ModelRef>& on);

}  // namespace octet
