// SPDX-License-Identifier: BSD-3-Clause
// An octant as a value, and the Morton keys that sort octants and lattice points.
#pragma once

#include <array>
#include <cstdint>

#include "base/vertex_order.h"

namespace octet {

/// A lattice point: coordinates 0..2^kLatticeLevels over the root.
using Lattice = std::array<std::uint32_t, 3>;

/// Lattice points along an edge of the root.
inline constexpr std::uint32_t kLatticeExtent = std::uint32_t{1} << kLatticeLevels;

/// The finest octants: their centres are lattice points too.
inline constexpr int kDeepestLevel = kLatticeLevels - 1;

/// A terminal octant: its lower corner on the lattice and its level (root = 0, at most kDeepestLevel).
struct Octant {
  Lattice corner{};
  std::int8_t level = 0;

  /// Edge length on the lattice.
  [[nodiscard]] std::uint32_t extent() const { return std::uint32_t{1} << (kLatticeLevels - level); }
  [[nodiscard]] Lattice centre() const {
    const std::uint32_t half = extent() / 2;
    return {corner[0] + half, corner[1] + half, corner[2] + half};
  }
  bool operator==(const Octant&) const = default;
};

/// Interleaved coordinates, x lowest. The key of a lattice point uses all its bits; the key of an octant at
/// level l is that of its corner in units of its own extent, 3*l bits, so its parent's is key >> 3.
using MortonKey = std::uint64_t;

/// The lowest 21 bits of x, two zero bits before each.
[[nodiscard]] constexpr MortonKey spread_bits(MortonKey x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Inverse of spread_bits.
[[nodiscard]] constexpr std::uint32_t gather_bits(MortonKey x) {
  x &= 0x1249249249249249;
  x = (x | x >> 2) & 0x10c30c30c30c30c3;
  x = (x | x >> 4) & 0x100f00f00f00f00f;
  x = (x | x >> 8) & 0x001f0000ff0000ff;
  x = (x | x >> 16) & 0x001f00000000ffff;
  x = (x | x >> 32) & 0x1fffff;
  return static_cast<std::uint32_t>(x);
}

[[nodiscard]] constexpr MortonKey morton_key(const Lattice& p) {
  return spread_bits(p[0]) | spread_bits(p[1]) << 1 | spread_bits(p[2]) << 2;
}

[[nodiscard]] constexpr Lattice lattice_of(MortonKey key) {
  return {gather_bits(key), gather_bits(key >> 1), gather_bits(key >> 2)};
}

/// The octant of that key and level.
[[nodiscard]] constexpr Octant octant_of(MortonKey key, int level) {
  return {lattice_of(key << (3 * (kLatticeLevels - level))), static_cast<std::int8_t>(level)};
}

/// Whether a's key is below b's, without making the keys.
[[nodiscard]] constexpr bool morton_less(const Lattice& a, const Lattice& b) {
  int axis = 2;
  std::uint32_t largest = a[2] ^ b[2];
  for (const int other : {1, 0}) {
    const std::uint32_t difference = a[other] ^ b[other];
    if (largest < difference && largest < (largest ^ difference)) {  // other's highest bit is the higher
      largest = difference;
      axis = other;
    }
  }
  return a[axis] < b[axis];
}

}  // namespace octet
