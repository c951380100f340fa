// SPDX-License-Identifier: BSD-3-Clause
// Places are those of groups.
#include "app/periodic_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/entity_groups.h"
#include "base/error.h"
#include "base/sort_unique.h"

namespace octet {
namespace {

InputError periodic_refusal(std::string_view text, std::string_view why) {
  return InputError(fmt::format("--periodic \"{}\": {}", text, why));
}

std::vector<int> faces_at(const Model& model, const PeriodicWish& wish,
                          const std::vector<SizeAttribute>& places) {
  std::vector<int> faces;
  try {
    for (const SizeAttribute& place : places)
      for (const ModelRef entity : selected_entities(model, place)) {
        if (entity.dim != 2)
          throw InputError(fmt::format("{} is no face{}", model.describe(entity),
                                       place.dim < 0 ? "; say which, as in Face:" + place.text : ""));
        faces.push_back(entity.tag);
      }
  } catch (const InputError& error) {
    throw periodic_refusal(wish.text, error.what());
  }
  sort_unique(faces);
  return faces;
}

}  // namespace

PeriodicWish parse_periodic(std::string_view text, double unit) {
  PeriodicWish wish;
  wish.text = text;
  constexpr std::string_view kAxes = "xyz";
  if (text.size() == 1 && kAxes.find(text.front()) != std::string_view::npos) {
    wish.axis = static_cast<int>(kAxes.find(text.front()));
    return wish;
  }
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == text.size())
    throw periodic_refusal(text, "faces and their images are written Face1,Face4=Face2,Face5, or x, y or z");
  try {
    wish.faces = parse_places(text.substr(0, equals), unit);
    wish.images = parse_places(text.substr(equals + 1), unit);
  } catch (const InputError& error) {
    throw periodic_refusal(text, error.what());
  }
  return wish;
}

std::vector<PeriodicFaces> periodic_faces(const Model& model, const std::vector<PeriodicWish>& wishes) {
  std::vector<PeriodicFaces> all;
  for (const PeriodicWish& wish : wishes) {
    if (wish.axis >= 0) {
      all.push_back(faces_across(model, wish.axis));
      continue;
    }
    PeriodicFaces faces;
    faces.words = wish.text;
    faces.faces = faces_at(model, wish, wish.faces);
    faces.images = faces_at(model, wish, wish.images);
    all.push_back(std::move(faces));
  }
  return all;
}

}  // namespace octet
