// SPDX-License-Identifier: BSD-3-Clause
// Work that may hang, crash or take all memory, run in a process of its own.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace octet {

struct ChildLimits {
  double seconds = 0.0;   ///< wall time; 0: none
  std::size_t bytes = 0;  ///< resident memory beyond that at the start, looked at 50 times a second; 0: none
};

/// The work came to no end: it took too long, needed too much memory, crashed or was killed.
class NoEnd : public InputError {
 public:
  NoEnd(const std::string& message, std::string stage) : InputError(message), stage_(std::move(stage)) {}
  /// What was being done, in the words of the log.
  [[nodiscard]] const std::string& stage() const { return stage_; }

 private:
  std::string stage_;
};

/// Told what comes next; the words complete "while ...", as in "fusing 12 solids".
using StageLog = std::function<void(const std::string&)>;

/// What the child does: returns the answer, or throws an Error that the parent then throws.
using ChildWork = std::function<std::string(const StageLog&)>;

/// Whether fork() is safe here: the child of a process with several threads may find locks held for ever.
[[nodiscard]] bool has_one_thread();

/// Forks, runs `work` in the child and returns its answer. Requires has_one_thread().
/// NoEnd: the work took too long, needed too much memory or crashed. Errors of the work
/// itself come out as they were thrown (InputError, ModelError with its entity, Bug, std::bad_alloc). The
/// child is gone when this returns or throws. Cancelled: the child was interrupted.
[[nodiscard]] std::string run_in_child(const ChildWork& work, const ChildLimits& limits);

/// The same in a new process: starts `program`, whose main() is serve_helper(), and hands it `request`.
/// Safe with any number of threads; costs the start of a program. InputError also when the program is of
/// another version.
[[nodiscard]] std::string run_in_helper(const std::filesystem::path& program, const std::string& version,
                                        std::string_view request, const ChildLimits& limits);

/// The other end of run_in_helper(): says the version, reads the request, answers, returns the exit code.
int serve_helper(const std::string& version,
                 const std::function<std::string(std::string_view request, const StageLog&)>& work);

}  // namespace octet
