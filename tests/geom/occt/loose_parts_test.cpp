// SPDX-License-Identifier: BSD-3-Clause
// What a fuse leaves inside of one face where nothing ends is taken away, and nothing else.
#include "geom/occt/loose_parts.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>

#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {
namespace {

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(); }

/// Edges in a row along the middle of the face x = 0 of a box, inside of it; returns the face.
TopoDS_Shape add_inside(const TopoDS_Shape& box, int count) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  TopoDS_Vertex from = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0.2, 0.5));
  for (int i = 1; i <= count; ++i) {
    const TopoDS_Vertex to = BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0.2 + 0.2 * i, 0.5));
    builder.Add(wire, BRepBuilderAPI_MakeEdge(from, to).Edge().Oriented(TopAbs_INTERNAL));
    from = to;
  }
  TopoDS_Shape face = sub_shapes(box, TopAbs_FACE)(1).Oriented(TopAbs_FORWARD);
  face.TShape()->Free(true);
  builder.Add(face, wire);
  return face;
}

TEST(LooseParts, ARowOfEdgesThatEndsNowhereGoes) {
  const TopoDS_Shape before = box(), fused = box();
  const TopoDS_Shape face = add_inside(fused, 3);
  ASSERT_EQ(sub_shapes(fused, TopAbs_EDGE).Extent(), 15);
  std::vector<std::vector<TopoDS_Shape>> images{{fused}};
  const Handle(BRepTools_History) history = new BRepTools_History();
  history->AddModified(before, fused);
  history->AddModified(sub_shapes(before, TopAbs_FACE)(1), face);
  drop_loose_parts({before}, images, history);
  EXPECT_EQ(sub_shapes(images[0][0], TopAbs_EDGE).Extent(), 12);
  EXPECT_EQ(sub_shapes(images[0][0], TopAbs_VERTEX).Extent(), 8);
  EXPECT_EQ(sub_shapes(images[0][0], TopAbs_FACE).Extent(), 6);
  EXPECT_NEAR(volume_of(images[0][0]), 1.0, 1e-9);
  EXPECT_TRUE(history->Modified(before).First().IsSame(images[0][0]));
  const TopoDS_Shape now = history->Modified(sub_shapes(before, TopAbs_FACE)(1)).First();
  EXPECT_TRUE(sub_shapes(images[0][0], TopAbs_FACE).Contains(now));
}

TEST(LooseParts, WhatTheSolidsHadStays) {
  const TopoDS_Shape solid = box();
  add_inside(solid, 2);
  std::vector<std::vector<TopoDS_Shape>> images{{solid}};
  const Handle(BRepTools_History) history = new BRepTools_History();
  drop_loose_parts({solid}, images, history);
  EXPECT_TRUE(images[0][0].IsSame(solid));
  EXPECT_EQ(sub_shapes(images[0][0], TopAbs_EDGE).Extent(), 14);
}

TEST(LooseParts, AnEdgeOfTwoFacesStays) {
  // Pieces of a line along which two solids touch: where they meet is told by them alone.
  const TopoDS_Shape one = box(), other = box();
  const TopoDS_Shape face = add_inside(one, 1);
  const BRep_Builder builder;
  TopoDS_Shape opposite = sub_shapes(other, TopAbs_FACE)(1).Oriented(TopAbs_FORWARD);
  opposite.TShape()->Free(true);
  const TopTools_IndexedMapOfShape wires = sub_shapes(face, TopAbs_WIRE);
  builder.Add(opposite, wires(wires.Extent()));
  std::vector<std::vector<TopoDS_Shape>> images{{one}, {other}};
  drop_loose_parts({box(), box()}, images, new BRepTools_History());
  EXPECT_EQ(sub_shapes(images[0][0], TopAbs_EDGE).Extent(), 13);
  EXPECT_EQ(sub_shapes(images[1][0], TopAbs_EDGE).Extent(), 13);
}

}  // namespace
}  // namespace octet::test
