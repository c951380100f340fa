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
      : others_(group.others), solids_(group.near), meant_(group.at_odds) {
    solids_.push_back(group.late);
    if (meant_.empty()) {
      meant_.resize(group.near.size());
      std::iota(meant_.begin(), meant_.end(), std::size_t{0});
    }
    thin_ = std::max(noise, kRoundingShare * diagonal_of_all(solids_));
  }

  std::unique_ptr<GroupFuse> run() const {
    if (auto plain = fuse(solids_, 0.0); is_good(*plain)) return plain;
    if (const std::optional<SplineFaces> about = with_spline_faces_about_last(solids_)) {
      auto fused = fuse(about->solids, kTearOfSplines);
      fused->began_with(about->history, {}, about->faces);
      if (is_good(*fused)) return fused;
      take_back(*about);
    }
    const std::vector<std::size_t> the_last{solids_.size() - 1};
    if (const std::optional<SplineSolids> last = as_splines(solids_, the_last)) {
      auto fused = fuse(last->solids, kTearOfSplines);
      fused->began_with(last->history, the_last);
      if (is_good(*fused)) return fused;
    }
    return nullptr;
  }

 private:
  [[nodiscard]] std::unique_ptr<GroupFuse> fuse(const std::vector<TopoDS_Shape>& solids, double tear) const {
    return std::make_unique<GroupFuse>(solids, std::vector<TopoDS_Edge>(), 0.0, thin_, tear);
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
  double thin_;
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
