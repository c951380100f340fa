// SPDX-License-Identifier: BSD-3-Clause
// Each region of a mesh beside the CAD's.
#pragma once

#include <vector>

#include "classify/acceptance.h"
#include "geom/model.h"

namespace octet {

struct RegionMeasure {
  int tag = 0;
  double volume = 0.0, cad_volume = 0.0;  ///< model units, cubed

  /// Of the CAD's volume, signed.
  [[nodiscard]] double relative_error() const { return cad_volume > 0.0 ? volume / cad_volume - 1.0 : 0.0; }
};

/// All regions of the model by tag, those without a tetrahedron too; none where the acceptance has no
/// volumes.
[[nodiscard]] std::vector<RegionMeasure> region_measures(const Acceptance& acceptance, const Model& model);

/// The one whose volume is off by the largest share; nothing of none.
[[nodiscard]] const RegionMeasure* least_alike(const std::vector<RegionMeasure>& regions);

/// A size (mm) that gives the region some twelve edges around where it is round: half of its thickness, twice
/// its volume over its area.
[[nodiscard]] double size_that_rounds(const Model& model, int region);

}  // namespace octet
