// SPDX-License-Identifier: BSD-3-Clause
// Rounds by hash, Hilbert curve within a round.
#include "delaunay/spatial_order.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "base/vertex_order.h"

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

// Round of a point: the last holds 7/8 of all, the one before 7/8 of the rest, and so on.
std::uint32_t round_of(std::uint64_t index, std::uint32_t rounds) {
  std::uint64_t h = (index + 1) * 0x9E3779B97F4A7C15u;  // the mixing of splitmix64
  h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  h ^= h >> 31;
  return rounds - 1 - std::min(rounds - 1, static_cast<std::uint32_t>(std::countr_zero(h)) / 3);
}

// Ranks below this are of the coarsest levels of octree vertices, of some per cent of all points at most.
std::uint64_t end_of_coarse(std::span<const std::uint64_t> ranks) {
  constexpr std::size_t kShare = 32;
  std::array<std::size_t, 64> count{};
  for (const std::uint64_t rank : ranks)
    if (rank >> 63 != 0) ++count[rank >> kRankClassShift & 63];
  std::uint64_t classes = 0;
  for (std::size_t sum = 0; classes < count.size(); ++classes)
    if ((sum += count[classes]) > ranks.size() / kShare) break;
  return (std::uint64_t{1} << 63) + (classes << kRankClassShift);
}

struct Item {
  std::uint64_t key;
  std::uint32_t index;
};

std::vector<Item> curve_items(std::span<const Vec3> points, std::span<const std::uint32_t> which,
                              double shift) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const double extent = points.empty() ? 0.0 : (1.0 + shift) * box.size().maxCoeff();
  const double scale = extent > 0 ? ((1u << kBits) - 1) / extent : 0.0;
  const Vec3 origin = box.lo - Vec3::Constant(extent > 0 ? shift / (1.0 + shift) * extent : 0.0);
  std::vector<Item> items(which.size());
  tbb::parallel_for(std::size_t{0}, which.size(), [&](std::size_t n) {
    std::array<std::uint32_t, 3> cell{};
    for (int k = 0; k < 3; ++k)
      cell[k] = static_cast<std::uint32_t>(std::max(0.0, (points[which[n]][k] - origin[k]) * scale));
    items[n] = {hilbert(cell), which[n]};
  });
  tbb::parallel_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  return items;
}

}  // namespace

std::vector<std::uint32_t> along_curve(std::span<const Vec3> points, std::span<const std::uint32_t> which,
                                       double shift) {
  const std::vector<Item> items = curve_items(points, which, shift);
  std::vector<std::uint32_t> order(items.size());
  std::transform(items.begin(), items.end(), order.begin(), [](const Item& item) { return item.index; });
  return order;
}

SpatialOrder spatial_order(std::span<const Vec3> points, std::span<const std::uint64_t> ranks) {
  // Rounds below some hundred points gain nothing.
  const auto rounds =
      static_cast<std::uint32_t>(std::clamp((static_cast<int>(std::bit_width(points.size())) - 6) / 3, 1, 6));
  const std::uint64_t fine = end_of_coarse(ranks);
  const auto round = [&](std::uint32_t i) {
    return ranks[i] >> 63 != 0 && ranks[i] < fine ? 0 : round_of(i, rounds);
  };
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  const std::vector<std::uint32_t> curve = along_curve(points, all, 0.0);
  SpatialOrder order;
  order.round_end.assign(rounds, 0);
  for (const std::uint32_t i : curve) ++order.round_end[round(i)];
  std::partial_sum(order.round_end.begin(), order.round_end.end(), order.round_end.begin());
  std::vector<std::size_t> next(rounds, 0);
  std::copy(order.round_end.begin(), order.round_end.end() - 1, next.begin() + 1);
  order.points.resize(points.size());
  for (const std::uint32_t i : curve) order.points[next[round(i)]++] = i;
  return order;
}

}  // namespace octet
