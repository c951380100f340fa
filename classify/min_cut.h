// SPDX-License-Identifier: BSD-3-Clause
// The cheapest way to part a small graph in two.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace octet {

/// Labels nodes 0 or 1 so that the sum of all costs is least. Exact (a minimum cut by blocking flows [Dinic
/// 1970]); of several optima the one with the fewest 0 labels. Meant for some thousand nodes.
class TwoLabels {
 public:
  explicit TwoLabels(std::size_t nodes) : own_(nodes), arcs_(nodes + 2) {}

  /// Costs of the node's own labels, at least 0; adds up over calls.
  void prefer(std::uint32_t node, std::int64_t cost_of_0, std::int64_t cost_of_1);
  /// Cost when a is 0 and b is 1, and when a is 1 and b is 0, at least 0; equal labels cost nothing.
  void join(std::uint32_t a, std::uint32_t b, std::int64_t cost_01, std::int64_t cost_10);
  [[nodiscard]] std::vector<std::uint8_t> solve();

 private:
  struct Arc {
    std::uint32_t to, back;  ///< `back`: number of the opposite arc at `to`
    std::int64_t capacity;
  };
  void add(std::uint32_t from, std::uint32_t to, std::int64_t capacity, std::int64_t reverse);
  void join_terminals();
  [[nodiscard]] bool find_levels();
  void block_flow();

  std::vector<std::array<std::int64_t, 2>> own_;  ///< per node, costs of labels 0 and 1
  std::vector<std::vector<Arc>> arcs_;  ///< nodes, then the source (label 0), then the sink (label 1)
  std::vector<std::uint32_t> level_;    ///< steps from the source
  std::vector<std::uint32_t> queue_;
};

}  // namespace octet
