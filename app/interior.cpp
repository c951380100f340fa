// SPDX-License-Identifier: BSD-3-Clause
// Template octants: their points kept out of the band, their tetrahedra looked up.
#include "app/interior.h"

#include <memory>

#include "delaunay/templates.h"

namespace octet {

BandAndInterior split_interior(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                               const OctreeLabels& labels, const Seeds& seeds) {
  BandAndInterior split;
  split.templates = template_octants(model, tree, vertices, labels, seeds.octree_vertex_kept, seeds.points);
  const std::vector<std::uint8_t> in_band =
      band_vertices(tree, vertices, split.templates, seeds.octree_vertex_kept);
  const SeedPoints& all = seeds.points;
  const auto take = [&](std::size_t n) {
    split.band.add(all.position[n], all.on[n], all.order[n], all.spacing[n]);
    return static_cast<std::uint32_t>(split.band.size() - 1);
  };
  for (std::size_t n = 0; n < seeds.surface_points; ++n) take(n);
  split.band_point.assign(vertices.size(), UINT32_MAX);
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (!seeds.octree_vertex_kept[v]) continue;
    if (in_band[v])
      split.band_point[v] = take(seeds.octree_point[v]);
    else
      split.interior_vertex.push_back(v);
  }
  return split;
}

ExtraTets template_tets(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, std::vector<Vec3>& points, std::vector<ModelRef>& on) {
  std::vector<std::uint32_t> number = split.band_point;
  for (const std::uint32_t v : split.interior_vertex) {
    number[v] = static_cast<std::uint32_t>(points.size());
    points.push_back(tree.position(vertices.at[v]));
    on.push_back(model_region(labels.vertex_region[v]));
  }
  ExtraTets extra;
  TemplateTable table;
  auto is_template = std::make_shared<std::vector<std::uint8_t>>(tree.size(), 0);
  for (const TemplateOctant& octant : split.templates) {
    (*is_template)[octant.octant.index()] = 1;
    OctantPattern pattern;
    for (std::size_t b = 0; b < kHangingPoint.size(); ++b)
      if (octant.vertex[kHangingPoint[b]] != UINT32_MAX) pattern.hanging |= 1u << b;
    for (std::size_t p = 0; p < 27; ++p)
      if (octant.vertex[p] != UINT32_MAX) pattern.rank[p] = vertices.rank(octant.vertex[p]);
    for (const auto& t : table.tets(pattern)) {
      extra.tets.push_back({number[octant.vertex[t[0]]], number[octant.vertex[t[1]]],
                            number[octant.vertex[t[2]]], number[octant.vertex[t[3]]]});
      extra.region.push_back(labels.region[octant.octant.index()]);
    }
  }
  extra.covers = [is_template, &tree](const Vec3& centroid) {
    return (*is_template)[tree.find(centroid).index()] != 0;
  };
  return extra;
}

}  // namespace octet
