// SPDX-License-Identifier: BSD-3-Clause
// Plain values, strings and vectors of them to bytes and back, on one machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/check.h"
#include "base/vec.h"

namespace octet {

/// Types that are their own bytes. Eigen's fixed vectors are, though not trivially copyable by the letter.
template <class T>
struct IsPlain : std::bool_constant<std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>> {};
template <>
struct IsPlain<Vec2> : std::true_type {};
template <>
struct IsPlain<Vec3> : std::true_type {};
template <class T, std::size_t N>
struct IsPlain<std::array<T, N>> : IsPlain<T> {};

/// writer(a, b, ...) appends; vectors may hold strings and vectors.
class ByteWriter {
 public:
  std::string bytes;

  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

 private:
  void append(const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  void put(const std::string& text) { put(std::string_view(text)); }
  template <class T>
  void put(const T& value) {
    static_assert(IsPlain<T>::value);
    append(&value, sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    if constexpr (IsPlain<T>::value) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
};

/// reader(a, b, ...) takes what the writer put, in the same order. Bug: the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

 private:
  void take(void* data, std::size_t size) {
    OCTET_CHECK(size <= bytes_.size());
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  std::size_t take_size(std::size_t least) {
    std::uint64_t size = 0;
    get(size);
    OCTET_CHECK(size <= bytes_.size() / least);
    return static_cast<std::size_t>(size);
  }
  void get(std::string& text) {
    text.resize(take_size(1));
    take(text.data(), text.size());
  }
  template <class T>
  void get(T& value) {
    static_assert(IsPlain<T>::value);
    take(static_cast<void*>(&value), sizeof value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    if constexpr (IsPlain<T>::value) {
      values.resize(take_size(sizeof(T)));
      take(static_cast<void*>(values.data()), values.size() * sizeof(T));
    } else {
      values.resize(take_size(1));
      for (T& value : values) get(value);
    }
  }

  std::string_view bytes_;
};

}  // namespace octet
