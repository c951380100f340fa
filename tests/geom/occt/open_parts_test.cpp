// SPDX-License-Identifier: BSD-3-Clause
// Parts without a solid: which of them are missing from the model, and which are only told.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "geom/occt/assemble.h"
#include "geom/occt/gathered.h"

namespace octet {
namespace {

/// Faces of a box that share no edges, as a part each; the last `missing` of the six are not there.
std::vector<TopoDS_Shape> loose_faces(const gp_Pnt& corner, int missing) {
  std::vector<TopoDS_Shape> faces;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(corner, 1.0, 2.0, 3.0).Solid();
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape());
  faces.resize(faces.size() - static_cast<std::size_t>(missing));
  return faces;
}

ModelParts parts_of(const std::vector<TopoDS_Shape>& shapes, const ReadOptions& options = {}) {
  CadDocument document;
  document.shape = compound_of(shapes);
  for (const TopoDS_Shape& shape : shapes) {
    PlacedPart part;
    part.node.name = "part " + std::to_string(document.tree.size());
    part.shape = shape;
    document.tree.push_back(part);
  }
  const OcctLock lock;
  return assemble(document, options, {}, [](const std::string&) {}).parts;
}

TEST(OpenParts, FacesSewnIntoASolidAreNotLeftOut) {
  std::vector<TopoDS_Shape> shapes = loose_faces({0, 0, 0}, 0);
  const std::vector<TopoDS_Shape> single = loose_faces({5, 0, 0}, 5);
  shapes.insert(shapes.end(), single.begin(), single.end());
  const ModelParts parts = parts_of(shapes);
  EXPECT_EQ(parts.regions.size(), 2u) << "the unused first and the box";
  EXPECT_TRUE(parts.faults.empty()) << parts.faults.front().cause;
  int left = 0;
  for (const LeftOut& item : parts.provenance.left_out) left += item.entity.dim == 2 ? 1 : 0;
  EXPECT_EQ(left, 1) << "the single face";
}

TEST(OpenParts, AShellThatLacksAFaceIsAFault) {
  std::vector<TopoDS_Shape> shapes{BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Solid(),
                                   compound_of(loose_faces({5, 0, 0}, 1))};
  const ModelParts parts = parts_of(shapes);
  ASSERT_EQ(parts.faults.size(), 1u);
  EXPECT_NE(parts.faults[0].cause.find("\"part 1\" is left out"), std::string::npos) << parts.faults[0].cause;
  EXPECT_NE(parts.faults[0].advice.find("1 opening(s) lie in planes: --cap closes such"), std::string::npos)
      << parts.faults[0].advice;
}

TEST(OpenParts, AShellThatSewingLeavesOpenBesideAClosedOneIsAFault) {
  std::vector<TopoDS_Shape> faces = loose_faces({0, 0, 0}, 0);
  const std::vector<TopoDS_Shape> open = loose_faces({5, 0, 0}, 1);
  faces.insert(faces.end(), open.begin(), open.end());
  const ModelParts parts = parts_of({compound_of(faces)});  // all in one part
  EXPECT_EQ(parts.regions.size(), 2u);
  ASSERT_EQ(parts.faults.size(), 1u);
  EXPECT_NE(parts.faults[0].cause.find("a shell of 5 faces is left out"), std::string::npos)
      << parts.faults[0].cause;
}

/// The first `count` faces of a box, as a shell.
TopoDS_Shape shell_of_box(const gp_Pnt& corner, double size, int count) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(corner, size, size, size).Solid();
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More() && count > 0; it.Next(), --count)
    builder.Add(shell, it.Current());
  return shell;
}

TEST(OpenParts, AnOpenShellBesideASolidOfItsPartIsAFault) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Solid();
  const auto beside = [&](const TopoDS_Shape& other, const ReadOptions& options = {}) {
    return parts_of({compound_of(std::vector<TopoDS_Shape>{box, other})}, options);
  };
  for (const int count : {3, 5}) {
    const ModelParts parts = beside(shell_of_box({5, 5, 5}, 1.0, count));
    EXPECT_EQ(parts.regions.size(), 2u);
    ASSERT_EQ(parts.faults.size(), 1u) << count;
    EXPECT_NE(parts.faults[0].cause.find(std::to_string(count) + " faces is left out"), std::string::npos)
        << parts.faults[0].cause;
  }
  // For construction: one face, two that only lie side by side, faces in no shell.
  EXPECT_TRUE(beside(shell_of_box({5, 5, 5}, 1.0, 1)).faults.empty());
  EXPECT_TRUE(beside(shell_of_box({5, 5, 5}, 1.0, 2)).faults.empty());
  EXPECT_TRUE(beside(compound_of(loose_faces({5, 5, 5}, 1))).faults.empty());
  // Within the solid: told by a note, or a part of the mesh.
  ReadOptions embed;
  embed.embed = true;
  EXPECT_TRUE(beside(shell_of_box({0.3, 0.3, 0.3}, 0.3, 3)).faults.empty());
  EXPECT_TRUE(beside(shell_of_box({0.3, 0.3, 0.3}, 0.3, 3), embed).faults.empty());
}

/// A block with a hole of radius 2 along z, and a tube of the radius and z given along the hole's axis.
ModelParts block_and_tube(double radius, double z0, double z1) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), 10, 10, 10).Shape();
  const auto cylinder = [](double r, double from, double to) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, from), gp::DZ()), r, to - from).Shape();
  };
  TopTools_ListOfShape sides;
  const TopoDS_Shape tube = cylinder(radius, z0, z1);
  for (TopExp_Explorer it(tube, TopAbs_FACE); it.More(); it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Cylinder)
      sides.Append(BRepBuilderAPI_Copy(it.Current()).Shape());
  const TopoDS_Shape far_side = cylinder(radius, z0 - 0.5, z0);  // a part of one face is not told so
  for (TopExp_Explorer it(far_side, TopAbs_FACE); it.More() && sides.Extent() == 1; it.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Cylinder)
      sides.Append(BRepBuilderAPI_Copy(it.Current()).Shape());
  return parts_of({BRepAlgoAPI_Cut(block, cylinder(2, -1, 11)).Shape(),
                   compound_of(std::vector<TopoDS_Shape>{sides.First(), sides.Last()})});
}

TEST(OpenParts, AThreadDrawnInsideOfASolidIsNoFault) {
  for (const double end : {9.0, 14.0}) {  // it may go on beyond the hole
    const ModelParts parts = block_and_tube(2.5, 1.0, end);
    EXPECT_TRUE(parts.faults.empty()) << parts.faults.front().cause;
    EXPECT_TRUE(std::any_of(parts.notes.begin(), parts.notes.end(), [](const std::string& note) {
      return note.find("\"part 1\" is surfaces inside of solids") != std::string::npos;
    }));
  }
}

TEST(OpenParts, AnOpenTubeInAHoleIsAFault) {
  for (const double radius : {2.0, 1.9})
    EXPECT_EQ(block_and_tube(radius, 1.0, 9.0).faults.size(), 1u) << radius;
  EXPECT_EQ(block_and_tube(2.5, 8.0, 14.0).faults.size(), 1u) << "most of it is outside";
}

/// Why a part of these faces is refused.
std::string refusal_of(const std::vector<TopoDS_Shape>& faces) {
  try {
    (void)parts_of(faces);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "it is not refused";
}

TEST(OpenParts, WhatIsLeftAfterSewingIsTold) {
  const std::string cause = refusal_of(loose_faces({0, 0, 0}, 1));  // without z = 3: five faces of four edges
  EXPECT_NE(cause.find("with its 5 faces sewn"), std::string::npos) << cause;
  EXPECT_NE(cause.find("one of 4 free edges"), std::string::npos) << cause;
  EXPECT_NE(cause.find("no other face comes near"), std::string::npos) << cause;
  EXPECT_EQ(cause.find("--sew"), std::string::npos) << "it cannot help: " << cause;
}

TEST(OpenParts, AToleranceThatSewsThemIsAdvised) {
  constexpr double kGap = 0.002;
  std::vector<TopoDS_Shape> faces = loose_faces({0, 0, 0}, 1);
  faces.push_back(loose_faces({0, 0, kGap}, 0).back());
  const std::string cause = refusal_of(faces);
  EXPECT_NE(cause.find("one of 8 free edges"), std::string::npos) << cause;
  const std::string option = "--sew ";
  const std::size_t at = cause.find(option);
  ASSERT_NE(at, std::string::npos) << cause;
  const double tolerance = std::stod(cause.substr(at + option.size()));
  EXPECT_NEAR(tolerance, 1.5 * kGap, 0.1 * kGap) << cause;
  ReadOptions options;
  options.sew_tolerance = tolerance;
  EXPECT_EQ(parts_of(faces, options).regions.size(), 2u);
}

TEST(OpenParts, NoToleranceIsAdvisedThatHasBeenTried) {
  std::vector<TopoDS_Shape> faces = loose_faces({0, 0, 0}, 1);
  faces.push_back(loose_faces({0, 0, 0.002}, 0).back());
  const TopoDS_Shape shape = compound_of(faces);
  const SolidSet none{{}, new BRepTools_History(), {}};
  EXPECT_NE(opening_of(shape, shape, ShapeMaps(shape), none, {0.0}).advice.find("--sew"), std::string::npos);
  EXPECT_EQ(opening_of(shape, shape, ShapeMaps(shape), none, {0.05}).advice, "close the shell there");
}

}  // namespace
}  // namespace octet
