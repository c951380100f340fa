// SPDX-License-Identifier: BSD-3-Clause
// What an exception is to whoever called.
#pragma once

#include <exception>
#include <string>

#include "app/exit_code.h"

namespace octet {

struct Failure {
  ExitCode code = kExitFailed;
  std::string text;
};

/// Of an exception of any kind.
[[nodiscard]] Failure failure_of(const std::exception_ptr& exception);

}  // namespace octet
