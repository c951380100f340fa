// SPDX-License-Identifier: BSD-3-Clause
// The entities that a size attribute names.
#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/sort_unique.h"
#include "geom/closest_word.h"
#include "base/entity_words.h"
#include "geom/entity_foot.h"
#include "geom/size_attributes.h"
#include "geom/text_pattern.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

const std::string& name_of(const Model& model, ModelRef entity) {
  switch (entity.dim) {
    case 0:
      return model.vertex(entity.tag).name;
    case 1:
      return model.edge(entity.tag).name;
    case 2:
      return model.face(entity.tag).name;
    default:
      return model.region(entity.tag).name;
  }
}

ModelRef nearest(const Model& model, int dim, const Vec3& p) {
  ModelRef best{dim, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int tag = 1; tag <= model.count(dim); ++tag) {
    const double d = entity_foot(model, {dim, tag}, p).distance;
    if (d >= least) continue;
    least = d;
    best.tag = tag;
  }
  return best;
}

/// Whether a part or an assembly that holds the region has such a name, or this use of it.
bool holder_matches(const Model& model, int region, const std::string& pattern) {
  const std::vector<PartNode>& tree = model.provenance().tree;
  const auto is_so = [&](const std::string& name) { return !name.empty() && matches_pattern(name, pattern); };
  for (const PartNode& holder : tree) {
    if (!std::binary_search(holder.regions.begin(), holder.regions.end(), region)) continue;
    for (const PartNode* node = &holder;; node = &tree[static_cast<std::size_t>(node->parent)]) {
      if (is_so(node->name) || is_so(node->instance)) return true;
      if (node->parent < 0) break;
    }
  }
  return false;
}

bool matches(const Model& model, const SizeAttribute& attribute, ModelRef entity) {
  switch (attribute.where) {
    case Where::kNumbers:
      return entity.tag >= attribute.first && entity.tag <= attribute.last;
    case Where::kName:
      if (matches_pattern(name_of(model, entity), attribute.pattern) &&
          (attribute.dim >= 0 || !name_of(model, entity).empty()))
        return true;
      return entity.dim == 3 && holder_matches(model, entity.tag, attribute.pattern);
    case Where::kColour: {
      std::string colour = model.face(entity.tag).colour;
      std::transform(colour.begin(), colour.end(), colour.begin(),
                     [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
      return matches_pattern(colour, attribute.pattern);
    }
    default:
      return false;
  }
}

/// Numbers of a dimension: the model's, or those of the file, which a model made without one has as its own.
int last_number(const Model& model, const SizeAttribute& attribute) {
  const std::size_t read = model.provenance().as_read[static_cast<std::size_t>(attribute.dim)].size();
  if (attribute.where == Where::kNumbers || read == 0) return model.count(attribute.dim);
  return static_cast<int>(read) - 1;
}

std::vector<ModelRef> each_once(std::vector<ModelRef> entities) {
  sort_unique(entities);
  return entities;
}

/// What the numbers of the file have become, ascending.
std::vector<ModelRef> became(const Model& model, const SizeAttribute& attribute) {
  const auto& as_read = model.provenance().as_read[static_cast<std::size_t>(attribute.dim)];
  std::vector<ModelRef> found;
  for (int n = attribute.first; n <= std::min(attribute.last, last_number(model, attribute)); ++n) {
    if (as_read.empty())
      found.push_back({attribute.dim, n});
    else
      for (const int tag : as_read[static_cast<std::size_t>(n)].tags) found.push_back({attribute.dim, tag});
  }
  return each_once(std::move(found));
}

/// The same of what the file calls so: several where a part is used several times.
std::vector<ModelRef> became_of_id(const Model& model, const SizeAttribute& attribute) {
  const Provenance& provenance = model.provenance();
  std::vector<ModelRef> found;
  if (provenance.id_mark + std::to_string(attribute.first) != attribute.pattern) return found;
  for (const EntityAsRead& entity : provenance.as_read[static_cast<std::size_t>(attribute.dim)])
    if (entity.id == attribute.first)
      for (const int tag : entity.tags) found.push_back({attribute.dim, tag});
  return each_once(std::move(found));
}

bool is_by_number(Where where) { return where == Where::kNumbers || where == Where::kAsRead; }

/// Whether a place is well formed and, where it is one of entities, there are such.
bool is_place(const Model& model, const std::string& place) {
  try {
    const SizeAttribute wish = parse_size_attribute(place + "=1");
    if (is_shape(wish.where)) return true;
    if (wish.dim < 0) return false;
    if (wish.where == Where::kNumbers) return wish.last <= model.count(wish.dim);
    for (int tag = 1; tag <= model.count(wish.dim); ++tag)
      if (matches(model, wish, {wish.dim, tag})) return true;
  } catch (const InputError&) {
  }
  return false;
}

/// Places that begin with another word, or with a colon behind the word.
void add_places_like(const Model& model, const std::string& place, std::vector<std::string>& places) {
  const std::size_t rest = std::min(place.find_first_of("0123456789:*"), place.size());
  const bool colon = rest < place.size() && place[rest] == '*';
  for (const char* word : {"Vertex", "Edge", "Face", "Region", "box", "ball", "cylinder"}) {
    const std::string like = word + std::string(colon ? ":" : "") + place.substr(rest);
    if (is_place(model, like)) places.push_back(like);
  }
}

/// The same numbers, as those of the file.
std::string file_place(const SizeAttribute& attribute) {
  std::string text = entity_word(attribute.dim);
  text.append("%").append(std::to_string(attribute.first));
  if (attribute.last > attribute.first) text.append("-").append(std::to_string(attribute.last));
  return text;
}

/// How numbers are written, for a place that has some but not so.
std::string forms_of_numbers(const std::string& place) {
  const std::size_t digit = place.find_first_of("0123456789"), comma = place.find(',');
  if (digit == std::string::npos || comma == std::string::npos) return {};
  const bool of_entities = digit > 0 && std::isalpha(static_cast<unsigned char>(place[digit - 1])) != 0;
  return of_entities ? " (a place has one number or a range: Face3, Face3-7)"
                     : " (shapes are box:x,y,z,x,y,z, ball:x,y,z,r and cylinder:x,y,z,x,y,z,r)";
}

/// What may have been meant, for an attribute that names nothing.
std::string meant(const Model& model, const SizeAttribute& attribute) {
  std::vector<std::string> known;
  for (int dim = 0; dim < 4; ++dim)
    for (int tag = 1; (attribute.dim < 0 || dim == attribute.dim) && tag <= model.count(dim); ++tag)
      known.push_back(attribute.where == Where::kColour ? model.face(tag).colour
                                                        : name_of(model, {dim, tag}));
  if (attribute.dim < 0) add_places_like(model, attribute.pattern, known);
  std::string text = "; octet info --entities lists what it has";
  const std::string close = closest_word(attribute.pattern, known);
  if (!close.empty())
    text.append(" (did you mean \"").append(close).append("\"?)");
  else if (attribute.dim < 0)
    text.append(forms_of_numbers(attribute.pattern));
  if (is_by_number(attribute.where)) {
    text.append(" (its numbers end at ").append(std::to_string(last_number(model, attribute)));
    const auto& as_read = model.provenance().as_read[static_cast<std::size_t>(attribute.dim)];
    if (attribute.where == Where::kNumbers && static_cast<std::size_t>(attribute.first) < as_read.size())
      text.append("; ").append(file_place(attribute)).append(" for the number in the file");
    text.append(")");
  }
  return text;
}

}  // namespace

std::vector<ModelRef> selected_entities(const Model& model, const SizeAttribute& attribute) {
  if (is_shape(attribute.where)) return {};
  std::vector<ModelRef> found;
  if (attribute.where == Where::kNearest) {
    const ModelRef entity = nearest(model, attribute.dim, attribute.a);
    if (entity.valid()) found.push_back(entity);
  } else if (attribute.where == Where::kAsRead) {
    found = became(model, attribute);
  } else if (attribute.where == Where::kId) {
    found = became_of_id(model, attribute);
  } else {
    for (int dim = 0; dim < 4; ++dim)
      for (int tag = 1; (attribute.dim < 0 || dim == attribute.dim) && tag <= model.count(dim); ++tag)
        if (matches(model, attribute, {dim, tag})) found.push_back({dim, tag});
  }
  std::string message = "size attribute \"" + attribute.text;
  if (found.empty())
    throw InputError(message.append("\" names nothing of the part").append(meant(model, attribute)));
  if (is_by_number(attribute.where) && attribute.last > last_number(model, attribute))
    throw InputError(message.append("\": the part has numbers up to ")
                         .append(std::to_string(last_number(model, attribute))));
  return found;
}

}  // namespace octet
