// SPDX-License-Identifier: BSD-3-Clause
// A tiny balanced octree for tests: terminal octants by level and corner, one-level difference over 26
// neighbours.
#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

#include "base/vertex_order.h"
#include "tests/delaunay/point_sets.h"

namespace octet::testing {

/// Coordinates on the lattice of vertex_order.h.
struct TestOctant {
  int level = 0;
  std::array<std::uint32_t, 3> corner{};

  [[nodiscard]] std::uint32_t extent() const { return 1u << (kLatticeLevels - level); }
  auto operator<=>(const TestOctant&) const = default;
};

class BalancedOctree {
 public:
  /// Splits every octant up to `uniform` levels, then random ones up to `finest`, then what balance asks.
  BalancedOctree(int uniform, int finest, double chance, Engine& engine) {
    std::set<TestOctant> open{TestOctant{}};
    while (!open.empty()) {
      const TestOctant o = *open.begin();
      open.erase(open.begin());
      if (o.level < uniform || (o.level < finest && real(engine) < chance)) {
        for (const TestOctant& child : children(o)) open.insert(child);
      } else {
        leaves_.insert(o);
      }
    }
    balance();
    for (const TestOctant& o : leaves_) {
      for (const int c : {0, 2, 6, 8, 18, 20, 24, 26}) {
        int& finest_at = finest_at_.try_emplace(local(o, c), 0).first->second;
        finest_at = std::max(finest_at, o.level);
      }
    }
    for (const auto& [at, level] : finest_at_) {
      number_[at] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.add(Vec3(at[0], at[1], at[2]) * 0x1p-18, octree_vertex_rank(at[0], at[1], at[2]));
    }
  }

  using At = std::array<std::uint32_t, 3>;

  [[nodiscard]] const std::set<TestOctant>& leaves() const { return leaves_; }
  [[nodiscard]] const RankedPoints& vertices() const { return vertices_; }

  /// The terminal octant whose half-open box holds the lattice point.
  [[nodiscard]] TestOctant find(const At& at) const {
    for (int level = 0; level <= kLatticeLevels; ++level) {
      TestOctant o{level, at};
      for (auto& c : o.corner) c &= ~(o.extent() - 1);
      if (leaves_.count(o) != 0) return o;
    }
    return {-1, {}};
  }

 private:
  static At local(const TestOctant& o, int n) {
    const std::uint32_t half = o.extent() / 2;
    return {o.corner[0] + half * static_cast<std::uint32_t>(n % 3),
            o.corner[1] + half * static_cast<std::uint32_t>(n / 3 % 3),
            o.corner[2] + half * static_cast<std::uint32_t>(n / 9)};
  }

  static std::array<TestOctant, 8> children(const TestOctant& o) {
    std::array<TestOctant, 8> result;
    for (int c = 0; c < 8; ++c) {
      const At at = local(o, (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2));
      result[c] = {o.level + 1, at};
    }
    return result;
  }

  // Octants around `o` that are more than one level coarser.
  [[nodiscard]] std::vector<TestOctant> too_coarse_around(const TestOctant& o) const {
    std::vector<TestOctant> coarse;
    const std::int64_t e = o.extent(), root = std::int64_t{1} << kLatticeLevels;
    for (int n = 0; n < 27; ++n) {
      At at{};
      bool outside = false;
      const int step[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      for (int k = 0; k < 3; ++k) {
        const std::int64_t c = o.corner[k] + step[k] * e;
        outside = outside || c < 0 || c >= root;
        at[k] = static_cast<std::uint32_t>(c);
      }
      if (outside) continue;
      const TestOctant near = find(at);
      if (near.level >= 0 && near.level < o.level - 1) coarse.push_back(near);
    }
    return coarse;
  }

  void balance() {
    std::vector<TestOctant> stack(leaves_.begin(), leaves_.end());
    while (!stack.empty()) {
      const TestOctant o = stack.back();
      stack.pop_back();
      if (leaves_.count(o) == 0) continue;
      const auto coarse = too_coarse_around(o);
      for (const TestOctant& c : coarse) {
        if (leaves_.erase(c) == 0) continue;
        for (const TestOctant& child : children(c)) {
          leaves_.insert(child);
          stack.push_back(child);
        }
      }
      if (!coarse.empty()) stack.push_back(o);
    }
  }

  std::set<TestOctant> leaves_;
  std::map<At, int> finest_at_;
  std::map<At, std::uint32_t> number_;
  RankedPoints vertices_;
};

}  // namespace octet::testing
