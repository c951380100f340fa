// SPDX-License-Identifier: BSD-3-Clause
// A model taken apart into what shares nothing.
#pragma once

#include <array>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Regions that hang together by the faces, edges and vertices they share, each such body as a model of its
/// own that tells of its entities by their tags in the whole (ModelParts::whole_tag).
///
/// By the lowest tag of their regions. Bodies may touch, or fill the same place, without sharing anything.
/// Faces that bound nothing (the same region, or none, on both sides) are in no body. Exact geometry is
/// shared with the whole. Cost: that of making the models.
[[nodiscard]] std::vector<Model> take_apart(const Model& model);

}  // namespace octet
