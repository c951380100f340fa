// SPDX-License-Identifier: BSD-3-Clause
// Groups of solids, each fused with the least tolerance that does, or without the solids to blame.
#include "geom/occt/fuse.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include "geom/occt/edge_uses.h"
#include "geom/occt/fuse_attempts.h"
#include "geom/occt/group_fuse.h"
#include "geom/occt/late_fuse.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

using Group = std::vector<std::size_t>;  ///< indices of solids, ascending

/// So many solids that groups were fused without are tried in the end.
constexpr int kMostLate = 6;

/// Groups of at least two solids that hang together by boxes that meet, or are parted by noise.
std::vector<Group> touching_groups(const std::vector<TopoDS_Shape>& solids, double noise,
                                   const std::vector<bool>& apart) {
  std::vector<Bnd_Box> boxes;
  for (const TopoDS_Shape& solid : solids) {
    boxes.push_back(box_of(solid));
    boxes.back().Enlarge(std::max(noise, kRoundingShare * diagonal_of(boxes.back())));
  }
  Group lead(solids.size());
  std::iota(lead.begin(), lead.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (lead[i] != i) i = lead[i];
    return i;
  };
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      if (apart[i] || apart[j] || boxes[i].IsOut(boxes[j])) continue;
      const std::size_t a = root(i), b = root(j);
      lead[std::max(a, b)] = std::min(a, b);
    }
  std::map<std::size_t, Group> by_lead;
  for (std::size_t i = 0; i < solids.size(); ++i) by_lead[root(i)].push_back(i);
  std::vector<Group> groups;
  for (auto& [first, group] : by_lead)
    if (group.size() > 1) groups.push_back(std::move(group));
  return groups;
}

/// The fewest solids without which no conflict is left, taken greedily, of a tie the smaller; a conflict each
/// that tells why.
std::map<std::size_t, FuseConflict> culprits(std::vector<FuseConflict> conflicts,
                                             const std::vector<double>& sizes) {
  std::map<std::size_t, FuseConflict> found;
  while (!conflicts.empty()) {
    std::map<std::size_t, std::size_t> blame;
    for (const FuseConflict& conflict : conflicts) {
      ++blame[conflict.solids[0]];
      if (conflict.solids[1] != conflict.solids[0]) ++blame[conflict.solids[1]];
    }
    auto worst = blame.begin();
    for (auto it = blame.begin(); it != blame.end(); ++it)
      if (it->second > worst->second ||
          (it->second == worst->second && sizes[it->first] <= sizes[worst->first]))
        worst = it;
    const std::size_t solid = worst->first;
    const auto is_of = [&](const FuseConflict& c) { return c.solids[0] == solid || c.solids[1] == solid; };
    found[solid] = *std::find_if(conflicts.begin(), conflicts.end(), is_of);
    std::erase_if(conflicts, is_of);
  }
  return found;
}

int shared_faces(const std::vector<TopoDS_Shape>& solids) {
  TopTools_IndexedDataMapOfShapeListOfShape solids_of;
  for (const TopoDS_Shape& solid : solids)
    TopExp::MapShapesAndAncestors(solid, TopAbs_FACE, TopAbs_SOLID, solids_of);
  int count = 0;
  for (int i = 1; i <= solids_of.Extent(); ++i) count += solids_of(i).Extent() > 1 ? 1 : 0;
  return count;
}

class Fuser {
 public:
  Fuser(SolidSet& set, double noise, std::vector<KeptApart>& apart, std::vector<DoneFuse>& done)
      : set_(set),
        noise_(noise),
        apart_(apart),
        done_(done),
        is_apart_(set.solids.size(), false),
        images_(set.solids.size()) {
    for (const KeptApart& kept : apart) {
      is_apart_[kept.solid] = true;
      if (kept.late) late_.push_back(kept.solid);
    }
    for (std::size_t i = 0; i < images_.size(); ++i) images_[i] = {set.solids[i]};
  }

  void run() {
    keep_open_ones_apart();
    for (const Group& group : touching_groups(set_.solids, noise_, is_apart_)) fuse(group);
    for (const std::size_t i : late_) join_late(i);
    copy_those_apart();
    collect();
  }

 private:
  /// What the general fuse makes of solids that are not closed harms the others.
  void keep_open_ones_apart() {
    for (const Group& group : touching_groups(set_.solids, noise_, is_apart_))
      for (const std::size_t i : group) {
        const EdgeUses uses = edge_uses(set_.solids[i]);
        const int open = uses.first(&Uses::open);
        if (open == 0) continue;
        apart_.push_back({i, i, middle_of(uses.edges(open)), "it is not closed"});
        is_apart_[i] = true;
      }
  }

  void fuse(Group group) {
    while (group.size() > 1) {
      std::vector<TopoDS_Shape> solids;
      for (const std::size_t i : group) solids.push_back(set_.solids[i]);
      const auto fuse = fuse_of(solids, false, [&] { return best_fuse(solids, noise_); });
      if (fuse->sound()) {
        accept(group, *fuse);
        return;
      }
      leave_apart(*fuse, group);
    }
  }

  /// What is known of these solids, else what `make` makes of them.
  template <class Make>
  std::shared_ptr<const GroupFuse> fuse_of(const std::vector<TopoDS_Shape>& solids, bool late,
                                           const Make& make) {
    const auto same = [](const TopoDS_Shape& a, const TopoDS_Shape& b) { return a.IsEqual(b); };
    const auto known = std::find_if(done_.begin(), done_.end(), [&](const DoneFuse& done) {
      return done.late == late &&
             std::equal(solids.begin(), solids.end(), done.solids.begin(), done.solids.end(), same);
    });
    return known != done_.end() ? known->fuse : done_.emplace_back(DoneFuse{solids, late, make()}).fuse;
  }

  void tell(const GroupFuse& fuse) {
    for (const std::string& text : fuse.warnings()) set_.notes.push_back(text);
    const std::size_t count = fuse.images().size();
    if (fuse.tolerance() > 0.0)
      set_.notes.push_back(
          fmt::format("{} solids that touch were fused with a tolerance of {:.3g} mm, for they overlap, or "
                      "miss each other, by less",
                      count, fuse.tolerance()));
    if (!fuse.as_splines().empty())
      set_.notes.push_back(
          fmt::format("{} of {} solids that touch were turned into splines to be fused, for as they are the "
                      "general fuse cannot join them",
                      fuse.as_splines().size(), count));
    if (fuse.spline_faces() > 0)
      set_.notes.push_back(
          fmt::format("{} face(s) of {} solids that touch were turned into splines to be fused, for as they "
                      "are the general fuse cannot join them",
                      fuse.spline_faces(), count));
  }

  void accept(const Group& group, const GroupFuse& fuse) {
    tell(fuse);
    for (std::size_t i = 0; i < group.size(); ++i) images_[group[i]] = fuse.images()[i];
    changed_ = changed_ || fuse.history()->HasModified() || fuse.history()->HasRemoved();
    set_.history->Merge(fuse.history());
  }

  /// Fuses a solid that was left apart with what has become of those near it.
  void join_late(std::size_t late) {
    KeptApart& kept =
        *std::find_if(apart_.begin(), apart_.end(), [&](const KeptApart& one) { return one.solid == late; });
    kept.late = late_tried_++ < kMostLate && joins_late(kept);
    is_apart_[late] = !kept.late;
  }

  bool joins_late(const KeptApart& kept) {
    Bnd_Box box = box_of(set_.solids[kept.solid]);
    box.Enlarge(std::max(noise_, kRoundingShare * diagonal_of(box)));
    LateGroup group{set_.solids[kept.solid], {}, {}, {}, kept.splines_join};
    TopTools_IndexedMapOfShape near;
    for (std::size_t i = 0; i < images_.size(); ++i)
      for (const TopoDS_Shape& image : images_[i]) {
        if (is_apart_[i]) continue;
        if (box.IsOut(box_of(image)))
          group.others.push_back(image);
        else
          near.Add(image);
      }
    if (near.IsEmpty()) return true;
    group.near.assign(near.cbegin(), near.cend());
    for (const TopoDS_Shape& image : images_[kept.other])
      if (const int index = near.FindIndex(image); index > 0)
        group.at_odds.push_back(static_cast<std::size_t>(index) - 1);
    std::vector<TopoDS_Shape> solids = group.near;
    solids.push_back(group.late);
    const auto fuse = fuse_of(solids, true, [&] { return late_fuse(group, noise_); });
    if (fuse) accept_late(near, kept.solid, *fuse);
    return fuse != nullptr;
  }

  void accept_late(const TopTools_IndexedMapOfShape& near, std::size_t late, const GroupFuse& fuse) {
    Followers followers(fuse.history());
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (is_apart_[i]) continue;
      std::vector<TopoDS_Shape> now;
      for (const TopoDS_Shape& image : images_[i])
        if (const int index = near.FindIndex(image); index > 0) {
          const std::vector<TopoDS_Shape>& made = fuse.images()[static_cast<std::size_t>(index) - 1];
          now.insert(now.end(), made.begin(), made.end());
        } else {
          now.push_back(followers.follow(image));
        }
      images_[i] = std::move(now);
    }
    images_[late] = fuse.images().back();
    set_.history->Merge(fuse.history());
    set_.history->Merge(followers.history());
    tell(fuse);
    changed_ = true;
  }

  void leave_apart(const GroupFuse& fuse, Group& group) {
    std::vector<double> sizes;
    for (const std::size_t i : group) sizes.push_back(diagonal_of(box_of(set_.solids[i])));
    std::map<std::size_t, FuseConflict> guilty = culprits(fuse.conflicts(), sizes);
    if (fuse.failed())
      for (std::size_t i = 0; i < group.size(); ++i)
        guilty[i] = {{i, i}, middle_of(set_.solids[group[i]]), "the general fuse failed"};
    for (const auto& [i, conflict] : guilty) {
      const std::size_t other = conflict.solids[conflict.solids[0] == i ? 1 : 0];
      apart_.push_back({group[i], group[other], conflict.place, conflict.cause, conflict.splines_join});
      is_apart_[group[i]] = true;
      if (!fuse.failed()) late_.push_back(group[i]);
    }
    std::erase_if(group, [&](std::size_t i) { return is_apart_[i]; });
  }

  /// They get faces, edges and vertices that they share with no other; what others share with them stays the
  /// others', too.
  void copy_those_apart() {
    TopTools_IndexedMapOfShape of_others;
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (!is_apart_[i]) TopExp::MapShapes(set_.solids[i], of_others);
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (is_apart_[i]) images_[i] = {own_copy(set_.solids[i], of_others)};
  }

  TopoDS_Shape own_copy(const TopoDS_Shape& solid, const TopTools_IndexedMapOfShape& of_others) {
    BRepBuilderAPI_Copy copy(solid, false, false);
    for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      const TopTools_IndexedMapOfShape map = sub_shapes(solid, type);
      for (int i = 1; i <= map.Extent(); ++i) {
        const bool stays = of_others.Contains(map(i)) && !set_.history->IsRemoved(map(i)) &&
                           set_.history->Modified(map(i)).IsEmpty();
        if (stays) set_.history->AddModified(map(i), map(i));
        set_.history->AddModified(map(i), copy.ModifiedShape(map(i)));
      }
    }
    return copy.Shape();
  }

  void collect() {
    std::vector<TopoDS_Shape> solids;
    TopTools_MapOfShape seen;
    for (const auto& images : images_)
      for (const TopoDS_Shape& image : images)
        if (seen.Add(image)) solids.push_back(image);
    if (solids.size() != set_.solids.size())
      set_.notes.push_back(fmt::format("solids interfere: {} solids became {} when they were fused",
                                       set_.solids.size(), solids.size()));
    if (changed_)
      set_.notes.push_back(
          fmt::format("solids that touch were fused: {} face(s) are shared by two solids, {} were so before",
                      shared_faces(solids), shared_faces(set_.solids)));
    set_.solids = std::move(solids);
  }

  SolidSet& set_;
  double noise_;
  std::vector<KeptApart>& apart_;
  std::vector<DoneFuse>& done_;
  std::vector<bool> is_apart_;
  std::vector<std::vector<TopoDS_Shape>> images_;  ///< by index of the set
  Group late_;                                     ///< left apart, to be joined in the end
  int late_tried_ = 0;
  bool changed_ = false;  ///< whether any fuse changed anything
};

}  // namespace

void fuse_touching(SolidSet& set, double noise, std::vector<KeptApart>& apart, std::vector<DoneFuse>& done) {
  Fuser(set, noise, apart, done).run();
}

}  // namespace octet
