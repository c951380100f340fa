// SPDX-License-Identifier: BSD-3-Clause
// What a failed CHECK throws.
#include "base/check.h"

#include <string>

#include "base/error.h"

namespace octet {

void check_failed(const char* condition, const char* file, int line) {
  throw Bug(std::string("internal error: ") + condition + " (" + file + ":" + std::to_string(line) + ")");
}

}  // namespace octet
