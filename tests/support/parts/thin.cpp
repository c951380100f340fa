// SPDX-License-Identifier: BSD-3-Clause
// Thin parts: housings, bent sheets, tubes, fins, wires.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet2d.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <ChFi2d_FilletAPI.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "base/constants.h"
#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace octet::test {
namespace {

/// A housing: a block, rod or tapered block with blends, hollowed, with bosses, ribs, snaps and cut-outs.
TopoDS_Shape housing(Draw& draw) {
  const double a = draw.scaled(10, 300), b = a * draw.length(0.3, 1.0), h = a * draw.length(0.1, 0.8);
  TopoDS_Shape part = draw.chance(0.2)
                          ? rod({a / 2, b / 2, 0}, gp::DZ(), b / 2, h)
                          : extruded(rounded_polygon({{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}},
                                                     draw.chance(0.6) ? b * draw.length(0.02, 0.3) : 0),
                                     {0, 0, h});
  if (draw.chance(0.3)) part = drafted(part, -draw.between(0.01, 0.1), 0);
  const double wall = std::min(b, h) * draw.scaled(0.01, 0.15);
  if (draw.chance(0.6)) part = blended(part, draw, wall * draw.length(0.5, 4.0), 0.5);
  const TopoDS_Shape full = part;
  part = shelled(part, wall);
  const Extent in = extent_of(part);
  for (int i = draw.count(0, 4); i > 0; --i) {
    const double r = wall * draw.length(1.5, 3.0), x = draw.length(0.1, 0.9) * a,
                 y = draw.length(0.1, 0.9) * b;
    const TopoDS_Shape post = common(full, rod({x, y, wall / 2}, gp::DZ(), r, h * draw.length(0.3, 0.9)));
    part = cut(fuse(part, post), rod({x, y, wall}, gp::DZ(), r * draw.length(0.3, 0.8), h));
  }
  for (int i = draw.count(0, 3); i > 0; --i)
    part = fuse(part, common(full, box({draw.length(0, 0.9) * a, 0, wall / 2}, wall * draw.length(0.4, 1.0),
                                       b, h * draw.length(0.2, 0.8))));
  for (int i = draw.count(0, 3); i > 0; --i) {
    const double w = a * draw.length(0.05, 0.3), z = h * draw.length(0.2, 0.9);
    if (draw.chance(0.5))
      part = cut(part, box({a * draw.length(0, 0.8), -1, z}, w, draw.chance(0.5) ? b + 2 : b / 2,
                           h * draw.length(0.05, 0.4)));
    else
      part = cut(part, rod({a * draw.length(0.1, 0.9), -1, z}, gp::DY(), w / 4, b / 2));
  }
  if (draw.chance(0.3)) part = blended(part, draw, wall * draw.length(0.1, 0.5), 0.2);
  return part;
}

/// A line of straight pieces in the plane y = 0, offset to a sheet, bends rounded inside and outside.
TopoDS_Shape sheet(Draw& draw) {
  const double a = draw.scaled(5, 300), t = a * draw.scaled(0.005, 0.1), width = a * draw.length(0.3, 1.5);
  std::vector<gp_Pnt> below{{0, 0, 0}}, above{{0, 0, t}};
  double angle = 0, x = 0, z = 0;
  for (int i = draw.count(1, 4); i > 0; --i) {
    const double length = a * draw.length(0.2, 1.0),
                 bend = (draw.chance(0.6) ? kPi / 2 : draw.between(0.2, 1.8)) * (draw.chance(0.5) ? 1 : -1);
    x += length * std::cos(angle), z += length * std::sin(angle);
    const double half = angle + bend / 2, over = t / std::cos(bend / 2);
    below.emplace_back(x, 0, z);
    above.emplace_back(x - over * std::sin(half), 0, z + over * std::cos(half));
    angle += bend;
  }
  x += 0.4 * a * std::cos(angle), z += 0.4 * a * std::sin(angle);
  below.emplace_back(x, 0, z);
  above.emplace_back(x - t * std::sin(angle), 0, z + t * std::cos(angle));
  below.insert(below.end(), above.rbegin(), above.rend());
  TopoDS_Face sketch = rounded_polygon(below, 0);
  if (draw.chance(0.7)) {  // the bends only: corners that are no ends
    BRepFilletAPI_MakeFillet2d round(sketch);
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(sketch, TopAbs_VERTEX, vertices);
    const int n = vertices.Extent() / 2;
    const double r = t * draw.length(0.5, 3);
    for (int i = 2; i < n; ++i) {
      round.AddFillet(TopoDS::Vertex(vertices(i)), r);
      round.AddFillet(TopoDS::Vertex(vertices(2 * n + 1 - i)), r + 0.4 * t);
    }
    round.Build();
    if (round.IsDone()) sketch = TopoDS::Face(round.Shape());
  }
  TopoDS_Shape part = extruded(sketch, {0, width, 0});
  const Extent in = extent_of(part);
  for (int i = draw.count(0, 5); i > 0; --i)
    part =
        cut(part,
            rod({in.low.X() + draw.between(0.1, 0.9) * in.x(), draw.length(0.1, 0.9) * width, in.low.Z() - 1},
                gp::DZ(), a * draw.length(0.02, 0.1), in.z() + 2));
  if (draw.chance(0.3))
    part = cut(part, box({in.low.X() + 0.3 * in.x(), -1, in.low.Z() - 1}, t * draw.length(0.3, 1.0),
                         width * draw.length(0.3, 0.8) + 1, in.z() + 2));
  return part;
}

TopoDS_Wire circle_at(const gp_Pnt& at, const gp_Dir& along, double r) {
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(at, along), r))).Wire();
}

/// Along lines and tangent arcs: a wire of the path.
TopoDS_Wire bent_path(Draw& draw, double a, double bend) {
  std::vector<gp_Pnt> points{{0, 0, 0}, {a, 0, 0}};
  for (int i = draw.count(1, 3); i > 0; --i) {
    gp_Pnt next = points.back();
    const int axis = draw.count(0, 2);
    next.SetCoord(1 + axis, next.Coord(1 + axis) + a * draw.length(0.6, 1.2));
    if (gp_Vec(points.back(), next).IsParallel(gp_Vec(points[points.size() - 2], points.back()), 0.1))
      continue;
    points.push_back(next);
  }
  BRepBuilderAPI_MakeWire wire;
  std::vector<TopoDS_Edge> edges;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    edges.push_back(BRepBuilderAPI_MakeEdge(points[i], points[i + 1]).Edge());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const gp_Vec u(points[i], points[i + 1]), v(points[i + 1], points[i + 2]);
    ChFi2d_FilletAPI corner(edges[i], edges[i + 1], gp_Pln(points[i + 1], u.Crossed(v)));
    TopoDS_Edge first, second;
    if (!corner.Perform(bend)) return {};  // along corners OCCT makes pipes that are flat in part
    const TopoDS_Edge arc = corner.Result(points[i + 1], first, second);
    wire.Add(first);
    wire.Add(arc);
    edges[i + 1] = second;
  }
  wire.Add(edges.back());
  return wire.Wire();
}

TopoDS_Shape tube(Draw& draw) {
  const double a = draw.scaled(10, 300), r = a * draw.scaled(0.02, 0.2), wall = r * draw.scaled(0.02, 0.5);
  const TopoDS_Wire path = bent_path(draw, a, r * draw.length(1.05, 2.5));
  if (path.IsNull()) return {};
  const auto pipe = [&](double radius) {
    return BRepOffsetAPI_MakePipe(path,
                                  BRepBuilderAPI_MakeFace(circle_at({0, 0, 0}, gp::DX(), radius)).Face())
        .Shape();
  };
  TopoDS_Shape part = pipe(r);
  if (draw.chance(0.4))
    part = fuse(part, rod({0, 0, 0}, gp::DX(), r * draw.length(1.3, 2), wall * draw.length(1, 3)));
  if (draw.chance(0.3)) part = fuse(part, rod({0.5 * a, 0, 0}, gp::DZ(), r * draw.length(0.3, 1.0), 3 * r));
  if (draw.chance(0.7)) part = cut(part, pipe(r - wall));
  return part;
}

/// Pipes of one or two radii that meet, hollow, with blends where they meet.
TopoDS_Shape fitting(Draw& draw) {
  const double r = draw.scaled(2, 100), wall = r * draw.scaled(0.03, 0.3), length = r * draw.length(2, 5);
  std::vector<gp_Dir> ways{gp::DX(), -gp::DX(), gp::DY()};
  if (draw.chance(0.3)) ways.push_back(gp_Dir(0.3, -1, draw.between(0, 1)));
  if (draw.chance(0.3)) ways.erase(ways.begin() + 1);
  std::vector<double> radii;
  for (std::size_t i = 0; i < ways.size(); ++i)
    radii.push_back(r * (draw.chance(0.5) ? 1.0 : draw.length(0.4, 1.0)));
  TopoDS_Shape part = rod({0, 0, 0}, ways[0], radii[0], length);
  for (std::size_t i = 1; i < ways.size(); ++i) part = fuse(part, rod({0, 0, 0}, ways[i], radii[i], length));
  if (draw.chance(0.5)) part = blended(part, draw, r * draw.length(0.02, 0.3), 0.5);
  if (draw.chance(0.7))
    for (std::size_t i = 0; i < ways.size(); ++i)
      part = cut(part, rod({0, 0, 0}, ways[i], radii[i] - wall, length + 1));
  return part;
}

TopoDS_Shape fins(Draw& draw) {
  const double a = draw.scaled(5, 200), b = a * draw.length(0.4, 1.0), foot = a * draw.length(0.05, 0.2),
               h = a * draw.length(0.1, 0.6);
  const int n = draw.count(4, 16);
  const double pitch = a / n, t = pitch * draw.scaled(0.05, 0.6);
  const bool pins = draw.chance(0.2), tapered = draw.chance(0.3);
  TopoDS_Shape part = box({0, 0, 0}, a, b, foot);
  for (int i = 0; i < n; ++i) {
    const double x = pitch * i + (draw.chance(0.5) ? 0.0 : 0.0);
    if (pins) {
      for (int k = 0; k < 4; ++k)
        part = fuse(part, rod({x + pitch / 2, b * (k + 0.5) / 4, foot}, gp::DZ(), t / 2, h));
    } else {
      const double top = tapered ? 0.4 * t : t;
      part = fuse(part, extruded(rounded_polygon({{x, 0, foot},
                                                  {x + t, 0, foot},
                                                  {x + (t + top) / 2, 0, foot + h},
                                                  {x + (t - top) / 2, 0, foot + h}},
                                                 0),
                                 {0, b, 0}));
    }
  }
  if (draw.chance(0.4))
    part = cut(part, rod({a / 2, b / 2, -1}, gp::DZ(), b * draw.length(0.05, 0.3), foot + h + 2));
  if (draw.chance(0.4)) part = blended(part, draw, t * draw.length(0.1, 0.5), draw.scaled(0.05, 1.0));
  return part;
}

/// Far longer than wide: rails, ribbons, needles, discs.
TopoDS_Shape slender(Draw& draw) {
  const double length = draw.scaled(50, 1000), w = length * draw.scaled(0.002, 0.05);
  switch (draw.count(0, 4)) {
    case 0:
      return rod({0, 0, 0}, gp::DX(), w / 2, length);
    case 1:
      return cut(rod({0, 0, 0}, gp::DX(), w, length),
                 rod({0, 0, 0}, gp::DX(), w * draw.length(0.7, 0.98), length));
    case 2:
      return blended(box({0, 0, 0}, length, w, w * draw.scaled(0.02, 1.0)), draw, w * 0.005, 0.5);
    case 3:
      return frustum({0, 0, 0}, gp::DZ(), w, draw.chance(0.5) ? 0.0 : w * draw.scaled(0.001, 0.3), length);
    default: {
      TopoDS_Shape disc = rod({0, 0, 0}, gp::DZ(), length / 4, length * draw.scaled(2e-4, 0.01));
      return cut(disc, rod({length * draw.length(0, 0.15), 0, -1}, gp::DZ(), length * draw.length(0.02, 0.1),
                           length));
    }
  }
}

}  // namespace

std::vector<PartKind> thin_kinds() {
  return {{"housing", housing}, {"sheet", sheet}, {"tube", tube},
          {"fitting", fitting}, {"fins", fins},   {"slender", slender}};
}

}  // namespace octet::test
