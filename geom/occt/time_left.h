// SPDX-License-Identifier: BSD-3-Clause
// A time limit that several steps share.
#pragma once

#include <algorithm>
#include <chrono>

namespace octet {

/// Counts down from when it is made.
class TimeLeft {
 public:
  /// In seconds, 0: none.
  explicit TimeLeft(double limit) : limit_(limit) {}

  /// In seconds, 0: no limit. Of a limit a moment is always left, for 0 would be none.
  [[nodiscard]] double seconds() const {
    constexpr double kMoment = 0.1;
    if (limit_ <= 0.0) return 0.0;
    return std::max(kMoment, limit_ - std::chrono::duration<double>(Clock::now() - begin_).count());
  }

 private:
  using Clock = std::chrono::steady_clock;
  double limit_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace octet
