// SPDX-License-Identifier: BSD-3-Clause
// Adjacency, edge uses, orientation and Euler characteristics of the sample parts.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Vec.hxx>
#include <gp_Vec2d.hxx>

#include <algorithm>
#include <map>
#include <set>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

const char* const kSamples[] = {"ball", "blade", "box",      "box_minus_ball",  "bracket",
                                "cone", "torus", "cylinder", "plate_with_hole", "two_boxes"};

TEST(Topology, EulerCharacteristicsOfFacesAreThoseOfTheirPointSets) {
  EXPECT_EQ(sample("ball").face(1).euler, 2);
  EXPECT_EQ(sample("torus").face(1).euler, 0);
  const Model cylinder = sample("cylinder");
  std::multiset<int> sides;
  for (int tag = 1; tag <= 3; ++tag) sides.insert(cylinder.face(tag).euler);
  EXPECT_EQ(sides, (std::multiset<int>{0, 1, 1}));
  const Model cone = sample("cone");
  EXPECT_EQ(cone.face(1).euler, 1);
  EXPECT_EQ(cone.face(2).euler, 1);
}

TEST(Topology, EulerCharacteristicsAgreeWithTheWeldedFacets) {
  for (const char* name : kSamples) {
    const Model model = sample(name);
    const Facets& facets = model.facets();
    std::map<int, std::set<std::uint32_t>> nodes;
    std::map<int, std::set<std::pair<std::uint32_t, std::uint32_t>>> edges;
    std::map<int, int> triangles;
    for (std::size_t i = 0; i < facets.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = facets.triangles[i][k], b = facets.triangles[i][(k + 1) % 3];
        nodes[facets.face[i]].insert(a);
        edges[facets.face[i]].insert(std::minmax(a, b));
        triangles[facets.face[i]] += k == 0 ? 1 : 0;
      }
    for (int tag = 1; tag <= model.count(2); ++tag)
      EXPECT_EQ(model.face(tag).euler,
                static_cast<int>(nodes[tag].size()) - static_cast<int>(edges[tag].size()) + triangles[tag])
          << name << " face " << tag;
  }
}

TEST(Topology, SeamsAndPolesAreNotRealEdges) {
  const Model ball = sample("ball");
  EXPECT_EQ(count_edges(ball, EdgeUse::kReal), 0);
  EXPECT_EQ(count_edges(ball, EdgeUse::kSeam), 1);
  EXPECT_EQ(count_edges(ball, EdgeUse::kDegenerate), 2);
  EXPECT_EQ(count_edges(sample("torus"), EdgeUse::kSeam), 2);
  EXPECT_EQ(count_edges(sample("cylinder"), EdgeUse::kReal), 2);
  EXPECT_EQ(count_edges(sample("box"), EdgeUse::kReal), 12);
}

TEST(Topology, NormalsPointOutOfTheFirstSolid) {
  for (const char* name : kSamples) {
    const Model model = sample(name);
    for (int tag = 1; tag <= model.count(2); ++tag)
      EXPECT_NE(model.face(tag).region[0], 0) << name << " face " << tag;
  }
  const Model void_in_box = sample("box_minus_ball");
  for (int tag = 1; tag <= void_in_box.count(2); ++tag) {
    if (std::string(void_in_box.surface(tag).kind()) != "sphere") continue;
    const Foot foot = void_in_box.face_closest(tag, {0.0, 20.0, 1.0});
    EXPECT_LT(foot.normal.dot(foot.point), 0.0) << "out of the solid is into the void";
  }
}

TEST(Topology, TwoBoxesShareOneFaceWithBothRegions) {
  const Model model = sample("two_boxes");
  int shared = 0;
  for (int tag = 1; tag <= model.count(2); ++tag)
    if (model.face(tag).region == std::array<int, 2>{1, 2}) ++shared;
  EXPECT_EQ(shared, 1);
  EXPECT_EQ(model.region(1).faces.size(), 6u);
  EXPECT_EQ(model.region(2).faces.size(), 6u);
}

TEST(Topology, AdjacencyAgreesInBothDirections) {
  for (const char* name : kSamples) {
    const Model model = sample(name);
    for (int tag = 1; tag <= model.count(1); ++tag) {
      const ModelEdge& edge = model.edge(tag);
      for (const int face : edge.faces) {
        const auto& sides = model.face(face).boundary;
        EXPECT_TRUE(
            std::any_of(sides.begin(), sides.end(), [&](const FaceBoundary& b) { return b.edge == tag; }));
      }
      if (edge.use == EdgeUse::kDegenerate) continue;
      for (const int v : edge.vertex) {
        const auto& edges = model.vertex(v).edges;
        EXPECT_TRUE(std::binary_search(edges.begin(), edges.end(), tag));
      }
    }
  }
}

TEST(Topology, EveryRealEdgeOfASolidBoundsItsTwoFacesInOppositeDirections) {
  for (const char* name : {"box", "bracket", "plate_with_hole", "box_minus_ball", "blade"}) {
    const Model model = sample(name);
    std::vector<int> sum(static_cast<std::size_t>(model.count(1)) + 1, 0);
    for (int tag = 1; tag <= model.count(2); ++tag)
      for (const FaceBoundary& side : model.face(tag).boundary) sum[side.edge] += side.sense;
    for (int tag = 1; tag <= model.count(1); ++tag) {
      if (model.edge(tag).use == EdgeUse::kReal) {
        EXPECT_EQ(sum[tag], 0) << name << " edge " << tag;
      }
    }
  }
}

TEST(Topology, TheFaceLiesToTheLeftOfItsBoundary) {
  for (const char* name : {"box", "bracket", "plate_with_hole", "cylinder"}) {
    const Model model = sample(name);
    for (int tag = 1; tag <= model.count(2); ++tag)
      for (const FaceBoundary& side : model.face(tag).boundary) {
        const ModelEdge& edge = model.edge(side.edge);
        if (edge.use != EdgeUse::kReal) continue;
        const double t = edge.t0 + 0.4 * (edge.t1 - edge.t0);
        const Vec3 p = model.edge_point(side.edge, t);
        const Vec3 along = side.sense * model.edge_derivative(side.edge, t).normalized();
        const FaceFoot foot = model.face_project(tag, p);
        const Vec3 left = foot.normal.cross(along);
        const double step = 1e-3 * edge.length;
        const FaceFoot inside = model.face_project(tag, p + step * left, foot.uv);
        EXPECT_EQ(model.face_side(tag, inside.uv), TrimSide::kIn)
            << name << " face " << tag << " edge " << side.edge;
      }
  }
}

TEST(Topology, EverySampleKeepsTheInvariantsOfAModel) {
  for (const char* name : kSamples) EXPECT_EQ(check_model(sample(name)), "") << name;
}

TEST(Topology, TolerancesAreMeasured) {
  const Model model = sample("bracket");
  for (int tag = 1; tag <= model.count(1); ++tag) EXPECT_LT(model.edge(tag).tolerance, 1e-5);
  for (int tag = 1; tag <= model.count(0); ++tag) EXPECT_LT(model.vertex(tag).tolerance, 1e-5);
}

/// A drop whose cusp is the seam of a periodic spline, drawn out.
TopoDS_Shape drawn_out_drop() {
  TColgp_Array1OfPnt poles(1, 7);
  const double at[7][2] = {{4, 0}, {2, 0.2}, {-2, 2}, {-4, 0}, {-2, -2}, {2, -0.2}, {4, 0}};
  for (int i = 0; i < 7; ++i) poles(i + 1) = gp_Pnt(at[i][0], at[i][1], 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger times(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = 0.1 * (i - 1);
    times(i) = i == 2 ? 3 : 4;
  }
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, times, 3);
  curve->SetPeriodic();
  const TopoDS_Face drop =
      BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve).Edge()).Wire()).Face();
  return BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakePrism(drop, gp_Vec(0, 0, 3)).Shape(), true).Shape();
}

/// Makes the spline periodic, and moves the side of the seam at the period's end beyond it by what a file's
/// digits may.
void run_beyond_the_period(const TopoDS_Shape& shape) {
  const BRep_Builder builder;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face face = TopoDS::Face(f.Current().Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(e.Current().Oriented(TopAbs_FORWARD));
      if (!BRep_Tool::IsClosed(edge, face)) continue;
      const auto spline = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face));
      ASSERT_FALSE(spline.IsNull());
      spline->SetUPeriodic();
      double first = 0.0, last = 0.0;
      Handle(Geom2d_Curve)
          sides[2] = {BRep_Tool::CurveOnSurface(edge, face, first, last),
                      BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Reversed()), face, first, last)};
      for (Handle(Geom2d_Curve) & side : sides) {
        side = Handle(Geom2d_Curve)::DownCast(side->Copy());
        if (side->Value(first).X() > 0.1) side->Translate(gp_Vec2d(1e-15, 0));
      }
      builder.UpdateEdge(edge, sides[0], sides[1], face, BRep_Tool::Tolerance(edge));
      return;
    }
  }
}

TEST(Topology, ACuspAtTheSeamOfAPeriodicSplineIsAnEdge) {
  for (const bool beyond : {false, true}) {
    const TopoDS_Shape shape = drawn_out_drop();
    if (beyond) run_beyond_the_period(shape);
    const Model model = model_from_shape(shape);
    int alone = 0;
    for (int e = 1; e <= model.count(1); ++e) {
      EXPECT_EQ(model.edge(e).use, EdgeUse::kReal) << beyond;
      alone += model.edge(e).faces.size() == 1 ? 1 : 0;
    }
    EXPECT_EQ(alone, 1) << beyond;
  }
}

}  // namespace
}  // namespace octet::test
