// SPDX-License-Identifier: BSD-3-Clause
// Faces are taken by the vertices they share; files are written into memory.
#include "geom/occt/piece_file.h"

#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <functional>
#include <sstream>

#include "base/entity_words.h"
#include "base/error.h"
#include "geom/occt/byte_stream.h"
#include "geom/occt/scoped_document.h"
#include "geom/occt/scoped_setting.h"
#include "geom/occt/solids.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

/// The entities that are wished for, solids by themselves.
struct Wished {
  TopTools_IndexedMapOfShape solids, others;
};

Wished wished_shapes(const ShapeMaps& as_read, const std::vector<ModelRef>& entities) {
  Wished wished;
  for (const ModelRef entity : entities) {
    if (!entity.valid() || entity.dim > 3) throw InputError("a piece needs entities with numbers from 1");
    const TopTools_IndexedMapOfShape& all = as_read.of[entity.dim];
    if (entity.tag > all.Extent())
      throw InputError(fmt::format("there is no {} {} in the file, which has {}",
                                   shape_word(entity.dim), entity.tag, all.Extent()));
    (entity.dim == 3 ? wished.solids : wished.others).Add(all(entity.tag));
  }
  return wished;
}

/// Per face, [0] unused.
using Choice = std::vector<char>;

/// The faces that are one of these shapes or have one on their boundary.
Choice faces_with(const TopTools_IndexedMapOfShape& faces, const TopTools_IndexedMapOfShape& shapes) {
  Choice choice(static_cast<std::size_t>(faces.Extent()) + 1, 0);
  for (int f = 1; f <= faces.Extent(); ++f)
    for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
      const TopTools_IndexedMapOfShape parts = sub_shapes(faces(f), type);
      for (int i = 1; i <= parts.Extent() && !choice[static_cast<std::size_t>(f)]; ++i)
        choice[static_cast<std::size_t>(f)] = shapes.Contains(parts(i)) ? 1 : 0;
    }
  return choice;
}

std::vector<int> numbers_of(const Choice& choice) {
  std::vector<int> numbers;
  for (std::size_t f = 1; f < choice.size(); ++f)
    if (choice[f]) numbers.push_back(static_cast<int>(f));
  return numbers;
}

/// Those that are not among these shapes.
std::vector<int> without(const TopTools_IndexedMapOfShape& shapes, const TopTools_IndexedMapOfShape& faces,
                         std::vector<int> numbers) {
  std::erase_if(numbers, [&](int number) { return shapes.Contains(faces(number)); });
  return numbers;
}

/// Adds the faces as one shell, for what STEP files have of faces by themselves shares no edges.
void add_faces(const TopTools_IndexedMapOfShape& faces, const std::vector<int>& numbers,
               TopoDS_Shape& whole) {
  if (numbers.empty()) return;
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const int number : numbers) builder.Add(shell, faces(number));
  builder.Add(whole, shell);
}

std::string brep_file(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out, false, false, TopTools_FormatVersion_CURRENT);
  return std::move(out).str();
}

/// Marks the faces of these numbers as parts of `whole`.
void mark_faces(const TDF_Label& whole, const TopTools_IndexedMapOfShape& faces,
                const std::vector<int>& numbers, bool is_wished) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(whole);
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(whole);
  for (const int number : numbers) {
    const TDF_Label label = shapes->AddSubShape(whole, faces(number));
    if (label.IsNull()) continue;  // a face of two solids that are parts of their own
    TDataStd_Name::Set(label, fmt::format("Face{}", number).c_str());
    if (is_wished) colours->SetColor(label, Quantity_Color(Quantity_NOC_RED), XCAFDoc_ColorSurf);
  }
}

/// A piece is the same file whenever it is written.
void set_header(const Handle(StepData_StepModel) & model) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(new TCollection_HAsciiString("piece"));
  header.SetTimeStamp(new TCollection_HAsciiString("1970-01-01T00:00:00"));
  header.SetOriginatingSystem(new TCollection_HAsciiString("Octet"));
}

std::string step_file(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces,
                      const PartPiece& piece) {
  STEPCAFControl_Controller::Init();
  const ScopedSetting names("write.stepcaf.subshapes.name", 1);
  ScopedDocument document;
  const TDF_Label whole = XCAFDoc_DocumentTool::ShapeTool(document.get()->Main())->AddShape(shape, false);
  TDataStd_Name::Set(whole, "piece");
  mark_faces(whole, faces, piece.wished, true);
  mark_faces(whole, faces, piece.around, false);
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  if (!writer.Transfer(document.get(), STEPControl_AsIs))
    throw InputError("the piece cannot be made a STEP file");
  const Handle(XSControl_WorkSession) session = writer.ChangeWriter().WS();
  const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
  set_header(model);
  StepData_StepWriter text(model);
  text.SendModel(Handle(StepData_Protocol)::DownCast(session->Protocol()));
  std::ostringstream out;
  text.Print(out);
  return std::move(out).str();
}

}  // namespace

PartPiece make_piece(const TopoDS_Shape& shape, const PieceWish& wish) {
  const ShapeMaps as_read(shape);
  const TopTools_IndexedMapOfShape& faces = as_read.of[2];
  const Wished wished = wished_shapes(as_read, wish.entities);
  const Choice first = faces_with(faces, wished.others);
  Choice all = first;
  for (int i = 0; i < wish.around; ++i) {
    TopTools_IndexedMapOfShape corners;
    for (const int number : numbers_of(all)) TopExp::MapShapes(faces(number), TopAbs_VERTEX, corners);
    const Choice next = faces_with(faces, corners);
    std::transform(all.begin(), all.end(), next.begin(), all.begin(),
                   std::bit_or<>());  // a ball has no corner
  }
  TopTools_IndexedMapOfShape of_solids, covered;
  std::vector<TopoDS_Shape> solids, loose;
  for (int i = 1; i <= wished.solids.Extent(); ++i) {
    solids.push_back(wished.solids(i));
    TopExp::MapShapes(wished.solids(i), TopAbs_FACE, of_solids);
  }
  for (int f = 1; f <= faces.Extent(); ++f)
    if (first[static_cast<std::size_t>(f)]) TopExp::MapShapes(faces(f), covered);
  for (int i = 1; i <= wished.others.Extent(); ++i)
    if (!covered.Contains(wished.others(i))) loose.push_back(wished.others(i));

  PartPiece piece;
  piece.wished = numbers_of(first);
  for (const int number : without(of_solids, faces, numbers_of(all)))
    if (!first[static_cast<std::size_t>(number)]) piece.around.push_back(number);
  std::vector<int> alone = without(of_solids, faces, piece.wished);
  alone.insert(alone.end(), piece.around.begin(), piece.around.end());
  TopoDS_Compound whole;
  const BRep_Builder builder;
  builder.MakeCompound(whole);
  for (const TopoDS_Shape& solid : solids) builder.Add(whole, solid);
  add_faces(faces, alone, whole);
  for (const TopoDS_Shape& shape : loose) builder.Add(whole, shape);
  piece.file = wish.format == PieceFormat::kBrep ? brep_file(whole) : step_file(whole, faces, piece);
  return piece;
}

std::string encode_piece(const PartPiece& piece) {
  ByteWriter out;
  out(piece.file, piece.wished, piece.around);
  return std::move(out.bytes);
}

PartPiece decode_piece(std::string_view bytes) {
  ByteReader in(bytes);
  PartPiece piece;
  in(piece.file, piece.wished, piece.around);
  return piece;
}

}  // namespace octet
