// SPDX-License-Identifier: BSD-3-Clause
// Solids whose boundary touches itself where the file has no edge get one there.
#include "geom/occt/imprint.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

#include "geom/face_touches.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"
#include "tests/support/hook.h"
#include "tests/support/notes.h"

namespace octet {
namespace {

TopoDS_Shape prism(double tip) {
  return BRepPrimAPI_MakePrism(test::hook(0.0, tip, true), gp_Vec(0, 3, 0)).Shape();
}
TopoDS_Shape turned(double tip, bool round) {
  return BRepPrimAPI_MakeRevol(test::hook(3.0, tip, round), gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ())).Shape();
}

/// Real edges with more uses by faces than two.
int pinched_edges(const Model& model) {
  int count = 0;
  for (int e = 1; e <= model.count(1); ++e) count += model.edge(e).faces.size() > 2 ? 1 : 0;
  return count;
}

TEST(Imprint, ARoundTipThatTouchesAWallAlongALine) {
  const Model model = model_from_shape(prism(1.5));
  EXPECT_TRUE(test::has_note(model, "1 pair(s) were imprinted")) << "one cylinder, one plane";
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty())
      << "they have the line in common now";
  EXPECT_EQ(pinched_edges(model), 1);
  EXPECT_TRUE(check_model(model).empty());
  const double area = 6.0 * 1.0 + 1.5 * 3.5 + 1.0 * 3.0 + 3.0 * 1.0 + std::numbers::pi / 8.0;
  EXPECT_NEAR(model.region(1).volume, 3.0 * area, 1e-9);
}

TEST(Imprint, ATipBesideTheWallStaysAsItIs) {
  for (const double gap : {1e-4, 0.05}) {
    const Model model = model_from_shape(prism(1.5 + gap));
    EXPECT_FALSE(test::has_note(model, "touch")) << gap;
    EXPECT_EQ(pinched_edges(model), 0);
  }
}

TEST(Imprint, ATorusThatTouchesACylinderAlongACircle) {
  const Model model = model_from_shape(turned(1.5, true));
  EXPECT_TRUE(test::has_note(model, "were imprinted on each other"));
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty());
  EXPECT_GE(pinched_edges(model), 1);
  EXPECT_TRUE(check_model(model).empty());
}

TEST(Imprint, FacesThatLieOnOneAnotherAreTakenAway) {
  const Model model = model_from_shape(turned(1.5, false));
  EXPECT_TRUE(test::has_note(model, "lay on one another"));
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty());
  EXPECT_EQ(pinched_edges(model), 0) << "the finger and the wall are one body there";
  EXPECT_TRUE(check_model(model).empty());
  double area = 0.0, before = 0.0;
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  const Model apart = model_from_shape(turned(1.5 + 1e-5, false));
  for (int f = 1; f <= apart.count(2); ++f) before += apart.face(f).area;
  const double tip = 2.0 * std::numbers::pi * 4.5;  // a cylinder of radius 4.5, 1 high
  EXPECT_NEAR(area, before - 2.0 * tip, 0.01);
}

/// The solid without the edges that lie within its faces.
TopoDS_Shape without_inner_edges(const TopoDS_Shape& solid) {
  const BRep_Builder builder;
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  const TopTools_IndexedMapOfShape faces = sub_shapes(solid, TopAbs_FACE);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Shape face = faces(i).Oriented(TopAbs_FORWARD);
    TopoDS_Shape bare = face.EmptyCopied();
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
      TopoDS_Shape border = wire.Current().EmptyCopied();
      for (TopoDS_Iterator edge(wire.Current()); edge.More(); edge.Next())
        if (edge.Value().Orientation() != TopAbs_INTERNAL) builder.Add(border, edge.Value());
      if (TopoDS_Iterator(border).More()) builder.Add(bare, border);
    }
    changes->Replace(face, bare);
  }
  return changes->Apply(solid);
}

/// A peg of radius 1 and height 2 in the corner of a floor and a wall, `gap` off the wall. At 0 it touches it
/// all along, and foot and corner have a vertex in common; no face has an edge up the wall.
TopoDS_Shape peg_in_a_corner(double gap) {
  const gp_Ax2 axes(gp_Pnt(1 - gap, 0, 0), gp::DZ(), gp_Dir(-1, 0, 0));
  const TopoDS_Shape floor = BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, -1), gp_Pnt(2, 2, 0)).Shape(),
                     wall = BRepPrimAPI_MakeBox(gp_Pnt(2, -2, -1), gp_Pnt(3, 2, 3)).Shape(),
                     peg = BRepPrimAPI_MakeCylinder(axes, 1, 2).Shape();
  const TopoDS_Shape corner = BRepAlgoAPI_Fuse(floor, wall).Shape();
  ShapeUpgrade_UnifySameDomain unify(without_inner_edges(BRepAlgoAPI_Fuse(corner, peg).Shape()));
  unify.Build();
  return unify.Shape();
}

TEST(Imprint, APegAlongAWallThatHasAVertexOfItsFoot) {
  const TopoDS_Shape shape = peg_in_a_corner(0.0);
  const Model model = model_from_shape(shape);
  EXPECT_TRUE(test::has_note(model, "2 pair(s) were imprinted")) << "the peg's side, and its top at a point";
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty());
  EXPECT_EQ(model.count(1), sub_shapes(shape, TopAbs_EDGE).Extent() + 2)
      << "the line up the wall, and the top's circle in two";
  EXPECT_NEAR(model.region(1).volume, 16.0 + 16.0 + 2.0 * std::numbers::pi, 1e-9);
  const Model clear = model_from_shape(peg_in_a_corner(1e-3));
  EXPECT_FALSE(test::has_note(clear, "touch"));
}

TEST(Imprint, NumbersOfOtherFacesStay) {
  const Model apart = model_from_shape(prism(1.55)), touching = model_from_shape(prism(1.5));
  int kept = 0;
  for (int f = 1; f <= apart.count(2); ++f)
    kept += apart.face(f).boundary.size() == touching.face(f).boundary.size() &&
                    std::string_view(apart.surface(f).kind()) == touching.surface(f).kind()
                ? 1
                : 0;
  EXPECT_GE(kept, apart.count(2) - 4) << "the wall, the tip and the two sides have other edges";
}

}  // namespace
}  // namespace octet
