// SPDX-License-Identifier: BSD-3-Clause
// Numbers as read beside the model's.
#include "app/changed_numbers.h"

namespace octet {

std::vector<NumberChange> changed_numbers(const Provenance& provenance) {
  std::vector<NumberChange> changes;
  for (int dim = 0; dim < 4; ++dim) {
    const auto& entities = provenance.as_read[static_cast<std::size_t>(dim)];
    for (int number = 1; number < static_cast<int>(entities.size()); ++number) {
      const std::vector<int>& tags = entities[static_cast<std::size_t>(number)].tags;
      if (tags != std::vector<int>{number}) changes.push_back({{dim, number}, tags});
    }
  }
  return changes;
}

}  // namespace octet
