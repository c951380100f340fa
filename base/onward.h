// SPDX-License-Identifier: BSD-3-Clause
// Progress that never goes back, of work that may begin anew.
#pragma once

#include <algorithm>

namespace octet {

/// Shares of a whole that is tried more than once: where one is less than that before, another try has
/// begun, and what is left is what it goes through.
class Onward {
 public:
  [[nodiscard]] double operator()(double fraction) {
    fraction = std::clamp(fraction, 0.0, 1.0);
    if (fraction < last_) begun_ = told_;
    last_ = fraction;
    told_ = std::max(told_, begun_ + (1.0 - begun_) * fraction);
    return told_;
  }

 private:
  double last_ = 0.0;   ///< as it came
  double told_ = 0.0;   ///< and as it was told
  double begun_ = 0.0;  ///< where this try began
};

}  // namespace octet
