// SPDX-License-Identifier: BSD-3-Clause
// Is configured, not built: that would be all of the library.
#include <app/mesh_part.h>
