// SPDX-License-Identifier: BSD-3-Clause
// Repairs what is wrong with solids, and says what it changed.
#include "geom/occt/heal.h"

#include <fmt/format.h>

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <ShapeFix_Shell.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/occt/crossed_sides.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/entity_names.h"
#include "geom/occt/face_volumes.h"
#include "geom/occt/flat_shells.h"
#include "geom/occt/folds.h"
#include "geom/occt/hairlines.h"
#include "geom/occt/missing_poles.h"
#include "geom/occt/rings.h"
#include "geom/occt/sew.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/shell_solids.h"
#include "geom/occt/short_edges.h"
#include "geom/occt/sphere_sides.h"
#include "geom/occt/stray_edges.h"
#include "geom/occt/strips.h"
#include "geom/occt/touched_edges.h"
#include "geom/occt/voids.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

/// What changes more of a solid's volume, all together, is no small feature of it: the solid is one, or a
/// sheet.
constexpr double kMostVolumeShare = 0.05;
/// And less than this of the cube of its diagonal is not as much of any solid that can be meshed.
constexpr double kSurelyLittle = 1e-9;

/// A solid before anything was taken away from it.
struct Original {
  explicit Original(const TopoDS_Shape& as_is) : Original(as_is, vertex_box_of(as_is)) {}
  Original(const TopoDS_Shape& as_is, const Bnd_Box& box)
      : solid(as_is),
        volumes(box.IsVoid() ? gp_Pnt() : gp_Pnt(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()))),
        surely_little(kSurelyLittle * std::pow(diagonal_of(box), 3.0)) {}

  TopoDS_Shape solid;
  FaceVolumes volumes;
  double surely_little;  ///< a change of volume that is little whatever the volume is
};

class Healer {
 public:
  Healer(const ShapeMaps& as_read, const HealOptions& options, const StageLog& log, SolidSet& set)
      : as_read_(as_read),
        options_(options),
        log_(log),
        set_(set),
        names_(as_read, set),
        curves_(names_, set) {}

  void run(const MeetingFaces& meeting) {
    for (const TopoDS_Shape& solid : set_.solids) {
      log_(fmt::format("looking for curves of {}", names_.solid(solid)));
      curves_.add_to(solid);
      curves_.renew(solid);
      curves_.fit(solid);
    }
    redraw_strays();
    for (std::size_t i = 0; i < set_.solids.size(); ++i) {
      log_(fmt::format("checking {}", names_.solid(set_.solids[i])));
      original_.reset();
      curves_.add_pole_edges(set_.solids[i]);
      turn_faces(set_.solids[i]);
      restore_poles(set_.solids[i]);
      choose_sides(set_.solids[i]);
      close(set_.solids[i]);
      take_small_features(set_.solids[i]);
      take_folds(set_.solids[i]);
      turn_voids(set_.solids[i]);
      turn_inside_out(set_.solids[i]);
    }
    join_touching_voids();
    join_meeting_faces(as_read_, meeting, curves_, log_, set_);
    curves_.tell();
  }

 private:
  [[nodiscard]] std::string smallest_name() const {
    return options_.smallest_feature > 0.0 ? fmt::format("{:.4g} mm", options_.smallest_feature)
                                           : "rounding leaves";
  }

  /// A new solid in the place of `solid`, of the same orientation.
  void replace(TopoDS_Shape& solid, const TopoDS_Shape& by) {
    const Handle(BRepTools_History) step = new BRepTools_History;
    step->AddModified(solid, by);
    set_.history->Merge(step);  // goes on from what the solid was before
    solid = by;
  }

  void redraw_strays() {
    const std::vector<EdgeRedrawn> redrawn = redraw_stray_edges(set_.solids);
    if (redrawn.empty()) return;
    std::vector<TopoDS_Shape> edges;
    double farthest = 0.0;
    for (const auto& [edge, gap] : redrawn) {
      edges.push_back(edge);
      farthest = std::max(farthest, gap);
    }
    set_.notes.push_back(fmt::format(
        "{} edge(s) ran up to {:.3g} mm beside their faces, and were drawn anew where these meet: {}",
        redrawn.size(), farthest, names_.listed("Edge", 1, edges)));
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
                    names_.solid(solid), names_.numbered("Edge", 1, uses.edges(wrong))));
    replace(solid, made);
  }

  void restore_poles(TopoDS_Shape& solid) {
    const Repair restored = add_missing_poles(solid);
    if (restored.entities.empty()) return;
    set_.notes.push_back(fmt::format(
        "{} face(s) of revolution of {} lacked the pole on their axis, and got it: {}",
        restored.entities.size(), names_.solid(solid), names_.listed("Face", 2, restored.entities)));
    set_.history->Merge(restored.history);
    replace(solid, restored.solid);
  }

  void choose_sides(TopoDS_Shape& solid) {
    const Repair chosen = choose_sphere_sides(solid);
    if (chosen.entities.empty()) return;
    set_.notes.push_back(fmt::format(
        "{} face(s) of {} lay on another of the same sphere, the rest of which is within their loop "
        "as well, and got that: {}",
        chosen.entities.size(), names_.solid(solid), names_.listed("Face", 2, chosen.entities)));
    set_.history->Merge(chosen.history);
    replace(solid, chosen.solid);
  }

  void close(TopoDS_Shape& solid) {
    const EdgeUses uses = edge_uses(solid);
    const int wrong = uses.first(&Uses::open);
    if (wrong == 0) return;
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
    const Sewn sewn = sew_faces(faces, options_.sewing);
    if (sewn.solids.size() != 1 || sewn.free_edges > 0) return;
    set_.notes.push_back(
        fmt::format("{} was open at {} and was closed by sewing its faces with tolerance {:.3g} mm",
                    names_.solid(solid), names_.numbered("Edge", 1, uses.edges(wrong)), sewn.tolerance));
    set_.history->Merge(sewn.history);
    add_caps(sewn.caps, as_read_, set_);
    replace(solid, sewn.solids.front());
  }

  /// Whether the solid, repaired, bounds what it did before any small feature was taken away.
  [[nodiscard]] bool keeps_volume(const TopoDS_Shape& solid, const TopoDS_Shape& repaired) {
    if (!original_) original_.emplace(solid);
    const double change = std::abs(original_->volumes.change(original_->solid, repaired));
    return change <= original_->surely_little ||
           change <= kMostVolumeShare * std::abs(original_->volumes.of(original_->solid));
  }

  /// Takes the repaired solid where it is as closed as it was and bounds as much, and adds the curves that
  /// its edges then lack. `dim`, `what`: of the entities that are gone, and what became of them.
  void adopt(TopoDS_Shape& solid, const Repair& repair, int dim, const std::string& what) {
    if (repair.entities.empty() || repair.solid.ShapeType() != TopAbs_SOLID) return;
    const bool closed = edge_uses(solid).first(&Uses::open) == 0;
    if (closed && edge_uses(repair.solid).first(&Uses::open) != 0) return;
    const bool edges = dim == 1;
    if (closed && !keeps_volume(solid, repair.solid)) {
      set_.notes.push_back(fmt::format(
          "{} keeps {} small {}(s), for without them its volume would change from {:.6g} to {:.6g} mm^3: {}",
          names_.solid(solid), repair.entities.size(), edges ? "edge" : "face",
          original_->volumes.of(original_->solid), original_->volumes.of(repair.solid),
          names_.listed(edges ? "Edge" : "Face", dim, repair.entities)));
      return;
    }
    set_.notes.push_back(fmt::format("{} {}(s) of {} {}: {}", repair.entities.size(), edges ? "edge" : "face",
                                     names_.solid(solid), what,
                                     names_.listed(edges ? "Edge" : "Face", dim, repair.entities)));
    set_.history->Merge(repair.history);
    replace(solid, repair.solid);
    curves_.add_to(solid);
  }

  void take_small_features(TopoDS_Shape& solid) {
    // OCCT's box of a surface of revolution takes thousands of points: it is asked anew only where something
    // went, which may have shot far out of the part.
    TopoDS_Shape boxed = solid;
    double diagonal = diagonal_of(box_of(solid));
    const auto current_diagonal = [&] {
      if (!solid.IsSame(boxed)) diagonal = diagonal_of(box_of(solid));
      boxed = solid;
      return diagonal;
    };
    const auto smallest = [&] {
      return std::max(options_.smallest_feature, kRoundingShare * current_diagonal());
    };
    const std::string name = smallest_name();
    adopt(
        solid, drop_flat_shells(solid, smallest()), 2,
        "are shells no thicker than the tolerance of their edges, or than " + name + ", and were taken away");
    adopt(solid, shrink_spots(solid, smallest()), 2, "are no larger than " + name + " and became vertices");
    adopt(
        solid, merge_strips(solid, smallest()), 2,
        "are no wider than the tolerance or the gaps of their sides, or than " + name + ", and became edges");
    adopt(solid, merge_rings(solid, smallest()), 2, "are rings no wider than " + name + " and became edges");
    adopt(solid, drop_short_edges(solid, smallest()), 1,
          "are no longer than " + name + " and became vertices");
    adopt(solid, split_touched_edges(solid, smallest()), 1,
          "are touched by a vertex of their face and were split there");
    split_crossed(solid, smallest());
    adopt(solid, close_hairlines(solid, smallest()), 1,
          "were sides of spikes or slits no wider than their tolerance, or than " + name +
              ", and became one with those beside them");
  }

  /// Where what is between the sides can be closed then.
  void split_crossed(TopoDS_Shape& solid, double smallest) {
    const Repair split = split_crossed_sides(solid);
    if (split.entities.empty()) return;
    const Repair closed = close_hairlines(split.solid, smallest);
    if (closed.entities.empty() || !keeps_volume(solid, closed.solid)) return;
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

  void turn_voids(TopoDS_Shape& solid) {
    const TurnedShells shells = turn_nested_shells(solid);
    if (shells.turned == 0) return;
    set_.notes.push_back(
        fmt::format("{} shell(s) of {} within another shell were turned as that one is, and "
                    "bound both sides of what is between; they were turned: a shell within "
                    "another is a void, one within a void is solid",
                    shells.turned, names_.solid(solid)));
    replace(solid, shells.solid);
  }

  void turn_inside_out(TopoDS_Shape& solid) {
    if (set_.solids.size() < 2 || edge_uses(solid).first(&Uses::open) != 0) return;
    BRepClass3d_SolidClassifier classifier(solid);
    classifier.PerformInfinitePoint(Precision::Confusion());
    if (classifier.State() != TopAbs_IN) return;
    set_.notes.push_back(inside_out_note(names_.solid(solid)));
    // Its shells: a general fuse takes no notice of a solid's own orientation.
    const BRep_Builder builder;
    TopoDS_Solid made;
    builder.MakeSolid(made);
    for (TopoDS_Iterator it(solid); it.More(); it.Next()) builder.Add(made, it.Value().Reversed());
    replace(solid, made);
  }

  void join_touching_voids() {
    std::vector<TopoDS_Shape> solids;
    for (const TopoDS_Shape& solid : set_.solids) {
      const VoidsJoined joined = join_voids(solid);
      solids.insert(solids.end(), joined.solids.begin(), joined.solids.end());
      if (!joined.touch) continue;
      std::string note = fmt::format("voids of {} touch its outside, and share edges or vertices with it now",
                                     names_.solid(solid));
      if (joined.solids.size() > 1)
        note +=
            fmt::format("; nothing else held it together, so that it became {} solids", joined.solids.size());
      set_.notes.push_back(note);
      set_.history->Merge(joined.history);
    }
    set_.solids = std::move(solids);
  }

  const ShapeMaps& as_read_;
  HealOptions options_;
  const StageLog& log_;
  SolidSet& set_;
  EntityNames names_;
  MissingCurves curves_;
  std::optional<Original> original_;  ///< of the solid in hand
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
