// SPDX-License-Identifier: BSD-3-Clause
// An observer beside which a function may end the run, too.
#pragma once

#include <functional>

#include "base/observer.h"

namespace octet {

class WatchedObserver : public Observer {
 public:
  /// Keeps references; the function may be empty.
  WatchedObserver(Observer& own, const std::function<bool()>& cancelled) : own_(own), cancelled_(cancelled) {}
  void stage(std::string_view name, double fraction) override { own_.stage(name, fraction); }
  void note(std::string_view text) override { own_.note(text); }
  void dump(std::string_view stage, const Mesh& mesh) override { own_.dump(stage, mesh); }
  [[nodiscard]] bool wants_dumps() const override { return own_.wants_dumps(); }
  [[nodiscard]] bool cancelled() const override { return own_.cancelled() || (cancelled_ && cancelled_()); }

 private:
  Observer& own_;
  const std::function<bool()>& cancelled_;
};

}  // namespace octet
