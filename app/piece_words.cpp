// SPDX-License-Identifier: BSD-3-Clause
// From tags back to the numbers of the file.
#include "app/piece_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

#include "app/words.h"
#include "base/error.h"
#include "io/output_file.h"

namespace octet {
namespace {

/// Tags to numbers as read; each dimension is turned round when it is first asked for.
class NumbersAsRead {
 public:
  explicit NumbersAsRead(const Model& model) : model_(model) {}

  void add(ModelRef entity, std::set<ModelRef>& entities) {
    auto& sources = sources_[static_cast<std::size_t>(entity.dim)];
    if (!sources) sources = octet::sources(model_.provenance(), entity.dim, model_.count(entity.dim));
    for (const int number : (*sources)[static_cast<std::size_t>(entity.tag)])
      entities.insert({entity.dim, number});
  }

 private:
  const Model& model_;
  std::array<std::optional<std::vector<std::vector<int>>>, 4> sources_;
};

bool is_by_number(const SizeAttribute& place) {
  return place.where == SizeAttribute::Where::kNumbers || place.where == SizeAttribute::Where::kAsRead;
}

void add_numbers(const SizeAttribute& place, std::set<ModelRef>& entities) {
  for (int number = place.first; number <= place.last; ++number) entities.insert({place.dim, number});
}

/// The model, or none where the part is no model and numbers tell all that is asked for.
std::optional<Model> model_if_any(const std::filesystem::path& part, const std::vector<SizeAttribute>& places,
                                  const ReadOptions& reading) {
  if (std::all_of(places.begin(), places.end(),
                  [](const SizeAttribute& place) { return place.where == SizeAttribute::Where::kAsRead; }))
    return std::nullopt;
  try {
    return read_part(part, reading);
  } catch (const ModelError&) {
    if (!std::all_of(places.begin(), places.end(), is_by_number)) throw;
    return std::nullopt;
  }
}

std::string piece_text(const PartPiece& piece, const std::vector<ModelRef>& entities) {
  std::vector<int> solids;
  for (const ModelRef entity : entities)
    if (entity.dim == 3) solids.push_back(entity.tag);
  std::string text;
  const auto add = [&](const std::string& words) { text += (text.empty() ? "" : " and ") + words; };
  if (!solids.empty()) add(tag_list("Solid", solids));
  if (!piece.wished.empty()) add(tag_list("Face", piece.wished));
  if (!piece.around.empty()) add(fmt::format("{} face(s) around", piece.around.size()));
  return text.empty() ? "what belongs to no face" : text;
}

}  // namespace

PieceFormat piece_format(const std::filesystem::path& path) {
  const std::string suffix = path.extension().string();
  if (suffix == ".brep" || suffix == ".brp") return PieceFormat::kBrep;
  if (suffix == ".step" || suffix == ".stp") return PieceFormat::kStep;
  throw InputError(fmt::format("\"{}\" must end in .brep or .step", path.string()));
}

std::vector<ModelRef> places_as_read(const std::filesystem::path& part,
                                     const std::vector<SizeAttribute>& places, const ReadOptions& reading) {
  std::set<ModelRef> entities;
  const std::optional<Model> model = model_if_any(part, places, reading);
  if (!model) {
    for (const SizeAttribute& place : places) add_numbers(place, entities);
    return {entities.begin(), entities.end()};
  }
  NumbersAsRead numbers(*model);
  for (const SizeAttribute& place : places) {
    if (place.where == SizeAttribute::Where::kAsRead)
      add_numbers(place, entities);
    else
      for (const ModelRef entity : selected_entities(*model, place)) numbers.add(entity, entities);
  }
  return {entities.begin(), entities.end()};
}

std::vector<ModelRef> faults_as_read(const Model& model, const std::vector<Fault>& faults) {
  std::set<ModelRef> entities;
  NumbersAsRead numbers(model);
  for (const Fault& fault : faults) {
    if (fault.as_read.valid()) entities.insert(fault.as_read);
    const ModelRef entity = fault.entity;
    if (!entity.valid()) continue;
    if (entity.dim < 3)
      numbers.add(entity, entities);
    else if (const auto foot = model.closest(fault.place, std::numeric_limits<double>::infinity()))
      numbers.add(model_face(foot->face), entities);
  }
  return {entities.begin(), entities.end()};
}

std::string write_piece(const std::filesystem::path& part, const PieceWish& wish, const ReadOptions& reading,
                        const std::filesystem::path& output) {
  const PartPiece piece = read_piece(part, wish, reading);
  OutputFile file(output);
  file.write(piece.file);
  file.commit();
  return piece_text(piece, wish.entities);
}

}  // namespace octet
