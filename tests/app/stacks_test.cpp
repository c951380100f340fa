// SPDX-License-Identifier: BSD-3-Clause
// Bodies of many layers far thinner than the octants: laminates, coats on coats.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <vector>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

Model assembled(const std::vector<TopoDS_Shape>& solids) {
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& solid : solids) builder.Add(all, solid);
  return model_from_shape(all);
}

MeshReport meshed(const Model& model, double size) {
  MeshOptions options;
  options.size = size;
  return mesh_part(model, options).report;
}

Model laminate(int layers, double thickness) {
  std::vector<TopoDS_Shape> solids;
  for (int i = 0; i < layers; ++i)
    solids.push_back(
        BRepPrimAPI_MakeBox(gp_Pnt(0, 0, i * thickness), gp_Pnt(6, 4, (i + 1) * thickness)).Shape());
  return assembled(solids);
}

/// A block of 4 x 3 x 2 in coats, each around the one before.
Model coated(int coats, double thickness) {
  const auto block = [&](int coat) {
    const double t = coat * thickness;
    return BRepPrimAPI_MakeBox(gp_Pnt(-t, -t, -t), gp_Pnt(4 + t, 3 + t, 2 + t)).Shape();
  };
  std::vector<TopoDS_Shape> solids{block(0)};
  for (int coat = 1; coat <= coats; ++coat)
    solids.push_back(BRepAlgoAPI_Cut(block(coat), block(coat - 1)).Shape());
  return assembled(solids);
}

TEST(Stacks, OfManyLayersNeedNoAttributePoints) {
  for (const double thickness : {0.05, 0.1}) {
    const Model model = laminate(10, thickness);
    ASSERT_EQ(model.count(3), 10);
    const MeshReport report = meshed(model, 0.5);
    EXPECT_EQ(report.status, MeshStatus::kComplete) << thickness;
    EXPECT_EQ(report.attribute_points, 0u) << thickness;
  }
}

TEST(Stacks, OfCoatsNeedHardlyAnyAttributePoints) {
  const Model model = coated(2, 0.05);
  ASSERT_EQ(model.count(3), 3);
  const MeshReport report = meshed(model, 0.4);
  EXPECT_EQ(report.status, MeshStatus::kComplete);
  EXPECT_LT(report.attribute_points, 500u) << "16 000 where pairs of sheets alone have partners";
}

}  // namespace
}  // namespace octet
