// SPDX-License-Identifier: BSD-3-Clause
// A few values by edge, for what need not be known of all edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "finalize/work_mesh.h"

namespace octet {

/// Two to the power of `bits` slots, each for many edges: an edge may be forgotten, none is made up.
template <class Value>
class EdgeSlots {
 public:
  explicit EdgeSlots(int bits) : shift_(64 - bits), slots_(std::size_t{1} << bits) {}

  /// What was set last of the edge; nullptr: nothing, or forgotten.
  [[nodiscard]] const Value* find(VertexId a, VertexId b) const {
    const std::uint64_t key = piece_key(a, b);
    const Slot& slot = slots_[(key * kSpread) >> shift_];
    return slot.key == key ? &slot.value : nullptr;
  }
  void set(VertexId a, VertexId b, const Value& value) {
    const std::uint64_t key = piece_key(a, b);
    slots_[(key * kSpread) >> shift_] = {key, value};
  }

 private:
  static constexpr std::uint64_t kSpread = 0x9E3779B97F4A7C15u;
  struct Slot {
    std::uint64_t key = UINT64_MAX;
    Value value{};
  };
  int shift_;
  std::vector<Slot> slots_;
};

}  // namespace octet
