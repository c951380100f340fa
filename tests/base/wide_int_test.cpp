// SPDX-License-Identifier: BSD-3-Clause
// Fixed-width integers obey the ring laws and convert doubles exactly.
#include "base/wide_int.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace octet {
namespace {

template <int N>
WideInt<N> random_int(std::mt19937_64& engine) {
  WideInt<N> a;
  for (auto& l : a.limb) l = engine();
  if (engine() % 4 == 0) a.limb[0] = 0;
  if (engine() % 4 == 0) a.limb[N - 1] = ~std::uint64_t{0};
  return a;
}

TEST(WideInt, ProductsDistributeOverSums) {
  std::mt19937_64 engine(1);
  for (int n = 0; n < 2000; ++n) {
    // Halved, so that the sums do not wrap.
    auto a = random_int<3>(engine), b = random_int<3>(engine);
    for (auto* x : {&a, &b})
      x->limb[2] = static_cast<std::uint64_t>(static_cast<std::int64_t>(x->limb[2]) >> 1);
    const auto c = random_int<2>(engine);
    ASSERT_EQ(((a + b) * c).limb, (a * c + b * c).limb);
    ASSERT_EQ(((a - b) * c).limb, (a * c - b * c).limb);
    ASSERT_EQ((c * a).limb, (a * c).limb);
    ASSERT_EQ(((a * c) * b).limb, (a * (c * b)).limb);
  }
}

TEST(WideInt, SignsOfProductsMultiply) {
  std::mt19937_64 engine(2);
  for (int n = 0; n < 2000; ++n) {
    const auto a = random_int<2>(engine);
    const auto b = random_int<1>(engine);
    ASSERT_EQ((a * b).sign(), a.sign() * b.sign());
    ASSERT_EQ((WideInt<2>() - a).sign(), -a.sign());
  }
}

TEST(WideInt, HoldsScaledDoublesExactly) {
  EXPECT_EQ(WideInt<1>::from_scaled(5.0, 0).limb[0], 5u);
  EXPECT_EQ(WideInt<1>::from_scaled(-5.0, 0).limb[0], ~std::uint64_t{4});
  EXPECT_EQ(WideInt<1>::from_scaled(0.75, -2).limb[0], 3u);
  EXPECT_EQ(WideInt<1>::from_scaled(-0.0, -2).sign(), 0);
  EXPECT_EQ(WideInt<1>::from_scaled(5e-324, -1074).limb[0], 1u);
  EXPECT_EQ(WideInt<2>::from_scaled(0x1p100, 0).limb[1], std::uint64_t{1} << 36);
  // Bits across a limb's border, and modulo 2^64.
  const auto a = WideInt<2>::from_scaled(0x1.8000000000001p63, 0);
  EXPECT_EQ(a.limb[0], (std::uint64_t{3} << 62) + (std::uint64_t{1} << 11));
  EXPECT_EQ(a.limb[1], 0u);
  EXPECT_EQ(WideInt<1>::from_scaled(0x1.4p64, 0).limb[0], std::uint64_t{1} << 62);
}

}  // namespace
}  // namespace octet
