// SPDX-License-Identifier: BSD-3-Clause
// Options that stand in a file.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace octet {

constexpr const char* kConfig = "--config";

/// The command line with what the files of --config say put in behind the command's name, as far as the
/// command line does not say it itself: an option of its own, or one that excludes the file's, prevails; of
/// --size-at place by place. A later file prevails over an earlier one in the same way. `command` has
/// parsed `arguments`, whether it took them or not.
///
/// A file is a JSON object or TOML: {"size": 2, "size-at": ["Face12=0.5"]}, in the words of the options
/// without their dashes; "size-at" may also be an object, {"Face12": 0.5}. InputError for a file that
/// is neither, and for a key that is no option of the command, stands twice or has no fit value.
[[nodiscard]] std::vector<std::string> with_config(const CLI::App& command,
                                                   const std::vector<std::string>& arguments);

}  // namespace octet
