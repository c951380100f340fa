// SPDX-License-Identifier: BSD-3-Clause
// The map from numbers as read to tags, turned round.
#include "geom/provenance.h"

#include <algorithm>

namespace octet {

std::vector<std::vector<int>> sources(const Provenance& provenance, int dim, int count) {
  std::vector<std::vector<int>> result(static_cast<std::size_t>(count) + 1);
  const auto& entities = provenance.as_read.at(static_cast<std::size_t>(dim));
  for (std::size_t number = 1; number < entities.size(); ++number)
    for (const int tag : entities[number].tags)
      result[static_cast<std::size_t>(tag)].push_back(static_cast<int>(number));
  return result;
}

std::vector<std::string> ids_in_file(const Provenance& provenance, int dim, const std::vector<int>& numbers) {
  std::vector<std::string> ids;
  const auto& entities = provenance.as_read.at(static_cast<std::size_t>(dim));
  for (const int number : numbers) {
    const int id = entities.at(static_cast<std::size_t>(number)).id;
    if (id == 0) continue;
    const std::string text = provenance.id_mark + std::to_string(id);
    if (std::find(ids.begin(), ids.end(), text) == ids.end()) ids.push_back(text);
  }
  return ids;
}

std::vector<Overlap> overlaps(const Provenance& provenance, int regions) {
  std::vector<Overlap> result;
  const auto solids = sources(provenance, 3, regions);
  for (int region = 1; region <= regions; ++region)
    if (solids[static_cast<std::size_t>(region)].size() > 1)
      result.push_back({region, solids[static_cast<std::size_t>(region)]});
  return result;
}

}  // namespace octet
