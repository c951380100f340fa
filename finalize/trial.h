// SPDX-License-Identifier: BSD-3-Clause
// Operations that are done together, and taken back together unless they are kept.
#pragma once

#include "finalize/workshop.h"

namespace octet {

/// From its making on the changes of the mesh, of the guard's account and of the report are written down; at
/// its end all is as it was, but for the work done and marks of walks, unless `keep` was called. One at a
/// time. Cost: that of the changes.
class Trial {
 public:
  explicit Trial(Workshop& shop);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial();
  void keep();

 private:
  Workshop& shop_;
  FinalizeReport report_;
  bool kept_ = false;
};

}  // namespace octet
