// SPDX-License-Identifier: BSD-3-Clause
// The limits of reading a part as options of every command that reads one.
#pragma once

#include <CLI/CLI.hpp>

#include "geom/occt/read_part.h"

namespace octet {

/// --read-time-limit and --read-memory-limit; both change what `reading` says.
void add_reading_options(CLI::App& command, ReadOptions& reading);

}  // namespace octet
