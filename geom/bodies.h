// SPDX-License-Identifier: BSD-3-Clause
// A model taken apart into what shares nothing.
#pragma once

#include <array>
#include <vector>

#include "geom/model.h"

namespace octet {

/// Regions that hang together by the faces, edges and vertices they share, as a model of its own.
struct Body {
  Model model;
  std::array<std::vector<int>, 4>
      whole_tag;  ///< by dimension and tag of `model`: tag in the whole, [0] unused
};

/// By the lowest tag of their regions. Bodies may touch, or fill the same place, without sharing anything.
/// Faces that bound nothing (the same region, or none, on both sides) are in no body. Exact geometry is
/// shared with the whole. Cost: that of making the models.
[[nodiscard]] std::vector<Body> take_apart(const Model& model);

}  // namespace octet
