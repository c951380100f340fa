// SPDX-License-Identifier: BSD-3-Clause
// A model of one solid while the part is still being healed.
#include "geom/occt/solid_model.h"

#include <BRepLib.hxx>
#include <BRepTools.hxx>

#include <utility>

#include "geom/occt/measure.h"
#include "geom/occt/numbering.h"
#include "geom/occt/tessellate.h"
#include "geom/occt/topology.h"

namespace octet {

Model model_of_solid(const TopoDS_Shape& solid, const StageLog& log) {
  const SolidSet alone{{solid}, new BRepTools_History, {}};
  ModelParts parts;
  const Numbering numbering = number_entities(ShapeMaps(solid), alone, parts.notes);
  BRepLib::BuildCurves3d(solid);
  fill_topology(numbering, parts);
  measure_gaps(numbering, parts);
  tessellate(numbering, 0.0, log, parts);
  BRepTools::Clean(solid);
  return Model(std::move(parts));
}

}  // namespace octet
