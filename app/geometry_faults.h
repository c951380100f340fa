// SPDX-License-Identifier: BSD-3-Clause
// What the part's own faults do to a mesh, in words.
#pragma once

#include <string>

#include "base/fault.h"
#include "geom/face_crossings.h"
#include "geom/face_touches.h"
#include "geom/model.h"
#include "geom/wide_gaps.h"

namespace octet {

/// Where features were taken away it is they who leave such gaps: no mending helps.
[[nodiscard]] Fault warning_of(const WideGap& gap, const Model& part);
[[nodiscard]] Fault warning_of(const FaceCrossing& crossing, const Model& part);
/// Why a part with such a crossing is not meshed.
[[nodiscard]] std::string refusal_of(const FaceCrossing& crossing, const Model& part);
/// Depth of the deepest crossing (mm) that a fault of the mesh may come of: of the faces that it is on, or of
/// any where it is on none of the part's entities. 0: of none.
[[nodiscard]] double deepest_crossing_at(const Fault& fault, const Model& part);
inline constexpr const char* kMendCrossings = "mend the part where its faces cross";
[[nodiscard]] Fault fault_of(const FaceTouch& touch, const Model& part);
/// Of a part that is far thinner than the size all over; `place`: about its middle.
[[nodiscard]] Fault fault_of_coarseness(double size, const Vec3& place);

}  // namespace octet
