// SPDX-License-Identifier: BSD-3-Clause
// Points in hash cells whose length follows the local spacing: neighbours within about one spacing.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Cost: a look-up visits the few cells of each level that holds points of comparable spacing.
class PointGrid {
 public:
  /// `unit` is the length of cells of level 0 (the root's length).
  PointGrid(const Vec3& origin, double unit) : origin_(origin), unit_(unit) {}

  void add(std::uint32_t point, const Vec3& at, double spacing) {
    const int level = level_of(2.0 * spacing);
    cells_[key(level, cell(at, level))].push_back({point, at});
    used_ |= std::uint64_t{1} << level;
  }

  /// Calls visit(point, squared distance) for every point closer to `at` than r; stops when it returns true.
  template <class Visit>
  bool any_within(const Vec3& at, double r, const Visit& visit) const {
    for (int level = 0; level < kLevels; ++level) {
      if (!(used_ >> level & 1)) continue;
      const Index lo = cell(at - Vec3::Constant(r), level), hi = cell(at + Vec3::Constant(r), level);
      for (std::int64_t i = lo.x; i <= hi.x; ++i)
        for (std::int64_t j = lo.y; j <= hi.y; ++j)
          for (std::int64_t k = lo.z; k <= hi.z; ++k) {
            const auto found = cells_.find(key(level, {i, j, k}));
            if (found == cells_.end()) continue;
            for (const Entry& e : found->second) {
              const double d = (e.at - at).squaredNorm();
              if (d < r * r && visit(e.point, d)) return true;
            }
          }
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

  [[nodiscard]] int level_of(double length) const {
    int level = 0;
    for (double l = unit_; l > length && level < kLevels - 1; l *= 0.5) ++level;
    return level;
  }
  [[nodiscard]] Index cell(const Vec3& p, int level) const {
    const double scale = static_cast<double>(1 << level) / unit_;
    const Vec3 x = (p - origin_) * scale;
    return {static_cast<std::int64_t>(std::floor(x.x())), static_cast<std::int64_t>(std::floor(x.y())),
            static_cast<std::int64_t>(std::floor(x.z()))};
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
