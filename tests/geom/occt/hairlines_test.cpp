// SPDX-License-Identifier: BSD-3-Clause
// Spikes of a face that meet each other, or another loop, at both of their ends.
#include "geom/occt/hairlines.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <gp.hxx>
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

constexpr double kHole = 2.0;

/// A block with a hole, and a pocket from above whose sharp side ends on the hole's seam: along that line the
/// solid touches itself.
TopoDS_Shape pocket_beside_a_hole() {
  const gp_Ax2 axes(gp_Pnt(0, 0, -1), gp::DZ(), gp::DX());
  const TopoDS_Shape block = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-5, -5, 0), gp_Pnt(5, 5, 3)).Shape(),
                                             BRepPrimAPI_MakeCylinder(axes, kHole, 5.0).Shape());
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(kHole, 0, 1), gp_Pnt(kHole + 2, -1, 1), gp_Pnt(kHole + 2, 1, 1),
                                      true);
  const TopoDS_Shape pocket =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape(), gp_Vec(0, 0, 5)).Shape();
  return TopExp_Explorer(BRepAlgoAPI_Cut(block, pocket), TopAbs_SOLID).Current();
}

bool is_line_of_contact(const TopoDS_Edge& edge) {
  TopoDS_Vertex a, b;
  TopExp::Vertices(edge, a, b);
  const auto at = [](const TopoDS_Vertex& v, double z) {
    return BRep_Tool::Pnt(v).Distance(gp_Pnt(kHole, 0, z)) < 1e-6;
  };
  return (at(a, 1) && at(b, 3)) || (at(a, 3) && at(b, 1));
}

/// The solid with an edge for either side of the line, as other CAD systems write it.
TopoDS_Shape with_two_edges(const TopoDS_Shape& solid) {
  const BRep_Builder builder;
  Handle(BRepTools_ReShape) changes = new BRepTools_ReShape;
  TopoDS_Edge line;
  for (TopExp_Explorer it(solid, TopAbs_EDGE); it.More(); it.Next())
    if (is_line_of_contact(TopoDS::Edge(it.Current()))) line = TopoDS::Edge(it.Current());
  TopoDS_Vertex a, b;
  TopExp::Vertices(line, a, b);
  const TopoDS_Edge first = BRepBuilderAPI_MakeEdge(a, b), second = BRepBuilderAPI_MakeEdge(a, b);
  bool turned = false;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
    const bool round = BRepAdaptor_Surface(face).GetType() == GeomAbs_Cylinder;
    for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
      TopoDS_Wire made;
      builder.MakeWire(made);
      bool changed = false;
      for (TopoDS_Iterator it(wires.Current()); it.More(); it.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(it.Value());
        if (!edge.IsSame(line)) {
          builder.Add(made, edge);
          continue;
        }
        changed = true;
        // One of the planes and one side of the hole have each.
        const bool forward = edge.Orientation() == TopAbs_FORWARD;
        const TopoDS_Edge& own = (round ? forward : turned) ? first : second;
        double t0 = 0.0, t1 = 0.0;
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, t0, t1);
        builder.UpdateEdge(own, new Geom2d_TrimmedCurve(curve, t0, t1), face, 1e-7);
        builder.Range(own, face, t0, t1);
        builder.SameRange(own, false);
        builder.SameParameter(own, false);
        builder.Add(made, own.Oriented(edge.Orientation()));
      }
      if (changed) changes->Replace(wires.Current(), made);
      if (changed && !round) turned = !turned;
    }
  }
  const TopoDS_Shape parted = changes->Apply(solid);
  BRepLib::SameParameter(parted, 1e-7, true);
  return parted;
}

int uses_of_contact(const TopoDS_Shape& solid) {
  int most = 0;
  const EdgeUses all = edge_uses(solid);
  for (int i = 1; i <= all.edges.Extent(); ++i)
    if (is_line_of_contact(TopoDS::Edge(all.edges(i))))
      most = std::max(most, all.uses[static_cast<std::size_t>(i)].forward +
                                all.uses[static_cast<std::size_t>(i)].reversed);
  return most;
}

TEST(SeamHairlines, BecomeAPieceOfTheSeam) {
  const TopoDS_Shape whole = pocket_beside_a_hole();
  ASSERT_EQ(uses_of_contact(whole), 4);
  const TopoDS_Shape parted = with_two_edges(whole);
  ASSERT_EQ(uses_of_contact(parted), 2);
  ASSERT_EQ(edge_uses(parted).first(&Uses::open), 0);
  const Repair closed = close_hairlines(parted, 1e-6);
  EXPECT_EQ(closed.entities.size(), 1u);
  EXPECT_EQ(uses_of_contact(closed.solid), 4);
  const Model model = model_from_shape(parted), same = model_from_shape(whole);
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.count(1), same.count(1));
  EXPECT_EQ(model.region_at({kHole - 0.01, 0, 2}), 0);
  EXPECT_EQ(model.region_at({kHole + 0.01, 0, 2}), 0);
  EXPECT_EQ(model.region_at({kHole, 0.1, 2}), 1);
  EXPECT_EQ(model.region_at({kHole, -0.1, 2}), 1);
  EXPECT_NEAR(model.region(1).volume, same.region(1).volume, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Blades, Hairlines, ::testing::Values(1, 2));

}  // namespace
}  // namespace octet::test
