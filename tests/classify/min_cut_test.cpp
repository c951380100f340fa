// SPDX-License-Identifier: BSD-3-Clause
// The two labels of least cost equal those of trying all.
#include "classify/min_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace octet {
namespace {

struct Costs {
  std::vector<std::array<std::int64_t, 2>> own;
  struct Pair {
    std::uint32_t a, b;
    std::int64_t c01, c10;
  };
  std::vector<Pair> pairs;

  [[nodiscard]] std::int64_t of(const std::vector<std::uint8_t>& label) const {
    std::int64_t sum = 0;
    for (std::size_t n = 0; n < own.size(); ++n) sum += own[n][label[n]];
    for (const Pair& p : pairs) {
      if (label[p.a] == 0 && label[p.b] == 1) sum += p.c01;
      if (label[p.a] == 1 && label[p.b] == 0) sum += p.c10;
    }
    return sum;
  }
};

TEST(TwoLabels, CostNoMoreThanAnyOthersWithTheFewestZeros) {
  std::mt19937 random(11);
  const auto draw = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int trial = 0; trial < 200; ++trial) {
    const std::uint32_t n = 2 + draw(9);
    Costs costs;
    TwoLabels labels(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::int64_t c0 = draw(4) == 0 ? draw(20) : 0, c1 = draw(4) == 0 ? draw(20) : 0;
      costs.own.push_back({c0, c1});
      labels.prefer(i, c0, c1);
    }
    for (std::uint32_t k = 0; k < 2 * n; ++k) {
      const std::uint32_t a = draw(static_cast<int>(n)), b = draw(static_cast<int>(n));
      if (a == b) continue;
      const std::int64_t c01 = draw(10), c10 = draw(10);
      costs.pairs.push_back({a, b, c01, c10});
      labels.join(a, b, c01, c10);
    }
    using Optimum = std::pair<std::int64_t, std::ptrdiff_t>;  // cost, labels 0
    const auto optimum = [&](const std::vector<std::uint8_t>& label) {
      return Optimum{costs.of(label), std::count(label.begin(), label.end(), 0)};
    };
    Optimum best = optimum(std::vector<std::uint8_t>(n, 0));
    for (std::uint32_t mask = 0; mask < (1u << n); ++mask) {
      std::vector<std::uint8_t> label(n);
      for (std::uint32_t i = 0; i < n; ++i) label[i] = mask >> i & 1;
      best = std::min(best, optimum(label));
    }
    EXPECT_EQ(optimum(labels.solve()), best);
  }
}

}  // namespace
}  // namespace octet
