// SPDX-License-Identifier: BSD-3-Clause
// OCCT's conversion, where it is exact, with curves on faces that are judged and, where need be, fitted.
#include "geom/occt/spline_solids.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>

#include "geom/occt/converted_curves.h"
#include "geom/occt/gathered.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/spline_limits.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"

namespace octet {
namespace {

bool all_convert_exactly(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (!converts_exactly(TopoDS::Face(it.Current()))) return false;
  return true;
}

}  // namespace

std::optional<SplineSolids> as_splines(const std::vector<TopoDS_Shape>& solids,
                                       const std::vector<std::size_t>& which) {
  std::vector<TopoDS_Shape> chosen;
  for (const std::size_t i : which) chosen.push_back(solids[i]);
  const TopoDS_Shape before = compound_of(chosen);
  if (sub_shapes(before, TopAbs_FACE).Extent() > kMostSplineFaces || !all_convert_exactly(before))
    return std::nullopt;
  SplineSolids result{solids, new BRepTools_History()};
  try {
    BRepBuilderAPI_NurbsConvert convert(before);
    if (!convert.IsDone()) return std::nullopt;
    for (const std::size_t i : which) result.solids[i] = convert.ModifiedShape(solids[i]);
    TopTools_IndexedMapOfShape of_others;
    for (std::size_t i = 0; i < solids.size(); ++i)
      if (std::find(which.begin(), which.end(), i) == which.end()) TopExp::MapShapes(solids[i], of_others);
    for (const TopAbs_ShapeEnum type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      const TopTools_IndexedMapOfShape shapes = sub_shapes(before, type);
      for (int i = 1; i <= shapes.Extent(); ++i) {
        const TopoDS_Shape& shape = shapes(i);
        const TopoDS_Shape made = convert.ModifiedShape(shape);
        if (made.IsSame(shape)) continue;
        if (of_others.Contains(shape)) result.history->AddModified(shape, shape);
        result.history->AddModified(shape, made);
      }
    }
    double allowed = 0.0;
    for (const std::size_t i : which) {
      const double noise = kRoundingShare * diagonal_of(box_of(solids[i]));
      mend_conversion(solids[i], convert, noise);
      allowed = std::max({allowed, noise, kWiderAsSplines * BRep_Tool::MaxTolerance(solids[i], TopAbs_EDGE)});
    }
    for (const std::size_t i : which)
      if (!lower_tolerances_to(result.solids[i], allowed)) return std::nullopt;
    return result;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace octet
