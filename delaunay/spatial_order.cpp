// SPDX-License-Identifier: BSD-3-Clause
// Rounds by hash, Hilbert curve within a round.
#include "delaunay/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>

namespace octet {
namespace {

constexpr int kBits = 20;  // per axis: 60 bits of curve, 4 of round

// Position on the Hilbert curve through a grid of 2^kBits per axis [Skilling 2004].
std::uint64_t hilbert(std::array<std::uint32_t, 3> x) {
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1) {
    const std::uint32_t low = q - 1;
    for (auto& xi : x) {
      if ((xi & q) != 0) {
        x[0] ^= low;
      } else {
        const std::uint32_t t = (x[0] ^ xi) & low;
        x[0] ^= t;
        xi ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1u << (kBits - 1); q > 1; q >>= 1) {
    if ((x[2] & q) != 0) t ^= q - 1;
  }
  std::uint64_t key = 0;
  for (int bit = kBits - 1; bit >= 0; --bit) {
    for (const std::uint32_t xi : x) key = 2 * key + (((xi ^ t) >> bit) & 1u);
  }
  return key;
}

// Round of a point: the last holds half of all, the one before a quarter, and so on.
std::uint64_t round_of(std::uint64_t index, int rounds) {
  std::uint64_t h = (index + 1) * 0x9E3779B97F4A7C15u;  // the mixing of splitmix64
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  h ^= h >> 31;
  return static_cast<std::uint64_t>(std::max(0, rounds - 1 - std::countr_zero(h)));
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const double extent = points.empty() ? 0.0 : box.size().maxCoeff();
  const double scale = extent > 0 ? ((1u << kBits) - 1) / extent : 0.0;
  // Rounds below some hundred points gain nothing.
  const int rounds = std::clamp(static_cast<int>(std::bit_width(points.size())) - 8, 1, 16);

  struct Item {
    std::uint64_t key;
    std::uint32_t index;
  };
  std::vector<Item> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<std::uint32_t>((points[i][k] - box.lo[k]) * scale);
    items[i] = {(round_of(i, rounds) << (3 * kBits)) | hilbert(cell), static_cast<std::uint32_t>(i)};
  }
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.key != b.key ? a.key < b.key : a.index < b.index; });
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].index;
  return order;
}

}  // namespace octet
