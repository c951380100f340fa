// SPDX-License-Identifier: BSD-3-Clause
// The size options that several commands share, --config among them.
#pragma once

#include "app/size_words.h"

namespace CLI {
class App;
}

namespace octet {

/// Adds --size, --size-at, --curvature and the others to a command; and --config (app/config_file.h).
void add_size_options(CLI::App& command, SizeWords& words);

}  // namespace octet
