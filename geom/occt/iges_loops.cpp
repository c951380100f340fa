// SPDX-License-Identifier: BSD-3-Clause
// Faces of the two readings are in the same order.
#include "geom/occt/iges_loops.h"

#include <BRep_Tool.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "geom/occt/shape_box.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

bool is_closed_all_around(const TopoDS_Shape& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(face));
  if (surface.IsNull() || !surface->IsUPeriodic()) return false;
  if (surface->IsVPeriodic() || surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface))) return true;
  const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
  if (turned.IsNull()) return false;
  Handle(Geom_Curve) curve = turned->BasisCurve();
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  return Handle(Geom_Line)::DownCast(curve).IsNull();
}

bool differ(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  constexpr double kSame = 1e-3;
  const double of_a = std::abs(area_of(a)), of_b = std::abs(area_of(b));
  return std::abs(of_a - of_b) > kSame * std::max(of_a, of_b);
}

/// Whether b has a vertex wherever a has one: the loops are the same, but for seams.
bool have_same_corners(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  constexpr double kSame = 1e-3;
  const auto corners = sub_shapes(a, TopAbs_VERTEX), others = sub_shapes(b, TopAbs_VERTEX);
  const double near = kSame * diagonal_of(box_of(a));
  return std::all_of(corners.cbegin(), corners.cend(), [&](const TopoDS_Shape& corner) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(corner));
    return std::any_of(others.cbegin(), others.cend(), [&](const TopoDS_Shape& other) {
      return BRep_Tool::Pnt(TopoDS::Vertex(other)).Distance(p) <= near;
    });
  });
}

}  // namespace

bool has_closed_surface(const TopoDS_Shape& shape) {
  const auto faces = sub_shapes(shape, TopAbs_FACE);
  return std::any_of(faces.cbegin(), faces.cend(), is_closed_all_around);
}

std::vector<TopoDS_Shape> empty_faces(const TopoDS_Shape& shape) {
  constexpr double kNothing = 1e-9;  // of the square of the face's diagonal
  const auto faces = sub_shapes(shape, TopAbs_FACE);
  std::vector<TopoDS_Shape> empty;
  std::copy_if(faces.cbegin(), faces.cend(), std::back_inserter(empty), [](const TopoDS_Shape& face) {
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(face));
    if (surface.IsNull() || (!surface->IsUPeriodic() && !surface->IsVPeriodic())) return false;
    const double diagonal = diagonal_of(box_of(face));
    return std::abs(area_of(face)) <= kNothing * diagonal * diagonal;
  });
  return empty;
}

OtherParts other_parts(const TopoDS_Shape& by_either, const TopoDS_Shape& by_surfaces) {
  const auto faces = sub_shapes(by_either, TopAbs_FACE), others = sub_shapes(by_surfaces, TopAbs_FACE);
  OtherParts parts;
  if (faces.Extent() != others.Extent()) return parts;
  for (int f = 1; f <= faces.Extent(); ++f)
    if (is_closed_all_around(faces(f)) && differ(faces(f), others(f))) parts.faces.push_back(faces(f));
  if (parts.faces.empty()) return parts;
  parts.to_be_believed = true;
  for (int f = 1; f <= faces.Extent() && parts.to_be_believed; ++f)
    if (differ(faces(f), others(f)))
      parts.to_be_believed = is_closed_all_around(faces(f)) && have_same_corners(faces(f), others(f));
  return parts;
}

}  // namespace octet
