// SPDX-License-Identifier: BSD-3-Clause
// What of a solid's faces is lost in a fuse, or cut to slivers.
#include "geom/occt/face_pieces.h"

#include <gtest/gtest.h>

#include <BOPAlgo_Builder.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools_History.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

namespace octet::test {
namespace {

/// A box of side 1 and what became of it when a plate `width` away from its side was fused with it.
struct Fused {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape();
  BOPAlgo_Builder fuse;
  std::vector<TopoDS_Shape> images;

  explicit Fused(double width) {
    fuse.AddArgument(box);
    fuse.AddArgument(BRepPrimAPI_MakeBox(gp_Pnt(width, -1, -1), gp_Pnt(3, 3, 3)).Shape());
    fuse.Perform();
    for (const TopoDS_Shape& image : fuse.Modified(box)) images.push_back(image);
  }
  [[nodiscard]] std::vector<FacePiece> pieces() { return face_pieces(box, *fuse.History()); }
};

TEST(FacePieces, EachPieceIsThereOnce) {
  Fused fused(0.25);
  const std::vector<FacePiece> pieces = fused.pieces();
  EXPECT_EQ(pieces.size(), 10u) << "four faces in two, two whole";
  for (const FacePiece& piece : pieces) EXPECT_FALSE(piece.is_several);
  EXPECT_EQ(fused.images.size(), 2u);
}

TEST(FacePieces, APieceThatNoImageHasIsLost) {
  Fused fused(0.25);
  EXPECT_TRUE(lost_piece(fused.pieces(), fused.images).IsNull());
  fused.images.pop_back();
  EXPECT_FALSE(lost_piece(fused.pieces(), fused.images).IsNull());
}

TEST(FacePieces, AFaceThatWentIsLostWhereVolumeWentWithIt) {
  const Fused fused(0.25);
  EXPECT_TRUE(lost_face(fused.box, {}, BRepTools_History(), 0.01).IsNull()) << "no face went";
  const TopoDS_Face face = TopoDS::Face(TopExp_Explorer(fused.box, TopAbs_FACE).Current());
  const Handle(BRepTools_History) history = new BRepTools_History;
  history->Remove(face);
  EXPECT_TRUE(lost_face(fused.box, fused.images, *history, 0.01).IsNull()) << "the images fill the box";
  const std::vector<TopoDS_Shape> one{fused.images.front()};
  EXPECT_TRUE(lost_face(fused.box, one, *history, 0.01).IsSame(face));
  EXPECT_TRUE(lost_face(fused.box, one, *history, 0.6).IsNull()) << "a square of side 1 is half of that wide";
}

TEST(FacePieces, SliversAreNarrowPiecesOfWideFaces) {
  EXPECT_EQ(count_slivers(Fused(0.25).pieces(), 0.01), 0);
  EXPECT_EQ(count_slivers(Fused(0.005).pieces(), 0.02), 4);
  EXPECT_EQ(count_slivers(Fused(0.005).pieces(), 0.002), 0);
  EXPECT_EQ(count_slivers(Fused(0.005).pieces(), 10.0), 0) << "the faces were as narrow before";
}

}  // namespace
}  // namespace octet::test
