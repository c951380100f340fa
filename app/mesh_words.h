// SPDX-License-Identifier: BSD-3-Clause
// What may be asked of a mesh, as options of every command that makes one.
#pragma once

#include <string>
#include <vector>

#include "app/commands.h"

namespace CLI {
class App;
}

namespace octet {

inline constexpr const char* kUnitHelp = "mm (default), um, cm, m, inch, ft, ...";

/// Adds sizes, order, groups, what is periodic, unit, threads, bounds, finalization and reading: all but
/// where the mesh goes and what is told of it.
void add_mesh_wishes(CLI::App& command, MeshCommand& mesh);
/// `none_given`: what there is by default.
void add_order(CLI::App& command, int& order, const char* none_given);
void add_periodic(CLI::App& command, std::vector<std::string>& periodic);

/// Parses the words: first as they stand, then with what the files say that they name (app/config_file.h).
/// InputError, or what the parser throws.
void parse(CLI::App& app, const std::vector<std::string>& words);
/// What may have been meant by the first option that a command does not know: " (did you mean --size?)".
[[nodiscard]] std::string meant_option(const CLI::App& app);

/// The wishes of words as of the command line, "--size", "2" and the like, alone: no part, no files to write.
/// InputError with the reason when they mean nothing.
[[nodiscard]] MeshCommand parse_mesh_wishes(const std::vector<std::string>& words);

/// How a part is read, of words likewise, --unit among them; lengths in millimetre.
[[nodiscard]] ReadOptions parse_reading(const std::vector<std::string>& words);

}  // namespace octet
