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
#include <BRepBuilderAPI_MakeVertex.hxx>
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
#include <gp_Dir.hxx>
#include <gp_Pln.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"
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

/// A solid of plane faces, each a loop of corners; an edge between the same two corners may be there twice.
class Polyhedron {
 public:
  explicit Polyhedron(const std::vector<gp_Pnt>& corners) {
    for (const gp_Pnt& corner : corners) corners_.push_back(BRepBuilderAPI_MakeVertex(corner));
  }
  /// `twin`: the corners whose edge to the next one is the second of two.
  void add(const std::vector<int>& loop, const std::set<std::size_t>& twins = {}) {
    const BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    gp_Vec normal;
    const auto at = [&](std::size_t k) {
      return BRep_Tool::Pnt(corners_[static_cast<std::size_t>(loop[k % loop.size()])]);
    };
    for (std::size_t k = 0; k < loop.size(); ++k) {
      builder.Add(wire, edge(loop[k], loop[(k + 1) % loop.size()], twins.contains(k)));
      normal += gp_Vec(gp::Origin(), at(k)).Crossed(gp_Vec(gp::Origin(), at(k + 1)));
    }
    faces_.push_back(BRepBuilderAPI_MakeFace(gp_Pln(at(0), gp_Dir(normal)), wire, false));
  }
  [[nodiscard]] TopoDS_Shape solid() const { return solid_of(faces_); }

 private:
  TopoDS_Edge edge(int from, int to, bool twin) {
    TopoDS_Edge& edge = edges_[{std::min(from, to), std::max(from, to), twin}];
    if (edge.IsNull())
      edge = BRepBuilderAPI_MakeEdge(corners_[static_cast<std::size_t>(std::min(from, to))],
                                     corners_[static_cast<std::size_t>(std::max(from, to))]);
    return TopoDS::Edge(edge.Oriented(from < to ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  std::vector<TopoDS_Vertex> corners_;
  std::map<std::tuple<int, int, bool>, TopoDS_Edge> edges_;
  std::vector<TopoDS_Face> faces_;
};

TEST(NeckHairlines, PartTheFace) {
  // A base of 3 by 2 by 1 with two towers on it, whose sides at y = 1 are one face: along the base between
  // them it has no height.
  Polyhedron towers({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {0, 2, 1}, {3, 2, 1}, {0, 1, 1},
                     {1, 1, 1}, {2, 1, 1}, {3, 1, 1}, {1, 0, 1}, {2, 0, 1}, {0, 0, 2}, {1, 0, 2},
                     {1, 1, 2}, {0, 1, 2}, {2, 0, 2}, {3, 0, 2}, {3, 1, 2}, {2, 1, 2}});
  towers.add({0, 3, 2, 1});
  towers.add({0, 1, 17, 16, 11, 10, 13, 12});
  towers.add({1, 2, 5, 9, 18, 17});
  towers.add({3, 0, 12, 15, 6, 4});
  towers.add({2, 3, 4, 5});
  towers.add({6, 7, 8, 9, 5, 4}, {1});
  towers.add({10, 11, 8, 7});
  towers.add({10, 7, 14, 13});
  towers.add({8, 11, 16, 19});
  towers.add({12, 13, 14, 15});
  towers.add({16, 17, 18, 19});
  towers.add({8, 7, 6, 15, 14, 7, 8, 19, 18, 9}, {0});
  const TopoDS_Shape solid = towers.solid();
  ASSERT_EQ(edge_uses(solid).first(&Uses::open), 0);
  const Repair closed = close_hairlines(solid, 1e-6);
  EXPECT_EQ(closed.entities.size(), 1u);
  EXPECT_EQ(edge_uses(closed.solid).first(&Uses::open), 0);
  EXPECT_EQ(edge_uses(closed.solid).first(&Uses::turned), 0);
  const Model model = model_from_shape(solid);
  EXPECT_EQ(check_model(model), "");
  EXPECT_EQ(model.count(2), 13);
  EXPECT_NEAR(model.region(1).volume, 8.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Blades, Hairlines, ::testing::Values(1, 2));

}  // namespace
}  // namespace octet::test
