// SPDX-License-Identifier: BSD-3-Clause
// Compound moves: an operation that makes things worse at first, and what mends them.
#include "finalize/compound.h"

#include <algorithm>
#include <tuple>

#include "base/sort_unique.h"
#include "finalize/collapse.h"
#include "finalize/edge_removal.h"
#include "finalize/improve.h"
#include "finalize/split.h"
#include "finalize/trial.h"

namespace octet {
namespace {

/// The first operation may leave nothing below this share of t's shape. Measured on a screw, a wheel and a
/// shell: 0 cost a third more than 0.2 for the same angles, 0.5 won less.
constexpr double kFirstStep = 0.2;
/// So many steps may mend it; half of those that succeed take one or two, one in forty more than eight.
constexpr int kMendingSteps = 12;
/// Where so many of what was touched are no better than t was, mending is given up: measured on seven parts,
/// half of all work went into what had come to this, of which one in 24 was mended (662 of 6261 in all).
constexpr std::ptrdiff_t kTooManyWorse = 8;
/// Where each vertex has seen so many tetrahedra tried in vain, the geometry is taken to forbid more.
constexpr std::uint8_t kHopeless = 8;
/// Evaluations of shapes that all of them may take, worst elements first: an ordinary part uses half of
/// it at most. Where walls are thinner than the size all over the part, most elements are tried: without a
/// bound finalization takes up to twice as long, for 0.4 degrees of the first percentile.
constexpr std::uint64_t kFreeWork = 12'000'000, kWorkPerTet = 24;
/// And beyond a first part of it, so many for each that is kept: an ordinary part takes 3 to 13 thousand for
/// one, a board with layers far thinner than the size 54 thousand, for one in a hundred tried.
constexpr std::uint64_t kFirstWork = 4'000'000, kWorkPerKept = 20'000;

/// Adds what the last operation made to the area, and drops what it removed.
void take_in_made(const Workshop& shop, std::vector<TetId>& area) {
  area.insert(area.end(), shop.made.begin(), shop.made.end());
  sort_unique(area);
  std::erase_if(area, [&](TetId t) { return !shop.mesh.alive(t); });
}

/// Betters the worst of what was made, and of what comes of that, until all of it is better than `bar` and no
/// more of it flat than may be.
bool mend(Workshop& shop, double bar, double goal) {
  const auto& quality = shop.mesh.quality;
  std::vector<TetId> area;
  for (int step = 0;; ++step) {
    take_in_made(shop, area);
    const auto worst = std::min_element(area.begin(), area.end(), [&](TetId s, TetId t) {
      return std::tie(quality[s], s) < std::tie(quality[t], t);
    });
    const auto worse = std::count_if(area.begin(), area.end(), [&](TetId t) { return quality[t] <= bar; });
    if (worse >= kTooManyWorse) return false;
    // Nothing is left where a surface swap took the one tetrahedron under it away.
    if (area.empty() || (quality[*worst] > bar && shop.flats.settled(shop.mesh.tets.size()))) {
      shop.made = area;
      return true;
    }
    if (step == kMendingSteps || !improve_tet(shop, *worst, goal, Effort::kPolish)) return false;
  }
}

bool tried_enough(const Workshop& shop, const std::array<VertexId, 4>& v) {
  if (shop.compound_work > kFreeWork + kWorkPerTet * shop.mesh.tets.size() ||
      shop.compound_work > kFirstWork + kWorkPerKept * shop.compound_kept)
    return true;
  return std::all_of(v.begin(), v.end(), [&](VertexId w) {
    return w.index() < shop.in_vain.size() && shop.in_vain[w.index()] >= kHopeless;
  });
}

/// Adds the work done in its life to the account of compound moves.
class Meter {
 public:
  explicit Meter(Workshop& shop) : shop_(shop), before_(shop.work) {}
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  ~Meter() { shop_.compound_work += shop_.work - before_; }

 private:
  Workshop& shop_;
  std::uint64_t before_;
};

void note_vain(Workshop& shop, const std::array<VertexId, 4>& v) {
  shop.in_vain.resize(shop.mesh.points.size(), 0);
  for (const VertexId w : v) {
    std::uint8_t& count = shop.in_vain[w.index()];
    if (count < kHopeless) ++count;
  }
}

}  // namespace

bool improve_by_compound(Workshop& shop, TetId t, double goal) {
  const auto v = shop.mesh.tets[t];
  if (tried_enough(shop, v)) return false;
  const double before = shop.mesh.quality[t], bar = better_than(before);
  const double floor = std::max(kNoise, kFirstStep * before);
  const Meter meter(shop);
  const auto mends = [&](const auto& first) {
    Trial trial(shop);
    if (!first() || !mend(shop, bar, goal)) return false;
    trial.keep();
    ++shop.compound_kept;
    return true;
  };
  for (const auto& [i, j] : kTetEdge) {
    const VertexId a = v[i], b = v[j];
    if (mends([&] { return remove_edge(shop, t, a, b, floor); })) return true;
  }
  for (const auto& [i, j] : kTetEdge) {
    const VertexId a = v[i], b = v[j];
    if (mends([&] { return collapse_edge(shop, a, b, floor); }) ||
        mends([&] { return collapse_edge(shop, b, a, floor); }))
      return true;
  }
  for (const auto& [i, j] : kTetEdge) {
    const VertexId a = v[i], b = v[j];
    if (mends([&] { return split_edge(shop, t, a, b, floor, goal); })) return true;
  }
  note_vain(shop, v);
  return false;
}

}  // namespace octet
