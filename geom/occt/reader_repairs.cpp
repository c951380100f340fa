// SPDX-License-Identifier: BSD-3-Clause
// OCCT's default repairs with one of them switched off.
#include "geom/occt/reader_repairs.h"

#include <ShapeExtend_MsgRegistrator.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_Solid.hxx>
#include <ShapeFix_Wire.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>

namespace octet {
namespace {

constexpr int kManyLoops = 256, kManySides = 512;

bool any_has_more(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, int children) {
  for (TopExp_Explorer it(shape, kind); it.More(); it.Next())
    if (it.Current().NbChildren() > children) return true;
  return false;
}

}  // namespace

bool has_countless_sides(const TopoDS_Shape& shape) {
  return any_has_more(shape, TopAbs_FACE, kManyLoops) || any_has_more(shape, TopAbs_WIRE, kManySides);
}

void repair_but_for_crossings(const TopoDS_Shape& shape, double precision, double most_tolerance,
                              ShapeProcess_ShapeContext& context, const Message_ProgressRange& progress) {
  const Handle(ShapeExtend_MsgRegistrator) messages = new ShapeExtend_MsgRegistrator;
  const Handle(ShapeFix_Shape) repair = new ShapeFix_Shape;
  repair->Init(shape);
  repair->SetMsgRegistrator(messages);
  repair->SetPrecision(precision);
  repair->SetMaxTolerance(most_tolerance);
  const Handle(ShapeFix_Wire) loops = repair->FixFaceTool()->FixWireTool();
  loops->FixSameParameterMode() = 0;
  loops->FixNonAdjacentIntersectingEdgesMode() = 0;
  repair->FixSolidTool()->CreateOpenSolidMode() = false;
  try {
    repair->Perform(progress);
  } catch (const Standard_Failure&) {
    return;  // as the reader does: the shape stays as it is
  }
  const TopoDS_Shape repaired = repair->Shape();
  if (repaired.IsNull() || repaired == shape) return;
  context.RecordModification(repair->Context(), messages);
  context.SetResult(repaired);
}

}  // namespace octet
