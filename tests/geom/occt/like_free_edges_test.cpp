// SPDX-License-Identifier: BSD-3-Clause
// Faces that have edges of their own in one place, between the same vertices, come to share one.
#include "geom/occt/like_free_edges.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "geom/occt/added_curve.h"
#include "geom/occt/free_edges.h"
#include "geom/occt/gathered.h"

namespace octet {
namespace {

/// The first edge of a solid between two faces, and the second of these.
struct Shared {
  TopoDS_Edge edge;
  TopoDS_Face face;
};

Shared first_shared(const TopoDS_Shape& solid) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndUniqueAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int i = 1; i <= faces_of.Extent(); ++i)
    if (faces_of(i).Extent() == 2)
      return {TopoDS::Edge(faces_of.FindKey(i).Oriented(TopAbs_FORWARD)), TopoDS::Face(faces_of(i).Last())};
  return {};
}

/// The solid's faces, the shared edge of the one replaced by another one between the same vertices.
TopoDS_Shape torn(const TopoDS_Shape& solid, const Shared& shared, const TopoDS_Edge& own, bool along) {
  BRepTools_ReShape changes;
  changes.Replace(shared.edge, own.Oriented(along ? TopAbs_FORWARD : TopAbs_REVERSED));
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(it.Current().IsSame(shared.face) ? changes.Apply(it.Current()) : it.Current());
  add_curve(own, TopoDS::Face(changes.Apply(shared.face)));
  return shell_of(faces);
}

/// What is left free once pairs are joined.
std::size_t free_after(const TopoDS_Shape& shape, double near, std::size_t pairs) {
  BRepTools_ReShape changes;
  EXPECT_EQ(join_like_free_edges(shape, near, changes), pairs);
  const TopoDS_Shape joined = changes.Apply(shape);
  EXPECT_TRUE(pairs == 0 || BRepCheck_Analyzer(joined).IsValid());
  return free_edges(joined).size();
}

TEST(LikeFreeEdges, OneOfTwoStandsForBoth) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape(),
                     cylinder = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
  for (const TopoDS_Shape& solid : {box, cylinder}) {
    for (const bool along : {true, false}) {
      const Shared shared = first_shared(solid);
      ASSERT_FALSE(shared.edge.IsNull());
      double first = 0.0, last = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(shared.edge, first, last);
      const TopoDS_Vertex start = TopExp::FirstVertex(shared.edge), end = TopExp::LastVertex(shared.edge);
      const TopoDS_Edge own =
          along ? BRepBuilderAPI_MakeEdge(curve, start, end, first, last)
                : BRepBuilderAPI_MakeEdge(curve->Reversed(), end, start, curve->ReversedParameter(last),
                                          curve->ReversedParameter(first));
      const TopoDS_Shape shape = torn(solid, shared, own, along);
      EXPECT_EQ(free_edges(shape).size(), 2u);
      EXPECT_EQ(free_after(shape, 1e-6, 1), 0u);
      EXPECT_EQ(free_edges(shape).size(), 2u) << "as it was";
      EXPECT_LT(BRep_Tool::Tolerance(shared.edge), 1e-6) << "as it was";
    }
  }
}

/// The faces of a cylinder whose wall has two edges for its seam; or, with `slit`, both on one side of it.
TopoDS_Shape with_two_seams(bool slit) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shape> faces;
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape();
  for (TopExp_Explorer face(cylinder, TopAbs_FACE); face.More(); face.Next()) {
    const TopoDS_Face was = TopoDS::Face(face.Current());
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (TopExp_Explorer it(was, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (!BRep_Tool::IsClosed(edge, was)) {
        builder.Add(wire, edge);
        continue;
      }
      double first = 0.0, last = 0.0;
      const Handle(Geom_Curve) line = BRep_Tool::Curve(edge, first, last);
      const TopoDS_Edge side = TopoDS::Edge(edge.Oriented(slit ? TopAbs_FORWARD : edge.Orientation()));
      const Handle(Geom2d_Curve) on_wall = BRep_Tool::CurveOnSurface(side, was, first, last);
      TopoDS_Edge own =
          BRepBuilderAPI_MakeEdge(line, TopExp::FirstVertex(edge), TopExp::LastVertex(edge), first, last);
      builder.UpdateEdge(own, on_wall, was, BRep_Tool::Tolerance(edge));
      builder.Add(wire, own.Oriented(edge.Orientation()));
    }
    const bool wall = wire.NbChildren() > 1;
    faces.push_back(wall ? was.EmptyCopied() : face.Current());
    if (wall) builder.Add(faces.back(), wire);
  }
  return shell_of(faces);
}

TEST(LikeFreeEdges, TwoEdgesOfOneFaceAreItsSeamButNotASlit) {
  EXPECT_EQ(free_edges(with_two_seams(false)).size(), 2u);
  EXPECT_EQ(free_after(with_two_seams(false), 1e-6, 1), 0u);
  EXPECT_EQ(free_after(with_two_seams(true), 1e-6, 0), 2u);
}

TEST(LikeFreeEdges, EdgesThatRunApartStayTwo) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape();
  const Shared shared = first_shared(box);
  const TopoDS_Vertex start = TopExp::FirstVertex(shared.edge), end = TopExp::LastVertex(shared.edge);
  const gp_Pnt a = BRep_Tool::Pnt(start), b = BRep_Tool::Pnt(end);
  // A hundredth of its length off at its middle, which still lies in the face.
  const gp_Pnt middle(0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()), 0.5 * (a.Z() + b.Z()));
  const gp_Pnt inside = [&] {
    gp_Pnt centre(0.5, 1.0, 1.5);
    for (TopExp_Explorer it(shared.face, TopAbs_VERTEX); it.More(); it.Next()) {
      const gp_Pnt corner = BRep_Tool::Pnt(TopoDS::Vertex(it.Current()));
      if (corner.Distance(a) > 1e-9 && corner.Distance(b) > 1e-9) centre = corner;
    }
    return centre;
  }();
  const gp_Pnt off = middle.Translated(0.01 * gp_Vec(a, inside));
  const TopoDS_Edge own = BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, off, b).Value(), start, end);
  const TopoDS_Shape shape = torn(box, shared, own, true);
  EXPECT_EQ(free_after(shape, 1e-3, 0), 2u);
}

}  // namespace
}  // namespace octet
