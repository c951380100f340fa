// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself asks for elements smaller than the size asked for.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/size_sample.h"
#include "geom/model.h"

namespace octet {

struct SizingOptions {
  double size = 0.0;                ///< h: the size asked for, model units
  double min_size = 0.0;            ///< no wish is smaller than this
  double curvature_angle = 0.785;   ///< radians of turning per element on edges and faces; 0: off
  double curvature_floor = 0.0;     ///< no wish for curvature's sake is smaller than this
  double edge_share = 1.0;          ///< size <= edge_share * length of a real edge with two distinct ends
                                    ///< that is no shorter than 1/32 of `min_size`; 0: off
  double edge_gap_elements = 1.0;   ///< across to the nearest edge that neither shares a vertex nor comes
                                    ///< nearer than 1/32 of `min_size`; 0: off
  std::function<bool()> cancelled;  ///< asked often; true ends with Cancelled; may be empty
};

/// Samples on edges and faces where the wished size is below `options.size`, in a deterministic order.
/// Samples are dense enough that every octant of the wished size that meets the entity holds one, or a
/// neighbour does.
[[nodiscard]] std::vector<SizeSample> feature_sizes(const Model& model, const SizingOptions& options);

/// What was found of one part's edges and faces, for a search that asks again: nearest edges of the last size
/// asked for, and of facets all that does not depend on the question.
class FeatureMemo {
 public:
  FeatureMemo();
  ~FeatureMemo();
  FeatureMemo(const FeatureMemo&) = delete;
  FeatureMemo& operator=(const FeatureMemo&) = delete;
  /// As feature_sizes(). Requires the same model each time.
  [[nodiscard]] std::vector<SizeSample> sizes(const Model& model, const SizingOptions& options);

 private:
  struct Edges;
  struct Faces;
  std::unique_ptr<Edges> edges_;
  std::unique_ptr<Faces> faces_;
};

/// A sensible size when none is given: from the diagonal, the volume and the surface (documented in the
/// source).
[[nodiscard]] double default_size(const Model& model);
/// Per region tag, a twelfth of its diagonal: thin regions are left to the sizes of walls.
[[nodiscard]] std::vector<double> default_region_sizes(const Model& model);

}  // namespace octet
