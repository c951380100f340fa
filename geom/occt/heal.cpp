// SPDX-License-Identifier: BSD-3-Clause
// Repairs what is wrong with solids, and says what it changed.
#include "geom/occt/heal.h"

#include <fmt/format.h>

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Shell.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "geom/occt/crossed_sides.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/folds.h"
#include "geom/occt/hairlines.h"
#include "geom/occt/imprint.h"
#include "geom/occt/misplaced_curves.h"
#include "geom/occt/rings.h"
#include "geom/occt/sew.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/short_edges.h"
#include "geom/occt/strips.h"
#include "geom/occt/sub_shapes.h"
#include "geom/occt/touched_edges.h"
#include "geom/occt/unite_crossed.h"
#include "geom/occt/voids.h"

namespace octet {
namespace {

/// Of the diagonal: spikes and slits so narrow are closed whatever is asked. Nothing of the part's volume
/// goes with them, and its mesh would have flat elements all along them.
constexpr double kHairlineShare = 1e-6;
/// What changes more of a solid's volume, all together, is no small feature of it: the solid is one, or a
/// sheet.
constexpr double kMostVolumeShare = 0.05;

double volume_of(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties);
  return properties.Mass();
}

class Healer {
 public:
  Healer(const ShapeMaps& as_read, const HealOptions& options, const StageLog& log, SolidSet& set)
      : as_read_(as_read), options_(options), log_(log), set_(set) {}

  void run(const MeetingFaces& meeting) {
    for (std::size_t i = 0; i < set_.solids.size(); ++i) {
      log_(fmt::format("checking {}", name_of(set_.solids[i])));
      volume_.reset();
      add_curves(set_.solids[i]);
      renew_curves(set_.solids[i]);
      add_pole_edges(set_.solids[i]);
      turn_faces(set_.solids[i]);
      close(set_.solids[i]);
      take_small_features(set_.solids[i]);
      take_folds(set_.solids[i]);
      turn_inside_out(set_.solids[i]);
    }
    join_touching_voids();
    unite(meeting.crossing);
    imprint(meeting.touching);
    if (curves_ > 0)
      set_.notes.push_back(
          fmt::format("{} edge(s) had no curve in space and got that of their face, the first is {}", curves_,
                      first_curve_));
    if (pole_edges_ > 0)
      set_.notes.push_back(fmt::format("{} loop(s) had no edge at a pole and got one, the first is of {}",
                                       pole_edges_, first_pole_edge_));
    if (pcurves_ > 0)
      set_.notes.push_back(fmt::format("{} edge(s) had no curve on a face and got one, the first is {}",
                                       pcurves_, first_pcurve_));
  }

 private:
  [[nodiscard]] std::string numbered(const char* kind, int dim, const TopoDS_Shape& shape) const {
    const int number = number_as_read(dim, shape, as_read_, set_);
    return number > 0 ? fmt::format("{} {}", kind, number) : fmt::format("a new {}", kind);
  }
  [[nodiscard]] std::string name_of(const TopoDS_Shape& solid) const { return numbered("Solid", 3, solid); }

  [[nodiscard]] double smallest_of(const TopoDS_Shape& solid) const {
    return std::max(options_.smallest_feature, kVanishingShare * diagonal_of(box_of(solid)));
  }
  [[nodiscard]] std::string smallest_name() const {
    return options_.smallest_feature > 0.0 ? fmt::format("{:.4g} mm", options_.smallest_feature)
                                           : "rounding leaves";
  }

  [[nodiscard]] std::string listed(const char* kind, int dim, const std::vector<TopoDS_Shape>& shapes) const {
    constexpr std::size_t kMost = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(kMost, shapes.size()); ++i)
      list += (i > 0 ? ", " : "") + numbered(kind, dim, shapes[i]);
    if (shapes.size() > kMost) list += fmt::format(" and {} more", shapes.size() - kMost);
    return list;
  }

  void add_curves(const TopoDS_Shape& solid) {
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
      const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
      for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) continue;
        add_curve(edge);
        add_pcurve(edge, face);
      }
    }
  }

  void add_curve(const TopoDS_Edge& edge) {
    double first = 0.0, last = 0.0;
    if (!BRep_Tool::Curve(edge, first, last).IsNull() || !BRepLib::BuildCurve3d(edge)) return;
    if (curves_++ == 0) first_curve_ = numbered("Edge", 1, edge);
  }

  void add_pcurve(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0, last = 0.0;
    if (!BRep_Tool::CurveOnSurface(edge, face, first, last).IsNull()) return;
    ShapeFix_Edge fix;
    if (!fix.FixAddPCurve(edge, face, false, Precision::Confusion())) return;
    if (pcurves_++ == 0) first_pcurve_ = numbered("Edge", 1, edge) + " on " + numbered("Face", 2, face);
  }

  void renew_curves(const TopoDS_Shape& solid) {
    const CurvesRenewed renewed = renew_misplaced_curves(solid);
    if (!renewed.curves.empty()) {
      const CurveRenewed& first = renewed.curves.front();
      set_.notes.push_back(fmt::format(
          "{} edge(s) of {} lie on their faces, but their curves there were of another place and were made "
          "anew, the first is {} on {} ({:.3g} mm)",
          renewed.curves.size(), name_of(solid), numbered("Edge", 1, first.edge),
          numbered("Face", 2, first.face), first.gap));
    }
    if (!renewed.joined.empty())
      set_.notes.push_back(
          fmt::format("{} face(s) of {} had curves of their edges whole turns apart, which were joined, the "
                      "first is {}",
                      renewed.joined.size(), name_of(solid), numbered("Face", 2, renewed.joined.front())));
  }

  /// Where a loop runs through a pole of its surface without an edge there, its ends are apart in (u,v).
  void add_pole_edges(TopoDS_Shape& solid) {
    const Handle(ShapeBuild_ReShape) changes = new ShapeBuild_ReShape();
    TopTools_MapOfShape seen;
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
      const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
      if (!seen.Add(face) ||
          !ShapeAnalysis_Surface(BRep_Tool::Surface(face)).HasSingularities(Precision::Confusion()))
        continue;
      for (TopExp_Explorer it(face, TopAbs_WIRE); it.More(); it.Next()) {
        ShapeFix_Wire fix(TopoDS::Wire(it.Current()), face, Precision::Confusion());
        const int edges = fix.NbEdges();
        fix.FixReorder();
        if (!fix.FixDegenerated() || fix.NbEdges() == edges) continue;
        changes->Replace(it.Current(), fix.Wire());
        if (pole_edges_++ == 0) first_pole_edge_ = numbered("Face", 2, face);
      }
    }
    const TopoDS_Shape made = changes->Apply(solid);
    if (made.IsSame(solid)) return;
    set_.history->Merge(changes->History());
    replace(solid, made);
  }

  /// A new solid in the place of `solid`, of the same orientation.
  void replace(TopoDS_Shape& solid, const TopoDS_Shape& by) {
    set_.history->AddModified(solid, by);
    solid = by;
  }

  void turn_faces(TopoDS_Shape& solid) {
    const EdgeUses uses = edge_uses(solid);
    const int wrong = uses.first(&Uses::turned);
    if (wrong == 0) return;
    const BRep_Builder builder;
    TopoDS_Solid made;
    builder.MakeSolid(made);
    for (TopoDS_Iterator it(solid); it.More(); it.Next()) {
      if (it.Value().ShapeType() != TopAbs_SHELL) continue;
      ShapeFix_Shell fix;
      fix.FixFaceOrientation(TopoDS::Shell(it.Value()));
      for (TopExp_Explorer shell(fix.Shape(), TopAbs_SHELL); shell.More(); shell.Next())
        builder.Add(made, shell.Current());
    }
    if (edge_uses(made).first(&Uses::turned) != 0) return;
    set_.notes.push_back(
        fmt::format("faces of {} were turned so that they agree along their edges, first at {}",
                    name_of(solid), numbered("Edge", 1, uses.edges(wrong))));
    replace(solid, made);
  }

  void close(TopoDS_Shape& solid) {
    const EdgeUses uses = edge_uses(solid);
    const int wrong = uses.first(&Uses::open);
    if (wrong == 0) return;
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
    const Sewn sewn = sew_faces(faces, options_.sew_tolerance);
    if (sewn.solids.size() != 1 || sewn.free_edges > 0) return;
    set_.notes.push_back(
        fmt::format("{} was open at {} and was closed by sewing its faces with tolerance {:.3g} mm",
                    name_of(solid), numbered("Edge", 1, uses.edges(wrong)), sewn.tolerance));
    set_.history->Merge(sewn.history);
    replace(solid, sewn.solids.front());
  }

  /// Whether the solid, once it has this volume, is what it was before any small feature was taken away.
  [[nodiscard]] bool keeps_volume(const TopoDS_Shape& solid, double after) {
    if (!volume_) volume_ = volume_of(solid);
    return std::abs(after - *volume_) <= kMostVolumeShare * std::abs(*volume_);
  }

  /// Takes the repaired solid where it is as closed as it was and bounds as much, and adds the curves that
  /// its edges then lack. `dim`, `what`: of the entities that are gone, and what became of them.
  void adopt(TopoDS_Shape& solid, const Repair& repair, int dim, const std::string& what) {
    if (repair.entities.empty() || repair.solid.ShapeType() != TopAbs_SOLID) return;
    const bool closed = edge_uses(solid).first(&Uses::open) == 0;
    if (closed && edge_uses(repair.solid).first(&Uses::open) != 0) return;
    const bool edges = dim == 1;
    const double after = volume_of(repair.solid);
    if (closed && !keeps_volume(solid, after)) {
      set_.notes.push_back(fmt::format(
          "{} keeps {} small {}(s), for without them its volume would change from {:.6g} to {:.6g} mm^3: {}",
          name_of(solid), repair.entities.size(), edges ? "edge" : "face", *volume_, after,
          listed(edges ? "Edge" : "Face", dim, repair.entities)));
      return;
    }
    set_.notes.push_back(fmt::format("{} {}(s) of {} {}: {}", repair.entities.size(), edges ? "edge" : "face",
                                     name_of(solid), what,
                                     listed(edges ? "Edge" : "Face", dim, repair.entities)));
    set_.history->Merge(repair.history);
    replace(solid, repair.solid);
    add_curves(solid);
  }

  void take_small_features(TopoDS_Shape& solid) {
    const std::string smallest = smallest_name();
    adopt(solid, shrink_spots(solid, smallest_of(solid)), 2,
          "are no larger than " + smallest + " and became vertices");
    adopt(solid, merge_strips(solid, smallest_of(solid)), 2,
          "are no wider than the tolerance or the gaps of their sides, or than " + smallest +
              ", and became edges");
    adopt(solid, merge_rings(solid, smallest_of(solid)), 2,
          "are rings no wider than " + smallest + " and became edges");
    adopt(solid, drop_short_edges(solid, smallest_of(solid)), 1,
          "are no longer than " + smallest + " and became vertices");
    adopt(solid, split_touched_edges(solid, smallest_of(solid)), 1,
          "are touched by a vertex of their face and were split there");
    const double hairline = std::max(smallest_of(solid), kHairlineShare * diagonal_of(box_of(solid)));
    split_crossed(solid, hairline);
    adopt(solid, close_hairlines(solid, hairline), 1,
          "were sides of spikes or slits no wider than their tolerance, or than " + smallest +
              ", and became one with those beside them");
  }

  /// Where what is between the sides can be closed then.
  void split_crossed(TopoDS_Shape& solid, double hairline) {
    const Repair split = split_crossed_sides(solid);
    if (split.entities.empty()) return;
    const Repair closed = close_hairlines(split.solid, hairline);
    if (closed.entities.empty() || !keeps_volume(solid, volume_of(closed.solid))) return;
    adopt(solid, split, 1,
          "cross a side beside them that they lie on within the tolerance, and were split there");
  }

  void take_folds(TopoDS_Shape& solid) {
    const Repair removed = remove_folds(solid);
    if (edge_uses(removed.solid).first(&Uses::open) != 0) return;
    adopt(solid, removed, 2,
          "lie flat on a face beside them, no farther than their sides lie off their faces, and were taken "
          "away");
  }

  void turn_inside_out(TopoDS_Shape& solid) {
    if (set_.solids.size() < 2 || edge_uses(solid).first(&Uses::open) != 0) return;
    BRepClass3d_SolidClassifier classifier(solid);
    classifier.PerformInfinitePoint(Precision::Confusion());
    if (classifier.State() != TopAbs_IN) return;
    set_.notes.push_back(inside_out_note(name_of(solid)));
    solid.Reverse();
  }

  void join_touching_voids() {
    std::vector<TopoDS_Shape> solids;
    for (const TopoDS_Shape& solid : set_.solids) {
      const VoidsJoined joined = join_voids(solid);
      solids.insert(solids.end(), joined.solids.begin(), joined.solids.end());
      if (!joined.touch) continue;
      std::string note = fmt::format("voids of {} touch its outside, and share edges or vertices with it now",
                                     name_of(solid));
      if (joined.solids.size() > 1)
        note +=
            fmt::format("; nothing else held it together, so that it became {} solids", joined.solids.size());
      set_.notes.push_back(note);
      set_.history->Merge(joined.history);
    }
    set_.solids = std::move(solids);
  }

  /// What became of the faces of each pair.
  [[nodiscard]] std::vector<std::array<TopoDS_Face, 2>> faces_of(const FaceNumberPairs& numbers) const {
    std::vector<std::array<TopoDS_Face, 2>> pairs;
    for (const auto& [a, b] : numbers)
      for (const TopoDS_Shape& f : images_of(as_read_.of[2](a), set_))
        for (const TopoDS_Shape& g : images_of(as_read_.of[2](b), set_))
          if (!f.IsSame(g)) pairs.push_back({TopoDS::Face(f), TopoDS::Face(g)});
    return pairs;
  }

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
        add_curves(made);
      }
    }
    if (!any) throw ModelError(cause, {});
    set_.solids = std::move(solids);
  }

  /// While the faces' numbers can still be told: before the history has what became of them.
  void tell_united(const TopoDS_Shape& solid, const std::vector<std::array<TopoDS_Face, 2>>& pairs,
                   const United& united) {
    std::string note = fmt::format(
        "{} crosses itself: {} pair(s) of its faces cross, the first is {} and {}; ", name_of(solid),
        pairs.size(), numbered("Face", 2, pairs.front()[0]), numbered("Face", 2, pairs.front()[1]));
    note += united.solids.empty()
                ? "it is left so: " + united.cause
                : fmt::format(
                      "they were cut along each other, and {} piece(s) that lay inside, or were turned "
                      "inside out, were taken away",
                      united.dropped);
    if (!united.gone.empty()) note += ", so that nothing is left of " + listed("Face", 2, united.gone);
    if (united.solids.size() > 1) note += fmt::format("; it became {} solids", united.solids.size());
    set_.notes.push_back(note);
  }

  void imprint(const FaceNumberPairs& touching) {
    if (touching.empty()) return;
    log_("imprinting faces that touch");
    const auto pairs = faces_of(touching);
    const Imprinted imprinted = imprint_faces(set_.solids, pairs);
    set_.notes.push_back(fmt::format(
        "{} pair(s) of faces touch without an edge or a vertex that they share, the first is Face {} and "
        "Face {}; {} pair(s) were imprinted on each other",
        touching.size(), touching.front()[0], touching.front()[1], imprinted.joined));
    if (imprinted.doubles > 0)
      set_.notes.push_back(fmt::format(
          "{} piece(s) of faces lay on one another, bound nothing and were taken away", imprinted.doubles));
    set_.solids = imprinted.solids;
    set_.history->Merge(imprinted.history);
    // An edge that took the place of one of another face has no curve on its neighbours there.
    if (imprinted.joined > 0)
      for (const TopoDS_Shape& solid : set_.solids) add_curves(solid);
  }

  const ShapeMaps& as_read_;
  HealOptions options_;
  const StageLog& log_;
  SolidSet& set_;
  std::optional<double> volume_;  ///< of the solid in hand, before anything was taken away
  int curves_ = 0, pcurves_ = 0, pole_edges_ = 0;
  std::string first_curve_, first_pcurve_, first_pole_edge_;
};

}  // namespace

std::string inside_out_note(const std::string& solid) {
  return solid + " was turned inside out (it filled all space but a hole) and was turned back";
}

void heal(const ShapeMaps& as_read, const HealOptions& options, const MeetingFaces& meeting,
          const StageLog& log, SolidSet& set) {
  Healer(as_read, options, log, set).run(meeting);
}

}  // namespace octet
