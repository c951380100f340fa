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
  const auto low = [](const auto& t) { return static_cast<std::uint64_t>(t); };
  const auto as_signed = [](std::uint64_t limb) {
    return static_cast<Signed>(static_cast<std::int64_t>(limb));
  };
  // The top limbs carry the sign, and so does the top limb of each row's sum: no corrections, no branches.
  WideInt<N + M> r;
  for (int i = 0; i + 1 < N; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j + 1 < M; ++j) {
      const Double t = static_cast<Double>(a.limb[i]) * b.limb[j] + r.limb[i + j] + carry;
      r.limb[i + j] = low(t);
      carry = low(t >> 64);
    }
    const Signed t = static_cast<Signed>(a.limb[i]) * as_signed(b.limb[M - 1]) +
                     as_signed(r.limb[i + M - 1]) + static_cast<Signed>(carry);
    r.limb[i + M - 1] = low(t);
    r.limb[i + M] = low(t >> 64);
  }
  Signed carry = 0;
  for (int j = 0; j + 1 < M; ++j) {
    const Signed t = as_signed(a.limb[N - 1]) * static_cast<Signed>(b.limb[j]) +
                     static_cast<Signed>(r.limb[N - 1 + j]) + carry;
    r.limb[N - 1 + j] = low(t);
    carry = t >> 64;
  }
  const Signed t = as_signed(a.limb[N - 1]) * as_signed(b.limb[M - 1]) + as_signed(r.limb[N + M - 2]) + carry;
  r.limb[N + M - 2] = low(t);
  r.limb[N + M - 1] = low(t >> 64);
  return r;
}

}  // namespace octet
