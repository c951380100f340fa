// SPDX-License-Identifier: BSD-3-Clause
// Rings with a flat on their seam, and loops that are open, through IGES files.
#include "geom/occt/iges_loops.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Curve.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "geom/occt/gathered.h"
#include "geom/occt/read_part.h"
#include "geom/occt/scoped_setting.h"
#include "geom/occt/shape_measures.h"
#include "tests/support/loose_iges.h"

namespace octet {
namespace {

/// A ring of radii 12 and 5, with a flat 15.5 from its axis at this angle.
TopoDS_Shape flattened_ring(double angle) {
  const gp_Dir way(std::cos(angle), std::sin(angle), 0.05);
  const gp_Ax2 axes(gp_Pnt(15.5 * way.X(), 15.5 * way.Y(), 15.5 * way.Z()), way);
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(12.0, 5.0).Solid(),
                         BRepPrimAPI_MakeCylinder(axes, 9.0, 10.0).Solid());
}

TEST(IgesLoops, ARingKeepsItsLargerPartBesideAFlat) {
  const auto path = std::filesystem::temp_directory_path() / "octet_IgesLoops.iges";
  int read_again = 0;
  for (const double angle : {0.7, 2.0, 4.0}) {
    const TopoDS_Shape ring = flattened_ring(angle);
    ASSERT_TRUE(test::write_loose_iges(ring, path));
    const int mode = Interface_Static::IVal("read.surfacecurve.mode");
    ReadOptions options;
    options.isolate = false;
    const Model model = read_part(path, options);
    EXPECT_EQ(Interface_Static::IVal("read.surfacecurve.mode"), mode) << "left changed for the whole process";
    ASSERT_EQ(model.count(3), 1);
    EXPECT_NEAR(model.region(1).volume, volume_of(ring), 1e-4 * volume_of(ring)) << angle;
    for (const std::string& note : model.notes())
      read_again += note.find("another part of their surface") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(read_again, 0) << "OCCT reads all of them as they are: the test tests nothing";
  std::filesystem::remove(path);
}

TEST(IgesLoops, AnotherReadingIsBelievedWhereOnlySuchFacesDiffer) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(12.0, 5.0).Shape();
  const TopoDS_Shape flat = flattened_ring(0.7), elsewhere = flattened_ring(2.0);
  EXPECT_TRUE(has_closed_surface(ring));
  EXPECT_FALSE(has_closed_surface(BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape()));
  EXPECT_TRUE(other_parts(ring, flat).faces.empty()) << "not as many faces";
  EXPECT_TRUE(other_parts(flat, flat).faces.empty());
  EXPECT_TRUE(other_parts(flat, elsewhere).faces.empty()) << "as large";
  const OtherParts larger = other_parts(ring, BRepPrimAPI_MakeTorus(12.0, 6.0).Shape());
  EXPECT_EQ(larger.faces.size(), 1u);
  EXPECT_FALSE(larger.to_be_believed) << "its corner is elsewhere";
}

/// The faces of a solid whose seam ends `gap` (of its parameter) off its vertex, which covers it; the loop of
/// the face with the seam begins with its edge of this index.
TopoDS_Shape loose_seam(const TopoDS_Shape& solid, double gap, std::size_t begin) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    std::vector<TopoDS_Shape> edges;
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) edges.push_back(it.Current());
    faces.push_back(face.Current());
    if (edges.size() < 4) continue;
    for (const TopoDS_Shape& shape : edges) {
      const TopoDS_Edge edge = TopoDS::Edge(shape.Oriented(TopAbs_FORWARD));
      double first = 0.0, last = 0.0;
      BRep_Tool::Range(edge, first, last);
      if (!BRep_Tool::IsClosed(edge, TopoDS::Face(face.Current())) || first > 0.0) continue;
      builder.Range(edge, gap, last);
      builder.UpdateVertex(TopExp::FirstVertex(edge), 2.0 * gap);
    }
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < edges.size(); ++i) builder.Add(wire, edges[(begin + i) % edges.size()]);
    faces.back() = face.Current().EmptyCopied();
    builder.Add(faces.back(), wire);
  }
  return compound_of(faces);
}

TEST(IgesLoops, LoopsOpenByMoreThanTheStatedPrecisionAreJoined) {
  const auto path = std::filesystem::temp_directory_path() / "octet_IgesPrecision.iges";
  IGESControl_Controller::Init();
  const ScopedSetting least("write.precision.mode", -1);  // states the least tolerance, not the mean one
  ReadOptions options;
  options.isolate = false;
  const auto notes_of_precision = [](const Model& model) {
    int found = 0;
    for (const std::string& note : model.notes()) found += note.rfind("read with a precision of", 0) == 0;
    return found;
  };
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(0.25, 11.1).Solid();
  for (const double gap : {0.0, 5e-6, 5e-5}) {
    int read_again = 0;
    for (std::size_t begin = 0; begin < 4; ++begin) {
      ASSERT_TRUE(test::write_loose_iges(loose_seam(cylinder, gap, begin), path));
      const int mode = Interface_Static::IVal("read.precision.mode");
      const double value = Interface_Static::RVal("read.precision.val");
      const Model model = read_part(path, options);
      EXPECT_EQ(Interface_Static::IVal("read.precision.mode"), mode);
      EXPECT_EQ(Interface_Static::RVal("read.precision.val"), value);
      ASSERT_EQ(model.count(3), 1) << gap << " " << begin;
      EXPECT_NEAR(model.region(1).volume, std::numbers::pi * 0.0625 * 11.1, 1e-4) << gap << " " << begin;
      read_again += notes_of_precision(model);
    }
    EXPECT_EQ(read_again > 0, gap > 0.0) << gap;
  }
  std::filesystem::remove(path);
}

/// The faces of a cylinder whose curves on its wall are a turn off at the top, and so slanted for its seam,
/// as some writers have them; in space they are right.
TopoDS_Shape turned_top() {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1.0, 3.0).Solid();
  const BRep_Builder builder;
  const double turn = 2.0 * std::numbers::pi;
  for (TopExp_Explorer face(cylinder, TopAbs_FACE); face.More(); face.Next())
    for (TopExp_Explorer it(face.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current().Oriented(TopAbs_FORWARD));
      const TopoDS_Face wall = TopoDS::Face(face.Current());
      if (BRepAdaptor_Surface(wall).GetType() != GeomAbs_Cylinder) continue;
      double first = 0.0, last = 0.0;
      const auto line = [](double u0, double v0, double u1, double v1, double from, double to) {
        TColgp_Array1OfPnt2d ends(1, 2);
        ends(1) = gp_Pnt2d(u0, v0);
        ends(2) = gp_Pnt2d(u1, v1);
        TColStd_Array1OfReal knots(1, 2);
        knots(1) = from;
        knots(2) = to;
        TColStd_Array1OfInteger multiplicities(1, 2);
        multiplicities.Init(2);
        return Handle(Geom2d_Curve)(new Geom2d_BSplineCurve(ends, knots, multiplicities, 1));
      };
      BRep_Tool::Range(edge, first, last);
      const double height = BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Z();
      if (BRep_Tool::IsClosed(edge, wall))
        builder.UpdateEdge(edge, line(turn, 0.0, 2.0 * turn, 3.0, first, last),
                           line(0.0, 0.0, turn, 3.0, first, last), wall, 1e-7);
      else if (height > 1.0)
        builder.UpdateEdge(edge, line(turn, 3.0, 2.0 * turn, 3.0, first, last), wall, 1e-7);
    }
  return cylinder;
}

TEST(IgesLoops, CurvesOnSurfacesThatAreWrongAreNotGoneBy) {
  const auto path = std::filesystem::temp_directory_path() / "octet_IgesTurned.iges";
  ASSERT_TRUE(test::write_loose_iges(turned_top(), path));
  const Model model = read_part(path);
  std::filesystem::remove(path);
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 3.0 * std::numbers::pi, 1e-6);
  EXPECT_TRUE(std::any_of(model.notes().begin(), model.notes().end(), [](const std::string& note) {
    return note.rfind("read by its curves in space alone", 0) == 0;
  }));
}

TEST(IgesLoops, AFaceOfWhichNothingIsLeftIsFound) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(2.0, 5.0).Shape();
  EXPECT_TRUE(empty_faces(cylinder).empty());
  EXPECT_TRUE(empty_faces(BRepPrimAPI_MakeTorus(12.0, 5.0).Shape()).empty());
  EXPECT_TRUE(empty_faces(BRepPrimAPI_MakeSphere(5.0).Shape()).empty());
  // The cylinder's wall with one of its circles alone.
  const TopoDS_Face wall = TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current());
  TopExp_Explorer it(wall, TopAbs_EDGE);
  while (BRep_Tool::IsClosed(TopoDS::Edge(it.Current()), wall)) it.Next();
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, it.Current());
  TopoDS_Shape empty = wall.EmptyCopied();
  builder.Add(empty, wire);
  EXPECT_EQ(empty_faces(empty).size(), 1u);
}

}  // namespace
}  // namespace octet
