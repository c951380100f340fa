// SPDX-License-Identifier: BSD-3-Clause
// Typed 4-byte indices: an id is comparable only with its own kind.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace octet {

/// An index into the arrays of one kind of thing. Default-constructed ids are invalid.
template <class Tag>
class Id {
 public:
  using Value = std::uint32_t;
  static constexpr Value kInvalid = std::numeric_limits<Value>::max();

  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : value_(static_cast<Value>(index)) {}

  [[nodiscard]] constexpr Value index() const { return value_; }
  [[nodiscard]] constexpr bool valid() const { return value_ != kInvalid; }
  constexpr auto operator<=>(const Id&) const = default;

 private:
  Value value_ = kInvalid;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using TriangleId = Id<struct TriangleTag>;
using TetId = Id<struct TetTag>;
using OctantId = Id<struct OctantTag>;

/// A vector subscripted by one kind of id only.
template <class IdType, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t n, const T& value = T()) : items_(n, value) {}

  [[nodiscard]] decltype(auto) operator[](IdType id) { return items_[id.index()]; }
  [[nodiscard]] decltype(auto) operator[](IdType id) const { return items_[id.index()]; }
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  void resize(std::size_t n) { items_.resize(n); }
  void resize(std::size_t n, const T& value) { items_.resize(n, value); }
  void assign(std::size_t n, const T& value) { items_.assign(n, value); }
  void reserve(std::size_t n) { items_.reserve(n); }
  void clear() { items_.clear(); }
  IdType push_back(const T& value) {
    items_.push_back(value);
    return IdType(items_.size() - 1);
  }
  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  [[nodiscard]] std::vector<T>& values() { return items_; }
  [[nodiscard]] const std::vector<T>& values() const { return items_; }

 private:
  std::vector<T> items_;
};

}  // namespace octet
