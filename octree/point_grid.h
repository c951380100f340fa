// SPDX-License-Identifier: BSD-3-Clause
// Points in hash cells whose length follows the local spacing: neighbours within about one spacing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Cells that hold points know their parents, so that a look-up descends only to where points are.
///
/// Cost: a look-up visits the cells that meet its box and hold points, and their parents.
class PointGrid {
 public:
  /// `unit` is the length of cells of level 0 (the root's length).
  PointGrid(const Vec3& origin, double unit) : origin_(origin), unit_(unit) {}

  void add(std::uint32_t point, const Vec3& at, double spacing) {
    int level = level_of(2.0 * spacing);
    Index c = cell(at, level);
    used_ |= std::uint64_t{1} << level;
    entries_.push_back({at, point, kNoEntry});
    Cell& holder = *cells_.insert(key(level, c)).first;
    entries_.back().next = holder.first;
    holder.first = static_cast<std::uint32_t>(entries_.size() - 1);
    while (level-- > 0) {
      c = {c.x >> 1, c.y >> 1, c.z >> 1};
      if (!cells_.insert(key(level, c)).second) break;  // its parents are there
    }
  }

  /// Calls visit(point, squared distance) for every point closer to `at` than r, in no particular order;
  /// stops when it returns true.
  template <class Visit>
  bool any_within(const Vec3& at, double r, const Visit& visit) const {
    if (used_ == 0) return false;
    const int start = level_of(2.0 * r);
    const Query<Visit> query{at, at - Vec3::Constant(r), at + Vec3::Constant(r), r * r, visit};
    // Those beside which a point is too near mostly have the spacing that is asked about.
    for (int level = start; level >= 0; --level) {
      if (level < start && !(used_ >> level & 1)) continue;
      const Index lo = cell(query.lo, level), hi = cell(query.hi, level);
      for (std::int64_t i = lo.x; i <= hi.x; ++i)
        for (std::int64_t j = lo.y; j <= hi.y; ++j)
          for (std::int64_t k = lo.z; k <= hi.z; ++k)
            if (visit_cell(query, level, {i, j, k}, level == start)) return true;
    }
    return false;
  }

  /// As any_within() with a radius that is no more than half the spacing that each point was added with, or
  /// than r where that is less: for points that are middles of balls of that diameter.
  template <class Visit>
  bool any_around(const Vec3& at, double r, const Visit& visit) const {
    for (int level = 0; used_ >> level != 0 && level < kLevels; ++level) {
      if (!(used_ >> level & 1)) continue;
      // A point of this level was added with no more than the cell's length, but on level 0.
      const double reach = level == 0 ? r : std::min(r, std::ldexp(0.5 * unit_, -level));
      const Query<Visit> query{at, at - Vec3::Constant(reach), at + Vec3::Constant(reach), reach * reach,
                               visit};
      const Index lo = cell(query.lo, level), hi = cell(query.hi, level);
      for (std::int64_t i = lo.x; i <= hi.x; ++i)
        for (std::int64_t j = lo.y; j <= hi.y; ++j)
          for (std::int64_t k = lo.z; k <= hi.z; ++k)
            if (visit_cell(query, level, {i, j, k}, false)) return true;
    }
    return false;
  }

 private:
  static constexpr int kLevels = 19;
  static constexpr std::uint32_t kNoEntry = UINT32_MAX;
  struct Entry {
    Vec3 at;
    std::uint32_t point;
    std::uint32_t next;  ///< of the same cell
  };
  struct Cell {
    std::uint64_t key = kNoCell;
    std::uint32_t first = kNoEntry;
  };
  static constexpr std::uint64_t kNoCell = UINT64_MAX;  // no cell's key: levels are fewer than 31
  struct Index {
    std::int64_t x, y, z;
  };

  template <class Visit>
  struct Query {
    Vec3 at, lo, hi;
    double squared;
    const Visit& visit;
  };

  /// The points of one cell and, when `descend`, of all cells in it.
  template <class Visit>
  bool visit_cell(const Query<Visit>& query, int level, const Index& c, bool descend) const {
    const Cell* found = cells_.find(key(level, c));
    if (found == nullptr) return false;
    for (std::uint32_t n = found->first; n != kNoEntry; n = entries_[n].next) {
      const Entry& e = entries_[n];
      const double d = (e.at - query.at).squaredNorm();
      if (d < query.squared && query.visit(e.point, d)) return true;
    }
    if (!descend || used_ >> level <= 1) return false;
    const Index lo = cell(query.lo, level + 1), hi = cell(query.hi, level + 1);
    for (std::int64_t i = std::max(lo.x, 2 * c.x); i <= std::min(hi.x, 2 * c.x + 1); ++i)
      for (std::int64_t j = std::max(lo.y, 2 * c.y); j <= std::min(hi.y, 2 * c.y + 1); ++j)
        for (std::int64_t k = std::max(lo.z, 2 * c.z); k <= std::min(hi.z, 2 * c.z + 1); ++k)
          if (visit_cell(query, level + 1, {i, j, k}, true)) return true;
    return false;
  }

  [[nodiscard]] int level_of(double length) const {
    int level = 0;
    for (double l = unit_; l > length && level < kLevels - 1; l *= 0.5) ++level;
    return level;
  }
  [[nodiscard]] Index cell(const Vec3& p, int level) const {
    const double scale = static_cast<double>(1 << level) / unit_;
    const Vec3 x = (p - origin_) * scale;
    return {floor_of(x.x()), floor_of(x.y()), floor_of(x.z())};
  }
  /// As std::floor, which is a call where the processor is not known.
  [[nodiscard]] static std::int64_t floor_of(double x) {
    const auto towards_zero = static_cast<std::int64_t>(x);
    return towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0);
  }
  [[nodiscard]] static std::uint64_t key(int level, const Index& c) {
    const auto part = [](std::int64_t x) { return static_cast<std::uint64_t>(x + 4) & 0xfffff; };
    return (static_cast<std::uint64_t>(level) << 59) ^ (part(c.x) << 40) ^ (part(c.y) << 20) ^ part(c.z);
  }

  /// Cells by their keys, with open addresses: a look-up costs one miss of the cache where a list for each
  /// bucket costs three.
  class Cells {
   public:
    /// The cell and whether it is new.
    std::pair<Cell*, bool> insert(std::uint64_t key) {
      if (2 * (count_ + 1) > cells_.size()) grow();
      Cell& cell = cells_[place_of(key)];
      if (cell.key == key) return {&cell, false};
      cell.key = key;
      ++count_;
      return {&cell, true};
    }
    /// Null where it is not there.
    [[nodiscard]] const Cell* find(std::uint64_t key) const {
      if (cells_.empty()) return nullptr;
      const Cell& cell = cells_[place_of(key)];
      return cell.key == key ? &cell : nullptr;
    }

   private:
    /// Where the key is, or would be.
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const {
      const std::size_t mask = cells_.size() - 1;
      std::size_t place = mixed(key) & mask;
      while (cells_[place].key != key && cells_[place].key != kNoCell) place = (place + 1) & mask;
      return place;
    }
    void grow() {
      std::vector<Cell> old(std::max<std::size_t>(64, 2 * cells_.size()));
      old.swap(cells_);
      for (const Cell& cell : old)
        if (cell.key != kNoCell) cells_[place_of(cell.key)] = cell;
    }
    /// Neighbouring cells have neighbouring keys: they are spread over the places.
    static std::size_t mixed(std::uint64_t x) {
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
      return x ^ (x >> 31);
    }

    std::vector<Cell> cells_;  ///< a power of two of them, half of them free at least
    std::size_t count_ = 0;
  };

  Vec3 origin_;
  double unit_;
  std::uint64_t used_ = 0;
  Cells cells_;
  std::vector<Entry> entries_;
};

}  // namespace octet
