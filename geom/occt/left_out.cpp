// SPDX-License-Identifier: BSD-3-Clause
// What no tag came of, from solids down.
#include "geom/occt/left_out.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <cmath>

#include "geom/occt/canonical.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// Volume, area or length and centre of mass; a vertex where there is neither (infinite or damaged entities).
void measure(int dim, const TopoDS_Shape& shape, LeftOut& item) {
  if (const TopExp_Explorer vertex(shape, TopAbs_VERTEX); vertex.More())
    item.place = to_vec(BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())));
  if (dim == 0) return;
  try {
    GProp_GProps properties;
    if (dim == 1)
      BRepGProp::LinearProperties(shape, properties);
    else if (dim == 2)
      BRepGProp::SurfaceProperties(shape, properties);
    else
      BRepGProp::VolumeProperties(shape, properties);
    const Vec3 centre = to_vec(properties.CentreOfMass());
    if (!std::isfinite(properties.Mass()) || !(centre.norm() < Precision::Infinite())) return;
    item.measure = std::abs(properties.Mass());
    item.place = centre;
  } catch (const Standard_Failure&) {
    return;
  }
}

}  // namespace

std::vector<LeftOut> left_out(const ShapeMaps& as_read, const Numbering& numbering) {
  std::vector<LeftOut> items;
  TopTools_MapOfShape told;
  for (int dim = 3; dim >= 0; --dim)
    for (int number = 1; number <= as_read.of[dim].Extent(); ++number) {
      const TopoDS_Shape& shape = as_read.of[dim](number);
      if (!numbering.became[dim][static_cast<std::size_t>(number)].empty() || told.Contains(shape)) continue;
      LeftOut item;
      item.entity = {dim, number};
      measure(dim, shape, item);
      items.push_back(item);
      for (int below = 0; below < dim; ++below)
        for (TopExp_Explorer it(shape, kShapeTypes[below]); it.More(); it.Next()) told.Add(it.Current());
    }
  return items;
}

}  // namespace octet
