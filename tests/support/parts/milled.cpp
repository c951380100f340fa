// SPDX-License-Identifier: BSD-3-Clause
// Plates and blocks with what a mill makes of them.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "base/constants.h"
#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace octet::test {
namespace {

/// Outlines of plates: rectangle, L, U, T, cross, regular or any polygon.
std::vector<gp_Pnt> outline(Draw& draw, double a, double b) {
  const double u = draw.length(0.15, 0.45) * a, v = draw.length(0.15, 0.45) * b;
  switch (draw.count(0, 6)) {
    case 0:
      return {{0, 0, 0}, {a, 0, 0}, {a, v, 0}, {u, v, 0}, {u, b, 0}, {0, b, 0}};
    case 1:
      return {{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {a - u, b, 0}, {a - u, v, 0}, {u, v, 0}, {u, b, 0}, {0, b, 0}};
    case 2:
      return {{0, b - v, 0},     {u, b - v, 0}, {u, 0, 0}, {a - u, 0, 0},
              {a - u, b - v, 0}, {a, b - v, 0}, {a, b, 0}, {0, b, 0}};
    case 3: {
      std::vector<gp_Pnt> corners;
      const int n = draw.count(3, 9);
      for (int i = 0; i < n; ++i) {
        const double r = 0.5 * a * draw.between(0.6, 1.0), t = 2 * kPi * i / n;
        corners.emplace_back(0.5 * a + r * std::cos(t), 0.5 * b + r * std::sin(t), 0);
      }
      return corners;
    }
    case 4:
      return {{0, 0, 0}, {a, 0, 0}, {a - u, b, 0}, {u, b, 0}};
    default:
      return {{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}};
  }
}

TopoDS_Shape obround(const gp_Pnt& from, double length, double radius, double depth, double angle) {
  const TopoDS_Shape ends =
      fuse(rod(from, gp::DZ(), radius, depth), rod(from.Translated({length, 0, 0}), gp::DZ(), radius, depth));
  const TopoDS_Shape slot = fuse(ends, box(from.Translated({0, -radius, 0}), length, 2 * radius, depth));
  return moved(slot, turn(gp_Ax1(from, gp::DZ()), angle));
}

/// Down from `top`: plain, with a drill's tip, counterbored, countersunk, with a round end.
TopoDS_Shape drill(Draw& draw, const gp_Pnt& top, double radius, double depth) {
  const gp_Dir down = -gp::DZ();
  const gp_Pnt above = top.Translated({0, 0, radius});
  const TopoDS_Shape shaft = rod(above, down, radius, depth + radius);
  const gp_Pnt bottom = top.Translated({0, 0, -depth});
  switch (draw.count(0, 5)) {
    case 0:
      return fuse(shaft, frustum(bottom, down, radius, 0, radius * 0.6));
    case 1:
      return fuse(shaft, rod(above, down, radius * draw.length(1.5, 2.2), radius * draw.length(1.5, 3.0)));
    case 2:
      return fuse(shaft, frustum(top, down, 2 * radius, radius, radius));
    case 3:
      return fuse(shaft, BRepPrimAPI_MakeSphere(bottom, radius).Shape());
    default:
      return shaft;
  }
}

/// Holes alone, in rows or on a circle, some near walls or through them.
TopoDS_Shape with_holes(TopoDS_Shape part, Draw& draw) {
  const Extent in = extent_of(part);
  const double radius = draw.length(0.02, 0.12) * std::min(in.x(), in.y());
  const double depth = draw.chance(0.5) ? 1.5 * in.z() : draw.length(0.2, 0.95) * in.z();
  const double x0 = in.low.X() + draw.length(0.05, 0.9) * in.x(),
               y0 = in.low.Y() + draw.length(0.05, 0.9) * in.y();
  const TopoDS_Shape one = drill(draw, {x0, y0, in.high.Z()}, radius, depth);
  part = cut(part, one);
  if (draw.chance(0.4)) {
    const int nx = draw.count(1, 4), ny = draw.count(1, 3);
    const double pitch = radius * draw.length(2.0, 4.0) * (draw.chance(0.2) ? 1.01 : 1.0);
    for (int i = 1; i < nx * ny; ++i)
      part = cut(part, moved(one, shift(pitch * (i % nx), pitch * static_cast<double>(i / nx), 0)));
  } else if (draw.chance(0.4)) {
    const int n = draw.count(3, 8);
    for (int i = 1; i < n; ++i)
      part = cut(part, moved(one, turn(gp_Ax1(in.middle(), gp::DZ()), 2 * kPi * i / n)));
  }
  return part;
}

/// A hole from the side, which meets those from above.
TopoDS_Shape with_cross_hole(const TopoDS_Shape& part, Draw& draw) {
  const Extent in = extent_of(part);
  const double radius = draw.length(0.05, 0.45) * std::min(in.y(), in.z());
  gp_Pnt foot = in.middle();
  foot.SetX(in.low.X() - radius);
  foot.SetZ(in.low.Z() + draw.length(0.3, 0.7) * in.z());
  gp_Dir along = gp::DX();
  if (draw.chance(0.3)) along = gp_Dir(1, draw.between(-0.3, 0.3), draw.between(-0.2, 0.2));
  return cut(part, rod(foot, along, radius, (draw.chance(0.5) ? 2.0 : draw.length(0.3, 0.8)) * in.x()));
}

TopoDS_Shape with_pocket(const TopoDS_Shape& part, Draw& draw) {
  const Extent in = extent_of(part);
  const double a = draw.length(0.1, 0.6) * in.x(), b = draw.length(0.1, 0.6) * in.y();
  const double depth = draw.length(0.1, 0.97) * in.z();
  const gp_Pnt at(in.low.X() + draw.length(0, 0.8) * in.x(), in.low.Y() + draw.length(0, 0.8) * in.y(),
                  in.high.Z() - depth);
  if (draw.chance(0.3))
    return cut(part, obround(at, a, 0.15 * b, 2 * depth, draw.chance(0.5) ? 0 : draw.between(0, kPi)));
  const std::vector<gp_Pnt> corners{at, at.Translated({a, 0, 0}), at.Translated({a, b, 0}),
                                    at.Translated({0, b, 0})};
  TopoDS_Shape tool =
      extruded(rounded_polygon(corners, draw.chance(0.6) ? draw.length(0.05, 0.45) * std::min(a, b) : 0),
               {0, 0, 2 * depth});
  if (draw.chance(0.3)) tool = drafted(tool, draw.between(0.01, 0.1), at.Z());
  if (draw.chance(0.3)) tool = blended(tool, draw, draw.length(0.02, 0.1) * std::min(a, b), 1.0);
  return cut(part, tool);
}

/// A boss with a bore, on the top or through it, also tangent to the part's walls.
TopoDS_Shape with_boss(const TopoDS_Shape& part, Draw& draw) {
  const Extent in = extent_of(part);
  const double radius = draw.length(0.05, 0.3) * std::min(in.x(), in.y());
  const double height = draw.length(0.2, 2.0) * radius;
  double x = in.low.X() + draw.length(0.1, 0.9) * in.x(), y = in.low.Y() + draw.length(0.1, 0.9) * in.y();
  if (draw.chance(0.3)) x = in.low.X() + radius;
  if (draw.chance(0.2)) y = in.high.Y() - radius;
  const gp_Pnt foot(x, y, in.high.Z() - (draw.chance(0.3) ? in.z() : 0.0));
  const double length = in.high.Z() + height - foot.Z();
  const TopoDS_Shape boss = draw.chance(0.3) ? frustum(foot, gp::DZ(), radius, 0.8 * radius, length)
                                             : rod(foot, gp::DZ(), radius, length);
  const TopoDS_Shape joined = fuse(part, boss);
  if (draw.chance(0.4)) return joined;
  return cut(joined, drill(draw, {x, y, in.high.Z() + height}, radius * draw.length(0.3, 0.9),
                           length * draw.between(0.3, 1.2)));
}

TopoDS_Shape with_rib(const TopoDS_Shape& part, Draw& draw) {
  const Extent in = extent_of(part);
  const double width = draw.length(0.02, 0.1) * in.y(), a = draw.length(0.2, 0.8) * in.x();
  const double height = draw.length(0.1, 0.8) * a;
  const double y = in.low.Y() + draw.length(0, 0.9) * in.y();
  const gp_Pnt at(in.low.X(), y, in.high.Z());
  TopoDS_Shape rib = extruded(
      rounded_polygon({at, at.Translated({a, 0, 0}), at.Translated({0, 0, height})}, 0), {0, width, 0});
  if (draw.chance(0.5)) rib = drafted(rib, 0.02, in.high.Z());
  return fuse(part, rib);
}

TopoDS_Shape with_blends(TopoDS_Shape part, Draw& draw) {
  const double least = extent_of(part).least();
  const int rounds = draw.count(0, 3);
  for (int i = 0; i < rounds; ++i) {
    const double radius =
        draw.chance(0.2) ? 0.5 * least * draw.between(0.9, 1.0) : least * draw.scaled(0.01, 0.3);
    part = draw.chance(0.15) ? blended_unevenly(part, draw, radius, radius * draw.between(0.2, 2.0))
                             : blended(part, draw, radius, draw.scaled(0.05, 1.0));
  }
  return part;
}

TopoDS_Shape with_features(TopoDS_Shape part, Draw& draw, int most) {
  for (int i = draw.count(1, most); i > 0; --i) switch (draw.count(0, 6)) {
      case 0:
      case 1:
        part = with_holes(part, draw);
        break;
      case 2:
        part = with_cross_hole(part, draw);
        break;
      case 3:
        part = with_pocket(part, draw);
        break;
      case 4:
        part = with_boss(part, draw);
        break;
      case 5:
        part = with_rib(part, draw);
        break;
      default:
        part = with_blends(part, draw);
        break;
    }
  return part;
}

TopoDS_Shape plate(Draw& draw) {
  const double a = draw.scaled(2, 400), b = a * draw.length(0.2, 1.0), thick = b * draw.scaled(0.03, 0.8);
  TopoDS_Shape part = extruded(
      rounded_polygon(outline(draw, a, b), draw.chance(0.4) ? draw.length(0.01, 0.2) * b : 0), {0, 0, thick});
  part = with_features(part, draw, 5);
  return with_blends(draw.chance(0.5) ? unified(part) : part, draw);
}

/// Boxes and rods on one grid of round numbers: much coincides, much is tangent.
TopoDS_Shape gridded(Draw& draw) {
  const double g = draw.length(0.5, 10);
  TopoDS_Shape part = box({0, 0, 0}, g * draw.count(4, 8), g * draw.count(3, 6), g * draw.count(2, 5));
  for (int i = draw.count(3, 9); i > 0; --i) {
    const gp_Pnt at(g * draw.count(0, 7), g * draw.count(0, 5), g * draw.count(-1, 4));
    TopoDS_Shape tool = box(at, g * draw.count(1, 3), g * draw.count(1, 3), g * draw.count(1, 5));
    if (draw.chance(0.5)) {
      const int axis = draw.count(0, 2);
      tool = rod(at,
                 axis == 0   ? gp::DX()
                 : axis == 1 ? gp::DY()
                             : gp::DZ(),
                 g * draw.count(1, 4) / 2.0, g * draw.count(1, 6));
    }
    part = draw.chance(0.5) ? cut(part, tool) : fuse(part, tool);
  }
  return with_blends(draw.chance(0.7) ? unified(part) : part, draw);
}

/// Two extrusions' common part: sharp wedges and faces of few edges.
TopoDS_Shape crossed_extrusions(Draw& draw) {
  const double a = draw.scaled(5, 200);
  const double r = draw.length(0, 0.15) * a;
  const TopoDS_Shape up = extruded(rounded_polygon(outline(draw, a, a), draw.chance(0.5) ? r : 0), {0, 0, a});
  TopoDS_Shape across =
      extruded(rounded_polygon(outline(draw, a, a), draw.chance(0.5) ? r : 0), {0, 0, 3 * a});
  across = moved(across, shift(0, 0, -a) * turn(gp_Ax1(gp_Pnt(0.5 * a, 0.5 * a, 0.5 * a), gp::DX()),
                                                draw.chance(0.6) ? kPi / 2 : draw.between(0.3, 2)));
  const TopoDS_Shape both = common(up, across);
  return with_blends(with_features(both, draw, 2), draw);
}

/// Letters of strokes, raised or cut into a plate.
TopoDS_Shape lettered(Draw& draw) {
  const double h = draw.length(2, 20), t = h * draw.length(0.1, 0.2), depth = h * draw.scaled(0.01, 0.3);
  const int letters = draw.count(2, 5);
  TopoDS_Shape part =
      box({-t, -t, -h * draw.length(0.2, 0.6)}, (0.8 * letters + 0.1) * h + t, h + 2 * t, h * 0.6);
  const double top = extent_of(part).high.Z();
  const bool raised = draw.chance(0.5);
  const auto stroke = [&](const TopoDS_Shape& s) { part = raised ? fuse(part, s) : cut(part, s); };
  for (int i = 0; i < letters; ++i) {
    const double x = 0.8 * h * i, z = raised ? top : top - depth;
    const auto bar = [&](double dx, double dy, double wx, double wy) {
      stroke(box({x + dx, dy, z}, wx, wy, depth));
    };
    switch (draw.count(0, 4)) {
      case 0:
        bar(0, 0, t, h);
        bar(0, 0, 0.6 * h, t);
        break;  // L
      case 1:
        bar(0, h - t, 0.6 * h, t);
        bar(0.3 * h - t / 2, 0, t, h);
        break;  // T
      case 2:
        stroke(cut(rod({x + 0.3 * h, 0.3 * h, z}, gp::DZ(), 0.3 * h, depth),
                   rod({x + 0.3 * h, 0.3 * h, z}, gp::DZ(), 0.3 * h - t, depth)));
        bar(0, 0, t, h);
        break;  // b
      case 3:
        stroke(extruded(rounded_polygon({{x, h, z},
                                         {x + t, h, z},
                                         {x + 0.3 * h, 1.5 * t, z},
                                         {x + 0.6 * h - t, h, z},
                                         {x + 0.6 * h, h, z},
                                         {x + 0.3 * h, 0, z}},
                                        0),
                        {0, 0, depth}));
        break;  // V
      default:
        bar(0, 0, t, h);
        bar(0, h - t, 0.5 * h, t);
        bar(0, 0.5 * h, 0.4 * h, t);
        break;  // F
    }
  }
  return with_blends(part, draw);
}

/// A block whose holes come near its walls, each other, or just break through.
TopoDS_Shape narrow_walls(Draw& draw) {
  const double a = draw.length(10, 200), r = a * draw.length(0.05, 0.2);
  TopoDS_Shape part = box({0, 0, 0}, a, 0.6 * a, 0.3 * a);
  const auto slip = [&] {
    return (draw.chance(0.5) ? 1 : -1) * r * (draw.chance(0.2) ? 0.0 : draw.scaled(1e-4, 0.1));
  };
  part = cut(part, rod({0.3 * a, r + slip(), -1}, gp::DZ(), r, a));
  part = cut(part,
             rod({0.3 * a + 2 * r + slip(), r + r / 3, -1}, gp::DZ(), r, draw.chance(0.5) ? a : 0.2 * a + 1));
  part = cut(part, rod({-1, 0.4 * a, 0.3 * a - r + slip()}, gp::DX(), r, draw.chance(0.5) ? 2 * a : 0.7 * a));
  if (draw.chance(0.5))
    part = cut(part, rod({0.6 * a, 0.4 * a - 2 * r + slip(), 0.15 * a},
                         draw.chance(0.5) ? gp::DX() : gp_Dir(1, 0.02, 0), r / 2, a));
  return with_blends(part, draw);
}

TopoDS_Shape all_splines(Draw& draw) {
  const TopoDS_Shape part = draw.chance(0.5) ? plate(draw) : gridded(draw);
  return changed(part, [&] { return BRepBuilderAPI_NurbsConvert(part, true).Shape(); });
}

}  // namespace

std::vector<PartKind> milled_kinds() {
  return {{"plate", plate},       {"gridded", gridded},     {"crossed", crossed_extrusions},
          {"lettered", lettered}, {"narrow", narrow_walls}, {"splines", all_splines}};
}

}  // namespace octet::test
