// SPDX-License-Identifier: BSD-3-Clause
// Spikes of a face that meet each other, or another loop, at both of their ends.
#include "geom/occt/hairlines.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/sub_shapes.h"
#include "geom/occt/touched_edges.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

constexpr double kRadius = 2.0, kDepth = 3.0, kHalf = 0.008, kOut = 1.0, kHeight = 0.5;
constexpr double kVolume = 16.0 * 16.0 * 6.0 - std::numbers::pi * kRadius * kRadius * kDepth / 3.0;
constexpr double kBlade = 2.0 * kHalf * kOut * kHeight;
/// How far the circle has turned away from its tangent at the blade's corners.
constexpr double kSpike = 0.5 * kHalf * kHalf / kRadius;

/// A block with a conical pocket in its top, and a blade on that, whose end wall touches the pocket's rim:
/// the top narrows to nothing between the two on either side of the place. `blades`: 1 or 2, the second
/// across the pocket.
TopoDS_Shape blades_beside_a_pocket(int blades) {
  const gp_Ax2 axes(gp_Pnt(0, 0, -kDepth), gp::DZ(), gp_Dir(0, 1, 0));
  TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-8, -8, -6), gp_Pnt(8, 8, 0)).Shape(),
                                       BRepPrimAPI_MakeCone(axes, 0.0, kRadius, kDepth).Shape());
  for (const double side : {1.0, -1.0}) {
    if (side < 0.0 && blades < 2) break;
    const TopoDS_Shape blade = BRepPrimAPI_MakeBox(gp_Pnt(side * kRadius, -kHalf, 0.0),
                                                   gp_Pnt(side * (kRadius + kOut), kHalf, kHeight));
    shape = BRepAlgoAPI_Fuse(shape, blade);
  }
  return TopExp_Explorer(shape, TopAbs_SOLID).Current();
}

int edges_at(const Model& model, const Vec3& place) {
  for (int v = 1; v <= model.count(0); ++v)
    if ((model.vertex(v).point - place).norm() < 1e-6) return static_cast<int>(model.vertex(v).edges.size());
  return 0;
}

class Hairlines : public ::testing::TestWithParam<int> {};

TEST_P(Hairlines, ThatMeetAreClosed) {
  const int blades = GetParam();
  const TopoDS_Shape part = blades_beside_a_pocket(blades);
  const Repair split = split_touched_edges(part, 2.0 * kSpike);
  ASSERT_FALSE(split.entities.empty());
  EXPECT_TRUE(close_hairlines(split.solid, 0.1 * kSpike).entities.empty()) << "they are wider";
  const Repair closed = close_hairlines(split.solid, 2.0 * kSpike);
  EXPECT_EQ(closed.entities.size(), static_cast<std::size_t>(2 * blades));
  EXPECT_EQ(edge_uses(closed.solid).first(&Uses::open), 0);
  EXPECT_EQ(edge_uses(closed.solid).first(&Uses::turned), 0);
}

TEST_P(Hairlines, ThatMeetLeaveAModelWithoutThem) {
  const int blades = GetParam();
  const Model model = model_from_shape(blades_beside_a_pocket(blades));
  EXPECT_TRUE(has_note(model, "were sides of spikes or slits"));
  EXPECT_EQ(check_model(model), "");
  // The end wall's lower side in two, shared with the cone.
  EXPECT_EQ(edges_at(model, {kRadius, 0.0, 0.0}), 2);
  EXPECT_EQ(edges_at(model, {kRadius, kHalf, 0.0}), 4);
  EXPECT_NEAR(model.region(1).volume, kVolume + blades * kBlade, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Blades, Hairlines, ::testing::Values(1, 2));

}  // namespace
}  // namespace octet::test
