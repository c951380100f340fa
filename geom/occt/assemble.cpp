// SPDX-License-Identifier: BSD-3-Clause
// An OCCT document to all that makes a model.
#include "geom/occt/assemble.h"

#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <utility>

#include "base/entity_words.h"
#include "base/error.h"
#include "geom/occt/common_faces.h"
#include "geom/occt/heal.h"
#include "geom/occt/inner_surfaces.h"
#include "geom/occt/join_solids.h"
#include "geom/occt/marks.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string solid_text(const ModelParts& parts, int number) {
  const std::string& name = parts.provenance.as_read[3][static_cast<std::size_t>(number)].name;
  return name.empty() ? fmt::format("Solid {}", number) : fmt::format("Solid {} \"{}\"", number, name);
}

/// What joins solids that overlap in a thin region, in words; empty where it is none. Of a plate twice the
/// volume over the surface is the thickness, of a wedge half the greatest.
std::string advice_for_overlap(const ModelParts& parts, int region) {
  constexpr double kThin = 1e-4;  // of the region's reach
  constexpr double kReserve = 4.0;
  const ModelRegion& overlap = parts.regions[static_cast<std::size_t>(region)];
  double area = 0.0;
  for (const int face : overlap.faces) area += parts.faces[static_cast<std::size_t>(face)].area;
  const double thickness = 2.0 * overlap.volume / area;
  if (!(thickness < kThin * std::sqrt(area))) return {};
  return fmt::format(", {:.2g} mm thick: --fuse-tolerance {:.2g} takes it away where it is not meant",
                     thickness, kReserve * thickness);
}

/// Pieces that two solids of the file both fill, the largest first.
void note_overlaps(ModelParts& parts) {
  std::vector<Overlap> found = overlaps(parts.provenance, static_cast<int>(parts.regions.size()) - 1);
  const auto volume = [&](const Overlap& o) {
    return parts.regions[static_cast<std::size_t>(o.region)].volume;
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Overlap& a, const Overlap& b) { return volume(a) > volume(b); });
  constexpr std::size_t kTold = 10;
  for (std::size_t i = 0; i < found.size() && i < kTold; ++i) {
    std::string solids;
    for (const int number : found[i].solids)
      solids += (solids.empty() ? "" : " and ") + solid_text(parts, number);
    parts.notes.push_back(fmt::format("{} overlap: what they share is Region {}, {:.6g} mm^3{}", solids,
                                      found[i].region, volume(found[i]),
                                      advice_for_overlap(parts, found[i].region)));
  }
  if (found.size() > kTold)
    parts.notes.push_back(fmt::format("and {} more overlaps of solids", found.size() - kTold));
}

void note_left_out(ModelParts& parts) {
  for (const int dim : {3, 2, 1, 0}) {
    int count = 0;
    const LeftOut* first = nullptr;
    for (const LeftOut& item : parts.provenance.left_out)
      if (item.entity.dim == dim && count++ == 0) first = &item;
    if (count == 0) continue;
    const std::string word = shape_word(dim);
    parts.notes.push_back(fmt::format(
        "{} {} number(s) of the file bound no volume and are left out, the first is {} {}{} at ({:.6g}, "
        "{:.6g}, "
        "{:.6g})",
        count, word, word, first->entity.tag, first->name.empty() ? "" : " \"" + first->name + "\"",
        first->place.x(), first->place.y(), first->place.z()));
  }
}

/// Files may hold triangles in the place of a face's surface.
void refuse_without_surfaces(const ShapeMaps& as_read, const SolidSet& set) {
  for (const TopoDS_Shape& solid : set.solids)
    for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
      if (!BRep_Tool::Surface(TopoDS::Face(it.Current())).IsNull()) continue;
      const int number = as_read.of[2].FindIndex(it.Current());
      throw ModelError(fmt::format("Face {} as read has no surface: files that hold triangles in its place "
                                   "are no CAD files",
                                   number),
                       {});
    }
}

/// Whether no face of a part is in the model. One face alone bounds nothing and was not meant to: it is told
/// among what is left out, and is no fault.
bool is_open_part(const TopoDS_Shape& part, const ShapeMaps& as_read, const Provenance& provenance) {
  const TopTools_IndexedMapOfShape faces = sub_shapes(part, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const auto number = static_cast<std::size_t>(as_read.of[2].FindIndex(faces(i)));
    if (!provenance.as_read[2][number].tags.empty()) return false;
  }
  return faces.Extent() > 1;
}

/// Of shells of which nothing is in the model.
class OpenShells {
 public:
  OpenShells(const ShapeMaps& as_read, const SolidSet& healed, const SewOptions& sewing, ModelParts& parts)
      : as_read_(as_read), healed_(healed), sewing_(sewing), parts_(parts) {}

  /// Parts of the tree.
  void tell_parts(const CadDocument& document) {
    const std::vector<PartNode>& tree = parts_.provenance.tree;
    std::vector<bool> is_leaf(tree.size(), true);
    for (const PartNode& node : tree)
      if (node.parent >= 0) is_leaf[static_cast<std::size_t>(node.parent)] = false;
    for (std::size_t i = 0; i < tree.size(); ++i) {
      if (!is_leaf[i] || !tree[i].solids.empty() || !tree[i].regions.empty()) continue;
      if (!is_open_part(document.tree[i].shape, as_read_, parts_.provenance)) continue;
      const TopoDS_Shape& part = document.tree[i].shape;
      tell(part, sewn(part), tree[i].name.empty() ? "a part without a name" : '"' + tree[i].name + '"');
    }
  }

  /// Shells beside solids, and what sewing left open of a part of which it closed something.
  void tell_shells() {
    for (const TopoDS_Shape& shell : healed_.open)
      if (!is_told(shell) && !is_embedded(shell))
        tell(shell, shell, fmt::format("a shell of {} faces", sub_shapes(shell, TopAbs_FACE).Extent()));
  }

 private:
  /// A part's faces sewn by themselves: where sewing all of them closed nothing, what it made was not kept.
  [[nodiscard]] TopoDS_Shape sewn(const TopoDS_Shape& part) const {
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
    const Sewn result = sew_faces(faces, sewing_);
    return result.shape.IsNull() ? part : result.shape;
  }

  void tell(const TopoDS_Shape& shape, const TopoDS_Shape& sewn, const std::string& name) {
    if (runs_within(shape, healed_.solids)) {
      parts_.notes.push_back(name + " is surfaces inside of solids (as threads are drawn) and is left out");
      return;
    }
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      told_.insert(number_as_read(2, it.Current(), as_read_, healed_));
    Fault fault = opening_of(shape, sewn, as_read_, healed_, sewing_);
    fault.as_read = std::exchange(fault.entity, {});
    fault.cause = name + " is left out: it bounds no volume: " + fault.cause;
    parts_.faults.push_back(fault);
  }

  [[nodiscard]] bool is_told(const TopoDS_Shape& shape) const {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      if (!told_.contains(number_as_read(2, it.Current(), as_read_, healed_))) return false;
    return true;
  }

  [[nodiscard]] bool is_embedded(const TopoDS_Shape& shape) const {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
      if (const int number = number_as_read(2, it.Current(), as_read_, healed_);
          number > 0 && !parts_.provenance.as_read[2][static_cast<std::size_t>(number)].tags.empty())
        return true;
    return false;
  }

  const ShapeMaps& as_read_;
  const SolidSet& healed_;
  const SewOptions& sewing_;
  ModelParts& parts_;
  std::set<int> told_;  ///< faces, by their numbers as read
};

/// What keeps a mesh of the part from being the whole part.
void tell_faults(const JoinedSolids& joined, const ShapeMaps& as_read, const SolidSet& healed,
                 ModelParts& parts) {
  const auto region_text = [&](std::size_t tag) {
    const std::string& name = parts.regions[tag].name;
    return name.empty() ? fmt::format("Region {}", tag) : fmt::format("Region {} \"{}\"", tag, name);
  };
  for (const KeptApart& kept : joined.apart) {
    if (kept.late) {
      parts.notes.push_back(
          fmt::format("{} could not be fused with all others at once ({}), and was fused with "
                      "what had become of those about it",
                      region_text(kept.solid), kept.cause));
      continue;
    }
    Fault fault{model_region(static_cast<int>(kept.solid)), kept.place, "it is not joined with ", ""};
    fault.cause +=
        kept.other == kept.solid ? "what it touches" : region_text(kept.other) + " and what else it touches";
    fault.cause += fmt::format(" ({})", kept.cause);
    fault.advice = "mend the solids where they meet, or accept that none are joined with --no-fuse";
    parts.faults.push_back(fault);
  }
  for (const LostSolid& lost : joined.lost) {
    const int number = number_as_read(3, lost.solid, as_read, healed);
    Fault fault{{}, middle_of(lost.solid), "", "mend it in the CAD system; the others are meshed without it"};
    fault.cause = fmt::format("{} is left out: {}", number > 0 ? solid_text(parts, number) : "a sewn solid",
                              lost.cause);
    if (number > 0) fault.as_read = {3, number};
    parts.faults.push_back(fault);
  }
}

}  // namespace

OcctLock::OcctLock() { occt_mutex().lock(); }
OcctLock::~OcctLock() { occt_mutex().unlock(); }

AssembledPart assemble(const CadDocument& document, const ReadOptions& options, const MeetingFaces& meeting,
                       const StageLog& log) {
  const ShapeMaps as_read(document.shape);
  log("collecting the solids");
  const SewOptions sewing{options.sew_tolerance, options.cap};
  SolidSet healed = collect_solids(document.shape, as_read, sewing);
  refuse_without_surfaces(as_read, healed);
  heal(as_read, {sewing, options.smallest_feature}, meeting, log, healed);
  if (options.fuse && healed.solids.size() > 1) {
    log(std::string(kFindingCommonFaces));
    join_common_faces(healed);
  }
  JoinedSolids joined = join_solids(as_read, healed, options, log);
  ModelParts& parts = joined.part.parts;
  parts.unit = document.unit;
  parts.notes.insert(parts.notes.begin(), document.notes.begin(), document.notes.end());
  parts.accuracy = document.accuracy;
  parts.taken_away = options.smallest_feature;
  parts.apart = !joined.apart.empty() || (!options.fuse && parts.regions.size() > 2);
  mark_entities(document, as_read, joined.part.numbering, parts);
  tell_faults(joined, as_read, healed, parts);
  OpenShells open(as_read, healed, sewing, parts);
  open.tell_parts(document);
  open.tell_shells();
  note_overlaps(parts);
  note_left_out(parts);
  return std::move(joined.part);
}

}  // namespace octet
