// SPDX-License-Identifier: BSD-3-Clause
// Signed integers of a fixed number of 64-bit limbs: the exact arithmetic behind the predicates.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace octet {

/// Two's complement, least limb first. Sums wrap modulo 2^(64 N); a product has the limbs of both factors and
/// never wraps. Cost: a product takes N*M hardware multiplications and touches no heap.
template <int N>
struct WideInt {
  std::array<std::uint64_t, N> limb{};

  [[nodiscard]] bool negative() const { return (limb[N - 1] >> 63) != 0; }

  /// -1, 0 or +1.
  [[nodiscard]] int sign() const {
    if (negative()) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t l : limb) any |= l;
    return any != 0 ? 1 : 0;
  }

  /// The integer `value / 2^exponent` modulo 2^(64 N).
  /// Requires: value is finite and a multiple of 2^exponent.
  [[nodiscard]] static WideInt from_scaled(double value, int exponent) {
    WideInt result;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased != 0) mantissa |= std::uint64_t{1} << 52;
    if (mantissa == 0) return result;
    const int shift = (biased == 0 ? 1 : biased) - 1075 - exponent;
    if (shift < 0) {  // the bits shifted out are zero
      result.limb[0] = mantissa >> -shift;
    } else {
      const int at = shift / 64, rest = shift % 64;
      if (at < N) result.limb[at] = mantissa << rest;
      if (rest != 0 && at + 1 < N) result.limb[at + 1] = mantissa >> (64 - rest);
    }
    return (bits >> 63) != 0 ? WideInt() - result : result;
  }

  friend WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt r;
    std::uint64_t carry = 0;
    for (int i = 0; i < N; ++i) {
      const std::uint64_t s = a.limb[i] + carry;
      carry = s < carry ? 1 : 0;
      r.limb[i] = s + b.limb[i];
      carry += r.limb[i] < s ? 1 : 0;
    }
    return r;
  }

  friend WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt r;
    std::uint64_t borrow = 0;
    for (int i = 0; i < N; ++i) {
      const std::uint64_t s = a.limb[i] - borrow;
      borrow = s > a.limb[i] ? 1 : 0;
      r.limb[i] = s - b.limb[i];
      borrow += r.limb[i] > s ? 1 : 0;
    }
    return r;
  }
};

template <int N, int M>
[[nodiscard]] WideInt<N + M> operator*(const WideInt<N>& a, const WideInt<M>& b) {
  __extension__ using Double = unsigned __int128;
  __extension__ using Signed = __int128;
  WideInt<N + M> r;
  if constexpr (N == 1 && M == 1) {
    const auto t = static_cast<Double>(static_cast<Signed>(static_cast<std::int64_t>(a.limb[0])) *
                                       static_cast<std::int64_t>(b.limb[0]));
    r.limb = {static_cast<std::uint64_t>(t), static_cast<std::uint64_t>(t >> 64)};
    return r;
  }
  for (int i = 0; i < N; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < M; ++j) {
      const Double t = static_cast<Double>(a.limb[i]) * b.limb[j] + r.limb[i + j] + carry;
      r.limb[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    r.limb[i + M] = carry;
  }
  // The loop multiplied the limbs as unsigned numbers: a negative factor counted 2^(64 N) too much.
  if (a.negative()) {
    std::uint64_t borrow = 0;
    for (int j = 0; j < M; ++j) {
      const std::uint64_t s = r.limb[N + j] - borrow;
      borrow = s > r.limb[N + j] ? 1 : 0;
      r.limb[N + j] = s - b.limb[j];
      borrow += r.limb[N + j] > s ? 1 : 0;
    }
  }
  if (b.negative()) {
    std::uint64_t borrow = 0;
    for (int i = 0; i < N; ++i) {
      const std::uint64_t s = r.limb[M + i] - borrow;
      borrow = s > r.limb[M + i] ? 1 : 0;
      r.limb[M + i] = s - a.limb[i];
      borrow += r.limb[M + i] > s ? 1 : 0;
    }
  }
  return r;
}

}  // namespace octet
