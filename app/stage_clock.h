// SPDX-License-Identifier: BSD-3-Clause
// How long a stage took.
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <ctime>
#include <string>

#include "app/mesh_part.h"

namespace octet {

/// Runs from its making, or from the last lap.
class StageClock {
 public:
  [[nodiscard]] StageTime lap(std::string name) {
    const Clock::time_point now = Clock::now();
    const std::clock_t cpu = std::clock();
    StageTime time{std::move(name), std::chrono::duration<double>(now - started_).count(),
                   static_cast<double>(cpu - cpu_started_) / CLOCKS_PER_SEC, peak_bytes()};
    started_ = now;
    cpu_started_ = cpu;
    return time;
  }

 private:
  [[nodiscard]] static double peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);  // kibibytes on Linux
  }

  using Clock = std::chrono::steady_clock;
  Clock::time_point started_ = Clock::now();
  std::clock_t cpu_started_ = std::clock();
};

}  // namespace octet
