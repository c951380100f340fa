// SPDX-License-Identifier: BSD-3-Clause
// Layers of elements on faces, from the user's words to the mesh.
#pragma once

#include <string_view>

#include "app/mesh_part.h"

namespace octet {

/// From `PLACES=HEIGHT,COUNT` or `PLACES=HEIGHT,COUNT,GROWTH`: faces, places as of parse_places(); the height
/// of the first layer, how many, and how much each is higher than the one before (1.2). `unit`: as there.
/// InputError with the reason when the text means nothing.
[[nodiscard]] LayerRequest parse_layers(std::string_view text, double unit = 1.0);

/// What is asked for, face by face: the last word counts. InputError where a place is nowhere in the model,
/// is no face's or one between two regions, and where not all have as many layers.
[[nodiscard]] std::vector<LayerWish> layer_wishes(const Model& model,
                                                  const std::vector<LayerRequest>& requests);

/// Puts layers into a mesh (finalize/layers.h), judges it again, and tells in the report what came of them. A
/// mesh with faults is left as it is, which a note tells. LimitError where there would be more than
/// `max_elements`.
void grow_layers(MeshResult& result, const Model& model, const std::vector<LayerWish>& wishes,
                 std::size_t max_elements, const std::function<bool()>& cancelled, Observer& observer);

}  // namespace octet
