// SPDX-License-Identifier: BSD-3-Clause
// Parts about the z axis: shafts, flanges, screws, springs, gears, wheels.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Circ.hxx>

#include "base/constants.h"
#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace octet::test {
namespace {

/// A profile of steps, tapers and grooves from the axis or a bore outwards.
TopoDS_Shape steps(Draw& draw, double radius, double bore) {
  std::vector<gp_Pnt> corners{{bore, 0, 0}};
  double z = 0, r = bore;
  for (int i = draw.count(2, 6); i > 0; --i) {
    r = bore + (radius - bore) * draw.length(0.2, 1.0);
    corners.emplace_back(r, 0, z);
    z += radius * draw.length(0.05, 1.5);
    if (draw.chance(0.25)) r = bore + (radius - bore) * draw.length(0.15, 1.0);
    corners.emplace_back(r, 0, z);
  }
  corners.emplace_back(bore, 0, z);
  std::vector<gp_Pnt> kept;
  for (const gp_Pnt& p : corners)
    if (kept.empty() || p.Distance(kept.back()) > 1e-3 * radius) kept.push_back(p);
  const double round = draw.chance(0.5) ? 0.0 : radius * draw.length(0.01, 0.05);
  return revolved(rounded_polygon(kept, bore > 0 ? round : 0.0),
                  draw.chance(0.15) ? draw.between(0.5, 6.0) : 2 * kPi);
}

TopoDS_Shape with_bolt_circle(TopoDS_Shape part, Draw& draw, double circle, double r, double z,
                              double depth) {
  const int n = draw.count(2, 8);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * kPi * i / n;
    part = cut(part, rod({circle * std::cos(t), circle * std::sin(t), z}, gp::DZ(), r, depth));
  }
  return part;
}

TopoDS_Shape shaft(Draw& draw) {
  const double radius = draw.scaled(0.5, 100),
               bore = draw.chance(0.6) ? radius * draw.length(0.05, 0.6) : 0.0;
  TopoDS_Shape part = steps(draw, radius, bore);
  const double length = extent_of(part).high.Z();
  if (draw.chance(0.5))  // a keyway, open at the end or not
    part = cut(part, box({0.7 * radius, -0.1 * radius, draw.chance(0.5) ? -1.0 : 0.3 * length}, radius,
                         0.2 * radius, draw.length(0.2, 0.6) * length));
  if (draw.chance(0.4))  // a cross hole, on the axis or off it
    part = cut(part, rod({-2 * radius, draw.chance(0.5) ? 0.0 : draw.length(0, 0.9) * radius,
                          draw.length(0.1, 0.9) * length},
                         gp::DX(), radius * draw.length(0.05, 0.3), 4 * radius));
  if (draw.chance(0.4))
    part = with_bolt_circle(part, draw, radius * draw.length(0.4, 1.0), radius * draw.length(0.03, 0.2), -1,
                            draw.chance(0.5) ? 2 * length : 0.5 * length);
  if (draw.chance(0.3))
    part = cut(part, BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, 0.5 * length}, gp::DZ()), 0.95 * radius,
                                           radius * draw.length(0.05, 0.2))
                         .Shape());
  if (draw.chance(0.3))
    part = cut(part, box({-radius, radius * draw.length(0.5, 0.95), -1}, 2 * radius, radius,
                         draw.length(0.2, 1.0) * length));  // a flat
  if (draw.chance(0.5)) part = blended(part, draw, radius * draw.scaled(0.01, 0.2), 0.3);
  return part;
}

/// A flange on a pipe, with bolts, ribs and fillets.
TopoDS_Shape flange(Draw& draw) {
  const double r = draw.scaled(5, 200), wall = r * draw.scaled(0.03, 0.3), rim = r * draw.length(1.4, 2.2),
               thick = r * draw.length(0.1, 0.4), height = r * draw.length(0.5, 3);
  TopoDS_Shape part = fuse(rod({0, 0, 0}, gp::DZ(), rim, thick), rod({0, 0, 0}, gp::DZ(), r + wall, height));
  const int ribs = draw.chance(0.5) ? draw.count(2, 6) : 0;
  for (int i = 0; i < ribs; ++i) {
    const double w = r * draw.length(0.05, 0.2);
    const TopoDS_Shape rib = extruded(rounded_polygon({{0.9 * r, -w / 2, 0.5 * thick},
                                                       {rim, -w / 2, 0.5 * thick},
                                                       {rim, -w / 2, thick},
                                                       {r + wall, -w / 2, 0.8 * height},
                                                       {0.9 * r, -w / 2, 0.8 * height}},
                                                      0),
                                      {0, w, 0});
    part = fuse(part, moved(rib, turn(gp_Ax1(gp_Pnt(), gp::DZ()), 2 * kPi * i / ribs)));
  }
  part = cut(part, rod({0, 0, -1}, gp::DZ(), r, height + 2));
  if (draw.chance(0.6))
    part = blended(part, draw, std::min(wall, thick) * draw.length(0.1, 0.5), draw.scaled(0.1, 1.0));
  return with_bolt_circle(part, draw, 0.5 * (r + wall + rim), (rim - r - wall) * draw.length(0.1, 0.55), -1,
                          2 * thick + 2);
}

TopoDS_Wire helix(double r, double pitch, double turns, double z, double taper) {
  Handle(Geom_Surface) surface;
  if (taper == 0.0)
    surface = new Geom_CylindricalSurface(gp_Ax3({0, 0, z}, gp::DZ()), r);
  else
    surface = new Geom_ConicalSurface(gp_Ax3({0, 0, z}, gp::DZ()), taper, r);
  const Handle(Geom2d_TrimmedCurve) line =
      GCE2d_MakeSegment(gp_Pnt2d(0, 0), gp_Pnt2d(2 * kPi * turns, pitch * turns)).Value();
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, surface).Edge();
  BRepLib::BuildCurve3d(edge, 1e-5, GeomAbs_C1, 14, 200);
  return BRepBuilderAPI_MakeWire(edge).Wire();
}

TopoDS_Shape swept_along(const TopoDS_Wire& spine, const TopoDS_Wire& profile, bool about_z) {
  BRepOffsetAPI_MakePipeShell pipe(spine);
  if (about_z) pipe.SetMode(gp_Dir(0, 0, 1));
  pipe.Add(profile);
  pipe.Build();
  pipe.MakeSolid();
  return pipe.Shape();
}

TopoDS_Shape spring(Draw& draw) {
  const double r = draw.scaled(1, 50), wire = r * draw.length(0.05, 0.3),
               pitch = wire * draw.length(2.1, 5.0);
  const TopoDS_Wire spine =
      helix(r, pitch, draw.length(1, 6), 0, draw.chance(0.3) ? draw.between(-0.2, 0.2) : 0.0);
  const TopoDS_Wire circle =
      BRepBuilderAPI_MakeWire(
          BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({r, 0, 0}, gp_Dir(0, 2 * kPi * r, pitch)), wire)))
          .Wire();
  if (draw.chance(0.6)) return swept_along(spine, circle, true);
  const double w = wire * draw.length(0.5, 1.5);
  return swept_along(
      spine,
      polygon({{r - w, 0, -wire / 2}, {r + w, 0, -wire / 2}, {r + w, 0, wire / 2}, {r - w, 0, wire / 2}}),
      true);
}

/// A screw: a thread cut into or raised on a rod, with a head.
TopoDS_Shape screw(Draw& draw) {
  const double r = draw.scaled(1, 30), pitch = r * draw.length(0.2, 0.6), depth = 0.5 * pitch,
               turns = draw.length(2, 7);
  const double length = pitch * (turns + 3);
  TopoDS_Shape body = rod({0, 0, 0}, gp::DZ(), r, length);
  if (draw.chance(0.5)) body = blended(body, draw, 0.2 * r, 0.5);
  const bool raised = draw.chance(0.5);
  const double out = raised ? r + depth : r + 0.1 * pitch, in = raised ? r - 0.1 * pitch : r - depth;
  const double foot = 0.4 * pitch, tip = draw.chance(0.3) ? 0.01 * pitch : 0.1 * pitch, z = pitch;
  const double low = raised ? foot : tip, high = raised ? tip : foot;  // half widths inside and outside
  const TopoDS_Shape thread = swept_along(
      helix(r, pitch, turns, z, 0),
      polygon({{in, 0, z - low}, {out, 0, z - high}, {out, 0, z + high}, {in, 0, z + low}}), true);
  TopoDS_Shape part = raised ? fuse(body, thread) : cut(body, thread);
  if (draw.chance(0.7)) {
    const double head = r * draw.length(1.5, 2.0), high_head = r * draw.length(0.6, 1.4);
    std::vector<gp_Pnt> six;
    for (int i = 0; i < 6; ++i)
      six.emplace_back(head * std::cos(kPi * i / 3), head * std::sin(kPi * i / 3), length);
    TopoDS_Shape top = extruded(rounded_polygon(six, 0), {0, 0, high_head});
    if (draw.chance(0.5))
      top = common(
          top, frustum({0, 0, length}, gp::DZ(), head + 0.8 * high_head, head - 0.2 * high_head, high_head));
    part = fuse(part, top);
    if (draw.chance(0.4))
      part = cut(part, box({-2 * r, -0.1 * r, length + 0.5 * high_head}, 4 * r, 0.2 * r, high_head));
  }
  return part;
}

TopoDS_Edge spline_through(const std::vector<gp_Pnt>& points) {
  TColgp_Array1OfPnt array(1, static_cast<int>(points.size()));
  for (int i = 1; i <= array.Length(); ++i) array(i) = points[static_cast<std::size_t>(i - 1)];
  return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(array).Curve()).Edge();
}

/// One flank of an involute of the base circle, from the angle where its tooth begins; side -1 is its mirror
/// image.
std::vector<gp_Pnt> involute(double base, double from, double to, double begin, int side) {
  std::vector<gp_Pnt> points;
  for (int i = 0; i <= 8; ++i) {
    const double r = from + (to - from) * i / 8.0, roll = std::sqrt(std::max(0.0, r * r / (base * base) - 1));
    const double angle = begin + side * (roll - std::atan(roll));
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return points;
}

TopoDS_Face gear_sketch(int teeth, double module) {
  const double pitch = 0.5 * module * teeth, base = 0.94 * pitch,
               root = std::max(base, pitch - 1.25 * module) * 0.995, tip = pitch + module;
  const double half = kPi / (2 * teeth) + 0.015;
  BRepBuilderAPI_MakeWire wire;
  const auto join = [&](const gp_Pnt& a, const gp_Pnt& b) { wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge()); };
  gp_Pnt last, first;
  for (int i = 0; i < teeth; ++i) {
    const double t = 2 * kPi * i / teeth;
    const auto up = involute(base, base, tip, t - half, 1);
    auto down = involute(base, base, tip, t + half, -1);
    const gp_Pnt foot(root * std::cos(t - half), root * std::sin(t - half), 0),
        end(root * std::cos(t + half), root * std::sin(t + half), 0);
    if (i > 0)
      join(last, foot);
    else
      first = foot;
    join(foot, up.front());
    wire.Add(spline_through(up));
    wire.Add(BRepBuilderAPI_MakeEdge(
                 GC_MakeArcOfCircle(up.back(), gp_Pnt(tip * std::cos(t), tip * std::sin(t), 0), down.back())
                     .Value())
                 .Edge());
    std::reverse(down.begin(), down.end());
    wire.Add(spline_through(down));
    join(down.back(), end);
    last = end;
  }
  join(last, first);
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

TopoDS_Shape gear(Draw& draw) {
  const int teeth = draw.count(12, 40);
  const double module = draw.scaled(0.2, 8), pitch = 0.5 * module * teeth,
               width = module * draw.length(2, 10);
  const TopoDS_Face sketch = gear_sketch(teeth, module);
  TopoDS_Shape part = extruded(sketch, {0, 0, width});
  if (draw.chance(0.3))
    part = changed(part, [&] {
      BRepOffsetAPI_ThruSections helical(true, false);
      const TopoDS_Wire outer = TopoDS::Wire(TopoDS_Iterator(sketch).Value());
      for (int i = 0; i < 3; ++i)
        helical.AddWire(TopoDS::Wire(
            moved(outer, shift(0, 0, width * i / 2) * turn(gp_Ax1(gp_Pnt(), gp::DZ()), 0.1 * i))));
      return helical.Shape();
    });
  part = cut(part, rod({0, 0, -1}, gp::DZ(), pitch * draw.length(0.1, 0.5), width + 2));
  if (draw.chance(0.5)) part = cut(part, box({0, -0.06 * pitch, -1}, 0.6 * pitch, 0.12 * pitch, width + 2));
  if (draw.chance(0.4))
    part = with_bolt_circle(part, draw, 0.7 * pitch, pitch * draw.length(0.05, 0.15), -1, width + 2);
  return part;
}

/// A rim, a hub and spokes, or an impeller's blades on a hub.
TopoDS_Shape wheel(Draw& draw) {
  const double r = draw.scaled(5, 300), width = r * draw.length(0.1, 0.5), hub = r * draw.length(0.15, 0.35);
  const bool blades = draw.chance(0.4);
  TopoDS_Shape part =
      blades ? frustum({0, 0, 0}, gp::DZ(), hub * 1.5, hub, width) : rod({0, 0, 0}, gp::DZ(), hub, width);
  if (!blades)
    part = fuse(part, cut(rod({0, 0, 0}, gp::DZ(), r, width),
                          rod({0, 0, 0}, gp::DZ(), r * draw.length(0.8, 0.97), width)));
  const int n = draw.count(3, 9);
  for (int i = 0; i < n; ++i) {
    const double w = r * draw.length(0.02, 0.1);
    TopoDS_Shape spoke = draw.chance(0.5)
                             ? rod({0.5 * hub, 0, 0.5 * width}, gp::DX(), w / 2, 0.95 * r - 0.5 * hub)
                             : box({0.5 * hub, -w / 2, 0.25 * width}, 0.95 * r - 0.5 * hub, w, 0.5 * width);
    if (blades)
      spoke = changed(spoke, [&] {
        BRepOffsetAPI_ThruSections loft(true, false);
        for (int k = 0; k < 3; ++k) {
          const double x = 0.6 * hub + (r - 0.6 * hub) * k / 2;
          const TopoDS_Wire section =
              polygon({{x, -w / 2, 0}, {x, w / 2, 0}, {x, w / 2, 0.9 * width}, {x, -w / 2, 0.9 * width}});
          loft.AddWire(
              TopoDS::Wire(moved(section, turn(gp_Ax1(gp_Pnt(x, 0, 0.5 * width), gp::DX()), 0.4 * k))));
        }
        return loft.Shape();
      });
    part = fuse(part, moved(spoke, turn(gp_Ax1(gp_Pnt(), gp::DZ()), 2 * kPi * i / n)));
  }
  if (draw.chance(0.5)) part = blended(part, draw, r * draw.scaled(0.003, 0.03), 0.5);
  return cut(part, rod({0, 0, -1}, gp::DZ(), hub * draw.length(0.2, 0.8), 2 * width + 2));
}

}  // namespace

std::vector<PartKind> turned_kinds() {
  return {{"shaft", shaft}, {"flange", flange}, {"spring", spring},
          {"screw", screw}, {"gear", gear},     {"wheel", wheel}};
}

}  // namespace octet::test
