// SPDX-License-Identifier: BSD-3-Clause
// Openings that lie in planes are closed where that is asked for, and nothing else is.
#include "geom/occt/caps.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <gp_Pln.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <set>

#include "base/error.h"
#include "geom/model_check.h"
#include "geom/occt/assemble.h"
#include "geom/occt/free_edges.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kTolerance = 1e-6;

ReadOptions capping() {
  ReadOptions options;
  options.cap = true;
  return options;
}

/// The faces of a shape but for some of these numbers.
std::vector<TopoDS_Shape> faces_without(const TopoDS_Shape& shape, const std::set<int>& missing) {
  std::vector<TopoDS_Shape> faces;
  int number = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (missing.count(++number) == 0) faces.push_back(it.Current());
  return faces;
}

/// A box 1 x 2 x 3 without some faces: 1 and 2 are x = 0 and 1, 5 and 6 are z = 0 and 3.
TopoDS_Shape open_box(const std::set<int>& missing, const gp_Pnt& corner = {0, 0, 0}) {
  return shell_of(faces_without(BRepPrimAPI_MakeBox(corner, 1.0, 2.0, 3.0).Solid(), missing));
}

/// The round face of a cylinder about z.
TopoDS_Shape tube(double radius, double height) {
  return shell_of(faces_without(BRepPrimAPI_MakeCylinder(radius, height).Solid(), {2, 3}));
}

/// Five faces of a box, and its top z = 3 with a hole of 0.6 by 1.
std::vector<TopoDS_Shape> faces_of_box_with_a_hole() {
  std::vector<TopoDS_Shape> faces = faces_without(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid(), {});
  BRepBuilderAPI_MakeFace top(TopoDS::Face(faces[5]));
  top.Add(BRepBuilderAPI_MakePolygon(gp_Pnt(0.2, 0.5, 3), gp_Pnt(0.2, 1.5, 3), gp_Pnt(0.8, 1.5, 3),
                                     gp_Pnt(0.8, 0.5, 3), true)
              .Wire());
  faces[5] = top.Face();
  return faces;
}

TopoDS_Shape polygon_face(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon loop;
  for (const gp_Pnt& corner : corners) loop.Add(corner);
  loop.Close();
  return BRepBuilderAPI_MakeFace(loop.Wire(), true).Face();
}

/// A box 1 x 2 x 3 without its top, of whose corners one is higher by `lift`.
TopoDS_Shape box_with_a_lifted_corner(double lift) {
  const std::array<gp_Pnt, 4> low{gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0), gp_Pnt(1, 2, 0), gp_Pnt(0, 2, 0)};
  const std::array<gp_Pnt, 4> high{gp_Pnt(0, 0, 3), gp_Pnt(1, 0, 3), gp_Pnt(1, 2, 3 + lift), gp_Pnt(0, 2, 3)};
  std::vector<TopoDS_Shape> faces{polygon_face({low.begin(), low.end()})};
  for (std::size_t i = 0; i < 4; ++i)
    faces.push_back(polygon_face({low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]}));
  return compound_of(faces);
}

std::string refusal_of(const TopoDS_Shape& shape, const ReadOptions& options) {
  try {
    (void)model_from_shape(shape, options);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "it is not refused";
}

TEST(Caps, ABoxGetsTheFaceItLacks) {
  const Model model = model_from_shape(open_box({6}), capping());
  ASSERT_EQ(model.count(2), 6);
  EXPECT_EQ(model.count(1), 12);
  EXPECT_EQ(model.count(0), 8);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
  EXPECT_EQ(check_model(model), "");
}

TEST(Caps, AreToldAndNumberedAfterTheFacesOfTheFile) {
  const TopoDS_Shape box = open_box({5, 6});
  const Model model = model_from_shape(box, capping());
  ASSERT_EQ(model.count(2), 6);
  for (int face = 1; face <= 4; ++face) EXPECT_EQ(model.face(face).name, "");
  EXPECT_EQ(model.face(5).name, "cap 1");
  EXPECT_EQ(model.face(6).name, "cap 2");
  const auto& as_read = model.provenance().as_read[2];
  for (std::size_t face = 1; face <= 4; ++face)
    EXPECT_EQ(as_read[face].tags, std::vector<int>{static_cast<int>(face)});
  const std::string note = note_with(model, "2 opening(s) that lie in planes were closed");
  EXPECT_NE(note.find("\"cap 1\" of 2 mm^2 at (0.5, 1, "), std::string::npos) << note;
  EXPECT_NE(note.find("\"cap 2\" of 2 mm^2"), std::string::npos) << note;
  EXPECT_NE(note.find("of Edge "), std::string::npos) << note;
}

TEST(Caps, NothingIsCappedUnasked) {
  const std::string cause = refusal_of(open_box({5, 6}), {});
  EXPECT_NE(cause.find("2 opening(s) lie in planes: --cap closes such"), std::string::npos) << cause;
  const Model box = model_from_shape(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid(), capping());
  EXPECT_TRUE(box.notes().empty()) << box.notes().front();
}

TEST(Caps, NestedLoopsOfAPlaneAreOneRing) {
  const Model model = model_from_shape(compound_of({tube(2.0, 5.0), tube(1.999, 5.0)}), capping());
  ASSERT_EQ(model.count(3), 1);
  EXPECT_EQ(model.count(2), 4);
  const double ring = kPi * (2.0 * 2.0 - 1.999 * 1.999);
  EXPECT_NEAR(model.region(1).volume, 5.0 * ring, 1e-9);
  for (int face = 3; face <= 4; ++face) {
    EXPECT_NEAR(model.face(face).area, ring, 1e-9);
    EXPECT_EQ(model.face(face).euler, 0);
  }
  EXPECT_EQ(check_model(model), "");
}

TEST(Caps, LoopsInLoopsAreRingsAndDiscsByTurns) {
  const std::vector<Cap> caps =
      planar_caps(compound_of({tube(3.0, 1.0), tube(2.0, 1.0), tube(1.0, 1.0)}), kTolerance);
  ASSERT_EQ(caps.size(), 4u);
  for (const std::size_t ring : {0u, 1u}) EXPECT_NEAR(caps[ring].area, 5.0 * kPi, 1e-9);
  for (const std::size_t disc : {2u, 3u}) EXPECT_NEAR(caps[disc].area, kPi, 1e-9);
}

TEST(Caps, HaveTheFreeEdgesThemselves) {
  const TopoDS_Shape box = open_box({6});
  const std::vector<Cap> caps = planar_caps(box, kTolerance);
  ASSERT_EQ(caps.size(), 1u);
  EXPECT_EQ(caps[0].edges.size(), 4u);
  EXPECT_TRUE(free_edges(compound_of({box, caps[0].face})).empty());
  EXPECT_LT(caps[0].off, 1e-15);
}

TEST(Caps, AnOpeningThatIsNotPlanarStaysAndIsNamed) {
  const std::string cause = refusal_of(open_box({1, 5}), capping());  // around an edge
  EXPECT_NE(cause.find("one of 6 free edges"), std::string::npos) << cause;
  EXPECT_EQ(cause.find("--cap"), std::string::npos) << cause;
}

TEST(Caps, TheOpeningThatIsLeftIsNamedWhereAnotherOneIsClosed) {
  std::vector<TopoDS_Shape> faces = faces_of_box_with_a_hole();
  faces.erase(faces.begin() + 4);
  faces.erase(faces.begin());
  const std::string cause = refusal_of(shell_of(faces), capping());
  EXPECT_NE(cause.find("and 1 opening(s) closed that lie in planes: Edge"), std::string::npos) << cause;
  EXPECT_NE(cause.find("one of 6 free edges"), std::string::npos) << cause;
}

TEST(Caps, WhatIsPlanarIsForTheToleranceToSay) {
  constexpr double kLift = 0.001;
  EXPECT_NE(refusal_of(box_with_a_lifted_corner(kLift), capping()).find("is free"), std::string::npos);
  ReadOptions wide = capping();
  wide.sew_tolerance = kLift;
  const Model model = model_from_shape(box_with_a_lifted_corner(kLift), wide);
  EXPECT_EQ(model.face(6).name, "cap 1");
  EXPECT_TRUE(has_note(model, "within 0.00025 mm of Edge")) << note_with(model, "cap 1");
  EXPECT_FALSE(has_note(model, "farther from their faces than the file's tolerance says"));
}

TEST(Caps, TwoOpenSolidsAreClosedByThemselves) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> solids;
  for (const double x : {0.0, 1.0}) {
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, open_box({6}, {x, 0, 0}));
    solids.push_back(solid);
  }
  const Model model = model_from_shape(compound_of(solids), capping());
  ASSERT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 11) << "they touch";
  for (int region = 1; region <= 2; ++region) EXPECT_NEAR(model.region(region).volume, 6.0, 1e-9);
  std::multiset<std::string> names;
  for (int face = 1; face <= model.count(2); ++face) names.insert(model.face(face).name);
  EXPECT_EQ(names.count("cap 1"), 1u);
  EXPECT_EQ(names.count("cap 2"), 1u);
  EXPECT_EQ(check_model(model), "");
}

TEST(Caps, AreFollowedThroughTheFuse) {
  const TopoDS_Shape foot = BRepPrimAPI_MakeBox(gp_Pnt(0.2, 0.5, 3), gp_Pnt(0.8, 1.5, 4)).Solid();
  const Model model = model_from_shape(compound_of({foot, open_box({6})}), capping());
  ASSERT_EQ(model.count(3), 2);
  int pieces = 0;
  for (int face = 1; face <= model.count(2); ++face) pieces += model.face(face).name == "cap 1" ? 1 : 0;
  EXPECT_EQ(pieces, 2) << "under the foot and around it";
  EXPECT_EQ(check_model(model), "");
}

TEST(Caps, APartKeepsItsNameAndColour) {
  CadDocument document;
  document.shape = open_box({6});
  document.labels.push_back({document.shape, {"tank", "#ff0000", "", "", 0.0}});
  document.tree.emplace_back();
  document.tree.back().shape = document.shape;
  const OcctLock lock;
  const ModelParts parts = assemble(document, capping(), {}, [](const std::string&) {}).parts;
  ASSERT_EQ(parts.regions.size(), 2u);
  EXPECT_EQ(parts.regions[1].name, "tank");
  EXPECT_EQ(parts.faces[1].colour, "#ff0000");
  EXPECT_EQ(parts.faces[6].colour, "");
  EXPECT_EQ(parts.provenance.tree[0].regions, std::vector<int>{1});
  EXPECT_TRUE(parts.faults.empty());
}

TEST(Caps, TheHelperProgramCapsToo) {
  ReadOptions helper = capping();
  helper.reader_program = OCTET_READER_PROGRAM;
  const Model model = model_from_shape(open_box({6}), helper);
  EXPECT_EQ(model.face(6).name, "cap 1");
  EXPECT_EQ(model.notes(), model_from_shape(open_box({6}), capping()).notes());
}

TEST(Caps, ACurvedSheetWithAPlaneRimIsABowl) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(1.0, 0.0, 0.5 * kPi).Solid();
  const Model model = model_from_shape(faces_without(ball, {2}).front(), capping());
  EXPECT_EQ(model.count(2), 2);
  EXPECT_NEAR(model.region(1).volume, 2.0 / 3.0 * kPi, 1e-6);
}

TEST(Caps, APlaneSheetIsNoOpening) {
  const std::vector<TopoDS_Shape> faces = faces_of_box_with_a_hole();
  for (const TopoDS_Shape& sheet : {faces[0], faces[1], faces[5]}) {
    EXPECT_TRUE(planar_caps(sheet, kTolerance).empty());
    EXPECT_TRUE(planar_caps(sheet.Reversed(), kTolerance).empty());
  }
  EXPECT_EQ(refusal_of(faces[0], {}).find("--cap"), std::string::npos);
  EXPECT_NE(refusal_of(faces[0], capping()).find("the part bounds no volume"), std::string::npos);
}

TEST(Caps, AHoleInAPlaneFaceIsAnOpening) {
  const Model model = model_from_shape(shell_of(faces_of_box_with_a_hole()), capping());
  ASSERT_EQ(model.count(2), 7);
  EXPECT_NEAR(model.face(7).area, 0.6, 1e-9);
  EXPECT_NEAR(model.region(1).volume, 6.0, 1e-9);
}

TEST(Caps, ARimThatLiesInTheOpeningsPlaneIsNotCovered) {
  // The free edges are those around the rim: a cap over them would lie on it.
  BRepBuilderAPI_MakeFace rim(gp_Pln(gp_Pnt(0, 0, 3), gp::DZ()), -1.0, 2.0, -1.0, 3.0);
  rim.Add(BRepBuilderAPI_MakePolygon(gp_Pnt(0, 0, 3), gp_Pnt(0, 2, 3), gp_Pnt(1, 2, 3), gp_Pnt(1, 0, 3), true)
              .Wire());
  const TopoDS_Shape pan = compound_of({open_box({6}), rim.Face()});
  const std::string cause = refusal_of(pan, capping());
  EXPECT_NE(cause.find("the part bounds no volume"), std::string::npos) << cause;
  EXPECT_EQ(cause.find("closed that lie in planes"), std::string::npos) << cause;
}

TEST(Caps, AShellOnWhichASheetHangsStaysOpen) {
  const TopoDS_Shape box = open_box({6});
  const TopExp_Explorer edge(faces_without(box, {}).back(), TopAbs_EDGE);  // of z = 0
  const TopoDS_Shape fin = BRepPrimAPI_MakePrism(edge.Current(), gp_Vec(0, 0, -1)).Shape();
  const std::string cause = refusal_of(compound_of({box, fin}), capping());
  EXPECT_NE(cause.find("of Face 6 is free"), std::string::npos) << cause;
}

}  // namespace
}  // namespace octet::test
