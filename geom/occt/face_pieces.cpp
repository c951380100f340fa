// SPDX-License-Identifier: BSD-3-Clause
// The fuse's history, face by face.
#include "geom/occt/face_pieces.h"

#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geom/occt/shape_measures.h"

namespace octet {
namespace {

/// Faces inside of a solid bound nothing.
bool bounds(const TopoDS_Face& face) {
  return face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED;
}

/// Whether the images fill clearly less than the solid did: OCCT's integrals are per cents off on some faces.
bool lacks_volume(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& images) {
  constexpr double kKept = 0.97;
  double kept = 0.0;
  for (const TopoDS_Shape& image : images) kept += std::abs(volume_of(image));
  return kept < kKept * std::abs(volume_of(solid));
}

}  // namespace

std::vector<FacePiece> face_pieces(const TopoDS_Shape& solid, const BRepTools_History& history) {
  std::vector<FacePiece> pieces;
  TopTools_IndexedMapOfShape known;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    if (!bounds(face) || history.IsRemoved(face)) continue;
    TopTools_ListOfShape now = history.Modified(face);
    if (now.IsEmpty()) now.Append(face);
    for (const TopoDS_Shape& piece : now) {
      const auto index = static_cast<std::size_t>(known.Add(piece));
      if (index > pieces.size())
        pieces.push_back({TopoDS::Face(piece), face, false});
      else
        pieces[index - 1].is_several = true;
    }
  }
  return pieces;
}

TopoDS_Face lost_face(const TopoDS_Shape& solid, const std::vector<TopoDS_Shape>& images,
                      const BRepTools_History& history, double width) {
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    if (bounds(face) && history.IsRemoved(face) && width_of(face) > width)
      return lacks_volume(solid, images) ? face : TopoDS_Face();
  }
  return {};
}

TopoDS_Face lost_piece(const std::vector<FacePiece>& pieces, const std::vector<TopoDS_Shape>& images) {
  TopTools_IndexedMapOfShape kept;
  for (const TopoDS_Shape& image : images) TopExp::MapShapes(image, TopAbs_FACE, kept);
  for (const FacePiece& piece : pieces)
    if (!piece.is_several && !kept.Contains(piece.piece)) return piece.piece;
  return {};
}

int count_slivers(const std::vector<FacePiece>& pieces, double width) {
  return static_cast<int>(std::count_if(pieces.begin(), pieces.end(), [&](const FacePiece& piece) {
    return !piece.piece.IsSame(piece.of) && width_of(piece.piece) < width && width_of(piece.of) >= width;
  }));
}

}  // namespace octet
