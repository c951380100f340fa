// SPDX-License-Identifier: BSD-3-Clause
// Whether the options of a run make sense.
#pragma once

#include "app/mesh_part.h"

namespace octet {

/// InputError with the option and what it must be. Sizes: geom/size_check.h; threads: app/usable_threads.h.
void check_options(const MeshOptions& options);

}  // namespace octet
