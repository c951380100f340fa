// SPDX-License-Identifier: BSD-3-Clause
// How a part is read, as options of every command that reads one.
#pragma once

#include "app/length_unit.h"
#include "geom/occt/read_part.h"

namespace CLI {
class App;
}

namespace octet {

/// --no-fuse, --fuse-tolerance, --sew, --cap, --defeature, --read-time-limit and --read-memory-limit; they
/// change what `reading` says. Its lengths are then in the user's unit.
void add_reading_options(CLI::App& command, ReadOptions& reading);

/// With lengths that are in this unit in millimetre.
[[nodiscard]] ReadOptions in_millimetres(ReadOptions reading, const LengthUnit& unit);

}  // namespace octet
