// SPDX-License-Identifier: BSD-3-Clause
// What the transfer of a file has written down of where its shapes come from.
#include "geom/occt/file_ids.h"

#include <IGESData_IGESModel.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Surface.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_SolidModel.hxx>
#include <StepShape_VertexPoint.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace octet {
namespace {

/// Calls `take(entity, shape)` for all that was transferred.
template <class Take>
void for_each_transferred(const XSControl_Reader& reader, const Take& take) {
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= process->NbMapped(); ++i) {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process->MapItem(i));
    if (!shape.IsNull()) take(process->Mapped(i), shape);
  }
}

/// A face may have become several.
void add(const TopoDS_Shape& shape, TopAbs_ShapeEnum type, int number, std::vector<FileId>& ids) {
  for (TopExp_Explorer it(shape, type); it.More(); it.Next()) ids.push_back({it.Current(), number});
}

/// What the entity is in a B-rep; TopAbs_SHAPE: nothing that has a number in a model.
TopAbs_ShapeEnum type_of(const Handle(Standard_Transient) & entity) {
  if (entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface))) return TopAbs_FACE;
  if (entity->IsKind(STANDARD_TYPE(StepGeom_Surface))) return TopAbs_FACE;  // of a set without topology
  if (entity->IsKind(STANDARD_TYPE(StepShape_EdgeCurve))) return TopAbs_EDGE;
  if (entity->IsKind(STANDARD_TYPE(StepShape_VertexPoint))) return TopAbs_VERTEX;
  if (entity->IsKind(STANDARD_TYPE(StepShape_SolidModel))) return TopAbs_SOLID;
  return TopAbs_SHAPE;
}

}  // namespace

std::vector<FileId> step_ids(const XSControl_Reader& reader) {
  std::vector<FileId> ids;
  const auto model = Handle(StepData_StepModel)::DownCast(reader.Model());
  for_each_transferred(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    const TopAbs_ShapeEnum type = type_of(entity);
    if (type != TopAbs_SHAPE) add(shape, type, model->IdentLabel(entity), ids);
  });
  return ids;
}

std::vector<FileId> iges_ids(const XSControl_Reader& reader) {
  std::vector<FileId> ids;
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  for_each_transferred(reader, [&](const Handle(Standard_Transient) & entity, const TopoDS_Shape& shape) {
    const TopAbs_ShapeEnum type = shape.ShapeType();
    const bool has_number =
        type == TopAbs_SOLID || type == TopAbs_FACE || type == TopAbs_EDGE || type == TopAbs_VERTEX;
    if (has_number) add(shape, type, 2 * model->Number(entity) - 1, ids);
  });
  return ids;
}

std::vector<int> ids_of(const TopTools_IndexedMapOfShape& entities, const std::vector<FileId>& ids) {
  const auto unplaced = [](const TopoDS_Shape& shape) { return shape.Located(TopLoc_Location()); };
  TopTools_DataMapOfShapeInteger id_of;
  for (const FileId& id : ids)
    if (!entities.IsEmpty() && id.shape.ShapeType() == entities(1).ShapeType())
      id_of.Bind(unplaced(id.shape), id.number);
  std::vector<int> numbers(static_cast<std::size_t>(entities.Extent()) + 1, 0);
  for (int i = 1; i <= entities.Extent(); ++i)
    if (const int* number = id_of.Seek(unplaced(entities(i)))) numbers[static_cast<std::size_t>(i)] = *number;
  return numbers;
}

}  // namespace octet
