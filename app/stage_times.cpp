// SPDX-License-Identifier: BSD-3-Clause
// Differences of times.
#include "app/stage_times.h"

#include <algorithm>

namespace octet {

StageTime beside_stages(StageTime whole, const std::vector<StageTime>& own) {
  for (const StageTime& stage : own) {
    whole.seconds -= stage.seconds;
    whole.cpu_seconds -= stage.cpu_seconds;
  }
  whole.seconds = std::max(0.0, whole.seconds);
  whole.cpu_seconds = std::max(0.0, whole.cpu_seconds);
  return whole;
}

void add_rest(StageTime rest, int makings, std::vector<StageTime>& times) {
  rest.name = makings > 1 ? "other tries" : "sizes";
  const auto known =
      std::find_if(times.begin(), times.end(), [&](const StageTime& time) { return time.name == rest.name; });
  if (known == times.end()) {
    times.insert(times.begin(), rest);
  } else {
    known->seconds += rest.seconds;
    known->cpu_seconds += rest.cpu_seconds;
  }
}

}  // namespace octet
