// SPDX-License-Identifier: BSD-3-Clause
// Options may come from programs, which no parser has seen.
#include "app/option_check.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/size_check.h"

namespace octet {

void check_options(const MeshOptions& options) {
  if (options.order != 1 && options.order != 2)
    throw InputError(fmt::format("the order of elements must be 1 or 2, not {}", options.order));
  const double target = options.target_elements;
  if (!std::isfinite(target) || (target != 0.0 && target < 1.0))
    throw InputError(fmt::format("the number of elements to aim at must be at least 1, not {}", target));
  for (const double shift : options.shift)
    if (!(shift >= 0.0 && shift < 1.0))
      throw InputError(fmt::format("each shift in the lattice must lie in [0, 1), not {}", shift));
  check_control(options);
}

}  // namespace octet
