// SPDX-License-Identifier: BSD-3-Clause
// Breadth-first augmenting paths; the side of the source that is still reached is label 0.
#include "classify/min_cut.h"

#include <algorithm>
#include <limits>

namespace octet {

void TwoLabels::add(std::uint32_t from, std::uint32_t to, std::int64_t capacity, std::int64_t reverse) {
  const auto forward = static_cast<std::uint32_t>(arcs_[from].size());
  const auto backward = static_cast<std::uint32_t>(arcs_[to].size());
  arcs_[from].push_back({to, backward, capacity});
  arcs_[to].push_back({from, forward, reverse});
}

void TwoLabels::prefer(std::uint32_t node, std::int64_t cost_of_0, std::int64_t cost_of_1) {
  const auto source = static_cast<std::uint32_t>(arcs_.size() - 2), sink = source + 1;
  // Cutting the arc from the source puts the node on the sink's side: label 1.
  if (cost_of_1 > 0) add(source, node, cost_of_1, 0);
  if (cost_of_0 > 0) add(node, sink, cost_of_0, 0);
}

void TwoLabels::join(std::uint32_t a, std::uint32_t b, std::int64_t cost_01, std::int64_t cost_10) {
  if (cost_01 > 0 || cost_10 > 0) add(a, b, cost_01, cost_10);
}

bool TwoLabels::augment(std::uint32_t source, std::uint32_t sink) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> via(arcs_.size(), {kNone, 0});  // node before, its arc
  std::vector<std::uint32_t> queue{source};
  via[source].first = source;
  for (std::size_t i = 0; i < queue.size() && via[sink].first == kNone; ++i)
    for (std::uint32_t k = 0; k < arcs_[queue[i]].size(); ++k) {
      const Arc& arc = arcs_[queue[i]][k];
      if (arc.capacity <= 0 || via[arc.to].first != kNone) continue;
      via[arc.to] = {queue[i], k};
      queue.push_back(arc.to);
    }
  if (via[sink].first == kNone) return false;
  std::int64_t flow = std::numeric_limits<std::int64_t>::max();
  for (std::uint32_t n = sink; n != source; n = via[n].first)
    flow = std::min(flow, arcs_[via[n].first][via[n].second].capacity);
  for (std::uint32_t n = sink; n != source; n = via[n].first) {
    Arc& arc = arcs_[via[n].first][via[n].second];
    arc.capacity -= flow;
    arcs_[n][arc.back].capacity += flow;
  }
  return true;
}

std::vector<std::uint8_t> TwoLabels::solve() {
  const auto source = static_cast<std::uint32_t>(arcs_.size() - 2), sink = source + 1;
  while (augment(source, sink)) {
  }
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
