// SPDX-License-Identifier: BSD-3-Clause
// Free forms: lofts, sweeps along splines, blocks under spline faces, castings.
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>

#include "base/constants.h"
#include "tests/support/parts/kinds.h"
#include "tests/support/parts/shaping.h"

namespace octet::test {
namespace {

TopoDS_Edge spline(const std::vector<gp_Pnt>& points, bool closed) {
  const Handle(TColgp_HArray1OfPnt) array = new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (int i = 1; i <= array->Length(); ++i) array->SetValue(i, points[static_cast<std::size_t>(i - 1)]);
  GeomAPI_Interpolate through(array, closed, 1e-7);
  through.Perform();
  return BRepBuilderAPI_MakeEdge(through.Curve()).Edge();
}

/// A section at the height z: circle, ellipse, rounded box, wing or any closed spline.
TopoDS_Wire section(Draw& draw, int kind, double size, double z) {
  const gp_Ax2 axes({0, 0, z}, gp::DZ());
  switch (kind) {
    case 0:
      return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, size))).Wire();
    case 1:
      return BRepBuilderAPI_MakeWire(
                 BRepBuilderAPI_MakeEdge(gp_Elips(axes, size, size * draw.between(0.2, 0.95))))
          .Wire();
    case 2: {
      const double b = size * draw.between(0.4, 1.0);
      return TopoDS::Wire(
          TopoDS_Iterator(
              rounded_polygon({{-size, -b, z}, {size, -b, z}, {size, b, z}, {-size, b, z}}, 0.3 * b))
              .Value());
    }
    case 3: {  // a wing's profile with a blunt or thin trailing edge
      const double thick = draw.between(0.1, 0.3), end = draw.chance(0.5) ? 0.002 : 0.02;
      std::vector<gp_Pnt> upper, lower;
      for (int i = 0; i <= 10; ++i) {
        const double t = i / 10.0, x = t * t,
                     y = thick * (1.48 * std::sqrt(x) * (1 - x) + 0.2 * x * (1 - x)) / 2 + end * x;
        upper.emplace_back(2 * size * x, 2 * size * (y + 0.1 * x * (1 - x)), z);
        lower.emplace_back(2 * size * x, 2 * size * (-y + 0.1 * x * (1 - x)), z);
      }
      BRepBuilderAPI_MakeWire wire(spline(upper, false));
      wire.Add(BRepBuilderAPI_MakeEdge(upper.back(), lower.back()).Edge());
      std::reverse(lower.begin(), lower.end());
      wire.Add(spline(lower, false));
      return wire.Wire();
    }
    default: {
      std::vector<gp_Pnt> points;
      for (int i = 0; i < 7; ++i) {
        const double r = size * draw.between(0.7, 1.0);
        points.emplace_back(r * std::cos(2 * kPi * i / 7), r * std::sin(2 * kPi * i / 7), z);
      }
      return BRepBuilderAPI_MakeWire(spline(points, true)).Wire();
    }
  }
}

TopoDS_Shape loft(Draw& draw) {
  const double size = draw.scaled(2, 100), length = size * draw.length(1, 6);
  const int n = draw.count(2, 4), kind = draw.count(0, 4);
  const bool mixed = draw.chance(0.3);
  BRepOffsetAPI_ThruSections through(true, draw.chance(0.3));
  for (int i = 0; i < n; ++i) {
    const gp_Trsf place = shift(size * draw.between(-0.3, 0.3) * i, 0, 0) *
                          turn(gp_Ax1(gp_Pnt(), gp::DZ()), draw.between(-0.15, 0.15) * i);
    through.AddWire(TopoDS::Wire(moved(
        section(draw, mixed ? draw.count(0, 2) : kind, size * draw.between(0.5, 1.1), length * i / (n - 1)),
        place)));
  }
  if (draw.chance(0.15)) through.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, length * 1.3)));
  TopoDS_Shape part = through.Shape();
  if (draw.chance(0.3)) part = shelled(part, size * draw.scaled(0.01, 0.15));
  if (draw.chance(0.3)) part = cut(part, rod({0, -2 * size, 0.5 * length}, gp::DY(), 0.2 * size, 4 * size));
  if (draw.chance(0.3)) part = fuse(part, rod({0, 0, -0.1 * length}, gp::DZ(), 1.2 * size, 0.15 * length));
  if (draw.chance(0.4)) part = blended(part, draw, size * draw.scaled(0.01, 0.15), 0.5);
  return part;
}

TopoDS_Shape sweep(Draw& draw) {
  const double a = draw.scaled(10, 200), r = a * draw.scaled(0.02, 0.15);
  std::vector<gp_Pnt> points{{0, 0, 0}};
  for (int i = draw.count(2, 4); i > 0; --i)
    points.push_back(points.back().Translated(
        {a * draw.between(-0.3, 0.3), a * draw.between(-0.3, 0.3), a * draw.between(0.4, 1.0)}));
  const TopoDS_Edge path = spline(points, false);
  BRepOffsetAPI_MakePipeShell pipe(BRepBuilderAPI_MakeWire(path).Wire());
  if (draw.chance(0.3)) pipe.SetMode(gp_Dir(1, 0, 0));
  pipe.Add(section(draw, draw.count(0, 4), r, 0), false, draw.chance(0.7));
  pipe.Build();
  pipe.MakeSolid();
  TopoDS_Shape part = pipe.Shape();
  if (draw.chance(0.3)) part = shelled(part, r * draw.scaled(0.05, 0.3));
  if (draw.chance(0.3)) part = fuse(part, box({-2 * r, -2 * r, -r}, 4 * r, 4 * r, 1.5 * r));
  if (draw.chance(0.3)) part = fuse(part, BRepPrimAPI_MakeSphere(points[1], 1.5 * r).Shape());
  if (draw.chance(0.4)) part = blended(part, draw, r * draw.scaled(0.02, 0.3), 0.5);
  return part;
}

TopoDS_Face waved_face(Draw& draw, double a, double b, double wave) {
  const int n = draw.count(4, 8);
  TColgp_Array2OfPnt points(1, n, 1, n);
  for (int i = 1; i <= n; ++i)
    for (int k = 1; k <= n; ++k)
      points(i, k) = gp_Pnt(a * (i - 1) / (n - 1), b * (k - 1) / (n - 1), draw.between(-wave, wave));
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points, 3, 8, GeomAbs_C2, 1e-4).Surface(),
                                 1e-6)
      .Face();
}

/// A block under a spline face, or between two of them, with pockets and holes down to it.
TopoDS_Shape dome(Draw& draw) {
  const double a = draw.scaled(5, 300), b = a * draw.length(0.4, 1.0), thick = a * draw.scaled(0.02, 0.3);
  TopoDS_Shape part = BRepPrimAPI_MakePrism(waved_face(draw, a, b, 0.08 * a), gp_Vec(0, 0, -thick)).Shape();
  const double top = extent_of(part).high.Z();
  for (int i = draw.count(0, 4); i > 0; --i) {
    const double r = a * draw.length(0.02, 0.1);
    const gp_Pnt at(a * draw.length(0.05, 0.95), b * draw.length(0.05, 0.95), 0);
    if (draw.chance(0.5))
      part = cut(part, rod({at.X(), at.Y(), -2 * a}, gp::DZ(), r, 4 * a));
    else
      part = fuse(part, rod({at.X(), at.Y(), -0.5 * thick}, gp::DZ(), r, top + 0.1 * a));
  }
  if (draw.chance(0.4)) part = common(part, rod({a / 2, b / 2, -2 * a}, gp::DZ(), 0.45 * b, 4 * a));
  if (draw.chance(0.4)) part = blended(part, draw, thick * draw.scaled(0.02, 0.3), 0.4);
  return part;
}

/// Rods, balls and rings grown together and rounded: castings and handles.
TopoDS_Shape casting(Draw& draw) {
  const double a = draw.scaled(5, 200);
  TopoDS_Shape part = box({0, 0, 0}, a, a * draw.length(0.3, 1), a * draw.length(0.1, 0.5));
  for (int i = draw.count(2, 5); i > 0; --i) {
    const gp_Pnt at(a * draw.length(0, 1), a * draw.length(0, 0.6), a * draw.length(0, 0.4));
    const gp_Dir along(draw.between(-1, 1), draw.between(-1, 1), draw.between(0.2, 1));
    const double r = a * draw.length(0.05, 0.25);
    TopoDS_Shape more = draw.chance(0.4) ? rod(at, along, r, a * draw.length(0.2, 0.8))
                                         : BRepPrimAPI_MakeSphere(at, r).Shape();
    if (draw.chance(0.2)) more = BRepPrimAPI_MakeTorus(gp_Ax2(at, along), 2 * r, r / 2).Shape();
    part = draw.chance(0.75) ? fuse(part, more) : cut(part, more);
    if (draw.chance(0.4)) part = blended(part, draw, a * draw.scaled(0.005, 0.05), 0.4);
  }
  return part;
}

}  // namespace

std::vector<PartKind> free_form_kinds() {
  return {{"loft", loft}, {"sweep", sweep}, {"dome", dome}, {"casting", casting}};
}

}  // namespace octet::test
