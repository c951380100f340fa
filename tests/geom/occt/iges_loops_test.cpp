// SPDX-License-Identifier: BSD-3-Clause
// A ring with a flat on its seam, through IGES files.
#include "geom/occt/iges_loops.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Interface_Static.hxx>
#include <gp_Ax2.hxx>

#include <cmath>
#include <filesystem>

#include "geom/occt/read_part.h"
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

}  // namespace
}  // namespace octet
