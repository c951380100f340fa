// SPDX-License-Identifier: BSD-3-Clause
// A surface without closed form: B-spline, Bezier, extrusion, revolution, offset.
#pragma once

#include <memory>

#include "geom/occt/surface_jets.h"

namespace octet {

/// `cell` is the (u,v) box of the face.
[[nodiscard]] std::shared_ptr<const Surface> make_free_form(SurfaceJets jets, const UvCell& cell);

}  // namespace octet
