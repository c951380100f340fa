// SPDX-License-Identifier: BSD-3-Clause
// Which new tetrahedron stands on which edge of a cavity's boundary.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "base/ids.h"

namespace octet {

/// Directed edges of the triangles on a closed surface, each with its triangle's tetrahedron. Open
/// addressing; what was put in before the last begin() is gone, at no cost. Cost: 16 bytes an entry, four
/// entries or more an edge; a look-up is one multiplication and seldom more than one comparison.
class RimTable {
 public:
  /// Makes room for so many edges.
  void begin(std::size_t edges) {
    if (entries_.size() < 4 * edges) {
      entries_.assign(std::bit_ceil(4 * edges), Entry());
      shift_ = 64 - std::countr_zero(entries_.size());
      stamp_ = 0;
    }
    if (++stamp_ == 0) {
      for (Entry& e : entries_) e.stamp = 0;
      stamp_ = 1;
    }
  }
  void put(VertexId from, VertexId to, TetId tet) {
    std::size_t i = start(from, to);
    while (entries_[i].stamp == stamp_) i = (i + 1) & (entries_.size() - 1);
    entries_[i] = {from, to, tet, stamp_};
  }
  /// Requires that the edge was put in.
  [[nodiscard]] TetId at(VertexId from, VertexId to) const {
    std::size_t i = start(from, to);
    while (entries_[i].from != from || entries_[i].to != to || entries_[i].stamp != stamp_)
      i = (i + 1) & (entries_.size() - 1);
    return entries_[i].tet;
  }

 private:
  struct Entry {
    VertexId from, to;
    TetId tet;
    std::uint32_t stamp = 0;
  };
  [[nodiscard]] std::size_t start(VertexId from, VertexId to) const {
    const std::uint64_t key = (std::uint64_t{from.index()} << 32) | to.index();
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> shift_);
  }

  std::vector<Entry> entries_;
  std::uint32_t stamp_ = 0;
  int shift_ = 63;
};

}  // namespace octet
