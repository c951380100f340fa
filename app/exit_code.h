// SPDX-License-Identifier: BSD-3-Clause
// What the program tells its caller when it ends.
#pragma once

namespace octet {

enum ExitCode : int {
  kExitComplete = 0,    ///< done; for `mesh` and `check`: every claim holds
  kExitBadInput = 2,    ///< the part, an option, a limit or an output path; nothing was written
  kExitIncomplete = 3,  ///< a mesh was written, and some claims do not hold; the faults are listed
  kExitFailed = 4,      ///< no mesh: cancelled, out of memory, or a defect of Octet
};

}  // namespace octet
