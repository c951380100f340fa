// SPDX-License-Identifier: BSD-3-Clause
// A hyperbola turned about an axis or drawn out, through STEP and BREP and back.
#include "geom/occt/bounded_sweeps.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools.hxx>
#include <Geom_Hyperbola.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <filesystem>
#include <gp.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Vec.hxx>

#include "geom/model_check.h"
#include "geom/occt/read_part.h"
#include "geom/occt/silence.h"

namespace octet::test {
namespace {

/// What lies between a branch of the hyperbola x^2 - y^2 = 1 and a chord.
TopoDS_Face cap() {
  const Handle(Geom_Hyperbola) hyperbola = new Geom_Hyperbola(gp_Ax2(gp::Origin(), gp::DZ()), 1.0, 1.0);
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(hyperbola, -1.0, 1.0);
  const TopoDS_Edge chord = BRepBuilderAPI_MakeEdge(TopExp::FirstVertex(arc), TopExp::LastVertex(arc));
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(arc, chord).Wire()).Face();
}

/// Turned about the chord's parallel at x = 3 by a third.
TopoDS_Shape turned() {
  return BRepPrimAPI_MakeRevol(cap(), gp_Ax1(gp_Pnt(3, 0, 0), gp::DY()), 2.0 * kPi / 3.0).Shape();
}

double area() { return std::cosh(1.0) * std::sinh(1.0) - 1.0; }

/// By Pappus: the area times the way of its centroid.
double turned_volume() {
  const double moment =
      2.0 * (std::pow(std::sinh(1.0), 3) / 3.0);  // of the area about x = 0: integral of x dA
  return 2.0 * kPi / 3.0 * (3.0 * area() - moment);
}

void expect_volume(const TopoDS_Shape& shape, double volume) {
  for (const char* suffix : {".step", ".brep"}) {
    const auto path =
        std::filesystem::temp_directory_path() /
        (std::string("octet_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + suffix);
    if (path.extension() == ".step") {
      const Silence silence;
      STEPControl_Writer writer;
      ASSERT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
      ASSERT_EQ(writer.Write(path.c_str()), IFSelect_RetDone);
    } else {
      ASSERT_TRUE(BRepTools::Write(shape, path.c_str()));
    }
    const Model model = read_part(path);
    std::filesystem::remove(path);
    EXPECT_NEAR(model.region(1).volume, volume, 1e-7) << suffix;
    EXPECT_EQ(check_model(model), "") << suffix;
  }
}

TEST(BoundedSweeps, AHyperbolaTurnedAboutAnAxisIsRead) { expect_volume(turned(), turned_volume()); }

TEST(BoundedSweeps, AHyperbolaDrawnOutAskewIsRead) {
  expect_volume(BRepPrimAPI_MakePrism(cap(), gp_Vec(0.5, 0.3, 2)).Shape(), 2.0 * area());
}

}  // namespace
}  // namespace octet::test
