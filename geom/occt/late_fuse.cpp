// SPDX-License-Identifier: BSD-3-Clause
// A few attempts, judged as those of whole groups are.
#include "geom/occt/late_fuse.h"

#include <BOPTools_AlgoTools.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "geom/occt/fuse_tolerances.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/spline_faces.h"
#include "geom/occt/spline_solids.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

constexpr std::array<TopAbs_ShapeEnum, 3> kPartTypes{TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX};

class LateAttempts {
 public:
  LateAttempts(const LateGroup& group, double noise)
      : others_(group.others),
        solids_(group.near),
        meant_(group.at_odds),
        splines_join_(group.splines_join),
        noise_(noise) {
    solids_.push_back(group.late);
    if (meant_.empty()) {
      meant_.resize(group.near.size());
      std::iota(meant_.begin(), meant_.end(), std::size_t{0});
    }
    thin_ = std::max(noise, kRoundingShare * diagonal_of_all(solids_));
  }

  std::unique_ptr<GroupFuse> run() const {
    if (!splines_join_ || solids_.size() <= kMostAgain)
      if (auto plain = attempt(solids_, 0.0, [](GroupFuse&) {})) return plain;
    if (const std::optional<SplineFaces> about = with_spline_faces_about_last(solids_)) {
      const auto tell = [&](GroupFuse& fuse) { fuse.began_with(about->history, {}, about->faces); };
      if (auto fused = attempt(about->solids, kTearOfSplines, tell)) return fused;
      take_back(*about);
    }
    const std::vector<std::size_t> the_last{solids_.size() - 1};
    if (const std::optional<SplineSolids> last = as_splines(solids_, the_last)) {
      const auto tell = [&](GroupFuse& fuse) { fuse.began_with(last->history, the_last); };
      if (auto fused = attempt(last->solids, kTearOfSplines, tell)) return fused;
    }
    return nullptr;
  }

 private:
  /// With more tolerance only where nothing but something thin, gaps or slivers is wrong.
  template <class Tell>
  [[nodiscard]] std::unique_ptr<GroupFuse> attempt(const std::vector<TopoDS_Shape>& solids, double tear,
                                                   const Tell& tell) const {
    for (const double tolerance : fuse_tolerances(solids_, noise_)) {
      auto fuse = std::make_unique<GroupFuse>(solids, std::vector<TopoDS_Edge>(), tolerance, thin_, tear);
      tell(*fuse);
      if (is_good(*fuse)) return fuse;
      const bool worth_more = tolerance > 0.0 || (fuse->sound() && !fuse->clean());
      if (!worth_more || solids_.size() > kMostAgain) break;
    }
    return nullptr;
  }

  [[nodiscard]] bool is_good(const GroupFuse& fuse) const {
    if (!fuse.clean()) return false;
    const auto meets = [&](std::size_t i) { return fuse.have_common_edges(i, solids_.size() - 1); };
    if (!std::any_of(meant_.begin(), meant_.end(), meets)) return false;
    const Followers followers(fuse.history());
    const auto follows = [&](const TopoDS_Shape& other) { return followers.can_follow(other); };
    if (!std::all_of(others_.begin(), others_.end(), follows)) return false;
    for (std::size_t i = 0; i < solids_.size(); ++i)
      if (!fuse.keeps_volume(i, solids_[i])) return false;
    return true;
  }

  const std::vector<TopoDS_Shape>& others_;
  std::vector<TopoDS_Shape> solids_;
  std::vector<std::size_t> meant_;
  bool splines_join_;
  double noise_, thin_;
};

}  // namespace

std::unique_ptr<GroupFuse> late_fuse(const LateGroup& group, double noise) {
  return LateAttempts(group, noise).run();
}

bool Followers::can_follow(const TopoDS_Shape& solid) const {
  const bool is_placed = !solid.Location().IsIdentity();
  for (const TopAbs_ShapeEnum type : kPartTypes) {
    const TopTools_IndexedMapOfShape parts = sub_shapes(solid, type);
    for (int i = 1; i <= parts.Extent(); ++i) {
      const int count = fuse_->Modified(parts(i)).Extent();
      if (fuse_->IsRemoved(parts(i)) || count > 1 || (count > 0 && is_placed)) return false;
    }
  }
  return true;
}

TopoDS_Shape Followers::follow(const TopoDS_Shape& solid) {
  bool changes = false;
  for (const TopAbs_ShapeEnum type : kPartTypes) {
    const TopTools_IndexedMapOfShape parts = sub_shapes(solid, type);
    for (int i = 1; i <= parts.Extent(); ++i) {
      const TopTools_ListOfShape& made = fuse_->Modified(parts(i));
      if (made.IsEmpty()) continue;
      const TopoDS_Shape was = parts(i).Oriented(TopAbs_FORWARD), is = made.First().Oriented(TopAbs_FORWARD);
      const bool turned = type != TopAbs_VERTEX && BOPTools_AlgoTools::IsSplitToReverse(is, was, context_);
      changes_->Replace(was, turned ? is.Reversed() : is);
      changes = true;
    }
  }
  if (!changes) return solid;
  TopoDS_Shape now = changes_->Apply(solid);
  own_->AddModified(solid, now);
  for (const TopAbs_ShapeEnum type : kPartTypes) {
    const TopTools_IndexedMapOfShape parts = sub_shapes(solid, type);
    for (int i = 1; i <= parts.Extent(); ++i) {
      const TopoDS_Shape& part = parts(i);
      if (!fuse_->Modified(part).IsEmpty() || !own_->Modified(part).IsEmpty()) continue;
      if (const TopoDS_Shape is = changes_->Apply(part); !is.IsSame(part)) own_->AddModified(part, is);
    }
  }
  return now;
}

}  // namespace octet
