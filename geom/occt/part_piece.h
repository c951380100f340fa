// SPDX-License-Identifier: BSD-3-Clause
// A piece of a part as a CAD file of its own: to look at what is at fault, or to send it on. No OCCT type
// appears here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/model_ref.h"
#include "geom/occt/read_part.h"

namespace octet {

enum class PieceFormat { kBrep, kStep };

struct PieceWish {
  std::vector<ModelRef> entities;  ///< by dimension and number as read; {3, n}: a solid, whole
  int around = 1;                  ///< how often the faces that touch those that are taken are taken, too
  PieceFormat format = PieceFormat::kBrep;
};

struct PartPiece {
  std::string file;         ///< all bytes of it
  std::vector<int> wished;  ///< numbers as read of the faces that are, or have, what is wished for; ascending
  std::vector<int> around;  ///< of the others, but for those of whole solids; ascending
};

/// The solids wished for, and the faces that are, or have on their boundary, what else is; with the faces
/// around them. As the file has them: nothing is healed, sewn or fused, and each stands where it stands in
/// the part, in millimetre. A STEP file names each face "Face12" by its number as read and has those wished
/// for in red; a BREP file has those first. The same piece is the same bytes. InputError: the file cannot be
/// read, or has no entity of that number. `installed_reader` is not for callers.
[[nodiscard]] PartPiece read_piece(const std::filesystem::path& path, const PieceWish& wish,
                                   const ReadOptions& options = {},
                                   const char* installed_reader = kInstalledReader);

}  // namespace octet
