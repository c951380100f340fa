// SPDX-License-Identifier: BSD-3-Clause
// Fuses of one group of solids with one tolerance after the other.
#include "geom/occt/fuse_attempts.h"

#include <Bnd_Box.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <tuple>

#include "geom/occt/contact_circle.h"
#include "geom/occt/shape_box.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

/// Tolerances of a fuse, as shares of its solids' diagonal, none of them more than a share of the smallest
/// solid's: none, then up to the noise of files, then, for walls askew of which a part only is noise, more.
/// What these give must leave nothing to be wished for.
struct Step {
  double of_all, of_smallest;
};
constexpr std::array<Step, 6> kSteps{
    {{0.0, 1e-5}, {1e-8, 1e-5}, {1e-7, 1e-5}, {1e-6, 1e-5}, {4e-6, 3e-5}, {1e-5, 5e-5}}};
/// Of a part with more pairs at odds than this no pair is fused by itself.
constexpr std::size_t kMostPairs = 40;

double diagonal_of_all(const std::vector<TopoDS_Shape>& solids) {
  Bnd_Box all;
  for (const TopoDS_Shape& solid : solids) all.Add(box_of(solid));
  return diagonal_of(all);
}

using Pair = std::array<std::size_t, 2>;

/// The pairs that conflicts name; where none does, each solid that is to blame alone, with those it may
/// touch.
std::set<Pair> blamed_pairs(const std::vector<TopoDS_Shape>& solids,
                            const std::vector<FuseConflict>& conflicts) {
  std::set<Pair> pairs;
  for (const FuseConflict& conflict : conflicts) {
    const auto [low, high] = std::minmax(conflict.solids[0], conflict.solids[1]);
    if (low != high) pairs.insert({low, high});
  }
  if (!pairs.empty()) return pairs;
  for (const FuseConflict& conflict : conflicts)
    for (std::size_t j = 0; j < solids.size(); ++j) {
      const std::size_t i = conflict.solids[0];
      if (i != j && !box_of(solids[i]).IsOut(box_of(solids[j])))
        pairs.insert({std::min(i, j), std::max(i, j)});
    }
  return pairs;
}

/// Pairs that no tolerance joins, though they are fused by themselves: without either nothing is wrong there.
std::vector<FuseConflict> pairs_at_odds(const std::vector<TopoDS_Shape>& solids,
                                        const std::vector<FuseConflict>& conflicts, double noise) {
  const std::set<Pair> pairs = blamed_pairs(solids, conflicts);
  std::vector<FuseConflict> found;
  if (pairs.size() > kMostPairs) return found;
  for (const Pair& pair : pairs) {
    const auto fuse = best_fuse({solids[pair[0]], solids[pair[1]]}, noise);
    if (fuse->failed())
      found.push_back({pair, middle_of(solids[pair[0]]), "the general fuse failed"});
    else if (!fuse->sound())
      found.push_back({pair, fuse->conflicts().front().place, fuse->conflicts().front().cause});
  }
  return found;
}

class Attempts {
 public:
  Attempts(const std::vector<TopoDS_Shape>& solids, double noise)
      : solids_(solids),
        noise_(noise),
        diagonal_(diagonal_of_all(solids)),
        thin_(std::max(noise, kRoundingShare * diagonal_)),
        contacts_(contacts_of(solids, kContactShare * diagonal_)) {}

  std::unique_ptr<GroupFuse> run() {
    double last = -1.0;
    for (const double tolerance : tolerances()) {
      if (tolerance <= last) continue;
      last = tolerance;
      if (best_ && is_clean_but_for_gaps() && tolerance < best_->near().narrowest) continue;
      if (!attempt(contacts_, tolerance) && !contacts_.empty()) attempt({}, tolerance);
      if (is_clean_but_for_gaps() && best_->near().count == 0) break;
      if (tolerance == 0.0 && is_hopeless()) break;
    }
    return std::move(best_);
  }

 private:
  /// Ascending, some twice.
  [[nodiscard]] std::vector<double> tolerances() const {
    double smallest = diagonal_;
    for (const TopoDS_Shape& solid : solids_) smallest = std::min(smallest, diagonal_of(box_of(solid)));
    std::vector<double> all{noise_};
    for (const Step& step : kSteps)
      all.push_back(std::min(step.of_all * diagonal_, step.of_smallest * smallest));
    std::sort(all.begin(), all.end());
    return all;
  }

  [[nodiscard]] bool is_clean_but_for_gaps() const {
    return best_->sound() && best_->thin_pieces() + best_->slivers() == 0;
  }

  using Badness = std::tuple<bool, std::size_t, int, int>;
  [[nodiscard]] static Badness badness(const GroupFuse& of) {
    return {of.failed(), of.conflicts().size(), of.thin_pieces() + of.near().count, of.slivers()};
  }

  /// Whether some of the solids cannot be joined by themselves; then they are what is told of the group.
  bool is_hopeless() {
    if (best_->sound() || best_->failed() || solids_.size() < 3) return false;
    std::vector<FuseConflict> odds = pairs_at_odds(solids_, best_->conflicts(), noise_);
    if (odds.empty()) return false;
    best_->blame(std::move(odds));
    return true;
  }

  bool attempt(const std::vector<TopoDS_Edge>& contacts, double tolerance) {
    auto fuse = std::make_unique<GroupFuse>(solids_, contacts, tolerance, thin_);
    const bool sound = fuse->sound();
    const bool counts = tolerance <= thin_ || badness(*fuse) == Badness{};
    if (!best_ || (counts && badness(*fuse) < badness(*best_))) best_ = std::move(fuse);
    return sound;
  }

  const std::vector<TopoDS_Shape>& solids_;
  double noise_, diagonal_;
  double thin_;  ///< what is thinner is there by mistake
  std::vector<TopoDS_Edge> contacts_;
  std::unique_ptr<GroupFuse> best_;
};

}  // namespace

std::unique_ptr<GroupFuse> best_fuse(const std::vector<TopoDS_Shape>& solids, double noise) {
  return Attempts(solids, noise).run();
}

}  // namespace octet
