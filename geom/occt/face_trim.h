// SPDX-License-Identifier: BSD-3-Clause
// The loops of a B-rep face.
#pragma once

#include <TopoDS_Face.hxx>
#include <memory>

#include "geom/surface.h"

namespace octet {

/// The loops of a face, in the (u,v) of `surface`, which make_surface() made for it.
[[nodiscard]] std::shared_ptr<const Trim> make_trim(const TopoDS_Face& face, const Surface& surface);

}  // namespace octet
