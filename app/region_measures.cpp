// SPDX-License-Identifier: BSD-3-Clause
// What the acceptance has summed up, and what the CAD says.
#include "app/region_measures.h"

#include <algorithm>
#include <cmath>

namespace octet {

std::vector<RegionMeasure> region_measures(const Acceptance& acceptance, const Model& model) {
  std::vector<RegionMeasure> regions;
  const std::vector<double>& filled = acceptance.filled;
  if (filled.empty()) return regions;
  for (int tag = 1; tag <= model.count(3); ++tag) {
    const auto r = static_cast<std::size_t>(tag);
    regions.push_back({tag, r < filled.size() ? filled[r] : 0.0, model.region(tag).volume});
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
  for (const int f : model.region(region).faces)
    if (!model.is_embedded(f)) area += model.face(f).area;
  return area > 0.0 ? model.region(region).volume / area : 0.0;
}

}  // namespace octet
