// SPDX-License-Identifier: BSD-3-Clause
// Wishes first, then what is left: as few numbers as possible change.
#include "geom/occt/numbering.h"

#include <fmt/format.h>

#include <TopTools_ListOfShape.hxx>
#include <algorithm>

#include "base/entity_words.h"
#include "base/sort_unique.h"
#include "geom/occt/gathered.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Indices in the final map, by number as read ([0] unused), and the other way round.
struct Trace {
  std::vector<std::vector<int>> images, sources;
};

/// Edges and vertices that lie within a solid and on no face are not among them.
ShapeMaps maps_of(const std::vector<TopoDS_Shape>& solids) {
  ShapeMaps maps(compound_of(solids));
  for (int dim = 0; dim < 2; ++dim) {
    maps.of[dim].Clear();
    for (int f = 1; f <= maps.of[2].Extent(); ++f)
      TopExp::MapShapes(maps.of[2](f), kShapeTypes[dim], maps.of[dim]);
  }
  return maps;
}

Trace trace(const TopTools_IndexedMapOfShape& as_read, const TopTools_IndexedMapOfShape& final,
            const SolidSet& set) {
  Trace result;
  result.images.resize(static_cast<std::size_t>(as_read.Extent()) + 1);
  result.sources.resize(static_cast<std::size_t>(final.Extent()) + 1);
  for (int number = 1; number <= as_read.Extent(); ++number) {
    auto& images = result.images[static_cast<std::size_t>(number)];
    for (const TopoDS_Shape& image : images_of(as_read(number), set))
      if (const int index = final.FindIndex(image); index > 0) images.push_back(index);
    sort_unique(images);
    for (const int index : images) result.sources[static_cast<std::size_t>(index)].push_back(number);
  }
  return result;
}

/// The tag of each index of the final map.
std::vector<int> tags_of(const Trace& trace) {
  const auto count = static_cast<int>(trace.sources.size()) - 1;
  std::vector<int> tag(trace.sources.size(), 0);
  std::vector<bool> taken(trace.sources.size(), false);
  std::vector<bool> served(trace.images.size(), false);
  const auto give = [&](int index, int number) {
    served[static_cast<std::size_t>(number)] = true;
    if (number > count) return;
    tag[static_cast<std::size_t>(index)] = number;
    taken[static_cast<std::size_t>(number)] = true;
  };
  std::vector<bool> kept(trace.sources.size(), false);
  for (const bool alone : {true, false})
    for (std::size_t number = 1; number < trace.images.size(); ++number)
      for (const int index : trace.images[number]) {
        const auto i = static_cast<std::size_t>(index);
        if (served[number] || kept[i] || (alone && trace.sources[i].size() > 1)) continue;
        kept[i] = true;
        give(index, static_cast<int>(number));
      }
  // Pieces and new entities first, then those whose number is beyond the count.
  int next = 1;
  for (const bool displaced : {false, true})
    for (int index = 1; index <= count; ++index) {
      const auto i = static_cast<std::size_t>(index);
      if (tag[i] != 0 || kept[i] != displaced) continue;
      while (taken[static_cast<std::size_t>(next)]) ++next;
      tag[i] = next;
      taken[static_cast<std::size_t>(next)] = true;
    }
  return tag;
}

/// A face embedded in a solid has no side there, and none of its edges as seen through it: it gets one.
TopoDS_Shape with_a_side(const TopoDS_Shape& entity) {
  const TopAbs_Orientation way = entity.Orientation();
  const bool has_none = way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL;
  return entity.ShapeType() == TopAbs_FACE && has_none ? entity.Oriented(TopAbs_FORWARD) : entity;
}

void number_dimension(int dim, const ShapeMaps& as_read, const ShapeMaps& final, const SolidSet& set,
                      Numbering& numbering) {
  const Trace traced = trace(as_read.of[dim], final.of[dim], set);
  const std::vector<int> tag = tags_of(traced);
  std::vector<int> index(tag.size(), 0);
  for (std::size_t i = 1; i < tag.size(); ++i) index[static_cast<std::size_t>(tag[i])] = static_cast<int>(i);
  for (std::size_t t = 1; t < index.size(); ++t) numbering.of[dim].Add(with_a_side(final.of[dim](index[t])));
  numbering.became[dim].resize(traced.images.size());
  for (std::size_t number = 1; number < traced.images.size(); ++number) {
    auto& tags = numbering.became[dim][number];
    for (const int i : traced.images[number]) tags.push_back(tag[static_cast<std::size_t>(i)]);
    std::sort(tags.begin(), tags.end());
  }
}

void note_changes(int dim, const Numbering& numbering, std::vector<std::string>& notes) {
  int changed = 0, first = 0;
  for (std::size_t number = 1; number < numbering.became[dim].size(); ++number) {
    const auto& tags = numbering.became[dim][number];
    if (tags.empty() || std::binary_search(tags.begin(), tags.end(), static_cast<int>(number))) continue;
    if (changed++ == 0) first = static_cast<int>(number);
  }
  if (changed > 0)
    notes.push_back(fmt::format("{} {} number(s) differ from the file's: {}{} as read is {}{}", changed,
                                shape_word(dim), shape_word(dim), first, shape_word(dim),
                                numbering.became[dim][static_cast<std::size_t>(first)].front()));
}

}  // namespace

Numbering number_entities(const ShapeMaps& as_read, const SolidSet& set, std::vector<std::string>& notes) {
  const ShapeMaps final = maps_of(set.solids);
  Numbering numbering;
  for (int dim = 0; dim < 4; ++dim) {
    number_dimension(dim, as_read, final, set, numbering);
    note_changes(dim, numbering, notes);
  }
  for (const TopoDS_Shape& cap : set.caps) {
    std::vector<int>& tags = numbering.caps.emplace_back();
    for (const TopoDS_Shape& image : images_of(cap, set))
      if (const int tag = numbering.tag(2, image); tag > 0) tags.push_back(tag);
  }
  return numbering;
}

}  // namespace octet
