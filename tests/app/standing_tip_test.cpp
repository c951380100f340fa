// SPDX-License-Identifier: BSD-3-Clause
// Cones that stand by their apex on a face of another solid.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include <cmath>

#include "geom/occt/from_shape.h"
#include "tests/support/expect_complete.h"

namespace octet {
namespace {

TEST(StandingTip, OfFifteenDegreesIsMeshed) {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(20.0, 20.0, 10.0).Shape());
  const gp_Ax2 axes(gp_Pnt(20.0, 10.0, 5.0), gp_Dir(1.0, 0.0, 0.0));
  builder.Add(both, BRepPrimAPI_MakeCone(axes, 0.0, 2.6, 10.0).Shape());
  const Model model = model_from_shape(both);
  ASSERT_EQ(model.count(3), 2);
  // Of 40 sizes, each a twentieth smaller than the last, those at which it was open without a ring of points.
  test::expect_complete(model, {2.85, 3.0 * std::pow(0.95, 33), 3.0 * std::pow(0.95, 34)}, "a cone on a box");
}

}  // namespace
}  // namespace octet
