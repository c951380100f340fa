// SPDX-License-Identifier: BSD-3-Clause
// Walls thousands of times thinner than the octants, beside a tangent face: points may come that near.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax2.hxx>

#include <cmath>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

constexpr double kTangency = 12.0;  ///< x where the fillet leaves the plate

/// A block 14 x 10 x 6 whose lower edge at x = 14 is rounded with radius 2: above z = 0 a cusp is left.
TopoDS_Shape rounded_block() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(14, 10, 6)).Shape();
  BRepFilletAPI_MakeFillet fillet(block);
  for (TopExp_Explorer it(block, TopAbs_EDGE); it.More(); it.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(it.Current()));
    const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
    if (middle.Distance(gp_Pnt(14, 5, 0)) > 1e-6) continue;
    fillet.Add(2.0, curve.Edge());
    break;
  }
  return fillet.Shape();
}

/// The block on a plate with a blind hole from below that leaves a wall of so much, and reaches beyond the
/// fillet's tangency by so much.
Model block_on_plate(double wall, double beyond) {
  constexpr double kRadius = 0.7;
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -2), gp_Pnt(20, 10, 0)).Shape();
  const gp_Ax2 axis(gp_Pnt(kTangency + beyond - kRadius, 5, -5), gp::DZ());
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(axis, kRadius, 5.0 - wall).Shape();
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, BRepAlgoAPI_Cut(plate, hole).Shape());
  builder.Add(all, rounded_block());
  return model_from_shape(all);
}

/// Octants stay as large as asked for, so that they do not follow the wall.
void expect_complete(double wall, double beyond, double size) {
  MeshOptions options;
  options.size = options.min_size = size;
  const Model model = block_on_plate(wall, beyond);
  ASSERT_EQ(model.count(3), 2);
  const MeshReport report = mesh_part(model, options).report;
  EXPECT_EQ(report.status, MeshStatus::kComplete) << wall << ' ' << beyond << ' ' << size << ": "
                                                  << (report.faults.empty() ? "" : report.faults[0].cause);
}

TEST(Membrane, OfAThousandthOfTheSizeBesideACusp) {
  expect_complete(1e-3, 0.01, 1.0);
  expect_complete(1e-3, 0.05, 2.0);
  expect_complete(1e-3, 0.2, 3.0);
}

TEST(Membrane, OfAFewThousandthsOfTheSize) {
  expect_complete(5e-4, 0.05, 2.0);
  expect_complete(5e-4, 0.2, 3.0);
}

}  // namespace
}  // namespace octet
