// SPDX-License-Identifier: BSD-3-Clause
// A plain big integer: the independent judge of the predicates' signs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace octet::testing {

/// Sign and magnitude in 32-bit digits, least first. Slow and simple on purpose.
class BigInteger {
 public:
  BigInteger() = default;

  /// value / 2^exponent; requires that to be an integer.
  static BigInteger scaled(double value, int exponent) {
    BigInteger r;
    int e = 0;
    const double fraction = std::frexp(std::abs(value), &e);
    auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = e - 53 - exponent;
    for (; shift < 0; ++shift) mantissa >>= 1;
    r.digits_.assign(static_cast<std::size_t>(shift / 32), 0);
    const int rest = shift % 32;
    std::uint64_t low = (mantissa & 0xffffffffu) << rest;
    std::uint64_t high = (mantissa >> 32) << rest;
    high += low >> 32;
    r.digits_.push_back(static_cast<std::uint32_t>(low));
    r.digits_.push_back(static_cast<std::uint32_t>(high));
    r.digits_.push_back(static_cast<std::uint32_t>(high >> 32));
    r.negative_ = value < 0;
    r.trim();
    return r;
  }

  [[nodiscard]] int sign() const { return digits_.empty() ? 0 : negative_ ? -1 : 1; }

  friend BigInteger operator-(BigInteger a) {
    a.negative_ = !a.negative_;
    return a;
  }

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger r;
    if (a.negative_ == b.negative_) {
      r.digits_ = sum(a.digits_, b.digits_);
      r.negative_ = a.negative_;
    } else if (less(a.digits_, b.digits_)) {
      r.digits_ = difference(b.digits_, a.digits_);
      r.negative_ = b.negative_;
    } else {
      r.digits_ = difference(a.digits_, b.digits_);
      r.negative_ = a.negative_;
    }
    r.trim();
    return r;
  }

  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger r;
    r.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.digits_.size() || carry != 0; ++j) {
        std::uint64_t t = r.digits_[i + j] + carry;
        if (j < b.digits_.size()) t += std::uint64_t{a.digits_[i]} * b.digits_[j];
        r.digits_[i + j] = static_cast<std::uint32_t>(t);
        carry = t >> 32;
      }
    }
    r.negative_ = a.negative_ != b.negative_;
    r.trim();
    return r;
  }

 private:
  using Digits = std::vector<std::uint32_t>;

  static bool less(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }
  static Digits sum(const Digits& a, const Digits& b) {
    Digits r;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()) || carry != 0; ++i) {
      carry += (i < a.size() ? a[i] : 0u);
      carry += (i < b.size() ? b[i] : 0u);
      r.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    return r;
  }
  static Digits difference(const Digits& a, const Digits& b) {  // a >= b
    Digits r;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::int64_t t = std::int64_t{a[i]} - (i < b.size() ? b[i] : 0u) - borrow;
      borrow = t < 0 ? 1 : 0;
      r.push_back(static_cast<std::uint32_t>(t + (borrow << 32)));
    }
    return r;
  }
  void trim() {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  }

  Digits digits_;
  bool negative_ = false;
};

}  // namespace octet::testing
