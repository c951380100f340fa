// SPDX-License-Identifier: BSD-3-Clause
// Which new tetrahedron stands on which edge of a cavity's boundary.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "base/ids.h"

namespace octet {

/// Edges of the triangles on a closed surface, each of which has two. Of the two triangles' tetrahedra the
/// sum (exclusive or) is kept, so that each finds the other, whichever came first, without a branch on that.
/// Open addressing; what was put in before the last begin() is gone, at no cost. Cost: 16 bytes an entry,
/// four entries or more an edge, of which as many are used as the surface needs: they stay in the nearest
/// cache.
class RimTable {
 public:
  /// Makes room for so many edges.
  void begin(std::size_t edges) {
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(4 * edges, 2));
    if (entries_.size() < size) {
      entries_.assign(size, Entry());
      stamp_ = 0;
    }
    mask_ = size - 1;
    shift_ = 64 - std::countr_zero(size);
    if (++stamp_ == 0) {
      for (Entry& e : entries_) e.stamp = 0;
      stamp_ = 1;
    }
  }
  /// Puts in a triangle's edge; returns its place in the table.
  std::uint32_t put(VertexId a, VertexId b, TetId tet) {
    const std::uint32_t exchange = (a.index() ^ b.index()) & (0u - std::uint32_t{a < b});
    const std::uint64_t key = std::uint64_t{b.index() ^ exchange} << 32 | (a.index() ^ exchange);
    std::size_t i = (key * 0x9e3779b97f4a7c15u) >> shift_;
    while (((entries_[i].key ^ key) & taken(i)) != 0) i = (i + 1) & mask_;
    Entry& e = entries_[i];
    e = {key, (e.sum & static_cast<std::uint32_t>(taken(i))) ^ tet.index(), stamp_};
    return static_cast<std::uint32_t>(i);
  }
  /// The other tetrahedron at an edge of which both were put in.
  [[nodiscard]] TetId beyond(std::uint32_t place, TetId tet) const {
    return TetId(entries_[place].sum ^ tet.index());
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t sum = 0;
    std::uint32_t stamp = 0;
  };

  /// All bits set where the entry is taken, else none.
  [[nodiscard]] std::uint64_t taken(std::size_t i) const {
    return std::uint64_t{0} - std::uint64_t{entries_[i].stamp == stamp_};
  }

  std::vector<Entry> entries_;
  std::uint32_t stamp_ = 0;
  std::size_t mask_ = 0;
  int shift_ = 63;
};

}  // namespace octet
