// SPDX-License-Identifier: BSD-3-Clause
// How far edges run from each other.
#pragma once

#include <TopoDS_Edge.hxx>

namespace octet {

/// How far points of the one are from the other at most, by samples; no more is looked for once it is beyond
/// `enough`. Infinite where OCCT cannot tell.
[[nodiscard]] double edge_distance(const TopoDS_Edge& one, const TopoDS_Edge& other, double enough);

}  // namespace octet
