// SPDX-License-Identifier: BSD-3-Clause
// Bodies that share nothing are meshed by themselves.
#include "app/apart.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>

#include "geom/analytic.h"
#include "geom/bodies.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/size_attributes.h"

namespace octet {
namespace {

Model touching_boxes(bool fuse) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, BRepPrimAPI_MakeBox(2, 2, 2).Shape());
  builder.Add(all, BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 0), gp_Pnt(3, 1, 1)).Shape());
  ReadOptions options;
  options.fuse = fuse;
  return model_from_shape(all, options);
}

TEST(Apart, BodiesAreModelsOfTheirOwn) {
  const Model model = touching_boxes(false);
  const std::vector<Model> bodies = take_apart(model);
  ASSERT_EQ(bodies.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    const Model& body = bodies[b];
    EXPECT_TRUE(check_model(body).empty());
    EXPECT_EQ(body.count(3), 1);
    EXPECT_EQ(body.count(2), 6);
    const int whole = bodies[b].parts().whole_tag[3][1];
    EXPECT_EQ(whole, static_cast<int>(b) + 1);
    EXPECT_EQ(body.describe(model_region(1)), model.describe(model_region(whole)));
    EXPECT_EQ(body.region(1).volume, model.region(whole).volume);
    for (int v = 1; v <= body.count(0); ++v)
      EXPECT_EQ(body.vertex(v).point,
                model.vertex(bodies[b].parts().whole_tag[0][static_cast<std::size_t>(v)]).point);
  }
}

TEST(Apart, FusedSolidsThatTouchAreOneBody) { EXPECT_EQ(take_apart(touching_boxes(true)).size(), 1u); }

TEST(Apart, EveryBodyIsMeshedAndJudgedByItself) {
  const Model model = touching_boxes(false);
  MeshOptions options;
  options.size = 0.5;
  Observer silent;
  MeshResult result = mesh_apart(model, options, silent);
  EXPECT_EQ(result.report.status, MeshStatus::kComplete);
  EXPECT_NEAR(result.report.volume, 9.0, 1e-9);
  EXPECT_EQ(result.report.tets, result.mesh.tets.size());
  EXPECT_TRUE(accept_apart(result.mesh, model).holds());
  // The same places of the two bodies are two vertices: for the whole that is a fault.
  EXPECT_FALSE(accept_mesh(result.mesh, model).holds());
  result.mesh.tets.pop_back();
  result.mesh.tet_in.pop_back();
  EXPECT_FALSE(accept_apart(result.mesh, model).holds());
}

TEST(Apart, EdgesThatHaveAnotherNumberOfElementsAreToldByTheWholesNumbers) {
  MeshOptions options;
  options.size = 0.1;
  options.attributes = {parse_size_attribute("Edge14=/2")};
  const MeshResult result = mesh_part(touching_boxes(false), options);
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes.front().find("Edge14 has "), std::string::npos)
      << result.report.notes.front();
}

/// The shares of a run as it tells them.
class Shares : public Observer {
 public:
  void stage(std::string_view name, double fraction) override {
    told.push_back(fraction);
    if (name == "finalization") ++tries;
  }
  std::vector<double> told;
  int tries = 0;
};

TEST(Apart, ProgressGoesOnFromBodyToBody) {
  Shares shares;
  MeshOptions options;
  options.size = 0.5;
  (void)mesh_part(touching_boxes(false), options, shares);
  EXPECT_TRUE(std::is_sorted(shares.told.begin(), shares.told.end()));
  // The second of two bodies begins half-way.
  EXPECT_TRUE(std::count(shares.told.begin(), shares.told.end(), 0.5) > 0);
}

TEST(Apart, ProgressGoesOnFromTryToTry) {
  Shares shares;
  MeshOptions options;
  options.target_elements = 5000.0;
  options.curvature_angle = 0.3;
  (void)mesh_part(analytic_torus(1.2, 0.4, {{}, 1e-3}), options, shares);
  EXPECT_GT(shares.tries, 1);
  EXPECT_TRUE(std::is_sorted(shares.told.begin(), shares.told.end()));
  EXPECT_LE(shares.told.back(), 1.0);
}

TEST(Apart, ABodyIsNoCoarserThanItWouldBeByItself) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  builder.Add(all, BRepPrimAPI_MakeBox(1e5, 1e5, 1e5).Shape());
  builder.Add(all, BRepPrimAPI_MakeBox(gp_Pnt(2e5, 0, 0), 0.1, 0.1, 0.1).Shape());
  ReadOptions options;
  options.fuse = false;
  const Model model = model_from_shape(all, options);
  const MeshResult unasked = mesh_part(model);
  EXPECT_EQ(unasked.report.status, MeshStatus::kComplete);
  EXPECT_GT(std::count(unasked.mesh.tet_in.begin(), unasked.mesh.tet_in.end(), 2), 500);
  MeshOptions asked;
  asked.size = 1e4;
  const MeshResult coarse = mesh_part(model, asked);
  EXPECT_EQ(coarse.report.size, 1e4);
  EXPECT_LT(std::count(coarse.mesh.tet_in.begin(), coarse.mesh.tet_in.end(), 2), 100);
}

}  // namespace
}  // namespace octet
