// SPDX-License-Identifier: BSD-3-Clause
// The families, in OCCT's words.
#include "tests/support/families.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "tests/support/hook.h"
#include "tests/support/with_void.h"

namespace octet::test {
namespace {

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape rod(const gp_Pnt& foot, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, along), radius, length).Shape();
}

TopoDS_Shape ball(double x, double radius) { return BRepPrimAPI_MakeSphere(gp_Pnt(x, 0, 0), radius).Shape(); }

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

TopoDS_Shape side_by_side(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, a);
  builder.Add(both, b);
  return both;
}

/// A block with a step and a void of which an edge lies in the step's inner edge.
TopoDS_Shape void_at_an_edge() {
  const TopoDS_Shape step = fuse(box(0, 0, 0, 4, 4, 2), box(0, 0, 2, 2, 4, 2));
  return with_void(step, box(0.7, 1.2, 0.8, 1.3, 1.5, 1.2));
}

/// A block with a hole much narrower than an octant, half round and aslant.
TopoDS_Shape slanted_half_hole() {
  TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({1.5, 1.8, -1}, gp::DZ()), 0.23, 5, M_PI);
  gp_Trsf tilt;
  tilt.SetRotation(gp_Ax1({1.5, 1.8, 1.3}, gp_Dir(1, 0.3, 0)), 0.3);
  drill = BRepBuilderAPI_Transform(drill, tilt, true).Shape();
  return cut(box(0, 0, 0, 4, 4, 2.7), drill);
}

/// A block with blind holes much narrower than an octant, made of halves.
TopoDS_Shape halved_blind_holes() {
  TopoDS_Shape block = box(0, 0, 0, 4, 4, 2.7);
  for (int i = 0; i < 4; ++i)
    for (const int side : {1, -1}) {
      const gp_Pnt bottom(1.5 + 0.95 * (i % 2), 1.8 + 0.9 * (i / 2), 1.2 - 0.11 * i);
      const gp_Ax2 axes(bottom, gp::DZ(), side * gp::DX());
      block = cut(block, BRepPrimAPI_MakeCylinder(axes, 0.23, 2, M_PI));
    }
  return block;
}

/// A block with a round boss, and below the boss a void of its radius: a circle is all that they share.
TopoDS_Shape boss_over_void() {
  const TopoDS_Shape block = fuse(box(-2, -2, 0, 4, 4, 2), rod({0, 0, 2}, gp::DZ(), 1, 1));
  const TopoDS_Shape hollow = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 2}, -gp::DZ(), gp::DY()), 1, 1.2);
  return with_void(block, hollow);
}

gp_Pnt middle_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return gp_Pnt(0.5 * (box.CornerMin().XYZ() + box.CornerMax().XYZ()));
}

TopoDS_Edge arc_between(const TopoDS_Edge& edge, const gp_Pnt& through) {
  const TopoDS_Vertex from = TopExp::FirstVertex(edge), to = TopExp::LastVertex(edge);
  const GC_MakeArcOfCircle arc(BRep_Tool::Pnt(from), through, BRep_Tool::Pnt(to));
  return BRepBuilderAPI_MakeEdge(arc.Value(), from, to).Edge();
}

/// A block whose top goes beyond its middle, turns back in a lune and turns again: three sheets in one plane.
TopoDS_Shape folded_top() {
  const TopoDS_Shape block = fuse(box(0, 0, 0, 2, 3, 1.5), box(2, 0, 0, 2, 3, 1.5));
  TopoDS_Edge middle;
  for (TopExp_Explorer it(block, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
    const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                 to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (from.X() == 2 && to.X() == 2 && from.Z() == 1.5 && to.Z() == 1.5)
      middle = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  }
  const TopoDS_Edge beyond = arc_between(middle, gp_Pnt(2.2, 1.5, 1.5)),
                    before = arc_between(middle, gp_Pnt(1.9, 1.5, 1.5));
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (TopExp_Explorer it(block, TopAbs_FACE); it.More(); it.Next()) {
    BRepTools_ReShape reshape;
    const bool left = middle_of(it.Current()).X() < 2.0;
    reshape.Replace(middle, left ? beyond : before);
    const bool is_top = middle_of(it.Current()).Z() > 1.4;
    builder.Add(shell, is_top ? reshape.Apply(it.Current()) : it.Current());
  }
  const TopoDS_Wire lune = BRepBuilderAPI_MakeWire(before, TopoDS::Edge(beyond.Reversed())).Wire();
  const TopoDS_Face fold = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(2, 0, 1.5), gp::DZ()), lune).Face();
  builder.Add(shell, fold.Reversed());
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TopoDS_Shape plate(double thickness) { return box(0, 0, 0, 2.5, 1.7, thickness); }

TopoDS_Shape wedge(double angle) {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(0, 0, 0), gp_Pnt(4, 0, 0),
                                      gp_Pnt(4 * std::cos(angle), 4 * std::sin(angle), 0), true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape(), gp_Vec(0, 0, 3)).Shape();
}

/// What two balls share whose surfaces meet at `angle` in a circle of radius 3.
TopoDS_Shape lens(double angle) {
  const double radius = 3.0 / std::sin(0.5 * angle), away = 3.0 / std::tan(0.5 * angle);
  return BRepAlgoAPI_Common(ball(-away, radius), ball(away, radius)).Shape();
}

TopoDS_Shape tube(double wall) {
  return cut(rod({0, 0, 0}, gp::DZ(), 1.2, 1.5), rod({0, 0, -1}, gp::DZ(), 1.2 - wall, 4));
}

/// A rod lying on a block and sunk into it by `depth`: two grooves with sharp bottoms.
TopoDS_Shape sunk_rod(double depth) {
  return fuse(box(0, 0, 0, 6, 5, 1), rod({1, 2.5, 2.5 - depth}, gp::DX(), 1.5, 4));
}

/// A roof over a rod, 0.003 from its crown, that ends just beyond it: an edge over a face that it does not
/// bound.
TopoDS_Shape roof_over_rod() {
  const TopoDS_Shape stand = fuse(box(0, 0, 0, 3, 4, 0.5), box(0, 3.2, 0, 3, 0.8, 3));
  const TopoDS_Shape roof = fuse(stand, box(0, 1.2, 2.503, 3, 2.8, 0.497));
  return fuse(roof, rod({0, 1.5, 1.4}, gp::DX(), 1.1, 3));
}

/// A block with a round lower edge, and under it a foot whose top is hollowed by a cylinder across: at one
/// corner three sheets touch the plane of the bottom, none of them at an angle.
TopoDS_Shape foot_under_round() {
  const TopoDS_Shape block = fuse(box(-1.5, 0, 0, 3, 2, 2), rod({-1.5, 0, 1}, gp::DX(), 1, 3));
  const TopoDS_Shape foot = cut(box(-0.2, -0.2, 0, 0.2, 0.4, 0.2), rod({0, -1, 1}, gp::DY(), 1, 3));
  return fuse(block, foot);
}

/// A block with a round side, and on it a boss that stands out over the round, which touches its foot's
/// plane: at either end of the overhang a corner of 14 degrees over a gap that closes as its square.
TopoDS_Shape boss_over_round() {
  const TopoDS_Shape block = fuse(box(-1.5, 0, 0, 3, 2, 2), rod({-1.5, 0, 1}, gp::DX(), 1, 3));
  return fuse(block, rod({0, 1, 2}, gp::DZ(), 1.03, 1));
}

/// A cone on its base of radius 1, `angle` of a whole one.
TopoDS_Shape sharp_cone(double height, double angle = 2.0 * std::numbers::pi) {
  return BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 0), gp::DZ()), 1.0, 0.0, height, angle).Shape();
}

/// A rod with a hole along it whose wall is `wall` thick at its thinnest.
TopoDS_Shape eccentric_hole(double wall) {
  return cut(rod({0, 0, 0}, gp::DZ(), 2, 3), rod({1 - wall, 0, -1}, gp::DZ(), 1, 5));
}

TopoDS_Shape perforated(int rows, int columns) {
  const gp_Pln plane(gp::XOY());
  BRepBuilderAPI_MakePolygon rim(gp_Pnt(0, 0, 0), gp_Pnt(columns, 0, 0), gp_Pnt(columns, rows, 0),
                                 gp_Pnt(0, rows, 0), true);
  BRepBuilderAPI_MakeFace face(plane, rim.Wire());
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const gp_Circ circle(gp_Ax2(gp_Pnt(i + 0.5, j + 0.5, 0), gp::DZ()), 0.3);
      face.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire().Reversed()));
    }
  return BRepPrimAPI_MakePrism(face.Shape(), gp_Vec(0, 0, 0.5)).Shape();
}

TopoDS_Shape comb(int teeth, double tooth, double gap) {
  TopoDS_Shape part = box(0, 0, 0, teeth * (tooth + gap), 2, 1);
  for (int i = 0; i < teeth; ++i) part = cut(part, box(i * (tooth + gap) + tooth, 0.7, -1, gap, 3, 3));
  return part;
}

/// A profile swept along a helix of radius 2.
TopoDS_Shape helix(const TopoDS_Wire& profile, double pitch, double turns) {
  const Handle(Geom_CylindricalSurface) cylinder = new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), 2.0);
  const double full = 2.0 * std::numbers::pi;
  const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(full, pitch));
  TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, cylinder, 0.0, turns * std::hypot(full, pitch)).Edge();
  BRepLib::BuildCurves3d(edge);
  BRepOffsetAPI_MakePipeShell sweep(BRepBuilderAPI_MakeWire(edge).Wire());
  sweep.SetMode(gp::DZ());
  sweep.Add(profile);
  sweep.Build();
  sweep.MakeSolid();
  return sweep.Shape();
}

TopoDS_Shape spring() {
  const gp_Circ circle(gp_Ax2(gp_Pnt(2, 0, 0), gp::DY()), 0.4);
  return helix(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)).Wire(), 1.5, 1.5);
}

/// A sharp ridge in a helix: the tooth of a thread.
TopoDS_Shape thread() {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(2, 0, -0.35), gp_Pnt(2, 0, 0.35), gp_Pnt(2.5, 0, 0), true);
  return helix(triangle.Wire(), 0.8, 1.5);
}

TopoDS_Shape rounded_box(double radius) {
  const TopoDS_Shape part = box(0, 0, 0, 2, 1.5, 1.2);
  BRepFilletAPI_MakeFillet fillet(part);
  for (TopExp_Explorer edge(part, TopAbs_EDGE); edge.More(); edge.Next())
    fillet.Add(radius, TopoDS::Edge(edge.Current()));
  return fillet.Shape();
}

/// A roof z = 2 + x y / 20 whose parameter lines are bent: y = 5 v + 6 u (1 - u). Its straight sides at
/// constant y are bent in (u,v), by more than an element.
TopoDS_Shape skewed_roof() {
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  const double bend[4] = {0, 2, 2, 0}, lift[4] = {0, 0, 12, 0};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j)
      poles(i + 1, j + 1) = gp_Pnt(2 * i, 5 * j + bend[i], 2 + (10 * i * j + lift[i]) / 20);
  const TopoDS_Shape roof = BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), 1e-7).Shape();
  const TopoDS_Shape block = BRepPrimAPI_MakePrism(roof, gp_Vec(0, 0, -1)).Shape();
  return BRepAlgoAPI_Common(block, box(0.5, 1.6, -3, 5, 3.2, 9)).Shape();
}

/// A thin solid between two others, as glue is.
TopoDS_Shape layer(double thickness) {
  return side_by_side(side_by_side(box(-1.2, 0, 0, 1.2, 1.5, 1.3), box(0, 0, 0, thickness, 1.5, 1.3)),
                      box(thickness, 0, 0, 1.2, 1.5, 1.3));
}

/// A ball in a coat in a box.
TopoDS_Shape coating(double thickness) {
  const TopoDS_Shape outer = ball(0, 2.0 + thickness);
  return side_by_side(side_by_side(ball(0, 2.0), cut(outer, ball(0, 2.0))),
                      cut(box(-3, -3, -3, 6, 6, 6), outer));
}

TopoDS_Shape ring_of(const TopoDS_Face& section) {
  return BRepPrimAPI_MakeRevol(section, gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ())).Shape();
}

}  // namespace

std::vector<FamilyPart> family_parts() {
  std::vector<FamilyPart> parts;
  const auto add = [&](std::string name, std::function<TopoDS_Shape()> build) {
    parts.push_back({std::move(name), 1.0, std::move(build)});
  };
  add("plate_1", [] { return plate(1); });
  add("plate_0_1", [] { return plate(0.1); });
  add("plate_0_01", [] { return plate(0.01); });
  add("plate_0_001", [] { return plate(0.001); });
  for (const double degrees : {30.0, 10.0, 5.0, 2.0, 1.0, 0.5})
    add("wedge_" + std::to_string(static_cast<int>(10 * degrees)), [=] { return wedge(degrees * kDegree); });
  for (const double degrees : {20.0, 5.0, 1.4})
    add("lens_" + std::to_string(static_cast<int>(10 * degrees)), [=] { return lens(degrees * kDegree); });
  add("tube_0_1", [] { return tube(0.1); });
  add("tube_0_01", [] { return tube(0.01); });
  add("hollow_ball_0_1", [] { return cut(ball(0, 3), ball(0, 2.9)); });
  add("hollow_ball_0_01", [] { return cut(ball(0, 3), ball(0, 2.99)); });
  add("sunk_rod_0_01", [] { return sunk_rod(0.01); });
  add("cusp_1_4", [] { return sunk_rod(1.5 * (1.0 - std::cos(1.4 * kDegree))); });
  add("roof_over_rod", [] { return roof_over_rod(); });
  add("skewed_roof", [] { return skewed_roof(); });
  add("foot_under_round", [] { return foot_under_round(); });
  add("boss_over_round", [] { return boss_over_round(); });
  for (const int height : {5, 20})
    add("sharp_cone_" + std::to_string(height), [=] { return sharp_cone(height); });
  add("sharp_half_cone", [] { return sharp_cone(8, std::numbers::pi); });
  add("sharp_quarter_cone", [] { return sharp_cone(8, 0.5 * std::numbers::pi); });
  add("spike_on_a_block", [] { return fuse(box(-2, -2, -1, 4, 4, 1), sharp_cone(12)); });
  add("sharp_hole", [] { return cut(box(-2, -2, 0, 4, 4, 11), sharp_cone(10)); });
  add("eccentric_hole_0_01", [] { return eccentric_hole(0.01); });
  add("tangent_rods", [] {
    return side_by_side(rod({0, 0, 0}, gp::DZ(), 1.5, 3), rod({3, 0, 0}, gp::DZ(), 1.5, 3));
  });
  add("overlapping_rods", [] {
    return fuse(rod({0, 0, 0}, gp::DZ(), 1.5, 3), rod({2.999, 0, 0}, gp::DZ(), 1.5, 3));
  });
  add("tangent_hole", [] { return eccentric_hole(0.0); });
  add("perforated", [] { return perforated(8, 8); });
  add("comb", [] { return comb(4, 0.1, 0.05); });
  add("spring", [] { return spring(); });
  add("thread", [] { return thread(); });
  add("fillets_0_05", [] { return rounded_box(0.05); });
  add("boxes_at_an_edge", [] { return side_by_side(box(0, 0, 0, 2, 2, 2), box(2, 2, 0, 2, 2, 2)); });
  add("boxes_at_a_vertex", [] { return side_by_side(box(0, 0, 0, 2, 2, 2), box(2, 2, 2, 2, 2, 2)); });
  for (const int per_mille : {100, 10})
    add("layer_" + std::to_string(per_mille), [=] { return layer(1e-3 * per_mille); });
  add("coating_0_01", [] { return coating(0.01); });
  add("small_void", [] { return cut(box(-2, -2, -2, 4, 4, 4), ball(0.37, 0.05)); });
  add("void_at_an_edge", [] { return void_at_an_edge(); });
  add("boss_over_void", [] { return boss_over_void(); });
  add("folded_top", [] { return folded_top(); });
  add("slanted_half_hole", [] { return slanted_half_hole(); });
  add("halved_blind_holes", [] { return halved_blind_holes(); });
  add("balls_at_a_point", [] { return side_by_side(cut(ball(0, 3), ball(1, 2)), ball(1, 2)); });
  // The ball's pole is a vertex within the box's top, which ends none of its edges.
  add("ball_on_a_box", [] { return side_by_side(box(-3, -3, -4, 6, 6, 2), ball(0, 2)); });
  add("needle_bore", [] { return cut(box(0, 0, 0, 2, 2, 2), rod({1.03, 0.9, 1.9}, gp::DZ(), 0.001, 1)); });
  add("tip_on_a_wall", [] { return BRepPrimAPI_MakePrism(hook(0, 1.5, true), gp_Vec(0, 3, 0)).Shape(); });
  add("ring_on_a_wall", [] { return ring_of(hook(1, 1.5, true)); });
  add("ring_flat_on_a_wall", [] { return ring_of(hook(1, 1.5, false)); });
  return parts;
}

TopoDS_Shape turned(const TopoDS_Shape& shape, int turn) {
  if (turn == 0) return shape;
  gp_Trsf rotation;
  if (turn == 1)
    rotation.SetRotation(gp_Ax1(gp_Pnt(0.3, -0.2, 0.7), gp_Dir(1, 2, 3)), 0.7);
  else
    rotation.SetRotation(gp_Ax1(gp_Pnt(-0.1, 0.4, 0.2), gp_Dir(-2, 1, 0.5)), 2.1);
  return BRepBuilderAPI_Transform(shape, rotation, true).Shape();
}

}  // namespace octet::test
