// SPDX-License-Identifier: BSD-3-Clause
// Where two sheets of the boundary face each other at less than the size asked for: walls and gaps.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/size_field.h"
#include "base/size_sample.h"
#include "geom/model.h"

namespace octet {

struct WallOptions {
  double size = 0.0;                ///< h: the size asked for, model units
  double min_size = 0.0;            ///< no wish is smaller than this
  double wall_elements = 1.0;       ///< n across the material; 0: off
  double gap_elements = 1.0;        ///< n across the outside, between two sheets; 0: off
  double budget = 0.0;              ///< elements that walls and gaps may cost, about; 0: any number
  std::function<bool()> cancelled;  ///< asked often; true ends the search with Cancelled; may be empty
};

/// Where walls are to have several elements across: the thinnest, and what its sizes were held to.
struct ThinnestWall {
  double wish = kNoSize;  ///< for all elements asked for; infinite for none
  double floor = 0.0;     ///< no wall's size is smaller than this
  Vec3 place = Vec3::Zero();
  int face = 0;
};

struct WallSizes {
  std::vector<SizeSample> samples;
  ThinnestWall thinnest;
};

/// Wishes for thickness / n, through the whole thickness, in a deterministic order.
///
/// The thickness at a point of a face is the distance along its surface's normal to the next sheet that faces
/// it (normals at more than 135 degrees), by the facets. Faces that share an edge are no wall: the thickness
/// of a knife has no lower bound. Within the budget the smallest size is doubled until the wishes fit.
[[nodiscard]] WallSizes wall_sizes_told(const Model& model, const WallOptions& options);
/// Their samples alone.
[[nodiscard]] std::vector<SizeSample> wall_sizes(const Model& model, const WallOptions& options);

/// What was found of one part's walls and gaps last, for a search that asks for the same.
class WallMemo {
 public:
  /// As wall_sizes_told(), which is called where the question is another one than the last. Requires the same
  /// model each time.
  [[nodiscard]] const WallSizes& sizes(const Model& model, const WallOptions& options);

 private:
  std::optional<WallOptions> options_;  ///< of the sizes
  WallSizes sizes_;
};

}  // namespace octet
