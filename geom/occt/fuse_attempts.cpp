// SPDX-License-Identifier: BSD-3-Clause
// Fuses of one group of solids with one tolerance after the other.
#include "geom/occt/fuse_attempts.h"

#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "geom/occt/contact_circle.h"
#include "geom/occt/fuse_tolerances.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/spline_solids.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

/// Of a part with more pairs at odds than this no pair is fused by itself.
constexpr std::size_t kMostPairs = 40;
/// So many of a group are tried as splines each by itself, before all that are at odds.
constexpr std::size_t kMostAlone = 3;

using SolidPair = std::array<std::size_t, 2>;

/// The pairs that conflicts name; where none does, each solid that is to blame alone, with those it may
/// touch.
std::set<SolidPair> blamed_pairs(const std::vector<TopoDS_Shape>& solids,
                                 const std::vector<FuseConflict>& conflicts) {
  std::set<SolidPair> pairs;
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

/// What came of two solids that were fused by themselves.
struct PairFuse {
  FuseConflict conflict;             ///< what is wrong with them in the group, or by themselves
  bool joined;                       ///< whether anything joins them
  double tolerance;                  ///< with which
  std::set<std::size_t> as_splines;  ///< those of them that must be splines for it
};

/// The first that names both, or the first.
const FuseConflict& first_between(const SolidPair& pair, const std::vector<FuseConflict>& conflicts) {
  const auto names_both = [&](const FuseConflict& conflict) {
    return std::minmax(conflict.solids[0], conflict.solids[1]) == std::minmax(pair[0], pair[1]);
  };
  const auto found = std::find_if(conflicts.begin(), conflicts.end(), names_both);
  return found != conflicts.end() ? *found : conflicts.front();
}

/// Without any of them nothing is wrong there.
std::vector<PairFuse> fuse_pairs(const std::vector<TopoDS_Shape>& solids,
                                 const std::vector<FuseConflict>& conflicts, double noise) {
  const std::set<SolidPair> pairs = blamed_pairs(solids, conflicts);
  std::vector<PairFuse> found;
  if (pairs.size() > kMostPairs) return found;
  for (const SolidPair& pair : pairs) {
    const auto fuse = best_fuse({solids[pair[0]], solids[pair[1]]}, noise);
    PairFuse of{
        {pair, middle_of(solids[pair[0]]), "the general fuse failed"}, fuse->sound(), fuse->tolerance(), {}};
    if (!fuse->failed()) {
      const FuseConflict& of_both =
          fuse->sound() ? first_between(pair, conflicts) : fuse->conflicts().front();
      of.conflict = {pair, of_both.place, of_both.cause};
    }
    for (const std::size_t i : fuse->as_splines()) of.as_splines.insert(pair[i]);
    found.push_back(std::move(of));
  }
  return found;
}

/// How many conflicts name one of these solids.
std::size_t count_of(const std::set<std::size_t>& solids, const std::vector<FuseConflict>& conflicts) {
  return static_cast<std::size_t>(
      std::count_if(conflicts.begin(), conflicts.end(), [&](const FuseConflict& conflict) {
        return solids.contains(conflict.solids[0]) || solids.contains(conflict.solids[1]);
      }));
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
    for (const double tolerance : fuse_tolerances(solids_, noise_)) {
      if (best_ && is_clean_but_for_gaps() && tolerance < best_->near().narrowest) continue;
      if (!attempt(contacts_, tolerance) && !contacts_.empty()) attempt({}, tolerance);
      if (best_->clean() || is_good_for_many()) break;
      if (tolerance == 0.0 && !pairs_give_hope()) return std::move(best_);
    }
    if (!best_->sound()) try_splines();
    return std::move(best_);
  }

 private:
  [[nodiscard]] bool is_clean_but_for_gaps() const {
    return best_->sound() && best_->thin_pieces() + best_->slivers() == 0;
  }

  /// Slivers alone are no reason to fuse many again.
  [[nodiscard]] bool is_good_for_many() const {
    return solids_.size() > kMostAgain && best_->sound() && best_->thin_pieces() + best_->near().count == 0;
  }

  using Badness = std::tuple<bool, std::size_t, int, int>;
  [[nodiscard]] static Badness badness(const GroupFuse& of) {
    return {of.failed(), of.conflicts().size(), of.thin_pieces() + of.near().count, of.slivers()};
  }

  /// Fuses solids at odds by themselves. False where some of them cannot be joined so, or not as splines
  /// among the others, which then are what is told of the group; or where the group is joined with them as
  /// splines.
  bool pairs_give_hope() {
    if (best_->sound() || best_->failed() || solids_.size() < 3) return true;
    std::vector<FuseConflict> at_odds, need_splines;
    std::set<std::size_t> which;
    std::vector<SolidPair> joined_so;
    double tolerance = 0.0;
    std::size_t most = 0, worst = 0;
    for (const PairFuse& pair : fuse_pairs(solids_, best_->conflicts(), noise_)) {
      tolerance = std::max(tolerance, pair.tolerance);
      if (!pair.joined) at_odds.push_back(pair.conflict);
      if (pair.as_splines.empty()) continue;
      which.insert(pair.as_splines.begin(), pair.as_splines.end());
      joined_so.push_back(pair.conflict.solids);
      need_splines.push_back(pair.conflict);
      need_splines.back().splines_join = true;
      const std::size_t count = count_of(pair.as_splines, best_->conflicts());
      if (count < most) continue;
      most = count;
      worst = need_splines.size() - 1;
    }
    if (at_odds.empty() && which.empty()) return true;
    if (at_odds.empty()) {
      const bool worth_it = 2 * count_of(which, best_->conflicts()) >= best_->conflicts().size();
      if (worth_it && attempt_as_splines({which.begin(), which.end()}, joined_so, tolerance)) return false;
    }
    if (solids_.size() > kMostAgain)
      at_odds.insert(at_odds.end(), need_splines.begin(), need_splines.end());
    else if (at_odds.empty())
      at_odds.push_back(need_splines[worst]);
    best_->blame(std::move(at_odds));
    return false;
  }

  void try_splines() {
    const std::vector<std::size_t> blamed = most_blamed();
    std::vector<std::vector<std::size_t>> choices;
    for (std::size_t i = 0; i < std::min(blamed.size(), kMostAlone); ++i) choices.push_back({blamed[i]});
    if (blamed.size() > 1) choices.push_back(blamed);
    const std::set<SolidPair> pairs = blamed_pairs(solids_, best_->conflicts());
    for (const std::vector<std::size_t>& which : choices)
      if (attempt_as_splines(which, {pairs.begin(), pairs.end()}, 0.0)) return;
  }

  /// The solids that conflicts name, those that most do first; both of two.
  [[nodiscard]] std::vector<std::size_t> most_blamed() const {
    if (solids_.size() == 2) return {0, 1};
    std::vector<std::pair<std::size_t, std::size_t>> counts;
    for (std::size_t i = 0; i < solids_.size(); ++i)
      counts.emplace_back(count_of({i}, best_->conflicts()), i);
    std::erase_if(counts, [](const auto& of) { return of.first == 0; });
    std::stable_sort(counts.begin(), counts.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::size_t> solids;
    for (const auto& [count, i] : counts) solids.push_back(i);
    return solids;
  }

  /// Two solids that nothing else joins are fused with `tolerance`, and with more up to noise where something
  /// thin, gaps or slivers are left. A group must have none of these, for there is another way: it can be
  /// fused without the solid to blame, and that with what becomes of the others, which is less work where
  /// they are many.
  bool attempt_as_splines(const std::vector<std::size_t>& which, const std::vector<SolidPair>& at_odds,
                          double tolerance) {
    if (solids_.size() > kMostAgain) return false;
    const std::optional<SplineSolids> splines = as_splines(solids_, which);
    if (!splines) return false;
    const bool is_group = solids_.size() > 2;
    std::unique_ptr<GroupFuse> best;
    double last = -1.0;
    for (const double step : fuse_tolerances(solids_, noise_)) {
      const double more = std::max(step, tolerance);
      if (more <= last || (best && more > thin_)) continue;
      last = more;
      auto fuse = std::make_unique<GroupFuse>(splines->solids, std::vector<TopoDS_Edge>(), more, thin_,
                                              kTearOfSplines);
      fuse->began_with(splines->history, which);
      if (!joins(*fuse, which, at_odds)) break;
      if (!best || badness(*fuse) < badness(*best)) best = std::move(fuse);
      if (best->clean() || is_group) break;
    }
    if (!best || (is_group && !best->clean())) return false;
    best_ = std::move(best);
    return true;
  }

  // Solids at odds meet: a fuse in which they have nothing in common has missed it.
  [[nodiscard]] bool joins(const GroupFuse& fuse, const std::vector<std::size_t>& as_splines,
                           const std::vector<SolidPair>& at_odds) const {
    if (!fuse.sound()) return false;
    for (const SolidPair& pair : at_odds)
      if (!fuse.have_common_edges(pair[0], pair[1])) return false;
    for (const std::size_t i : as_splines)
      if (!fuse.keeps_volume(i, solids_[i])) return false;
    return true;
  }

  bool attempt(const std::vector<TopoDS_Edge>& contacts, double tolerance) {
    auto fuse = std::make_unique<GroupFuse>(solids_, contacts, tolerance, thin_);
    const bool sound = fuse->sound();
    const bool counts = tolerance <= thin_ || fuse->clean();
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
