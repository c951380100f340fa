// SPDX-License-Identifier: BSD-3-Clause
// Most of what this tells of comes of a wrong unit or another frame of coordinates.
#include "app/size_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/words.h"
#include "geom/size_attributes.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

/// Of the diagonal: what a point may be off the part's box for a click beside it.
constexpr double kBeside = 0.1;

std::string box_text(const Box3& box) {
  return fmt::format("the part's box, {} to {}", place_text(box.lo), place_text(box.hi));
}

/// The box in 512: what is farther from the part than one of these is long shall not count as near.
std::vector<Box3> cells_of(const Box3& box) {
  constexpr int kEach = 8;
  const Vec3 step = box.size() / kEach;
  std::vector<Box3> cells;
  for (int x = 0; x < kEach; ++x)
    for (int y = 0; y < kEach; ++y)
      for (int z = 0; z < kEach; ++z) {
        const Vec3 lo = box.lo + step.cwiseProduct(Vec3(x, y, z));
        cells.push_back({lo, lo + step});
      }
  return cells;
}

std::string note_of(const Model& model, const SizeAttribute& wish, const std::vector<Box3>& cells) {
  if (wish.where == Where::kNearest) {
    const double off = std::sqrt(model.box().squared_distance(wish.a));
    if (off <= kBeside * model.diagonal()) return {};
    return fmt::format("\"{}\" is {:.4g} mm outside of {}; {} is nearest", wish.text, off,
                       box_text(model.box()), model.describe(selected_entities(model, wish).front()));
  }
  if (!is_shape(wish.where)) return {};
  if (std::any_of(cells.begin(), cells.end(), [&](const Box3& cell) { return shape_meets(wish, cell); }))
    return {};
  return fmt::format("\"{}\" has no effect: it lies outside of {}", wish.text, box_text(model.box()));
}

}  // namespace

std::vector<std::string> size_notes(const Model& model, const MeshOptions& options) {
  std::vector<std::string> notes;
  const std::vector<Box3> cells = cells_of(model.box());
  if (options.size > model.diagonal())
    notes.push_back(
        fmt::format("the size, {:.6g} mm, is longer than the part's diagonal, {:.6g} mm: is the "
                    "unit right?",
                    options.size, model.diagonal()));
  for (const SizeAttribute& wish : options.attributes)
    if (std::string note = note_of(model, wish, cells); !note.empty()) notes.push_back(std::move(note));
  const auto says_nothing = [&](const Box3& cell) { return !(options.background(cell) < kNoSize); };
  if (options.background && std::all_of(cells.begin(), cells.end(), says_nothing))
    notes.push_back(
        fmt::format("the sizes over space have no effect: all lie outside of {}", box_text(model.box())));
  return notes;
}

std::optional<Fault> warning_of(const ThinnestWall& wall, const SizeControl& control) {
  constexpr double kAsGood = 0.9;
  const double n = control.wall_elements;
  if (!(n > 1.0) || control.min_size > 0.0 || wall.wish >= kAsGood * wall.floor) return {};
  const std::string why =
      control.wall_budget > 0.0
          ? fmt::format("walls of a mesh without a size may cost about {:.2g} elements", control.wall_budget)
          : "sizes go down to a 32nd of the one asked for";
  return Fault{wall.face > 0 ? model_face(wall.face) : ModelRef{}, wall.place,
               fmt::format("elements across walls: {:.3g} asked for, about {:.2g} given where they are "
                           "thinnest: {}",
                           n, n * wall.wish / wall.floor, why),
               control.wall_budget > 0.0 ? "give --size" : "set --min-size, or ask for a smaller size"};
}

void add_size_notes(const Model& model, const MeshOptions& options, Observer& observer, MeshReport& report) {
  for (std::string& note : size_notes(model, options)) {
    observer.note(note);
    report.notes.push_back(std::move(note));
  }
}

}  // namespace octet
