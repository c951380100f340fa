// SPDX-License-Identifier: BSD-3-Clause
// General fuse of solids that touch, so that what they share is one entity.
#include <fmt/format.h>

#include <BOPAlgo_Builder.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Message_Alert.hxx>
#include <Message_Report.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <algorithm>
#include <map>
#include <string_view>

#include "base/error.h"
#include "geom/occt/solids.h"

namespace octet {
namespace {

/// Which solids have a box that meets another's.
std::vector<bool> may_touch(const std::vector<TopoDS_Shape>& solids) {
  std::vector<Bnd_Box> boxes(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i) BRepBndLib::Add(solids[i], boxes[i], false);
  std::vector<bool> touch(solids.size(), false);
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t j = i + 1; j < solids.size(); ++j)
      if (!boxes[i].IsOut(boxes[j])) touch[i] = touch[j] = true;
  return touch;
}

/// The solids a fuse made of `solid`, in the order of the result.
void append_images(const TopoDS_Shape& solid, BRepTools_History& history, TopTools_MapOfShape& seen,
                   std::vector<TopoDS_Shape>& solids) {
  const TopTools_ListOfShape& images = history.Modified(solid);
  if (images.IsEmpty()) {
    if (!history.IsRemoved(solid) && seen.Add(solid)) solids.push_back(solid);
    return;
  }
  for (const TopoDS_Shape& image : images)
    if (image.ShapeType() == TopAbs_SOLID && seen.Add(image)) solids.push_back(image);
}

const char* meaning_of(std::string_view alert) {
  if (alert == "BOPAlgo_AlertSelfInterferingShape") return "shape(s) that cross themselves";
  if (alert == "BOPAlgo_AlertAcquiredSelfIntersection")
    return "shape(s) that would cross themselves once fused";
  if (alert == "BOPAlgo_AlertIntersectionOfPairOfShapesFailed")
    return "pair(s) that could not be intersected";
  if (alert == "BOPAlgo_AlertTooSmallEdge") return "edge(s) too small to stay";
  if (alert == "BOPAlgo_AlertUnableToOrientTheShell") return "shell(s) without orientation";
  return nullptr;
}

/// What the fuse could not do as it should: where the mesh fails later, this is why.
void note_warnings(const BOPAlgo_Builder& fuse, std::vector<std::string>& notes) {
  std::map<std::string, int> counts;
  for (const Handle(Message_Alert) & alert : fuse.GetReport()->GetAlerts(Message_Warning))
    ++counts[alert->GetMessageKey()];
  for (const auto& [key, count] : counts) {
    const char* meaning = meaning_of(key);
    notes.push_back(
        fmt::format("general fuse warns of {} {}", count, meaning != nullptr ? meaning : key.c_str()));
  }
}

int shared_faces(const std::vector<TopoDS_Shape>& solids) {
  TopTools_IndexedDataMapOfShapeListOfShape solids_of;
  for (const TopoDS_Shape& solid : solids)
    TopExp::MapShapesAndAncestors(solid, TopAbs_FACE, TopAbs_SOLID, solids_of);
  int count = 0;
  for (int i = 1; i <= solids_of.Extent(); ++i) count += solids_of(i).Extent() > 1 ? 1 : 0;
  return count;
}

}  // namespace

void fuse_touching(SolidSet& set) {
  const std::vector<bool> touch = may_touch(set.solids);
  if (std::count(touch.begin(), touch.end(), true) < 2) return;
  BOPAlgo_Builder fuse;
  for (std::size_t i = 0; i < set.solids.size(); ++i)
    if (touch[i]) fuse.AddArgument(set.solids[i]);
  fuse.SetNonDestructive(true);
  fuse.SetRunParallel(false);
  fuse.Perform();
  if (fuse.HasErrors())
    throw ModelError(
        "the solids that touch cannot be joined along common faces (general fuse failed); --no-fuse keeps "
        "them "
        "apart",
        {});
  note_warnings(fuse, set.notes);
  const Handle(BRepTools_History) history = fuse.History();
  std::vector<TopoDS_Shape> solids;
  TopTools_MapOfShape seen;
  for (std::size_t i = 0; i < set.solids.size(); ++i) {
    if (!touch[i]) {
      solids.push_back(set.solids[i]);
    } else {
      append_images(set.solids[i], *history, seen, solids);
    }
  }
  if (solids.size() != set.solids.size())
    set.notes.push_back(fmt::format("solids interfere: {} solids became {} when they were fused",
                                    set.solids.size(), solids.size()));
  if (history->HasModified() || history->HasRemoved())
    set.notes.push_back(fmt::format(
        "solids that touch were fused: {} face(s) are shared by two solids, {} were so in the file",
        shared_faces(solids), shared_faces(set.solids)));
  set.solids = std::move(solids);
  set.history->Merge(history);
}

}  // namespace octet
