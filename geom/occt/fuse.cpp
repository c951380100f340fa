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
#include <array>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>

#include "geom/occt/contact_circle.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/group_fuse.h"
#include "geom/occt/shape_box.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

/// Tolerances of a fuse, as shares of its solids' diagonal: none, then up to the noise of files.
constexpr std::array<double, 4> kTolerances{0.0, 1e-8, 1e-7, 1e-6};
/// No tolerance is more than this share of the smallest solid's diagonal.
constexpr double kLargestTolerance = 1e-5;
using Group = std::vector<std::size_t>;  ///< indices of solids, ascending

/// Groups of at least two solids that hang together by boxes that meet, or are parted by noise.
std::vector<Group> touching_groups(const std::vector<TopoDS_Shape>& solids, const std::vector<bool>& apart) {
  std::vector<Bnd_Box> boxes;
  for (const TopoDS_Shape& solid : solids) {
    boxes.push_back(box_of(solid));
    boxes.back().Enlarge(kRoundingShare * diagonal_of(boxes.back()));
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

double diagonal_of_all(const std::vector<TopoDS_Shape>& solids) {
  Bnd_Box all;
  for (const TopoDS_Shape& solid : solids) all.Add(box_of(solid));
  return diagonal_of(all);
}

/// Without conflicts, thin pieces and gaps if any tolerance gives that; else that with the fewest. Circles
/// of contact are left away where the fuse gets worse by them.
std::unique_ptr<GroupFuse> best_fuse(const std::vector<TopoDS_Shape>& solids) {
  const double diagonal = diagonal_of_all(solids);
  double smallest = diagonal;
  for (const TopoDS_Shape& solid : solids) smallest = std::min(smallest, diagonal_of(box_of(solid)));
  const std::vector<TopoDS_Edge> contacts = contacts_of(solids, kContactShare * diagonal);
  const auto badness = [](const GroupFuse& fuse) {
    return std::make_tuple(fuse.failed(), fuse.conflicts().size(), fuse.thin_pieces() + fuse.near().count);
  };
  const double largest = kLargestTolerance * smallest;
  std::unique_ptr<GroupFuse> best;
  const auto attempt = [&](const std::vector<TopoDS_Edge>& with, double tolerance) {
    auto fuse = std::make_unique<GroupFuse>(solids, with, tolerance, kRoundingShare * diagonal);
    const bool sound = fuse->sound();
    if (!best || badness(*fuse) < badness(*best)) best = std::move(fuse);
    return sound;
  };
  double last = -1.0;
  for (const double share : kTolerances) {
    const double tolerance = std::min(share * diagonal, largest);
    if (tolerance <= last) break;
    last = tolerance;
    if (best && best->sound() && best->thin_pieces() == 0 && tolerance < best->near().narrowest) continue;
    if (!attempt(contacts, tolerance) && !contacts.empty()) attempt({}, tolerance);
    if (best->sound() && best->thin_pieces() == 0 && best->near().count == 0) break;
  }
  return best;
}

/// The fewest solids without which no conflict is left, taken greedily; a conflict each that tells why.
std::map<std::size_t, FuseConflict> culprits(std::vector<FuseConflict> conflicts) {
  std::map<std::size_t, FuseConflict> found;
  while (!conflicts.empty()) {
    std::map<std::size_t, std::size_t> blame;
    for (const FuseConflict& conflict : conflicts) {
      ++blame[conflict.solids[0]];
      if (conflict.solids[1] != conflict.solids[0]) ++blame[conflict.solids[1]];
    }
    auto worst = blame.begin();
    for (auto it = blame.begin(); it != blame.end(); ++it)
      if (it->second >= worst->second) worst = it;
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
  Fuser(SolidSet& set, std::vector<KeptApart>& apart, std::vector<DoneFuse>& done)
      : set_(set),
        apart_(apart),
        done_(done),
        is_apart_(set.solids.size(), false),
        images_(set.solids.size()) {
    for (const KeptApart& kept : apart) is_apart_[kept.solid] = true;
    for (std::size_t i = 0; i < images_.size(); ++i) images_[i] = {set.solids[i]};
  }

  void run() {
    keep_open_ones_apart();
    for (const Group& group : touching_groups(set_.solids, is_apart_)) fuse(group);
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (is_apart_[i]) images_[i] = {own_copy(set_.solids[i])};
    collect();
  }

 private:
  /// What the general fuse makes of solids that are not closed harms the others.
  void keep_open_ones_apart() {
    for (const Group& group : touching_groups(set_.solids, is_apart_))
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
      const std::shared_ptr<const GroupFuse> fuse = fuse_of(solids);
      if (fuse->sound()) {
        accept(group, *fuse);
        return;
      }
      leave_apart(*fuse, group);
    }
  }

  std::shared_ptr<const GroupFuse> fuse_of(const std::vector<TopoDS_Shape>& solids) {
    const auto same = [](const TopoDS_Shape& a, const TopoDS_Shape& b) { return a.IsEqual(b); };
    const auto known = std::find_if(done_.begin(), done_.end(), [&](const DoneFuse& done) {
      return std::equal(solids.begin(), solids.end(), done.solids.begin(), done.solids.end(), same);
    });
    return known != done_.end() ? known->fuse : done_.emplace_back(DoneFuse{solids, best_fuse(solids)}).fuse;
  }

  void accept(const Group& group, const GroupFuse& fuse) {
    for (const std::string& text : fuse.warnings()) set_.notes.push_back(text);
    if (fuse.tolerance() > 0.0)
      set_.notes.push_back(
          fmt::format("{} solids that touch were fused with a tolerance of {:.3g} mm, for they overlap, or "
                      "miss each other, by less",
                      group.size(), fuse.tolerance()));
    for (std::size_t i = 0; i < group.size(); ++i) images_[group[i]] = fuse.images()[i];
    changed_ = changed_ || fuse.history()->HasModified() || fuse.history()->HasRemoved();
    set_.history->Merge(fuse.history());
  }

  void leave_apart(const GroupFuse& fuse, Group& group) {
    std::map<std::size_t, FuseConflict> guilty = culprits(fuse.conflicts());
    if (fuse.failed())
      for (std::size_t i = 0; i < group.size(); ++i)
        guilty[i] = {{i, i}, middle_of(set_.solids[group[i]]), "the general fuse failed"};
    for (const auto& [i, conflict] : guilty) {
      const std::size_t other = conflict.solids[conflict.solids[0] == i ? 1 : 0];
      apart_.push_back({group[i], group[other], conflict.place, conflict.cause});
      is_apart_[group[i]] = true;
    }
    std::erase_if(group, [&](std::size_t i) { return is_apart_[i]; });
  }

  /// The solid with faces, edges and vertices that it shares with no other.
  TopoDS_Shape own_copy(const TopoDS_Shape& solid) {
    BRepBuilderAPI_Copy copy(solid, false, false);
    for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      TopTools_IndexedMapOfShape map;
      TopExp::MapShapes(solid, type, map);
      for (int i = 1; i <= map.Extent(); ++i) set_.history->AddModified(map(i), copy.ModifiedShape(map(i)));
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
      set_.notes.push_back(fmt::format(
          "solids that touch were fused: {} face(s) are shared by two solids, {} were so in the file",
          shared_faces(solids), shared_faces(set_.solids)));
    set_.solids = std::move(solids);
  }

  SolidSet& set_;
  std::vector<KeptApart>& apart_;
  std::vector<DoneFuse>& done_;
  std::vector<bool> is_apart_;
  std::vector<std::vector<TopoDS_Shape>> images_;  ///< by index of the set
  bool changed_ = false;                           ///< whether any fuse changed anything
};

}  // namespace

void fuse_touching(SolidSet& set, std::vector<KeptApart>& apart, std::vector<DoneFuse>& done) {
  Fuser(set, apart, done).run();
}

}  // namespace octet
