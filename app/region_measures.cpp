// SPDX-License-Identifier: BSD-3-Clause
// Sums over blocks, added in their order.
#include "app/region_measures.h"

#include <algorithm>
#include <cmath>

#include "base/blocks.h"
#include "mesh/quality.h"

namespace octet {
namespace {

constexpr std::size_t kBlock = 262144;

struct Sum {
  std::size_t tets = 0;
  double volume = 0.0;
};

}  // namespace

std::vector<RegionMeasure> region_measures(const Mesh& mesh, const Model& model) {
  const auto count = static_cast<std::size_t>(model.count(3));
  std::vector<RegionMeasure> regions(count);
  for (std::size_t r = 0; r < count; ++r) {
    regions[r].tag = static_cast<int>(r) + 1;
    regions[r].cad_volume = model.region(regions[r].tag).volume;
  }
  const auto of_block = [&](std::size_t first, std::size_t last) {
    std::vector<Sum> sums(count);
    for (std::size_t t = first; t < last; ++t) {
      const auto& [a, b, c, d] = mesh.tets[t];
      const auto region = static_cast<std::size_t>(mesh.tet_in[t]);
      if (region < 1 || region > count) continue;
      Sum& sum = sums[region - 1];
      ++sum.tets;
      sum.volume += signed_volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
    }
    return sums;
  };
  for (const std::vector<Sum>& sums : map_blocks<std::vector<Sum>>(mesh.tets.size(), kBlock, of_block))
    for (std::size_t r = 0; r < count; ++r) {
      regions[r].tets += sums[r].tets;
      regions[r].volume += sums[r].volume;
    }
  return regions;
}

const RegionMeasure* least_alike(const std::vector<RegionMeasure>& regions) {
  const auto found = std::max_element(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return std::abs(a.relative_error()) < std::abs(b.relative_error());
  });
  return found == regions.end() ? nullptr : &*found;
}

double size_that_rounds(const Model& model, int region) {
  double area = 0.0;
  for (int f = 1; f <= model.count(2); ++f) {
    const auto& sides = model.face(f).region;
    if ((sides[0] == region) != (sides[1] == region)) area += model.face(f).area;
  }
  return area > 0.0 ? model.region(region).volume / area : 0.0;
}

}  // namespace octet
