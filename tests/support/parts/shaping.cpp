// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/parts/shaping.h"

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepFilletAPI_MakeFillet2d.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Plane.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <exception>

#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet::test {

bool is_sound(const TopoDS_Shape& shape) {
  if (shape.IsNull() || !BRepCheck_Analyzer(shape).IsValid()) return false;
  const TopTools_IndexedMapOfShape solids = sub_shapes(shape, TopAbs_SOLID);
  for (int i = 1; i <= solids.Extent(); ++i)
    if (!(volume_of(solids(i)) > 0.0)) return false;
  return !solids.IsEmpty();
}

TopoDS_Shape changed(const TopoDS_Shape& shape, const std::function<TopoDS_Shape()>& change) {
  try {
    const TopoDS_Shape result = change();
    return is_sound(result) ? result : shape;
  } catch (const Standard_Failure&) {
    return shape;
  } catch (const std::exception&) {
    return shape;
  }
}

TopoDS_Shape box(const gp_Pnt& corner, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(corner, dx, dy, dz).Shape();
}

TopoDS_Shape rod(const gp_Pnt& foot, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(foot, along), radius, length).Shape();
}

TopoDS_Shape frustum(const gp_Pnt& foot, const gp_Dir& along, double r1, double r2, double length) {
  return BRepPrimAPI_MakeCone(gp_Ax2(foot, along), r1, r2, length).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool) {
  return changed(from, [&] { return BRepAlgoAPI_Cut(from, tool).Shape(); });
}
TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return changed(a, [&] { return BRepAlgoAPI_Fuse(a, b).Shape(); });
}
TopoDS_Shape common(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return changed(a, [&] { return BRepAlgoAPI_Common(a, b).Shape(); });
}

TopoDS_Shape unified(const TopoDS_Shape& shape) {
  return changed(shape, [&] {
    ShapeUpgrade_UnifySameDomain unify(shape);
    unify.Build();
    return unify.Shape();
  });
}

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& by) {
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

gp_Trsf turn(const gp_Ax1& about, double angle) {
  gp_Trsf result;
  result.SetRotation(about, angle);
  return result;
}

gp_Trsf shift(double x, double y, double z) {
  gp_Trsf result;
  result.SetTranslation(gp_Vec(x, y, z));
  return result;
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners, bool closed) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : corners) wire.Add(p);
  if (closed) wire.Close();
  return wire.Wire();
}

TopoDS_Face rounded_polygon(const std::vector<gp_Pnt>& corners, double radius) {
  const TopoDS_Face sharp = BRepBuilderAPI_MakeFace(polygon(corners), true);
  if (radius <= 0.0) return sharp;
  BRepFilletAPI_MakeFillet2d round(sharp);
  const TopTools_IndexedMapOfShape vertices = sub_shapes(sharp, TopAbs_VERTEX);
  for (int i = 1; i <= vertices.Extent(); ++i) round.AddFillet(TopoDS::Vertex(vertices(i)), radius);
  round.Build();
  return round.IsDone() ? TopoDS::Face(round.Shape()) : sharp;
}

TopoDS_Shape extruded(const TopoDS_Shape& sketch, const gp_Vec& by) {
  return BRepPrimAPI_MakePrism(sketch, by).Shape();
}

TopoDS_Shape revolved(const TopoDS_Shape& sketch, double angle) {
  return BRepPrimAPI_MakeRevol(sketch, gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ()), angle).Shape();
}

namespace {

/// Edges drawn with the probability, in the order of the shape, or those of one drawn face.
std::vector<TopoDS_Shape> drawn_edges(const TopoDS_Shape& shape, Draw& draw, double share) {
  TopoDS_Shape within = shape;
  if (draw.chance(0.4)) {
    const TopTools_IndexedMapOfShape faces = sub_shapes(shape, TopAbs_FACE);
    within = faces(draw.count(1, faces.Extent()));
  }
  std::vector<TopoDS_Shape> chosen;
  const TopTools_IndexedMapOfShape edges = sub_shapes(within, TopAbs_EDGE);
  for (int i = 1; i <= edges.Extent(); ++i)
    if (!BRep_Tool::Degenerated(TopoDS::Edge(edges(i))) && draw.chance(share)) chosen.push_back(edges(i));
  return chosen;
}

TopoDS_Shape with_fillets(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& edges, double r1,
                          double r2) {
  return changed(shape, [&] {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Shape& edge : edges) fillet.Add(r1, r2, TopoDS::Edge(edge));
    return fillet.Shape();
  });
}

TopoDS_Shape with_chamfers(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& edges, double width) {
  return changed(shape, [&] {
    BRepFilletAPI_MakeChamfer chamfer(shape);
    for (const TopoDS_Shape& edge : edges) chamfer.Add(width, TopoDS::Edge(edge));
    return chamfer.Shape();
  });
}

}  // namespace

TopoDS_Shape blended(const TopoDS_Shape& shape, Draw& draw, double radius, double share) {
  const bool chamfer = draw.chance(0.3);
  const auto blend = [&](const TopoDS_Shape& s, const std::vector<TopoDS_Shape>& edges) {
    return chamfer ? with_chamfers(s, edges, radius) : with_fillets(s, edges, radius, radius);
  };
  const std::vector<TopoDS_Shape> chosen = drawn_edges(shape, draw, share);
  const TopoDS_Shape all = blend(shape, chosen);
  if (!all.IsSame(shape)) return all;
  for (const TopoDS_Shape& edge : chosen) {  // OCCT cannot do all of them at once: the first it can do
    const TopoDS_Shape result = blend(shape, {edge});
    if (!result.IsSame(shape)) return result;
  }
  return shape;
}

TopoDS_Shape blended_unevenly(const TopoDS_Shape& shape, Draw& draw, double r1, double r2) {
  return with_fillets(shape, drawn_edges(shape, draw, 0.15), r1, r2);
}

TopoDS_Shape shelled(const TopoDS_Shape& shape, double thickness) {
  return changed(shape, [&] {
    TopTools_ListOfShape open;
    double top = -1e300;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      if (Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Current()))).IsNull()) continue;
      GProp_GProps area;
      BRepGProp::SurfaceProperties(it.Current(), area);
      if (area.CentreOfMass().Z() <= top) continue;
      top = area.CentreOfMass().Z();
      open.Clear();
      open.Append(it.Current());
    }
    BRepOffsetAPI_MakeThickSolid hollow;
    hollow.MakeThickSolidByJoin(shape, open, -thickness, 1e-4);
    return hollow.Shape();
  });
}

TopoDS_Shape drafted(const TopoDS_Shape& shape, double angle, double height) {
  return changed(shape, [&] {
    BRepOffsetAPI_DraftAngle draft(shape);
    const gp_Pln neutral(gp_Pnt(0, 0, height), gp::DZ());
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Current())));
      if (!plane.IsNull() && std::abs(plane->Axis().Direction().Z()) < 0.1)
        draft.Add(TopoDS::Face(it.Current()), gp::DZ(), angle, neutral);
    }
    draft.Build();
    return draft.Shape();
  });
}

Extent extent_of(const TopoDS_Shape& shape) {
  Bnd_Box bounds;
  BRepBndLib::AddOptimal(shape, bounds, false, false);
  return {bounds.CornerMin(), bounds.CornerMax()};
}

}  // namespace octet::test
