// SPDX-License-Identifier: BSD-3-Clause
// Groups of entities that the user names, for boundary conditions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geom/model.h"
#include "geom/size_attributes.h"
#include "mesh/model_outline.h"

namespace octet {

/// What --group asks for.
struct GroupWords {
  std::string name, text;  ///< `text`: as the user wrote it
  std::vector<SizeAttribute> places;
};

/// From `PLACE,PLACE,...`, places as of parse_size_attribute() but for shapes: a comma parts two places where
/// a letter, * or ? follows, else it is one of a point's. `unit`: as there. InputError with the reason when
/// the text means nothing.
[[nodiscard]] std::vector<SizeAttribute> parse_places(std::string_view text, double unit = 1.0);

/// From `NAME=PLACES`, as of parse_places(). InputError likewise.
[[nodiscard]] GroupWords parse_group(std::string_view text, double unit = 1.0);

/// The groups, each name once: what is said of it several times is put together. InputError where a place is
/// nowhere in the model, or a group has entities of several dimensions.
[[nodiscard]] std::vector<OutlineGroup> groups_of(const Model& model, const std::vector<GroupWords>& words);

}  // namespace octet
