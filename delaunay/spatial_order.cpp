// SPDX-License-Identifier: BSD-3-Clause
// Rounds by hash, Hilbert curve within a round.
#include "delaunay/spatial_order.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/bucket_sort.h"
#include "base/vertex_order.h"

namespace octet {
namespace {

constexpr int kBits = 20;  // per axis: 60 bits of curve, 4 of round

/// How the Hilbert curve [Skilling 2004] runs through a cell: which axis is meant by each of three, in which
/// direction, and whether it runs backwards.
struct CurveState {
  std::array<std::uint8_t, 3> axis{0, 1, 2};
  std::array<bool, 3> turned{};
  bool back = false;

  constexpr bool operator==(const CurveState&) const = default;
};

/// Which of its eight parts the curve comes to when, and its state there.
struct CurveStep {
  std::uint8_t when, next;
};

/// A part is told by a bit per axis, the first the highest.
constexpr std::pair<std::uint8_t, CurveState> curve_step(const CurveState& state, unsigned part) {
  CurveState next = state;
  std::array<bool, 3> bit{};
  for (std::size_t i = 0; i < 3; ++i) bit[i] = (((part >> (2 - state.axis[i])) & 1u) != 0) != state.turned[i];
  for (std::size_t i = 0; i < 3; ++i) {
    if (bit[i]) {
      next.turned[0] = !next.turned[0];
    } else {
      std::swap(next.axis[0], next.axis[i]);
      std::swap(next.turned[0], next.turned[i]);
    }
  }
  const bool second = bit[1] != bit[0], third = bit[2] != second;  // Gray code
  next.back = next.back != third;
  const unsigned when = 4u * bit[0] + 2u * second + 1u * third;
  return {static_cast<std::uint8_t>(state.back ? 7u - when : when), next};
}

constexpr std::size_t kCurveStates = 96;
using CurveTable = std::array<std::array<CurveStep, 8>, kCurveStates>;

/// The states that are met, numbered as they are.
constexpr CurveTable make_curve_table() {
  CurveTable table{};
  std::array<CurveState, kCurveStates> states{};
  std::size_t count = 1;
  for (std::size_t n = 0; n < count; ++n) {
    for (unsigned part = 0; part < 8; ++part) {
      const auto [when, next] = curve_step(states[n], part);
      std::size_t number = 0;
      while (number < count && !(states[number] == next)) ++number;
      if (number == count) states[count++] = next;
      table[n][part] = {when, static_cast<std::uint8_t>(number)};
    }
  }
  return table;
}

/// Position on the Hilbert curve through a grid of 2^kBits per axis.
std::uint64_t hilbert(const std::array<std::uint32_t, 3>& x) {
  static constexpr CurveTable kTable = make_curve_table();
  std::uint64_t key = 0;
  std::size_t state = 0;
  for (int bit = kBits - 1; bit >= 0; --bit) {
    const CurveStep& step =
        kTable[state][((x[0] >> bit) & 1u) << 2 | ((x[1] >> bit) & 1u) << 1 | ((x[2] >> bit) & 1u)];
    key = key << 3 | step.when;
    state = step.next;
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
  // About as many pieces of the curve as points.
  const int levels = std::max(1, static_cast<int>(std::bit_width(which.size())) / 3);
  bucket_sort(
      items, std::size_t{1} << (3 * levels),
      [&](const Item& item) { return item.key >> 3 * (kBits - levels); },
      [](const Item& a, const Item& b) { return a.key != b.key ? a.key < b.key : a.index < b.index; });
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

std::vector<std::uint32_t> SpatialOrder::along_curve_until(std::size_t last_round) const {
  std::vector<std::uint32_t> found;
  found.reserve(round_end[last_round]);
  std::copy_if(curve.begin(), curve.end(), std::back_inserter(found),
               [&](std::uint32_t i) { return round[i] <= last_round; });
  return found;
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
  SpatialOrder order;
  order.curve = along_curve(points, all, 0.0);
  order.round.resize(points.size());
  order.round_end.assign(rounds, 0);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    order.round[i] = static_cast<std::uint8_t>(round(i));
    ++order.round_end[order.round[i]];
  }
  std::partial_sum(order.round_end.begin(), order.round_end.end(), order.round_end.begin());
  std::vector<std::size_t> next(rounds, 0);
  std::copy(order.round_end.begin(), order.round_end.end() - 1, next.begin() + 1);
  order.points.resize(points.size());
  for (const std::uint32_t i : order.curve) order.points[next[order.round[i]]++] = i;
  return order;
}

}  // namespace octet
