// SPDX-License-Identifier: BSD-3-Clause
// The size options that several commands share, and the file they may stand in.
#pragma once

#include <string>
#include <vector>

#include "app/size_words.h"

namespace CLI {
class App;
}

namespace octet {

/// Adds --size, --size-at, --curvature and the others to a command.
void add_size_options(CLI::App& command, SizeWords& words);

/// The command line with the contents of the files of --config put in before its own options, so that these
/// prevail. A file is JSON or TOML: {"size": 2, "size-at": ["Face12=0.5"]}, in the words of the options
/// without their dashes; "size-at" may also be an object, {"Face12": 0.5}. InputError when a file cannot be
/// read; words that are no options are left for the parser to refuse.
[[nodiscard]] std::vector<std::string> with_config(const std::vector<std::string>& arguments);

}  // namespace octet
