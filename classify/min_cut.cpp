// SPDX-License-Identifier: BSD-3-Clause
// Blocking flows over levels; the side of the source that is still reached is label 0.
#include "classify/min_cut.h"

#include <algorithm>
#include <limits>

namespace octet {
namespace {

constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void TwoLabels::add(std::uint32_t from, std::uint32_t to, std::int64_t capacity, std::int64_t reverse) {
  const auto forward = static_cast<std::uint32_t>(arcs_[from].size());
  const auto backward = static_cast<std::uint32_t>(arcs_[to].size());
  arcs_[from].push_back({to, backward, capacity});
  arcs_[to].push_back({from, forward, reverse});
}

void TwoLabels::prefer(std::uint32_t node, std::int64_t cost_of_0, std::int64_t cost_of_1) {
  own_[node][0] += cost_of_0;
  own_[node][1] += cost_of_1;
}

void TwoLabels::join(std::uint32_t a, std::uint32_t b, std::int64_t cost_01, std::int64_t cost_10) {
  if (cost_01 > 0 || cost_10 > 0) add(a, b, cost_01, cost_10);
}

/// What a node's two labels cost alike decides nothing.
void TwoLabels::join_terminals() {
  const auto source = static_cast<std::uint32_t>(own_.size()), sink = source + 1;
  for (std::uint32_t n = 0; n < own_.size(); ++n) {
    const std::int64_t more = own_[n][1] - own_[n][0];
    // Cutting the arc from the source puts the node on the sink's side: label 1.
    if (more > 0) add(source, n, more, 0);
    if (more < 0) add(n, sink, -more, 0);
  }
}

/// Steps from the source over arcs with room left. False when the sink is not reached.
bool TwoLabels::find_levels() {
  const auto source = static_cast<std::uint32_t>(own_.size()), sink = source + 1;
  level_.assign(arcs_.size(), kFar);
  queue_.assign(1, source);
  level_[source] = 0;
  for (std::size_t i = 0; i < queue_.size() && level_[sink] == kFar; ++i)
    for (const Arc& arc : arcs_[queue_[i]]) {
      if (arc.capacity <= 0 || level_[arc.to] != kFar) continue;
      level_[arc.to] = level_[queue_[i]] + 1;
      queue_.push_back(arc.to);
    }
  return level_[sink] != kFar;
}

/// Fills paths that go up a level with every step until there is none.
void TwoLabels::block_flow() {
  const auto source = static_cast<std::uint32_t>(own_.size()), sink = source + 1;
  std::vector<std::uint32_t> next(arcs_.size(), 0);  // per node, the first arc that may still lead on
  std::vector<std::uint32_t> path{source};           // every arc on it is its tail's `next`
  const auto arc_from = [&](std::uint32_t n) -> Arc& { return arcs_[n][next[n]]; };
  while (!path.empty()) {
    const std::uint32_t at = path.back();
    if (at == sink) {
      std::int64_t flow = std::numeric_limits<std::int64_t>::max();
      for (std::size_t i = 0; i + 1 < path.size(); ++i) flow = std::min(flow, arc_from(path[i]).capacity);
      std::size_t keep = path.size();
      for (std::size_t i = path.size() - 1; i-- > 0;) {
        Arc& arc = arc_from(path[i]);
        arc.capacity -= flow;
        arcs_[arc.to][arc.back].capacity += flow;
        if (arc.capacity == 0) keep = i + 1;
      }
      path.resize(keep);
      continue;
    }
    auto& k = next[at];
    while (k < arcs_[at].size() && (arcs_[at][k].capacity <= 0 || level_[arcs_[at][k].to] != level_[at] + 1))
      ++k;
    if (k < arcs_[at].size()) {
      path.push_back(arcs_[at][k].to);
    } else {
      path.pop_back();
      if (!path.empty()) ++next[path.back()];
    }
  }
}

std::vector<std::uint8_t> TwoLabels::solve() {
  const auto source = static_cast<std::uint32_t>(own_.size());
  join_terminals();
  while (find_levels()) block_flow();
  std::vector<std::uint8_t> label(arcs_.size(), 1);
  std::vector<std::uint32_t> queue{source};
  label[source] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const Arc& arc : arcs_[queue[i]])
      if (arc.capacity > 0 && label[arc.to] == 1) {
        label[arc.to] = 0;
        queue.push_back(arc.to);
      }
  label.resize(source);
  return label;
}

}  // namespace octet
