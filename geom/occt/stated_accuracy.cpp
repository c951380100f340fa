// SPDX-License-Identifier: BSD-3-Clause
// What a STEP file says of how near places are one and the same.
#include "geom/occt/stated_accuracy.h"

#include <STEPConstruct_UnitContext.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepRepr_GlobalUncertaintyAssignedContext.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <cmath>

namespace octet {
namespace {

bool has_geometry(const StepRepr_Representation& representation) {
  for (int i = 1; i <= representation.NbItems(); ++i) {
    const Handle(StepRepr_RepresentationItem) item = representation.ItemsValue(i);
    if (!item.IsNull() && (item->IsKind(STANDARD_TYPE(StepShape_SolidModel)) ||
                           item->IsKind(STANDARD_TYPE(StepShape_ShellBasedSurfaceModel))))
      return true;
  }
  return false;
}

/// 0: it states none.
double accuracy_of(const StepRepr_Representation& representation) {
  const auto context = Handle(StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx)::DownCast(
      representation.ContextOfItems());
  if (context.IsNull() || context->GlobalUncertaintyAssignedContext().IsNull() ||
      context->GlobalUnitAssignedContext().IsNull())
    return 0.0;
  STEPConstruct_UnitContext units;
  units.ComputeFactors(context->GlobalUnitAssignedContext());
  units.ComputeTolerance(context->GlobalUncertaintyAssignedContext());
  const double accuracy = units.HasUncertainty() ? units.Uncertainty() * units.LengthFactor() : 0.0;
  return std::isfinite(accuracy) && accuracy > 0.0 ? accuracy : 0.0;
}

}  // namespace

double stated_accuracy(const Handle(Interface_InterfaceModel) & model) {
  double least = 0.0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto representation = Handle(StepRepr_Representation)::DownCast(model->Value(i));
    if (representation.IsNull() || !has_geometry(*representation)) continue;
    const double accuracy = accuracy_of(*representation);
    if (accuracy > 0.0 && (least == 0.0 || accuracy < least)) least = accuracy;
  }
  return least;
}

}  // namespace octet
