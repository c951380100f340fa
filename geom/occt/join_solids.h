// SPDX-License-Identifier: BSD-3-Clause
// Solids to one model's entities, as many of them and as much joined as can be.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <string_view>
#include <vector>

#include "geom/occt/assemble.h"
#include "geom/occt/fuse.h"
#include "geom/occt/solids.h"

namespace octet {

/// A solid of which no boundary that closes could be made.
struct LostSolid {
  TopoDS_Shape solid;
  std::string cause;
};

struct JoinedSolids {
  AssembledPart part;            ///< numbers, topology, facets and measures
  std::vector<KeptApart> apart;  ///< those joined late, too; indices are tags of regions here
  std::vector<LostSolid> lost;
};

/// How the stages begin in which solids are joined (StageLog).
inline constexpr std::string_view kFusing = "fusing";
inline constexpr std::string_view kFindingCommonFaces = "looking for faces that solids have alike";

/// Fuses the solids (ReadOptions::fuse), and makes their entities. Where that fails for one solid of several,
/// it is first kept apart from those it touches, then left out. ModelError: no solid is left, or the
/// error names none.
[[nodiscard]] JoinedSolids join_solids(const ShapeMaps& as_read, SolidSet healed, const ReadOptions& options,
                                       const StageLog& log);

}  // namespace octet
