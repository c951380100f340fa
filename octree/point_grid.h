// SPDX-License-Identifier: BSD-3-Clause
// Points in hash cells whose length follows the local spacing: neighbours within about one spacing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
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
    cells_[key(level, c)].push_back({point, at});
    while (level-- > 0) {
      c = {c.x >> 1, c.y >> 1, c.z >> 1};
      if (!cells_.try_emplace(key(level, c)).second) break;  // its parents are there
    }
  }

  /// Calls visit(point, squared distance) for every point closer to `at` than r, in no particular order;
  /// stops when it returns true.
  template <class Visit>
  bool any_within(const Vec3& at, double r, const Visit& visit) const {
    const int start = level_of(2.0 * r);
    const Query<Visit> query{at, at - Vec3::Constant(r), at + Vec3::Constant(r), r * r, visit};
    for (int level = 0; level <= start; ++level) {
      if (level < start && !(used_ >> level & 1)) continue;
      const Index lo = cell(query.lo, level), hi = cell(query.hi, level);
      for (std::int64_t i = lo.x; i <= hi.x; ++i)
        for (std::int64_t j = lo.y; j <= hi.y; ++j)
          for (std::int64_t k = lo.z; k <= hi.z; ++k)
            if (visit_cell(query, level, {i, j, k}, level == start)) return true;
    }
    return false;
  }

 private:
  static constexpr int kLevels = 19;
  struct Entry {
    std::uint32_t point;
    Vec3 at;
  };
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
    const auto found = cells_.find(key(level, c));
    if (found == cells_.end()) return false;
    for (const Entry& e : found->second) {
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

  /// Neighbouring cells have neighbouring keys: they are spread over the buckets.
  struct Mix {
    std::size_t operator()(std::uint64_t x) const {
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
      return x ^ (x >> 31);
    }
  };

  Vec3 origin_;
  double unit_;
  std::uint64_t used_ = 0;
  std::unordered_map<std::uint64_t, std::vector<Entry>, Mix> cells_;
};

}  // namespace octet
