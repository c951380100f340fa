// SPDX-License-Identifier: BSD-3-Clause
// General fuse of solids that touch, so that what they share is one entity.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/vec.h"
#include "geom/occt/group_fuse.h"
#include "geom/occt/solids.h"

namespace octet {

/// A solid that others were fused without.
struct KeptApart {
  std::size_t solid = 0;      ///< index in the set before the fuse
  std::size_t other = 0;      ///< the solid it is at odds with; itself: none
  Vec3 place = Vec3::Zero();  ///< where
  std::string cause;          ///< completes "is not joined with what it touches: "
  bool splines_join = false;  ///< the two are joined by themselves, but only as splines
  bool late = false;          ///< it was joined in the end, with what had become of the others
};

/// A group of solids that has been fused, and what came of it.
struct DoneFuse {
  std::vector<TopoDS_Shape> solids;
  bool late;                              ///< the last with what had become of the others
  std::shared_ptr<const GroupFuse> fuse;  ///< none: it could not be fused with them late
};

/// Fuses each group of solids whose boxes meet. What is no thicker than `noise` (mm), or kRoundingShare of
/// the diagonal, lies between solids by mistake. Solids in `apart` stay as they are, with faces, edges and
/// vertices of their own; so do those that are not closed. Where a fuse leaves a solid open, two solids on
/// one side of a face or edges that end nowhere, it is tried again with a tolerance, and then without the
/// solids to blame, which are appended to `apart`; these are then fused with what became of the others, one
/// after the other (geom/occt/late_fuse), a few at most. A group that is among `done` is not fused again;
/// what is fused is added.
void fuse_touching(SolidSet& set, double noise, std::vector<KeptApart>& apart, std::vector<DoneFuse>& done);

}  // namespace octet
