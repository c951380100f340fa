// SPDX-License-Identifier: BSD-3-Clause
// Vertex labels by parity along octant edges.
#include "octree/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "octree/cuts.h"

namespace octet {
namespace {

constexpr std::int32_t kUnknown = -1;

/// A crossing whose direction makes a smaller cosine with the face normal has no trustworthy sign.
constexpr double kGrazing = 1e-6;

/// What one octant edge says about its two ends.
struct Passage {
  enum class Kind : std::uint8_t {
    kPlain,     ///< no cut: both ends have the same region
    kCrossing,  ///< from `region_from` to `region_to`
    kSilent,    ///< events that say nothing about parity
    kBroken,    ///< its cuts contradict each other
  };
  Kind kind = Kind::kPlain;
  std::int32_t region_from = 0, region_to = 0;
  std::uint32_t first_cut = 0, last_cut = 0;  ///< cuts [first, last)
};

/// The regions before and after one event; {kUnknown, kUnknown} when it says nothing.
std::array<std::int32_t, 2> regions_across(const Model& model, const Hit& hit, const Vec3& direction) {
  const double along = direction.dot(hit.normal);
  const bool says_nothing = hit.kind != HitKind::kTransversal || hit.end_point || hit.on.dim != 2 ||
                            std::abs(along) < kGrazing * direction.norm();
  if (says_nothing) return {kUnknown, kUnknown};
  const auto& region = model.face(hit.face).region;
  return along > 0.0 ? std::array<std::int32_t, 2>{region[0], region[1]}
                     : std::array<std::int32_t, 2>{region[1], region[0]};
}

class VertexLabeller {
 public:
  VertexLabeller(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                 const OctantTypes& types, std::span<const OctantEdge> edges,
                 const std::vector<OctantEdgeCut>& cuts)
      : model_(model),
        tree_(tree),
        vertices_(vertices),
        types_(types),
        edges_(edges),
        cuts_(cuts),
        region_(vertices.size(), kUnknown),
        asked_(vertices.size(), 0) {}

  OctreeLabels run() {
    read_passages();
    list_edges_of_vertices();
    take_octants_regions();
    spread();
    ask_for_the_rest();
    settle_conflicts();
    return {types_, std::move(region_), std::move(faults_)};
  }

 private:
  void read_passages() {
    passages_.resize(edges_.size());
    std::uint32_t cut = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      passages_[e].first_cut = cut;
      while (cut < cuts_.size() && cuts_[cut].from == edges_[e].from && cuts_[cut].to == edges_[e].to) ++cut;
      passages_[e].last_cut = cut;
      if (passages_[e].first_cut < cut) read_cuts(edges_[e], passages_[e]);
    }
    OCTET_CHECK(cut == cuts_.size());
  }

  void read_cuts(const OctantEdge& edge, Passage& passage) const {
    const Vec3 direction = position(edge.to) - position(edge.from);
    passage.kind = Passage::Kind::kCrossing;
    for (std::uint32_t c = passage.first_cut; c < passage.last_cut; ++c) {
      const auto [before, after] = regions_across(model_, cuts_[c].hit, direction);
      if (before == kUnknown) {
        passage.kind = Passage::Kind::kSilent;
        return;
      }
      if (c == passage.first_cut) passage.region_from = before;
      if (c != passage.first_cut && before != passage.region_to) passage.kind = Passage::Kind::kBroken;
      passage.region_to = after;
    }
  }

  /// Compressed rows: the edges of each vertex.
  void list_edges_of_vertices() {
    row_.assign(vertices_.size() + 1, 0);
    for (const OctantEdge& e : edges_) {
      ++row_[e.from + 1];
      ++row_[e.to + 1];
    }
    for (std::size_t v = 0; v < vertices_.size(); ++v) row_[v + 1] += row_[v];
    edges_of_.resize(2 * edges_.size());
    std::vector<std::uint32_t> next(row_.begin(), row_.end() - 1);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      edges_of_[next[edges_[e].from]++] = e;
      edges_of_[next[edges_[e].to]++] = e;
    }
  }

  void take_octants_regions() {
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (types_.type[i] == OctantType::kBoundary) continue;
      for (const std::uint32_t v : octant_lattice(vertices_, OctantId(i))) {
        if (v == kNoVertex) continue;
        if (region_[v] == kUnknown) {
          region_[v] = types_.region[i];
          if (row_[v] < row_[v + 1]) queue_.push_back(v);
        } else if (region_[v] != types_.region[i]) {
          conflict_at_octant(v, types_.region[i]);
        }
      }
    }
  }

  /// Breadth first from the queue along edges that can be trusted.
  void spread() {
    for (; next_in_queue_ < queue_.size(); ++next_in_queue_) {
      const std::uint32_t v = queue_[next_in_queue_];
      for (std::uint32_t r = row_[v]; r < row_[v + 1]; ++r) {
        const OctantEdge& e = edges_[edges_of_[r]];
        const std::uint32_t other = e.from == v ? e.to : e.from;
        if (region_[other] != kUnknown) continue;
        region_[other] = told_by(edges_of_[r], v);
        if (region_[other] != kUnknown) queue_.push_back(other);
      }
    }
  }

  /// The region at the far end of an edge, given the one at v; kUnknown where the edge does not tell.
  [[nodiscard]] std::int32_t told_by(std::uint32_t e, std::uint32_t v) const {
    const Passage& p = passages_[e];
    const bool forward = edges_[e].from == v;
    switch (p.kind) {
      case Passage::Kind::kPlain:
        return region_[v];
      case Passage::Kind::kCrossing:
        if (region_[v] != (forward ? p.region_from : p.region_to)) return kUnknown;
        return forward ? p.region_to : p.region_from;
      case Passage::Kind::kSilent:
      case Passage::Kind::kBroken:
        break;
    }
    return kUnknown;
  }

  void ask_for_the_rest() {
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (region_[v] != kUnknown) continue;
      ask(v);
      queue_.push_back(v);
      spread();
    }
  }

  void ask(std::uint32_t v) {
    region_[v] = model_.region_at(position(v));
    asked_[v] = 1;
  }

  [[nodiscard]] bool agrees(std::uint32_t e) const {
    const Passage& p = passages_[e];
    switch (p.kind) {
      case Passage::Kind::kPlain:
        return region_[edges_[e].from] == region_[edges_[e].to];
      case Passage::Kind::kCrossing:
        return region_[edges_[e].from] == p.region_from && region_[edges_[e].to] == p.region_to;
      case Passage::Kind::kSilent:
        return true;
      case Passage::Kind::kBroken:
        break;
    }
    return false;
  }

  /// An edge that disagrees is told once and its ends are asked for, which may make neighbours disagree in
  /// turn; each vertex is asked for at most once, so this ends.
  void settle_conflicts() {
    std::vector<std::uint8_t> told(edges_.size(), 0);
    std::vector<std::uint32_t> suspects(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) suspects[e] = e;
    for (std::size_t s = 0; s < suspects.size(); ++s) {
      const std::uint32_t e = suspects[s];
      if (told[e] != 0 || agrees(e)) continue;
      told[e] = 1;
      conflict_on_edge(e);
      for (const std::uint32_t v : {edges_[e].from, edges_[e].to}) {
        if (asked_[v] != 0) continue;
        const std::int32_t before = region_[v];
        ask(v);
        if (region_[v] == before) continue;
        suspects.insert(suspects.end(), edges_of_.begin() + row_[v], edges_of_.begin() + row_[v + 1]);
      }
    }
  }

  void conflict_on_edge(std::uint32_t e) {
    const Passage& p = passages_[e];
    const Vec3 from = position(edges_[e].from), to = position(edges_[e].to);
    Fault fault;
    if (p.first_cut < p.last_cut) {
      fault.entity = cuts_[p.first_cut].hit.on;
      fault.place = cuts_[p.first_cut].hit.point;
    } else {
      fault.place = 0.5 * (from + to);
      if (const auto foot = model_.closest(fault.place, (to - from).norm())) fault.entity = foot->on;
    }
    fault.cause = fmt::format(
        "{} cuts between ({:g}, {:g}, {:g}) and ({:g}, {:g}, {:g}) do not fit the regions {} and "
        "{} found at these ends",
        p.last_cut - p.first_cut, from.x(), from.y(), from.z(), to.x(), to.y(), to.z(),
        region_[edges_[e].from], region_[edges_[e].to]);
    fault.advice =
        "check the part for a gap, an overlap or a wrongly oriented face there, or try a slightly different "
        "size";
    faults_.push_back(std::move(fault));
  }

  void conflict_at_octant(std::uint32_t v, std::int32_t other_region) {
    Fault fault;
    fault.place = position(v);
    fault.entity = model_region(std::max(region_[v], other_region));
    fault.cause = fmt::format("regions {} and {} touch with no face between them", region_[v], other_region);
    fault.advice = "check the part for an open shell or a missing face there";
    faults_.push_back(std::move(fault));
    if (asked_[v] == 0) ask(v);
  }

  [[nodiscard]] Vec3 position(std::uint32_t v) const { return tree_.position(vertices_.at[v]); }

  const Model& model_;
  const Octree& tree_;
  const OctreeVertices& vertices_;
  const OctantTypes& types_;
  std::span<const OctantEdge> edges_;
  const std::vector<OctantEdgeCut>& cuts_;
  std::vector<Passage> passages_;   // per edge
  std::vector<std::uint32_t> row_;  // per vertex: first of its entries in edges_of_
  std::vector<std::uint32_t> edges_of_;
  std::vector<std::int32_t> region_;  // per vertex
  std::vector<std::uint8_t> asked_;   // per vertex: answered by the model itself
  std::vector<std::uint32_t> queue_;
  std::size_t next_in_queue_ = 0;
  std::vector<Fault> faults_;
};

}  // namespace

OctreeLabels label_vertices(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                            const OctantTypes& types, std::span<const OctantEdge> edges,
                            const std::vector<OctantEdgeCut>& cuts) {
  return VertexLabeller(model, tree, vertices, types, edges, cuts).run();
}

}  // namespace octet
