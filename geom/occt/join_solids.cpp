// SPDX-License-Identifier: BSD-3-Clause
// Attempts, each with one solid less to join or to keep, until one succeeds.
#include "geom/occt/join_solids.h"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "geom/facet_volumes.h"
#include "geom/occt/closed_forms.h"
#include "geom/occt/embed_faces.h"
#include "geom/occt/heal.h"
#include "geom/occt/measure.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/tessellate.h"
#include "geom/occt/topology.h"

namespace octet {
namespace {

/// Turns solids that fill all space but a hole, where faces know one side only; returns whether there were
/// any.
bool turn_back(const AssembledPart& part, SolidSet& set) {
  bool turned = false;
  const std::vector<double> volume = facet_volumes(part.parts);
  for (int region = 1; region < static_cast<int>(volume.size()); ++region) {
    if (volume[region] >= 0.0) continue;
    for (TopoDS_Shape& solid : set.solids) {
      if (!solid.IsSame(part.numbering.solid(region))) continue;
      solid.Reverse();
      set.notes.push_back(inside_out_note(fmt::format("Solid {}", region)));
      turned = true;
    }
  }
  return turned;
}

bool has_part(const TopoDS_Shape& solid, const TopoDS_Shape& entity) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(solid, entity.ShapeType(), parts);
  return parts.Contains(entity);
}

class Joiner {
 public:
  Joiner(const ShapeMaps& as_read, SolidSet healed, const ReadOptions& options, const StageLog& log)
      : as_read_(as_read), healed_(std::move(healed)), options_(options), log_(log) {}

  JoinedSolids run() {
    const SolidSet as_they_are = healed_;
    const std::vector<ClosedForm> forms = closed_forms_first();
    if (forms.empty()) {
      join();
    } else if (!joins_all()) {
      // Where surfaces touch OCCT may find what they have in common as splines and not on closed forms.
      take_back(forms);
      healed_ = as_they_are;
      apart_.clear();
      lost_.clear();
      fuses_.clear();
      log_("joining the solids with their splines as they are");
      join();
    }
    for (KeptApart& kept : apart_) {
      kept.solid = tag_of(kept.solid);
      kept.other = tag_of(kept.other);
    }
    return {std::move(part_), std::move(apart_), std::move(lost_)};
  }

 private:
  [[nodiscard]] bool fuses() const { return options_.fuse && healed_.solids.size() > 1; }

  [[nodiscard]] std::vector<ClosedForm> closed_forms_first() {
    if (!fuses()) return {};
    log_("looking for planes, cylinders and cones among splines");
    std::vector<ClosedForm> forms = give_closed_forms(healed_.solids);
    if (!forms.empty())
      healed_.notes.push_back(fmt::format(
          "{} face(s) whose splines are planes, cylinders or cones to rounding were put on these before the "
          "solids were fused",
          forms.size()));
    return forms;
  }

  void join() {
    while (!succeeds()) {
    }
  }

  /// Whether all solids were joined, and none was lost.
  bool joins_all() {
    try {
      join();
    } catch (const ModelError&) {
      return false;
    }
    return lost_.empty() &&
           std::all_of(apart_.begin(), apart_.end(), [](const KeptApart& kept) { return kept.late; });
  }

  bool succeeds() {
    try {
      attempt();
      return true;
    } catch (const ModelError& error) {
      if (parts_late()) return false;
      const std::optional<std::size_t> solid = culprit(error);
      if (!solid) throw as_read(error);
      const bool is_apart = std::any_of(apart_.begin(), apart_.end(),
                                        [&](const KeptApart& kept) { return kept.solid == *solid; });
      if (joined_.history->HasModified() && !is_apart) {
        apart_.push_back({*solid, *solid, middle_of(healed_.solids[*solid]), error.what()});
      } else if (healed_.solids.size() > 1) {
        leave_out(*solid, error.what());
      } else {
        throw as_read(error);
      }
      return false;
    }
  }

  /// Keeps apart what was joined late, if anything was: the first to blame where something fails.
  bool parts_late() {
    bool any = false;
    for (KeptApart& kept : apart_) any = std::exchange(kept.late, false) || any;
    return any;
  }

  void attempt() {
    part_ = {};
    joined_ = {healed_.solids, new BRepTools_History(), {}};
    if (fuses()) {
      log_(fmt::format("{} {} solid(s) that may touch", kFusing, healed_.solids.size()));
      fuse_touching(joined_, options_.fuse_tolerance, apart_, fuses_);
    }
    SolidSet all{joined_.solids, new BRepTools_History(), healed_.notes, healed_.caps};
    all.history->Merge(healed_.history);
    all.history->Merge(joined_.history);
    all.notes.insert(all.notes.end(), joined_.notes.begin(), joined_.notes.end());
    embed(all);
    add_entities(all);
    if (turn_back(part_, all)) {
      part_ = {};
      add_entities(all);
    }
    log_("measuring the entities");
    measure_volumes(part_.numbering, part_.parts);
  }

  void embed(SolidSet& all) {
    if (!options_.embed) return;
    if (!options_.fuse || std::any_of(apart_.begin(), apart_.end(), [](const auto& a) { return !a.late; })) {
      all.notes.push_back("no loose faces are embedded: solids that touch are kept apart");
      return;
    }
    log_("embedding loose faces");
    embed_faces(as_read_, all);
  }

  /// Numbers, topology and facets of the solids as they are now.
  void add_entities(const SolidSet& set) {
    part_.parts.notes = set.notes;
    part_.numbering = number_entities(as_read_, set, part_.parts.notes);
    const Numbering& numbering = part_.numbering;
    log_("building the edges' curves");
    for (int tag = 1; tag <= numbering.count(3); ++tag) BRepLib::BuildCurves3d(numbering.solid(tag));
    log_("analysing the topology");
    fill_topology(numbering, part_.parts);
    log_("measuring the edges");
    measure_gaps(numbering, part_.parts);
    log_("triangulating the faces");
    tessellate(numbering, options_.facet_deflection, log_, part_.parts);
  }

  /// The error with the number as read of the entity that it names by its tag; of none, where it is new.
  [[nodiscard]] ModelError as_read(const ModelError& error) const {
    const ModelRef entity = error.entity();
    if (!entity.valid() || entity.dim > 3) return error;
    const auto& became = part_.numbering.became[entity.dim];
    for (std::size_t number = 1; number < became.size(); ++number)
      if (std::find(became[number].begin(), became[number].end(), entity.tag) != became[number].end())
        return {error.what(), {entity.dim, static_cast<std::int32_t>(number)}};
    return {error.what(), {}};
  }

  /// The first solid that holds the entity the error names.
  [[nodiscard]] std::optional<std::size_t> culprit(const ModelError& error) const {
    const ModelRef ref = error.entity();
    if (!ref.valid() || ref.dim > 3 || ref.tag > part_.numbering.count(ref.dim)) return std::nullopt;
    const TopoDS_Shape& entity = part_.numbering.of[ref.dim](ref.tag);
    for (std::size_t i = 0; i < healed_.solids.size(); ++i)
      for (const TopoDS_Shape& image : images_of(healed_.solids[i], joined_))
        if (has_part(image, entity)) return i;
    return std::nullopt;
  }

  void leave_out(std::size_t solid, const std::string& cause) {
    lost_.push_back({healed_.solids[solid], cause});
    healed_.solids.erase(healed_.solids.begin() + static_cast<std::ptrdiff_t>(solid));
    std::erase_if(apart_, [&](const KeptApart& kept) { return kept.solid == solid; });
    for (KeptApart& kept : apart_) {
      if (kept.other == solid) kept.other = kept.solid;
      if (kept.solid > solid) --kept.solid;
      if (kept.other > solid) --kept.other;
    }
  }

  /// The least of the regions that the solid has become: a history that was merged has them in no order.
  [[nodiscard]] std::size_t tag_of(std::size_t solid) const {
    int least = part_.numbering.count(3);
    for (const TopoDS_Shape& image : images_of(healed_.solids[solid], joined_))
      least = std::min(least, part_.numbering.tag(3, image));
    return static_cast<std::size_t>(least);
  }

  const ShapeMaps& as_read_;
  SolidSet healed_;  ///< without those left out
  const ReadOptions& options_;
  const StageLog& log_;
  std::vector<KeptApart> apart_;  ///< indices in healed_
  std::vector<LostSolid> lost_;
  std::vector<DoneFuse> fuses_;  ///< of all attempts
  SolidSet joined_;              ///< of this attempt; its history begins with healed_
  AssembledPart part_;
};

}  // namespace

JoinedSolids join_solids(const ShapeMaps& as_read, SolidSet healed, const ReadOptions& options,
                         const StageLog& log) {
  return Joiner(as_read, std::move(healed), options, log).run();
}

}  // namespace octet
