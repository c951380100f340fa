// SPDX-License-Identifier: BSD-3-Clause
// Volumes within the facets of regions.
#include "geom/facet_volumes.h"

#include <cstddef>

namespace octet {

std::vector<double> facet_volumes(const ModelParts& parts) {
  std::vector<double> volume(parts.regions.size(), 0.0);
  const Facets& facets = parts.facets;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto [a, b, c] = facet_corners(facets, i);
    const Vec3& origin = facets.nodes.front();
    const double share = (a - origin).dot((b - origin).cross(c - origin)) / 6.0;
    const auto& [behind, before] = parts.faces[facets.face[i]].region;
    volume[behind] += share;
    volume[before] -= share;
  }
  return volume;
}

}  // namespace octet
