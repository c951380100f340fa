// SPDX-License-Identifier: BSD-3-Clause
// Which entities bear another number than the file gives them.
#pragma once

#include <vector>

#include "base/model_ref.h"
#include "geom/provenance.h"

namespace octet {

/// What fusing, healing and leaving out have made of a number of the file.
struct NumberChange {
  ModelRef as_read;
  std::vector<int> tags;  ///< ascending; none where it is not in the model; never just the number as read
};

/// All numbers of the file that are no more their entity's, by dimension and number.
[[nodiscard]] std::vector<NumberChange> changed_numbers(const Provenance& provenance);

}  // namespace octet
