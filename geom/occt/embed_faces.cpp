// SPDX-License-Identifier: BSD-3-Clause
// One general fuse of the solids and the loose faces.
#include "geom/occt/embed_faces.h"

#include <fmt/format.h>

#include <BOPAlgo_Builder.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>

#include "geom/occt/cause.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

/// Share of a solid's volume that it may be off by once its faces are split.
constexpr double kSameVolume = 1e-6;

/// What the fuse made of each solid.
class Embedding {
 public:
  /// Why it failed, or nothing.
  std::string run(const std::vector<TopoDS_Shape>& solids, const std::vector<TopoDS_Shape>& faces) {
    try {
      builder_.SetNonDestructive(true);
      builder_.SetRunParallel(false);
      for (const auto* shapes : {&solids, &faces})
        for (const TopoDS_Shape& shape : *shapes) builder_.AddArgument(shape);
      builder_.Perform();
    } catch (const Standard_Failure& failure) {
      return cause_of(failure);
    }
    if (builder_.HasErrors()) return "OCCT's general fuse failed";
    for (const TopoDS_Shape& solid : solids) {
      std::vector<TopoDS_Shape>& images = images_.emplace_back();
      for (const TopoDS_Shape& image : builder_.Modified(solid)) images.push_back(image);
      if (images.empty() && !builder_.IsDeleted(solid)) images.push_back(solid);
      const auto same = [](double a, double b) { return std::abs(a - b) <= kSameVolume * std::abs(a); };
      const TopoDS_Compound all = compound_of(images);
      if (same(volume_of(solid), volume_of(all))) continue;
      const double before = refined_volume_of(solid), after = refined_volume_of(all);
      if (!same(before, after))
        return fmt::format("a solid of {:.6g} mm^3 would be one of {:.6g} mm^3", before, after);
    }
    return {};
  }
  [[nodiscard]] const std::vector<std::vector<TopoDS_Shape>>& images() const { return images_; }
  [[nodiscard]] Handle(BRepTools_History) history() { return builder_.History(); }

 private:
  BOPAlgo_Builder builder_;
  std::vector<std::vector<TopoDS_Shape>> images_;
};

}  // namespace

void embed_faces(const ShapeMaps& as_read, SolidSet& set) {
  const LooseFaces loose = loose_faces(as_read, set);
  if (loose.faces.empty()) {
    set.notes.push_back("no loose faces to embed");
    return;
  }
  Embedding embedding;
  if (const std::string cause = embedding.run(set.solids, loose.faces); !cause.empty()) {
    set.notes.push_back(fmt::format("{} loose face(s) could not be embedded: {}", loose.faces.size(), cause));
    return;
  }
  std::size_t parted = 0;
  std::vector<TopoDS_Shape> solids;
  for (const auto& images : embedding.images()) {
    parted += images.size() > 1 ? 1 : 0;
    solids.insert(solids.end(), images.begin(), images.end());
  }
  set.solids = std::move(solids);
  set.history->Merge(embedding.history());
  const std::vector<int> left = loose_faces(as_read, set).numbers;
  const std::size_t count = loose.numbers.size() - left.size();
  const auto first = std::mismatch(left.begin(), left.end(), loose.numbers.begin()).second;
  if (count == 0)
    set.notes.push_back("no loose face lies in a solid: none is embedded");
  else
    set.notes.push_back(
        fmt::format("{} loose face(s) are embedded in solids, the first is Face {}", count, *first));
  if (parted > 0)
    set.notes.push_back(fmt::format("{} solid(s) are parted by faces that reach across them", parted));
}

}  // namespace octet
