// SPDX-License-Identifier: BSD-3-Clause
// Grooves and ridges that fade out: as wide as the square of the distance from where they end.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>
#include <gp.hxx>

#include "geom/occt/from_shape.h"
#include "tests/support/expect_complete.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

constexpr double kLength = 8.0;

TopoDS_Edge bezier(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = a;
  poles(2) = b;
  poles(3) = c;
  return BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(new Geom_BezierCurve(poles)));
}

/// On the plane z = 0 from the origin along x; half as wide as `width`, and `height` high, where it ends.
TopoDS_Solid fading_ridge(double width, double height) {
  const gp_Pnt tip(0.0, 0.0, 0.0), middle(0.5 * kLength, 0.0, 0.0), left(kLength, -0.5 * width, 0.0),
      top(kLength, 0.0, 2.0 * height), right(kLength, 0.5 * width, 0.0);
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int j = 1; j <= 3; ++j) {
    poles(1, j) = tip;
    poles(2, j) = middle;
    poles(3, j) = j == 1 ? left : j == 2 ? top : right;
  }
  const TopoDS_Edge end = BRepBuilderAPI_MakeEdge(left, right);
  BRepBuilderAPI_MakeWire foot(bezier(tip, middle, left), end, bezier(tip, middle, right)),
      front(end, bezier(left, top, right));
  BRepBuilderAPI_Sewing sewing(1e-6);
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  sewing.Add(BRepBuilderAPI_MakeFace(surface, Precision::Confusion()).Face());
  sewing.Add(BRepBuilderAPI_MakeFace(foot.Wire(), true).Face());
  sewing.Add(BRepBuilderAPI_MakeFace(front.Wire(), true).Face());
  sewing.Perform();
  TopoDS_Solid solid;
  BRep_Builder().MakeSolid(solid);
  BRep_Builder().Add(solid, TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL).Current());
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape block(double z0, double z1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(-2.0, -5.0, z0), gp_Pnt(kLength + 2.0, 5.0, z1)).Shape();
}

TopoDS_Shape grooved(double width, double height) {
  return BRepAlgoAPI_Cut(block(0.0, 5.0), fading_ridge(width, height)).Shape();
}

void expect_closes(const TopoDS_Shape& shape) {
  const Model model = model_from_shape(shape);
  ASSERT_EQ(model.count(2), 8);
  test::expect_complete(model, {0.7, 1.1, 1.8});
}

/// Facets across the groove are nearer to the face beside it than to its bottom, and in that face's plane.
TEST(FadingGroove, Closes) {
  expect_closes(grooved(1.2, 0.5));
  expect_closes(grooved(0.4, 0.2));
}

TEST(FadingGroove, ARidgeCloses) {
  expect_closes(BRepAlgoAPI_Fuse(block(-5.0, 0.0), fading_ridge(0.4, 0.2)).Shape());
}

/// The groove is a tip: near its end its edges have no points, but one long piece each, about which no face
/// has any.
TEST(FadingGroove, NoPointOfAFaceIsAboutAPieceOfAnEdge) {
  const Model model = model_from_shape(grooved(0.4, 0.2));
  OctreeRequest request;
  request.size = 0.3;
  const Octree tree = build_octree(model, request, {});
  const Seeds seeds = test::seed_points(model, tree, request.size);
  double longest = 0.0;
  for (const EdgePiece& piece : seeds.pieces) {
    const Vec3 a = seeds.points.position[piece.a], b = seeds.points.position[piece.b];
    if (piece.edge != 0) longest = std::max(longest, (a - b).norm() / tree.spacing_at(0.5 * (a + b)));
    for (std::size_t i = 0; i < seeds.points.size(); ++i) {
      if (seeds.points.on[i].dim != 2) continue;
      const Vec3 p = seeds.points.position[i];
      EXPECT_GE((p - a).dot(p - b), 0.0) << p.transpose() << " about a piece of Edge " << piece.edge;
    }
  }
  EXPECT_GT(longest, 3.0);
}

/// Its border turns back at the groove's end, within a hundredth of the size.
TEST(FadingGroove, OfAConeKeepsItsEnd) {
  for (const double radius : {0.3835, 0.8584}) {
    const gp_Ax2 axis(gp_Pnt(-4.0, 0.0, 0.2 * radius), gp::DX());
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-10.0, -7.0, -6.0), gp_Pnt(20.0, 7.0, 0.0)).Shape();
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(axis, radius, 0.05 * radius, 20.0).Shape();
    const Model model = model_from_shape(BRepAlgoAPI_Cut(block, cone).Shape());
    test::expect_complete(model, {1.188, 4.949}, std::to_string(radius));
  }
}

}  // namespace
}  // namespace octet
