// SPDX-License-Identifier: BSD-3-Clause
// All sizes of a run together: what the user asks for, and what the part asks for itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/size_field.h"
#include "base/size_sample.h"
#include "geom/model.h"
#include "geom/size_attributes.h"
#include "geom/wall_sizing.h"

namespace octet {

struct SizeMemo;  ///< geom/size_memo.h

/// Edge lengths in model units (millimetre), angles in radians.
struct SizeControl {
  double size = 0.0;  ///< edge length asked for; 0: chosen from the part
  double min_size =
      0.0;  ///< nothing is refined further than this; 0: size / 32, less only where the mesh would have holes
  double max_size = 0.0;           ///< no size is larger than this, wherever it comes from; 0: no such limit
  double curvature_angle = 0.585;  ///< radians of turning per element: eleven on a circle; 0: off
  double curvature_floor = 0.0;    ///< curvature refines no further; 0: size / 11
  bool suit_curvature = false;     ///< the octants' lengths suit the commonest radius, too
  bool suit_own_sizes = false;     ///< they suit what the part asks for itself, where that spares elements
  double wall_elements = 1.0;      ///< n across walls; 0: off
  double gap_elements = 1.0;       ///< n across gaps and to edges that run close by; 0: off
  bool short_edges = true;         ///< edges shorter than the size are one element
  bool small_regions = true;       ///< without a size asked for: see region_scale
  double region_scale = 0.0;       ///< no region is coarser than this times default_region_sizes(); 0: off
  double wall_budget = 250'000.0;  ///< elements that walls and gaps of faces may cost; 0: any number
  double growth = 2.0;             ///< largest ratio of neighbouring sizes, above 1
  std::vector<SizeAttribute> attributes;
  SizeField background;                   ///< wishes over space; only those below the size asked for count
  std::size_t max_elements = 20'000'000;  ///< LimitError when more would be needed
  std::function<bool()> cancelled;        ///< asked often; true ends planning with Cancelled; may be empty
};

/// No mesh has more: numbers of nodes and elements have 4 bytes.
inline constexpr std::size_t kMostElements = std::numeric_limits<std::uint32_t>::max();

/// What else to do about a limit of elements that is too low: nothing where there can be no higher one.
[[nodiscard]] inline const char* or_raise(std::size_t max_elements) {
  return max_elements < kMostElements ? ", or raise --max-elements" : "";
}

/// What one of the user's sizes asks for by itself (geom/wish_cost.h).
struct WishCost {
  std::string wish;       ///< as the user wrote it; empty for none
  double elements = 0.0;  ///< about
  std::string advice;     ///< what stays below the limit, in the user's unit
};

/// What the octree is built from.
struct SizePlan {
  double asked = 0.0;  ///< the size asked for or chosen
  double size = 0.0;   ///< that, or the largest size of a region above it: nothing is coarser
  double octaves =
      0.0;  ///< not above 0: octants are so much shorter than `asked` says, for what the part asks for
  double min_size = 0.0;  ///< no wish is smaller
  std::vector<double>
      wanted;  ///< sizes of attributes, and for the commonest radius: the lattice should suit them
  std::vector<SizeSample> samples;  ///< in a deterministic order
  std::vector<double> region_size;  ///< per region tag, infinite where nothing is asked for
  std::vector<SizeReason> region_why;
  SizeField field;  ///< shapes and background; may be empty
  double growth = 2.0;
  std::size_t max_elements = SizeControl().max_elements;  ///< of the control
  std::function<bool()> cancelled;                        ///< of the control
  WishCost costliest;                                     ///< of the attributes
  ThinnestWall thinnest_wall;
};

/// InputError for a control that makes no sense or an attribute that names nothing; LimitError, at once, for
/// an attribute that asks for far more than max_elements by itself. `memo`, where given:
/// what earlier plans of the same part found of it, and what this one finds.
[[nodiscard]] SizePlan plan_sizes(const Model& model, const SizeControl& control, SizeMemo* memo = nullptr);

/// The plan that the same part gets about where nothing but a size is asked for, and one so many times as
/// large: wishes for walls and features stay, those the larger size leaves room for are missing. For
/// estimates: walls are measured once. Requires scale >= 1.
[[nodiscard]] SizePlan coarsened(SizePlan plan, double scale);

/// The size of the control, or the default for the part and no less than the least; within the largest size.
[[nodiscard]] double global_size(const Model& model, const SizeControl& control);

}  // namespace octet
