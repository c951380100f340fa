// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra that a const search has met.
#pragma once

#include <cstdint>
#include <vector>

#include "base/ids.h"

namespace octet {

/// An open-addressed hash set; only membership is asked, so its order affects nothing.
class VisitSet {
 public:
  VisitSet() : slots_(256) {}

  /// True when t was not in the set before.
  bool insert(TetId t) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    TetId& slot = find(t);
    if (slot.valid()) return false;
    slot = t;
    ++size_;
    return true;
  }

 private:
  TetId& find(TetId t) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (t.index() * std::size_t{0x9E3779B97F4A7C15u} >> 20) & mask;
    while (slots_[at].valid() && slots_[at] != t) at = (at + 1) & mask;
    return slots_[at];
  }
  void grow() {
    std::vector<TetId> old(2 * slots_.size());
    old.swap(slots_);
    for (const TetId t : old) {
      if (t.valid()) find(t) = t;
    }
  }

  std::vector<TetId> slots_;
  std::size_t size_ = 0;
};

}  // namespace octet
