// SPDX-License-Identifier: BSD-3-Clause
// Sharp tips that are not round: cones squeezed flat, and lofts that end in a point.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <gp_GTrsf.hxx>

#include <string>

#include "geom/occt/from_shape.h"
#include "octree/tips.h"
#include "tests/support/expect_complete.h"

namespace octet {
namespace {

constexpr double kRadius = 3.0, kHeight = 35.0;

TopoDS_Shape flat_cone(double share) {
  gp_GTrsf squeeze;
  squeeze.SetValue(2, 2, share);
  return BRepBuilderAPI_GTransform(BRepPrimAPI_MakeCone(kRadius, 0.0, kHeight).Solid(), squeeze, true);
}

/// Over a closed spline through four points.
TopoDS_Shape loft_to_a_point() {
  const Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, 4);
  places->SetValue(1, gp_Pnt(3.0, 0.0, 0.0));
  places->SetValue(2, gp_Pnt(0.0, 1.5, 0.0));
  places->SetValue(3, gp_Pnt(-3.0, 0.3, 0.0));
  places->SetValue(4, gp_Pnt(0.0, -1.0, 0.0));
  GeomAPI_Interpolate curve(places, true, 1e-7);
  curve.Perform();
  BRepOffsetAPI_ThruSections loft(true);
  loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve())));
  loft.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0.0, 1.0, 30.0)));
  return loft.Shape();
}

void expect_complete(const std::string& name, const TopoDS_Shape& shape) {
  test::expect_complete(model_from_shape(shape), {2.0, 1.0}, name);
}

TEST(FlatTips, AreMeasuredEitherWay) {
  const Model model = model_from_shape(flat_cone(0.5));
  OctreeRequest request;
  request.size = 1.0;
  const Tips tips(model, build_octree(model, request, {}));
  ASSERT_EQ(tips.all().size(), 1u);
  const Tip& tip = tips.all().front();
  EXPECT_NEAR(std::abs(tip.along.z()), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(tip.across.x()), 1.0, 1e-6);
  EXPECT_NEAR(tip.taper, kRadius / kHeight, 1e-6);
  EXPECT_NEAR(tip.lesser_taper, 0.5 * kRadius / kHeight, 1e-6);
  for (const Vec3& place : ring_places(model, tip)) {
    const auto p = ring_point(model, tip, tip.faces.front(), place);
    ASSERT_TRUE(p);
    EXPECT_LT((*p - place).norm(), 1e-6 * tip.reach) << "the ring is on the cone";
  }
}

TEST(FlatTips, AConeSqueezedFlatCloses) {
  for (const double share : {0.8, 0.5}) expect_complete(std::to_string(share), flat_cone(share));
}

TEST(FlatTips, ALoftThatEndsInAPointCloses) { expect_complete("loft", loft_to_a_point()); }

}  // namespace
}  // namespace octet
