// SPDX-License-Identifier: BSD-3-Clause
// How a part is read, as options of every command that reads one.
#pragma once

#include "geom/occt/read_part.h"

namespace CLI {
class App;
}

namespace octet {

/// --no-fuse, --fuse-tolerance, --sew, --cap, --defeature, --read-time-limit and --read-memory-limit; they
/// change what `reading` says.
void add_reading_options(CLI::App& command, ReadOptions& reading);

}  // namespace octet
