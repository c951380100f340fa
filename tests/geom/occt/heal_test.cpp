// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a solid is repaired, told in the notes, and nothing else is touched.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "base/constants.h"
#include "base/error.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"
#include "geom/occt/read_part.h"
#include "geom/occt/voids.h"
#include "tests/support/notes.h"
#include "tests/support/with_void.h"

namespace octet::test {
namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

/// The faces of a box, each moved away from its centre.
TopoDS_Shape exploded_box(double gap) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  const std::vector<TopoDS_Face> faces = faces_of(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    gp_Trsf away;
    gp_XYZ step(0.0, 0.0, 0.0);
    step.SetCoord(static_cast<int>(i / 2) + 1, i % 2 == 0 ? -gap : gap);
    away.SetTranslation(gp_Vec(step));
    builder.Add(all, BRepBuilderAPI_Copy(faces[i]).Shape().Moved(away));
  }
  return all;
}

/// A box 1 x 2 x 3 whose face y = 0 ends in an arc that bulges by `bulge` over the edge that the face z = 3
/// ends in, with a face between the two, on a plane `lift` above; the arc has the given tolerance.
TopoDS_Shape box_with_a_strip(double bulge, double tolerance, double lift = 0.0) {
  const BRep_Builder builder;
  std::vector<TopoDS_Face> faces = faces_of(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
  TopoDS_Edge straight;
  for (TopExp_Explorer it(faces[2], TopAbs_EDGE); it.More(); it.Next())
    for (TopExp_Explorer other(faces[5], TopAbs_EDGE); other.More(); other.Next())
      if (it.Current().IsSame(other.Current()))
        straight = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
  const TopoDS_Vertex from = TopExp::FirstVertex(straight), to = TopExp::LastVertex(straight);
  const GC_MakeArcOfCircle arc(BRep_Tool::Pnt(from), gp_Pnt(0.5, -bulge, 3.0), BRep_Tool::Pnt(to));
  const TopoDS_Edge bowed = BRepBuilderAPI_MakeEdge(arc.Value(), from, to).Edge();
  builder.UpdateEdge(bowed, tolerance);
  BRepTools_ReShape reshape;
  reshape.Replace(straight, bowed);
  faces[2] = TopoDS::Face(reshape.Apply(faces[2]));
  const gp_Pln top(gp_Pnt(0, 0, 3 + lift), gp::DZ());
  const TopoDS_Wire loop = BRepBuilderAPI_MakeWire(bowed, TopoDS::Edge(straight.Reversed())).Wire();
  faces.push_back(BRepBuilderAPI_MakeFace(top, loop).Face());
  return solid_of(faces);
}

void expect_no_strip(const Model& model) {
  EXPECT_NE(note_with(model, "no wider than the tolerance or the gaps of their sides"), "");
  EXPECT_EQ(model.count(2), 6);
  EXPECT_EQ(model.count(1), 12);
  EXPECT_EQ(check_model(model), "");
  EXPECT_NEAR(model.region(1).volume, 6.0, 0.01);
}

void expect_the_strip(const Model& model) {
  EXPECT_EQ(note_with(model, "no wider than the tolerance or the gaps of their sides"), "");
  EXPECT_EQ(model.count(2), 7);
}

TEST(Heal, AFaceWithinTheToleranceOfItsSidesBecomesAnEdge) {
  expect_no_strip(model_from_shape(box_with_a_strip(0.004, 0.005)));
  expect_the_strip(model_from_shape(box_with_a_strip(0.04, 0.005)));
}

TEST(Heal, AFaceNoWiderThanItsSidesLieOffItBecomesAnEdge) {
  expect_no_strip(model_from_shape(box_with_a_strip(0.004, 1e-7, 0.005)));
  expect_the_strip(model_from_shape(box_with_a_strip(0.04, 1e-7, 0.005)));
}

TEST(Heal, AFaceNoWiderThanRoundingLeavesBecomesAnEdge) {
  expect_no_strip(model_from_shape(box_with_a_strip(3e-6, 1e-7)));  // the diagonal is 3.7
  expect_the_strip(model_from_shape(box_with_a_strip(3e-5, 1e-7)));
}

TEST(Heal, OfTheSidesOfALensTheOneThatMayRunAnywhereGoes) {
  const auto length_of_edges = [](const Model& model) {
    double length = 0.0;
    for (int e = 1; e <= model.count(1); ++e) length += model.edge(e).length;
    return length;
  };
  // The arc is longer by 4e-3 of 1.
  const Model model = model_from_shape(box_with_a_strip(0.04, 0.05));
  expect_no_strip(model);
  EXPECT_NEAR(length_of_edges(model), 4.0 * (1.0 + 2.0 + 3.0), 1e-9);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
}

TEST(Heal, SaysNothingOfAHealthyPart) {
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()).notes().empty());
  EXPECT_TRUE(model_from_shape(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()).notes().empty());
}

TEST(Heal, TurnsFacesThatDisagreeWithTheirNeighbours) {
  std::vector<TopoDS_Face> faces = faces_of(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape());
  faces[3].Reverse();
  const Model model = model_from_shape(solid_of(faces));
  EXPECT_NE(note_with(model, "were turned so that they agree"), "");
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

TEST(Heal, TurnsASolidThatFillsAllButAHole) {
  const Model model = model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape().Reversed());
  EXPECT_NE(note_with(model, "Solid 1 was turned inside out"), "");
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

/// A box at x = 0, another one that stands beside it, and nothing to mend but that one's sides.
void expect_two_turned_boxes(const TopoDS_Shape& other) {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 1)).Shape());
  builder.Add(both, other);
  const Model model = model_from_shape(both);
  EXPECT_NE(note_with(model, "Solid 2 was turned inside out"), "");
  EXPECT_EQ(note_with(model, "bound no volume"), "") << "Solid 2 is still there";
  EXPECT_TRUE(model.parts().faults.empty());
  ASSERT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 11);
  for (int region = 1; region <= 2; ++region) EXPECT_NEAR(model.region(region).volume, 1.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

TEST(Heal, TurnsOneOfTwoSolidsThatTouchBeforeTheyAreFused) {
  expect_two_turned_boxes(BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 1, 1)).Shape().Reversed());
}

TEST(Heal, TurnsTheFacesOfASolidThatTouchesAnother) {
  std::vector<TopoDS_Face> faces;
  for (const TopoDS_Face& face : faces_of(BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), gp_Pnt(2, 1, 1)).Shape()))
    faces.push_back(TopoDS::Face(face.Reversed()));
  expect_two_turned_boxes(solid_of(faces));
  faces[3].Reverse();
  expect_two_turned_boxes(solid_of(faces));
}

TEST(Heal, SewsAnOpenSolidWhoseFacesOnlyNearlyMeet) {
  std::vector<TopoDS_Face> loose;
  for (const TopoDS_Face& face : faces_of(exploded_box(1e-6))) loose.push_back(face);
  const Model model = model_from_shape(solid_of(loose));
  EXPECT_NE(note_with(model, "was closed by sewing its faces"), "");
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-4);
}

TEST(Heal, SewsWithinTheToleranceAsked) {
  const TopoDS_Shape apart = exploded_box(0.01);
  EXPECT_THROW((void)model_from_shape(apart), ModelError);
  ReadOptions options;
  options.sew_tolerance = 0.05;
  const Model model = model_from_shape(apart, options);
  EXPECT_NE(note_with(model, "sewn with tolerance 0.05 mm"), "");
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 6);
  EXPECT_EQ(model.count(1), 12);
  EXPECT_EQ(model.count(0), 8);
  EXPECT_NEAR(model.region(1).volume, 6.0, 0.3);
}

/// An eighth of a ball whose round face has no edge at the pole.
TopoDS_Shape eighth_without_pole_edge() {
  const TopoDS_Shape eighth = BRepPrimAPI_MakeSphere(1.0, 0.0, 0.5 * kPi, 0.5 * kPi).Solid();
  const Handle(BRepTools_ReShape) changes = new BRepTools_ReShape();
  for (TopExp_Explorer it(eighth, TopAbs_EDGE); it.More(); it.Next())
    if (BRep_Tool::Degenerated(TopoDS::Edge(it.Current()))) changes->Remove(it.Current());
  return changes->Apply(eighth);
}

TEST(Heal, ALoopThroughAPoleGetsAnEdgeThere) {
  const Model model = model_from_shape(eighth_without_pole_edge());
  EXPECT_NE(note_with(model, "had no edge at a pole and got one, the first is of Face 1"), "");
  EXPECT_EQ(model.edge(model.count(1)).use, EdgeUse::kDegenerate);
  EXPECT_NEAR(model.region(1).volume, kPi / 6.0, 1e-9);
  EXPECT_EQ(model.region_at({0.5, 0.5, 0.5}), 1);
}

TEST(Heal, AFaceFoldedFlatOntoItsNeighbourIsTakenAway) {
  const Model model = read_part(OCTET_MODELS "/bugs/folded_top.step");
  EXPECT_NE(note_with(model, "lie flat on a face beside them"), "");
  EXPECT_EQ(model.count(2), 10);
  EXPECT_NEAR(model.region(1).volume, 18.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

/// The shape with a loop of 0.002 more, from a vertex back to it, in the border of the face that lies between
/// two others in one plane.
TopoDS_Shape with_speck_at_fold(const TopoDS_Shape& shape) {
  const auto is_fold = [](const TopoDS_Face& face) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(face, TopAbs_EDGE, edges);
    return edges.Extent() == 2;
  };
  const std::vector<TopoDS_Face> faces = faces_of(shape);
  const TopoDS_Face fold = *std::find_if(faces.begin(), faces.end(), is_fold);
  const TopoDS_Vertex at = TopoDS::Vertex(TopExp_Explorer(fold, TopAbs_VERTEX).Current());
  const gp_Pnt from = BRep_Tool::Pnt(at);
  const BRep_Builder builder;
  const gp_Ax2 circle(from.Translated(gp_Vec(0, 0.001 / kPi, 0)), gp::DZ(), gp_Dir(0, -1, 0));
  TopoDS_Edge speck = BRepBuilderAPI_MakeEdge(gp_Circ(circle, 0.001 / kPi), at, at);
  builder.UpdateVertex(at, 0.002);
  TopoDS_Face plain = TopoDS::Face(fold.EmptyCopied());
  const TopoDS_Wire old = TopoDS::Wire(TopExp_Explorer(fold, TopAbs_WIRE).Current());
  TopoDS_Wire border = TopoDS::Wire(old.EmptyCopied());
  builder.Add(border, speck);
  for (TopoDS_Iterator it(old); it.More(); it.Next()) builder.Add(border, it.Value());
  builder.Add(plain, border);
  ShapeFix_Edge().FixAddPCurve(speck, plain, false, Precision::Confusion());
  BRepTools_ReShape changes;
  changes.Replace(fold, plain);
  return changes.Apply(shape);
}

TEST(Heal, AFoldWhoseLoopHasASpeckIsTakenAwayToo) {
  STEPControl_Reader reader;
  ASSERT_EQ(reader.ReadFile(OCTET_MODELS "/bugs/folded_top.step"), IFSelect_RetDone);
  reader.TransferRoots();
  const Model model = model_from_shape(with_speck_at_fold(reader.OneShape()));
  EXPECT_NE(note_with(model, "lie flat on a face beside them"), "");
  EXPECT_EQ(model.count(2), 10);
  EXPECT_NEAR(model.region(1).volume, 18.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

TEST(Heal, AKnifeIsNoFold) {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(1, 0.001, 0), true);
  const TopoDS_Shape knife =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape(), gp_Vec(0, 0, 1)).Shape();
  const Model model = model_from_shape(knife);
  EXPECT_EQ(note_with(model, "lie flat"), "");
  EXPECT_EQ(model.count(2), 5);
}

/// A block from x = 0 to 3, y and z = 0 to 1, with a step down to `low` beyond x = 1, and a void below the
/// step's inner edge whose upper edge is `below` that.
TopoDS_Shape stepped_block_with_void(double low, double below) {
  const TopoDS_Shape cut_off = BRepPrimAPI_MakeBox(gp_Pnt(1.0, -1.0, low), gp_Pnt(4.0, 2.0, 2.0));
  const TopoDS_Shape block = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(3.0, 1.0, 1.0).Shape(), cut_off);
  const TopoDS_Shape hollow =
      BRepPrimAPI_MakeBox(gp_Pnt(0.5, 0.2, 0.1 - below), gp_Pnt(1.0, 0.8, low - below));
  return with_void(block, hollow);
}

TEST(Heal, AVoidSharesTheEdgeWhereItTouchesTheOutside) {
  const Model model = model_from_shape(stepped_block_with_void(0.5, 0.0));
  EXPECT_NE(note_with(model, "voids of Solid 1 touch its outside"), "");
  EXPECT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 8 + 6);
  EXPECT_EQ(model.count(1), 18 + 12 + 2 - 1);  // the step's edge is three, the void's own is one of them
  EXPECT_EQ(model.count(0), 12 + 8);
  EXPECT_NEAR(model.region(1).volume, 2.0 - 0.5 * 0.6 * 0.4, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

TEST(Heal, AVoidApartFromTheOutsideIsLeftAlone) {
  const Model model = model_from_shape(stepped_block_with_void(0.5, 0.05));
  EXPECT_EQ(note_with(model, "voids of"), "");
  EXPECT_EQ(model.count(1), 18 + 12);
}

/// A cube with a void in it that is a plate of the given thickness, one edge of which has the tolerance.
TopoDS_Shape cube_with_a_leaf(double thickness, double tolerance) {
  const TopoDS_Shape leaf = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), 2.0, 2.0, thickness).Shape();
  BRep_Builder().UpdateEdge(TopoDS::Edge(TopExp_Explorer(leaf, TopAbs_EDGE).Current()), tolerance);
  return with_void(BRepPrimAPI_MakeBox(4.0, 4.0, 4.0).Shape(), leaf);
}

TEST(Heal, AVoidOfNoThicknessIsTakenAway) {
  for (const auto& [thickness, tolerance] : {std::pair{1e-6, 1e-7}, std::pair{1e-4, 1e-3}}) {
    const Model model = model_from_shape(cube_with_a_leaf(thickness, tolerance));
    EXPECT_NE(note_with(model, "6 face(s) of Solid 1 are shells no thicker than"), "");
    EXPECT_EQ(model.count(2), 6);
    EXPECT_EQ(check_model(model), "");
  }
  EXPECT_EQ(model_from_shape(cube_with_a_leaf(1e-4, 1e-7)).count(2), 12);
}

TEST(Heal, ShellsOfWhichNoneIsOutsideAreNoVoids) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (const double x : {0.0, 3.0}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(x, 0.0, 0.0), 1.0, 1.0, 1.0).Solid();
    builder.Add(solid, TopExp_Explorer(box, TopAbs_SHELL).Current().Reversed());
  }
  const VoidsJoined joined = join_voids(solid);
  EXPECT_FALSE(joined.touch);
  ASSERT_EQ(joined.solids.size(), 1u);
  EXPECT_TRUE(joined.solids.front().IsEqual(solid));
}

TEST(Heal, AVoidThatTouchesTheOutsideAtPointsIsNotLost) {
  // OCCT's fuse loses the ball: its seam's middle lies on the box.
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-2, -2, -2), gp_Pnt(2, 2, 2)).Shape();
  const Model model = model_from_shape(BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeSphere(2.0).Shape()).Shape());
  EXPECT_EQ(model.count(2), 7);
  EXPECT_NEAR(model.region(1).volume, 64.0 - 32.0 / 3.0 * kPi, 1e-6);
}

TEST(Heal, AVoidThatTouchesTheOutsideWithItsPolesKeepsThem) {
  const gp_Ax2 axes(gp_Pnt(0, 0, -2), gp::DZ());
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(axes, 3.0, 4.0).Shape();
  const Model model = model_from_shape(BRepAlgoAPI_Cut(rod, BRepPrimAPI_MakeSphere(2.0).Shape()).Shape());
  EXPECT_EQ(model.count(2), 4);
  EXPECT_NEAR(model.region(1).volume, (36.0 - 32.0 / 3.0) * kPi, 1e-6);
}

TEST(Heal, WhatACircleAloneHeldTogetherBecomesTwoSolids) {
  const Model model = read_part(OCTET_MODELS "/bugs/boss_over_void.step");
  EXPECT_NE(note_with(model, "it became 2 solids"), "");
  EXPECT_EQ(model.count(3), 2);
  EXPECT_NEAR(model.region(1).volume + model.region(2).volume, 32.0 + kPi - 1.2 * kPi, 1e-6);
}

TEST(Heal, AnEdgeElsewhereThanItsFaceIsRefusedByName) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  double first = 0.0, last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges(5)), first, last);
  BRep_Builder().UpdateEdge(TopoDS::Edge(edges(5)),
                            Handle(Geom_Curve)::DownCast(curve->Translated(gp_Vec(5.0, 5.0, 5.0))), 1e-7);
  try {
    (void)model_from_shape(box);
    FAIL() << "the box was taken";
  } catch (const ModelError& error) {
    EXPECT_EQ(error.entity(), model_edge(5));
    EXPECT_NE(std::string(error.what()).find("Edge 5 lies up to"), std::string::npos) << error.what();
  }
}

TEST(Heal, AnEdgeThatEndsFarFromItsVertexIsRefusedByName) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(box, TopAbs_VERTEX, vertices);
  BRep_Builder().UpdateVertex(TopoDS::Vertex(vertices(3)), gp_Pnt(9.0, 9.0, 9.0), 20.0);
  try {
    (void)model_from_shape(box);
    FAIL() << "the box was taken";
  } catch (const ModelError& error) {
    EXPECT_EQ(error.entity().dim, 1);
    EXPECT_NE(std::string(error.what()).find("off Vertex 3"), std::string::npos) << error.what();
  }
}

TEST(Heal, GivesEdgesWithoutACurveOnTheirFaceOne) {
  const TopoDS_Shape part = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
  const BRep_Builder builder;
  for (const TopoDS_Face& face : faces_of(part)) {
    if (faces_of(part).front().IsSame(face)) {
      for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
        if (!BRep_Tool::IsClosed(edge, face)) builder.UpdateEdge(edge, Handle(Geom2d_Curve)(), face, 1e-7);
      }
    }
  }
  const Model model = model_from_shape(part);
  EXPECT_NE(note_with(model, "had no curve on a face and got one"), "");
  EXPECT_NEAR(model.region(1).volume, 2.0 * kPi, 1e-6);
  EXPECT_EQ(check_model(model), "");
}

}  // namespace
}  // namespace octet::test
