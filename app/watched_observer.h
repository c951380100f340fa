// SPDX-License-Identifier: BSD-3-Clause
// An observer beside which a function may end the run, too, and which sees it go on only.
#pragma once

#include <functional>

#include "base/observer.h"
#include "base/onward.h"

namespace octet {

class WatchedObserver : public Observer {
 public:
  /// Keeps references; the function may be empty. What is watched is the work from one share of the whole to
  /// another.
  WatchedObserver(Observer& own, const std::function<bool()>& cancelled, double from = 0.0, double to = 1.0)
      : own_(own), cancelled_(cancelled), from_(from), to_(to) {}
  void stage(std::string_view name, double fraction) override {
    own_.stage(name, from_ + (to_ - from_) * onward_(fraction));
  }
  void note(std::string_view text) override { own_.note(text); }
  void dump(std::string_view stage, const Mesh& mesh) override { own_.dump(stage, mesh); }
  [[nodiscard]] bool wants_dumps() const override { return own_.wants_dumps(); }
  [[nodiscard]] bool cancelled() const override { return own_.cancelled() || (cancelled_ && cancelled_()); }

 private:
  Observer& own_;
  const std::function<bool()>& cancelled_;
  double from_, to_;
  Onward onward_;
};

}  // namespace octet
