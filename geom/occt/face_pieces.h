// SPDX-License-Identifier: BSD-3-Clause
// What a fuse made of the faces of a solid.
#pragma once

#include <BRepTools_History.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace octet {

struct FacePiece {
  TopoDS_Face piece;
  TopoDS_Face of;           ///< the first face of the solid that the piece is of
  bool is_several = false;  ///< whether it is a piece of more than one face of the solid
};

/// Each piece once, in the order of the solid's faces. Faces inside the solid, and such as were removed, have
/// none.
[[nodiscard]] std::vector<FacePiece> face_pieces(const TopoDS_Shape& solid, const BRepTools_History& history);

/// The first face of the solid, wider than `width`, that went without a piece of it, where what became of the
/// solid (`images`) fills clearly less than the solid did; null: none. A face may also go by rights, into
/// others that lie on it but for the tolerance.
[[nodiscard]] TopoDS_Face lost_face(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& images,
                                    const BRepTools_History& history, double width);

/// The first piece that none of the images has, which are what became of the solid; null: none. A piece of
/// several of its faces lies between these, and may bound nothing.
[[nodiscard]] TopoDS_Face lost_piece(const std::vector<FacePiece>& pieces,
                                     const std::vector<TopoDS_Shape>& images);

/// The number of pieces that are narrower than `width`, of faces that were not. The width of a face is twice
/// its area over its perimeter.
[[nodiscard]] int count_slivers(const std::vector<FacePiece>& pieces, double width);

}  // namespace octet
