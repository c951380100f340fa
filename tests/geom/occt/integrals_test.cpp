// SPDX-License-Identifier: BSD-3-Clause
// Areas and volumes of curved parts against their formulas.
#include "geom/occt/integrals.h"

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "geom/occt/from_shape.h"

namespace octet {
namespace {

double area_of(const Model& model) {
  double area = 0.0;
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  return area;
}

TEST(Integrals, OfABoxRoundedByCylindersAndSpheres) {
  const Vec3 size(40.0, 30.0, 20.0);
  for (const double radius : {0.5, 4.0}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(size.x(), size.y(), size.z()).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer e(box, TopAbs_EDGE); e.More(); e.Next())
      fillet.Add(radius, TopoDS::Edge(e.Current()));
    const Model model = model_from_shape(fillet.Shape());
    ASSERT_EQ(model.count(2), 26);
    const Vec3 core = size - Vec3::Constant(2.0 * radius);
    const double sides = core.x() * core.y() + core.y() * core.z() + core.z() * core.x(),
                 square = radius * radius;
    const double area = 2.0 * sides + 2.0 * M_PI * radius * core.sum() + 4.0 * M_PI * square;
    const double volume =
        core.prod() + 2.0 * radius * sides + M_PI * square * core.sum() + 4.0 / 3.0 * M_PI * square * radius;
    EXPECT_NEAR(area_of(model), area, 1e-9 * area);
    EXPECT_NEAR(model.region(1).volume, volume, 1e-9 * volume);
  }
}

TEST(Integrals, OfARing) {
  const Model ring = model_from_shape(BRepPrimAPI_MakeTorus(10.0, 3.0).Shape());
  const double area = 4.0 * M_PI * M_PI * 30.0, volume = 2.0 * M_PI * M_PI * 90.0;
  EXPECT_NEAR(area_of(ring), area, 1e-9 * area);
  EXPECT_NEAR(ring.region(1).volume, volume, 1e-9 * volume);
}

}  // namespace
}  // namespace octet
