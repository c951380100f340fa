// SPDX-License-Identifier: BSD-3-Clause
// Octant edges against the exact boundary.
#include "octree/cuts.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "base/blocks.h"
#include "base/error.h"

namespace octet {
namespace {

/// Edges a task: large enough to make tasks cheap, small enough to share out a few thousand edges.
constexpr std::size_t kChunk = 256;
/// Tasks between two questions whether to go on: a tenth of a second, where edges cross many sheets.
constexpr std::size_t kChunksAQuestion = 64;

void cut_edges(const Model& model, const Octree& tree, const OctreeVertices& vertices,
               std::span<const OctantEdge> edges, std::vector<OctantEdgeCut>& cuts) {
  std::vector<Hit> hits;
  for (const OctantEdge& edge : edges) {
    hits.clear();
    model.intersect(tree.position(vertices.at[edge.from]), tree.position(vertices.at[edge.to]), hits);
    for (const Hit& hit : hits) cuts.push_back({edge.from, edge.to, hit});
  }
}

}  // namespace

std::vector<OctantEdgeCut> cut_octant_edges(const Model& model, const Octree& tree,
                                            const OctreeVertices& vertices, std::span<const OctantEdge> edges,
                                            const std::function<bool()>& cancelled) {
  std::vector<std::vector<OctantEdgeCut>> chunks((edges.size() + kChunk - 1) / kChunk);
  for (std::size_t begin = 0; begin < chunks.size(); begin += kChunksAQuestion) {
    if (cancelled && cancelled()) throw Cancelled();
    tbb::parallel_for(begin, std::min(begin + kChunksAQuestion, chunks.size()), [&](std::size_t i) {
      const std::size_t first = i * kChunk;
      cut_edges(model, tree, vertices, edges.subspan(first, std::min(kChunk, edges.size() - first)),
                chunks[i]);
    });
  }
  return joined(chunks);
}

}  // namespace octet
