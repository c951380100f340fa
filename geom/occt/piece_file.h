// SPDX-License-Identifier: BSD-3-Clause
// Some faces and solids of a shape as a file.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <string_view>

#include "geom/occt/part_piece.h"

namespace octet {

/// As read_piece() says, of a shape as read. InputError: no entity of that number.
[[nodiscard]] PartPiece make_piece(const TopoDS_Shape& shape, const PieceWish& wish);

/// Between processes.
[[nodiscard]] std::string encode_piece(const PartPiece& piece);
[[nodiscard]] PartPiece decode_piece(std::string_view bytes);

}  // namespace octet
