// SPDX-License-Identifier: BSD-3-Clause
// What is smaller than asked for is taken away, told by name, and the part stays closed.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "geom/model_check.h"
#include "geom/occt/edge_uses.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/hairlines.h"
#include "geom/occt/read_part.h"

namespace octet::test {
namespace {

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape(); }

/// The block less the corner at (1, 0, 1) beyond these points.
TopoDS_Shape cut_off(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
  BRepBuilderAPI_MakePolygon triangle(a, b, c, true);
  const TopoDS_Face plane = BRepBuilderAPI_MakeFace(triangle.Wire(), true);
  const TopoDS_Shape half = BRepPrimAPI_MakeHalfSpace(plane, gp_Pnt(1.0, 0.0, 1.0)).Solid();
  return BRepAlgoAPI_Cut(block(), half).Shape();
}

TopoDS_Edge first_edge(const TopoDS_Shape& shape) {
  return TopoDS::Edge(TopExp_Explorer(shape, TopAbs_EDGE).Current());
}

Model read(const TopoDS_Shape& shape, double smallest) {
  ReadOptions options;
  options.smallest_feature = smallest;
  return model_from_shape(shape, options);
}

std::string notes_of(const Model& model) {
  std::string all;
  for (const std::string& note : model.notes()) all += note + "\n";
  return all;
}

void expect_counts(const Model& model, std::array<int, 3> counts, double volume, double slack) {
  for (int dim = 0; dim < 3; ++dim) EXPECT_EQ(model.count(dim), counts[static_cast<std::size_t>(dim)]) << dim;
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, volume, slack);
  EXPECT_TRUE(model.parts().faults.empty());
}

TEST(Defeature, ANarrowChamfer) {
  const TopoDS_Shape box = block();
  BRepFilletAPI_MakeChamfer chamfer(box);
  chamfer.Add(0.01, first_edge(box));
  const Model kept = read(chamfer.Shape(), 0.0), gone = read(chamfer.Shape(), 0.05);
  expect_counts(kept, {10, 15, 7}, 1.0 - 0.5e-4, 1e-9);
  expect_counts(gone, {8, 12, 6}, 1.0, 1e-2);
  EXPECT_NE(notes_of(gone).find("became edges: Face "), std::string::npos) << notes_of(gone);
}

TEST(Defeature, ANarrowFillet) {
  const TopoDS_Shape box = block();
  BRepFilletAPI_MakeFillet fillet(box);
  fillet.Add(0.02, first_edge(box));
  expect_counts(read(fillet.Shape(), 0.01), {10, 15, 7}, 1.0, 1e-3);
  expect_counts(read(fillet.Shape(), 0.05), {8, 12, 6}, 1.0, 1e-2);
}

/// Where a pin stands on a block that is wider by `step` on all sides.
TopoDS_Shape square_ledge(double step) {
  const TopoDS_Shape pin =
      BRepPrimAPI_MakeBox(gp_Pnt(step, step, 1.0), gp_Pnt(1.0 - step, 1.0 - step, 2.0)).Shape();
  return BRepAlgoAPI_Fuse(block(), pin).Shape();
}

TopoDS_Shape round_ledge(double step) {
  const gp_Ax2 top(gp_Pnt(0.0, 0.0, 1.0), gp::DZ(), gp::DX());
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape(),
                          BRepPrimAPI_MakeCylinder(top, 1.0 - step, 1.0).Shape())
      .Shape();
}

TEST(Defeature, ANarrowLedgeAllAround) {
  expect_counts(read(square_ledge(0.01), 0.0), {16, 24, 11}, 1.0 + 0.98 * 0.98, 1e-9);
  const Model square = read(square_ledge(0.01), 0.02), round = read(round_ledge(0.01), 0.02);
  expect_counts(square, {12, 20, 10}, 2.0, 0.05);
  EXPECT_NE(
      notes_of(square).find("1 face(s) of Solid 1 are rings no wider than 0.02 mm and became edges: Face "),
      std::string::npos)
      << notes_of(square);
  EXPECT_EQ(check_model(square), "");
  expect_counts(read(round_ledge(0.01), 0.0), {4, 6, 5}, std::numbers::pi * (1.0 + 0.99 * 0.99), 1e-9);
  expect_counts(round, {3, 5, 4}, 2.0 * std::numbers::pi, 0.15);
  EXPECT_EQ(check_model(round), "");
}

TEST(Defeature, ALedgeThatIsAsWideStays) {
  expect_counts(read(square_ledge(0.1), 0.05), {16, 24, 11}, 1.0 + 0.8 * 0.8, 1e-9);
}

TEST(Defeature, ASmallFaceAtACorner) {
  const TopoDS_Shape part = cut_off({0.99, 0, 1}, {1, 0.01, 1}, {1, 0, 0.99});
  expect_counts(read(part, 0.0), {10, 15, 7}, 1.0 - 1e-6 / 6.0, 1e-12);
  const Model gone = read(part, 0.05);
  expect_counts(gone, {8, 12, 6}, 1.0, 1e-2);
  EXPECT_NE(notes_of(gone).find("Face "), std::string::npos) << notes_of(gone);
}

TEST(Defeature, AShortEdgeBetweenLargeFaces) {
  const TopoDS_Shape part = cut_off({0.01, 0, 1}, {1, 0.5, 1}, {1, 0, 0.5});
  expect_counts(read(part, 0.0), {10, 15, 7}, 1.0 - 0.99 * 0.5 * 0.5 / 6.0, 1e-9);
  const Model gone = read(part, 0.05);
  expect_counts(gone, {9, 14, 7}, 1.0 - 0.5 * 0.5 / 6.0, 1e-2);
  EXPECT_NE(notes_of(gone).find("1 edge(s) of Solid 1 are no longer than 0.05 mm and became vertices: Edge "),
            std::string::npos)
      << notes_of(gone);
}

TEST(Defeature, NothingThatIsAsLarge) {
  const TopoDS_Shape part = cut_off({0.5, 0, 1}, {1, 0.5, 1}, {1, 0, 0.5});
  const Model model = read(part, 0.4);
  expect_counts(model, {10, 15, 7}, 1.0 - 0.125 / 6.0, 1e-9);
  EXPECT_EQ(notes_of(model).find("no longer than"), std::string::npos) << notes_of(model);
}

/// A face with other loops in the place of a face's outer one.
TopoDS_Face with_edges(const TopoDS_Face& face, const std::vector<TopoDS_Edge>& edges) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge);
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied().Oriented(TopAbs_FORWARD));
  builder.Add(made, wire);
  return TopoDS::Face(made.Oriented(face.Orientation()));
}

std::vector<TopoDS_Edge> edges_of(const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer it(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); it.More(); it.Next())
    edges.push_back(TopoDS::Edge(it.Current()));
  return edges;
}

/// A block one of whose edges is two: its faces there have one each, as far apart as `bulge`, and what is
/// between them is a spike of the face at the edges' end.
TopoDS_Shape block_with_spike(double bulge) {
  const TopoDS_Shape box = block();
  const TopoDS_Edge edge = first_edge(box);
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(box, TopAbs_EDGE, TopAbs_FACE, faces_of);
  const TopoDS_Face one = TopoDS::Face(faces_of.FindFromKey(edge).First()),
                    two = TopoDS::Face(faces_of.FindFromKey(edge).Last());
  const TopoDS_Vertex from = TopExp::FirstVertex(edge), to = TopExp::LastVertex(edge);
  const gp_Pnt a = BRep_Tool::Pnt(from), b = BRep_Tool::Pnt(to);
  // In face two, whose middle tells the way.
  gp_XYZ inner;
  for (const TopoDS_Edge& side : edges_of(two))
    inner += 0.25 * BRep_Tool::Pnt(TopExp::FirstVertex(side)).XYZ();
  const gp_XYZ middle = 0.5 * (a.XYZ() + b.XYZ());
  const gp_Pnt bulged(middle + bulge * (inner - middle).Normalized());
  const TopoDS_Edge other = BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, bulged, b).Value(), from, to);
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  bool has_spike = false;
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next()) {
    TopoDS_Face face = TopoDS::Face(it.Current());
    std::vector<TopoDS_Edge> edges = edges_of(face);
    const auto way_in = [&](const TopoDS_Face& of) {
      for (const TopoDS_Edge& side : edges_of(of))
        if (side.IsSame(edge)) return TopAbs::Compose(side.Orientation(), of.Orientation());
      return TopAbs_EXTERNAL;
    };
    if (face.IsSame(two)) {
      for (TopoDS_Edge& side : edges)
        if (side.IsSame(edge)) side = TopoDS::Edge(other.Oriented(side.Orientation()));
      face = with_edges(face, edges);
    } else if (!face.IsSame(one) && !has_spike) {
      const auto has = [&](const TopoDS_Vertex& v) {
        for (const TopoDS_Edge& side : edges)
          if (TopExp::FirstVertex(side).IsSame(v) || TopExp::LastVertex(side).IsSame(v)) return true;
        return false;
      };
      if (!has(from) && !has(to)) {
        builder.Add(shell, face);
        continue;
      }
      // What face two had of the edge, and the other way round for the new one.
      const TopAbs_Orientation way = TopAbs::Compose(way_in(two), face.Orientation());
      edges.push_back(TopoDS::Edge(edge.Oriented(way)));
      edges.push_back(TopoDS::Edge(other.Oriented(TopAbs::Reverse(way))));
      face = with_edges(face, edges);
      has_spike = true;
    }
    builder.Add(shell, face);
  }
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TEST(Defeature, ASpikeOfAFace) {
  const TopoDS_Shape part = block_with_spike(1e-4);
  ASSERT_EQ(edge_uses(part).first(&Uses::open), 0);
  ASSERT_EQ(edge_uses(part).first(&Uses::turned), 0);
  EXPECT_TRUE(close_hairlines(part, 0.5e-4).entities.empty()) << "it is wider";
  const Repair closed = close_hairlines(part, 2e-4);
  EXPECT_EQ(closed.entities.size(), 1u);
  EXPECT_EQ(edge_uses(closed.solid).first(&Uses::open), 0);
  EXPECT_EQ(edge_uses(closed.solid).edges.Extent(), 12);
  const Model model = read(part, 2e-4);
  expect_counts(model, {8, 12, 6}, 1.0, 1e-3);
  EXPECT_NE(notes_of(model).find(
                "1 edge(s) of Solid 1 were sides of spikes or slits no wider than their tolerance, or than "
                "0.0002 mm"),
            std::string::npos)
      << notes_of(model);
}

TEST(Defeature, ASpikeThatRoundingLeavesIsClosedUnasked) {
  expect_counts(read(block_with_spike(1e-6), 0.0), {8, 12, 6}, 1.0, 1e-5);
}

TEST(Defeature, ARodIsNoFeature) {
  const Model rod = read(BRepPrimAPI_MakeCylinder(1.0, 10.0).Shape(), 3.0);
  expect_counts(rod, {2, 3, 3}, 10.0 * M_PI, 1e-9);
  EXPECT_NE(notes_of(rod).find("Solid 1 keeps 2 small face(s)"), std::string::npos) << notes_of(rod);
}

TopoDS_Shape shape_of(const char* path) {
  STEPControl_Reader reader;
  if (reader.ReadFile(path) != IFSelect_RetDone || reader.TransferRoots() < 1) return {};
  return reader.OneShape();
}

Model read_bracket(double smallest) {
  ReadOptions options;
  options.smallest_feature = smallest;
  return read_part(OCTET_MODELS "/bracket.step", options);
}

/// Its fillet of radius 6 becomes an edge that one of its faces does not reach.
TEST(Defeature, LessWhereAllWouldSpoilAFace) {
  const Model whole = read_bracket(0.0), model = read_bracket(8.0);
  EXPECT_NE(notes_of(model).find("features smaller than 8 mm cannot all be taken away, for "),
            std::string::npos)
      << notes_of(model);
  EXPECT_NE(notes_of(model).find("those smaller than 4 mm were"), std::string::npos) << notes_of(model);
  EXPECT_EQ(check_model(model), "");
  EXPECT_NEAR(model.region(1).volume, whole.region(1).volume, 0.05 * whole.region(1).volume);
}

/// Where a solid is left out that was whole, the part is spoilt, too; one that was open all along is no
/// reason.
TEST(Defeature, LessWhereASolidWouldBeLost) {
  BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(10.5, 0.0, 0.0), 4.0, 4.0, 4.0).Shape());
  builder.Add(both, shape_of(OCTET_MODELS "/l_domain.step"));
  const Model model = read(both, 4.761);
  EXPECT_EQ(model.count(3), 2);
  EXPECT_TRUE(model.parts().faults.empty());
  EXPECT_NE(notes_of(model).find("those smaller than 2.381 mm were"), std::string::npos) << notes_of(model);
}

}  // namespace
}  // namespace octet::test
