// SPDX-License-Identifier: BSD-3-Clause
// Fuses of one group of solids with one tolerance after the other.
#pragma once

#include <TopoDS_Shape.hxx>
#include <memory>
#include <vector>

#include "geom/occt/group_fuse.h"

namespace octet {

/// The first fuse, by ascending tolerance, without conflicts, thin pieces, gaps and slivers; where none is,
/// that with the fewest. Circles of contact are left away where the fuse gets worse by them. Of more than two
/// solids whose first fuse has conflicts, those at odds are fused by themselves, two at a time, which costs
/// less than the whole group: where nothing joins the two, nothing is tried on the group. Two that no
/// tolerance joins are fused with one, the other or both as splines (geom/occt/spline_solids), and where that
/// joins them so is the group; so are the solids to blame in a group that no tolerance joins. Of more than
/// eight solids slivers are no reason to try another tolerance, and all pairs that only splines join are told
/// at once.
/// `noise` (mm): a tolerance, too, where it is more than what is tried else, and what is thinner counts as
/// thin.
[[nodiscard]] std::unique_ptr<GroupFuse> best_fuse(const std::vector<TopoDS_Shape>& solids, double noise);

}  // namespace octet
