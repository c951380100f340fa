// SPDX-License-Identifier: BSD-3-Clause
// Solids that cross themselves, then faces that touch.
#include "geom/occt/meeting_faces.h"

#include <fmt/format.h>

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <string>

#include "base/error.h"
#include "geom/occt/entity_names.h"
#include "geom/occt/imprint.h"
#include "geom/occt/sub_shapes.h"
#include "geom/occt/unite_crossed.h"

namespace octet {
namespace {

class Meeting {
 public:
  Meeting(const ShapeMaps& as_read, MissingCurves& curves, const StageLog& log, SolidSet& set)
      : as_read_(as_read), names_(as_read, set), curves_(curves), log_(log), set_(set) {}

  /// Solids that cross themselves.
  void unite(const FaceNumberPairs& crossing) {
    if (crossing.empty()) return;
    const auto pairs = faces_of(crossing);
    std::vector<TopoDS_Shape> solids;
    std::string cause = "no solid has both faces of a pair";
    bool any = false;
    for (const TopoDS_Shape& solid : set_.solids) {
      const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
      std::vector<std::array<TopoDS_Face, 2>> own;
      for (const auto& pair : pairs)
        if (faces.Contains(pair[0]) && faces.Contains(pair[1])) own.push_back(pair);
      const United united = own.empty() ? United{} : unite_crossed(solid, own, log_);
      if (united.solids.empty()) solids.push_back(solid);
      if (own.empty()) continue;
      tell_united(solid, own, united);
      any = any || !united.solids.empty();
      cause = united.cause;
      if (!united.solids.empty()) set_.history->Merge(united.history);
      for (const TopoDS_Shape& made : united.solids) {
        solids.push_back(made);
        curves_.add_to(made);
      }
    }
    if (!any) throw ModelError(cause, {});
    set_.solids = std::move(solids);
  }

  void imprint(const FaceNumberPairs& touching) {
    if (touching.empty()) return;
    log_("imprinting faces that touch");
    const auto pairs = faces_of(touching);
    const Imprinted imprinted = imprint_faces(set_.solids, pairs);
    const std::string done = imprinted.joined > 0
                                 ? fmt::format("{} pair(s) were imprinted on each other", imprinted.joined)
                                 : "they are left so, for a general fuse finds nothing there";
    set_.notes.push_back(fmt::format(
        "{} pair(s) of faces touch where they share no edge and no vertex, the first is Face {} and "
        "Face {}; {}",
        touching.size(), touching.front()[0], touching.front()[1], done));
    if (imprinted.doubles > 0)
      set_.notes.push_back(fmt::format(
          "{} piece(s) of faces lay on one another, bound nothing and were taken away", imprinted.doubles));
    set_.solids = imprinted.solids;
    set_.history->Merge(imprinted.history);
    // An edge that took the place of one of another face has no curve on its neighbours there.
    if (imprinted.joined > 0)
      for (const TopoDS_Shape& solid : set_.solids) curves_.add_to(solid);
  }

 private:
  /// What became of the faces of each pair.
  [[nodiscard]] std::vector<std::array<TopoDS_Face, 2>> faces_of(const FaceNumberPairs& numbers) const {
    std::vector<std::array<TopoDS_Face, 2>> pairs;
    for (const auto& [a, b] : numbers)
      for (const TopoDS_Shape& f : images_of(as_read_.of[2](a), set_))
        for (const TopoDS_Shape& g : images_of(as_read_.of[2](b), set_))
          if (!f.IsSame(g)) pairs.push_back({TopoDS::Face(f), TopoDS::Face(g)});
    return pairs;
  }

  /// While the faces' numbers can still be told: before the history has what became of them.
  void tell_united(const TopoDS_Shape& solid, const std::vector<std::array<TopoDS_Face, 2>>& pairs,
                   const United& united) {
    std::string note =
        fmt::format("{} crosses itself: {} pair(s) of its faces cross, the first is {} and {}; ",
                    names_.solid(solid), pairs.size(), names_.numbered("Face", 2, pairs.front()[0]),
                    names_.numbered("Face", 2, pairs.front()[1]));
    note += united.solids.empty()
                ? "it is left so: " + united.cause
                : fmt::format(
                      "they were cut along each other, and {} piece(s) that lay inside, or were turned "
                      "inside out, were taken away",
                      united.dropped);
    if (!united.gone.empty()) note += ", so that nothing is left of " + names_.listed("Face", 2, united.gone);
    if (united.solids.size() > 1) note += fmt::format("; it became {} solids", united.solids.size());
    set_.notes.push_back(note);
  }

  const ShapeMaps& as_read_;
  EntityNames names_;
  MissingCurves& curves_;
  const StageLog& log_;
  SolidSet& set_;
};

}  // namespace

void join_meeting_faces(const ShapeMaps& as_read, const MeetingFaces& meeting, MissingCurves& curves,
                        const StageLog& log, SolidSet& set) {
  Meeting faces(as_read, curves, log, set);
  faces.unite(meeting.crossing);
  faces.imprint(meeting.touching);
}

}  // namespace octet
