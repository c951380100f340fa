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
    return std::max(kMoment, limit_ - gone());
  }

  /// In seconds, 0: no limit. For what may better a part that has been read: twenty times what that took and
  /// a minute at least, of what is left. OCCT's cuts of free-form faces that cross need less or do not
  /// end, and a part need not wait for them as long as reading may take at all.
  [[nodiscard]] double seconds_for_repair() const {
    constexpr double kTimes = 20.0, kLeast = 60.0;
    if (limit_ <= 0.0) return 0.0;
    return std::min(seconds(), std::max(kLeast, kTimes * gone()));
  }

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] double gone() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  double limit_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace octet
