// SPDX-License-Identifier: BSD-3-Clause
// A surface without closed form: B-spline, Bezier, extrusion, revolution, offset.
#pragma once

#include <Geom_Surface.hxx>
#include <memory>

#include "geom/occt/patch_tree.h"

namespace octet {

/// `cell` is the (u,v) box of the face. Evaluated on the Geom handle, which OCCT lets threads share
/// (adaptors are not).
[[nodiscard]] std::shared_ptr<const Surface> make_free_form(const Handle(Geom_Surface) & surface,
                                                            const UvCell& cell);

}  // namespace octet
