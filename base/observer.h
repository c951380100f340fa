// SPDX-License-Identifier: BSD-3-Clause
// The one door through which a run tells of its progress and can be cancelled.
#pragma once

#include <string_view>

namespace octet {

struct Mesh;

/// Derive to follow a run. All calls come from the thread that called the library.
class Observer {
 public:
  virtual ~Observer() = default;
  /// A stage begins; `fraction` of the whole run is done (0..1), which a run never tells less of than before:
  /// where a part is tried again, what is left is what that goes through.
  virtual void stage(std::string_view /*name*/, double /*fraction*/) {}
  /// A line worth telling with --verbose.
  virtual void note(std::string_view /*text*/) {}
  /// An intermediate mesh, only built when `wants_dumps()`.
  virtual void dump(std::string_view /*stage*/, const Mesh& /*mesh*/) {}
  [[nodiscard]] virtual bool wants_dumps() const { return false; }
  /// Asked often; true ends the run with `Cancelled`.
  [[nodiscard]] virtual bool cancelled() const { return false; }
};

}  // namespace octet
