// SPDX-License-Identifier: BSD-3-Clause
// Two to five solids that touch, are inserted in each other, or nearly so; sheets within a solid.
#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>

#include "base/constants.h"
#include "geom/occt/gathered.h"
#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace octet::test {
namespace {

/// Mostly 0; else a gap or an overlap by a share of the length.
double misfit(Draw& draw, double length) {
  return draw.chance(0.7) ? 0.0 : length * draw.scaled(1e-3, 0.03) * (draw.chance(0.6) ? 1 : -1);
}

/// A plate with pins, bushings or bolts in its bores.
TopoDS_Shape pinned(Draw& draw) {
  const double a = draw.scaled(5, 200), b = a * draw.length(0.4, 1), t = a * draw.length(0.05, 0.4);
  TopoDS_Shape plate = box({0, 0, 0}, a, b, t);
  if (draw.chance(0.5)) plate = blended(plate, draw, 0.1 * t, 0.4);
  std::vector<TopoDS_Shape> parts;
  const int n = draw.count(1, 3);
  for (int i = 0; i < n; ++i) {
    const double r = b * draw.length(0.05, 0.2), x = a * (i + 0.5) / n, y = b * draw.length(0.3, 0.7);
    const bool blind = draw.chance(0.3);
    plate = cut(plate, rod({x, y, blind ? 0.3 * t : -1.0}, gp::DZ(), r, 2 * t + 2));
    const double foot = blind ? 0.3 * t : draw.chance(0.5) ? 0.0 : -0.3 * t;
    TopoDS_Shape pin = rod({x, y, foot}, gp::DZ(), r - misfit(draw, r), t * draw.length(0.7, 2.0));
    if (draw.chance(0.4)) pin = fuse(pin, rod({x, y, t}, gp::DZ(), r * draw.length(1.3, 2.0), 0.3 * t));
    if (draw.chance(0.3)) pin = cut(pin, rod({x, y, -t}, gp::DZ(), r * draw.length(0.3, 0.8), 5 * t));
    if (draw.chance(0.3)) pin = blended(pin, draw, 0.1 * r, 0.5);
    parts.push_back(pin);
  }
  parts.push_back(plate);
  return compound_of(parts);
}

/// Blocks on blocks: faces that coincide in whole or in part, edges on faces, some turned.
TopoDS_Shape stacked(Draw& draw) {
  const double g = draw.scaled(1, 50);
  std::vector<TopoDS_Shape> parts;
  double z = 0;
  for (int i = draw.count(2, 5); i > 0; --i) {
    const double h = g * draw.length(0.1, 2);
    TopoDS_Shape part = draw.chance(0.6) ? box({g * draw.count(0, 2), g * draw.count(0, 2), z},
                                               g * draw.count(1, 4), g * draw.count(1, 4), h)
                                         : rod({2 * g, 2 * g, z}, gp::DZ(), g * draw.count(1, 4) / 2, h);
    if (draw.chance(0.2))
      part = moved(part, turn(gp_Ax1(gp_Pnt(2 * g, 2 * g, 0), gp::DZ()), draw.between(0, kPi)));
    if (draw.chance(0.3))
      part = cut(part, rod({2 * g, 2 * g, z - 1}, gp::DZ(), g * draw.length(0.1, 0.5), h + 2));
    if (draw.chance(0.2)) part = blended(part, draw, 0.1 * std::min(g, h), 0.4);
    parts.push_back(part);
    z += h - misfit(draw, h);
  }
  return compound_of(parts);
}

/// Rings in rings about a shaft, with balls between some: bearings and seals.
TopoDS_Shape nested(Draw& draw) {
  const double r = draw.scaled(1, 100), h = r * draw.length(0.2, 1.5);
  std::vector<TopoDS_Shape> parts{rod({0, 0, -h * draw.length(0, 1)}, gp::DZ(), r, h * draw.length(1, 3))};
  double inner = r;
  for (int i = draw.count(1, 3); i > 0; --i) {
    const double outer = inner * draw.length(1.05, 1.6);
    TopoDS_Shape ring = cut(rod({0, 0, 0}, gp::DZ(), outer, h), rod({0, 0, -1}, gp::DZ(), inner, h + 2));
    if (draw.chance(0.3)) ring = blended(ring, draw, 0.2 * (outer - inner), 0.5);
    parts.push_back(ring);
    inner = outer + std::max(0.0, misfit(draw, r));
  }
  if (draw.chance(0.4))
    parts.push_back(BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, h / 2}, gp::DZ()), inner + 0.1 * r, 0.1 * r).Shape());
  return compound_of(parts);
}

/// Things sunk into a block, which the block has a hollow for or, by mistake, has not.
TopoDS_Shape embedded(Draw& draw) {
  const double a = draw.scaled(3, 100);
  TopoDS_Shape block = box({0, 0, 0}, a, a * draw.length(0.5, 1), a * draw.length(0.3, 0.8));
  const Extent in = extent_of(block);
  std::vector<TopoDS_Shape> parts;
  for (int i = draw.count(1, 3); i > 0; --i) {
    const gp_Pnt at(in.x() * draw.length(0.1, 0.9), in.y() * draw.length(0.1, 0.9),
                    in.z() * draw.length(0.2, 1.0));
    const double r = in.least() * draw.length(0.1, 0.35);
    TopoDS_Shape thing = BRepPrimAPI_MakeSphere(at, r).Shape();
    if (draw.chance(0.4))
      thing = box(at, 2 * r, r, r);
    else if (draw.chance(0.5))
      thing = rod(at, draw.chance(0.5) ? gp::DZ() : gp_Dir(1, 0.2, 0.5), r, 2 * r);
    bool apart = true;
    for (const TopoDS_Shape& other : parts) apart = apart && common(other, thing).IsSame(other);
    if (!apart) continue;
    if (draw.chance(0.85)) block = cut(block, thing);
    parts.push_back(thing);
  }
  parts.push_back(block);
  return compound_of(parts);
}

/// A block or a rod with sheets in it, plane or round, which cross each other and the walls at random, as far
/// as they lie within.
TopoDS_Shape sheeted(Draw& draw) {
  const double a = draw.scaled(3, 100);
  TopoDS_Shape body = draw.chance(0.6) ? box({0, 0, 0}, a, a * draw.length(0.4, 1), a * draw.length(0.3, 0.8))
                                       : rod({0, 0, 0}, gp::DZ(), a * draw.length(0.2, 0.5), a);
  const Extent in = extent_of(body);
  const double r = in.least();
  BOPAlgo_Builder builder;
  const auto within = [&] {
    return gp_Pnt(in.low.X() + in.x() * draw.between(0.2, 0.8), in.low.Y() + in.y() * draw.between(0.2, 0.8),
                  in.low.Z() + in.z() * draw.between(0.2, 0.8));
  };
  if (draw.chance(0.3))
    body = cut(body, rod(within(), gp_Dir(1, 0.3, 0.2), r * draw.length(0.05, 0.15), 2 * a));
  builder.AddArgument(body);
  for (int i = draw.count(1, 4); i > 0; --i) {
    const gp_Pnt at = within();
    const gp_Dir normal = draw.chance(0.5) ? gp::DZ() : gp_Dir(draw.between(-1, 1), draw.between(-1, 1), 0.7);
    const double w = r * draw.length(0.1, 0.6), h = r * draw.length(0.1, 0.6);
    if (draw.chance(0.7))
      builder.AddArgument(BRepBuilderAPI_MakeFace(gp_Pln(at, normal), -w, w, -h, h).Shape());
    else
      builder.AddArgument(BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(at, normal), 0.4 * w), 0.0,
                                                  draw.chance(0.5) ? 2 * kPi : draw.between(1, 5), -h / 2,
                                                  h / 2)
                              .Shape());
  }
  builder.Perform();
  std::vector<TopoDS_Shape> solids;
  for (TopExp_Explorer it(builder.Shape(), TopAbs_SOLID); it.More(); it.Next())
    solids.push_back(it.Current());
  return compound_of(solids);
}

}  // namespace

std::vector<PartKind> joined_kinds() {
  return {{"pinned", pinned},
          {"stacked", stacked},
          {"nested", nested},
          {"embedded", embedded},
          {"sheeted", sheeted}};
}

}  // namespace octet::test
