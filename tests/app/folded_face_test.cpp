// SPDX-License-Identifier: BSD-3-Clause
// A wing whose surface is one face that runs from its sharp trailing edge around to the same.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>

#include <cmath>
#include <numbers>

#include "app/mesh_part.h"
#include "geom/creases.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

/// An airfoil of four digits, symmetric, at height z; the trailing edge is sharp.
TopoDS_Wire airfoil(double chord, double thickness, double z) {
  constexpr int kSide = 20;
  const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, 2 * kSide + 1);
  for (int i = 0; i <= 2 * kSide; ++i) {
    const double x = 0.5 * (1.0 + std::cos(std::numbers::pi * i / kSide));
    const double y =
        5.0 * thickness *
        (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1036 * x * x * x * x);
    const bool ends = i == 0 || i == 2 * kSide;
    places->SetValue(i + 1, gp_Pnt(chord * x, ends ? 0.0 : chord * (i < kSide ? y : -y), z));
  }
  GeomAPI_Interpolate spline(places, false, 1e-9);
  spline.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline.Curve()));
}

Model wing() {
  BRepOffsetAPI_ThruSections loft(true);
  loft.AddWire(airfoil(15.0, 0.12, 0.0));
  loft.AddWire(airfoil(11.0, 0.12, 20.0));
  return model_from_shape(loft.Shape());
}

TEST(FoldedFace, AWingOfOneFaceMeetsItselfAndIsMeshedAtAnySize) {
  const Model model = wing();
  ASSERT_EQ(model.count(2), 3);
  int folded = 0;
  for (int face = 1; face <= 3; ++face) folded += meets_itself(model, face) ? 1 : 0;
  EXPECT_EQ(folded, 1);
  for (const double size : {2.0, 1.0}) {
    MeshOptions options;
    options.size = size;
    const MeshResult result = mesh_part(model, options);
    EXPECT_EQ(result.report.status, MeshStatus::kComplete)
        << size << ": " << (result.report.faults.empty() ? "" : result.report.faults[0].cause);
    EXPECT_LT(result.report.attribute_points, result.report.nodes / 20) << size;
  }
}

}  // namespace
}  // namespace octet
