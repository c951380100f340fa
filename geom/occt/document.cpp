// SPDX-License-Identifier: BSD-3-Clause
// A CAD file to an OCCT shape with its tree of parts, its labels and its unit.
#include "geom/occt/document.h"

#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <NCollection_DataMap.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_Representation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <vector>

#include "base/error.h"
#include "geom/occt/bounded_sweeps.h"
#include "geom/occt/cause.h"
#include "geom/occt/iges_loops.h"
#include "geom/occt/labels.h"
#include "geom/occt/loop_sides.h"
#include "geom/occt/scoped_document.h"
#include "geom/occt/scoped_setting.h"
#include "geom/occt/shape_box.h"
#include "geom/occt/stated_accuracy.h"
#include "geom/occt/sub_shapes.h"

namespace octet {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string quoted(const std::filesystem::path& path) { return fmt::format("'{}'", path.string()); }

/// A complete STEP file ends with END-ISO-10303-21 (ISO 10303-21, 5.2); OCCT reads on without it.
void require_step_end(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(in.tellg());
  const std::streamoff tail = std::min<std::streamoff>(size, 4096);
  in.seekg(size - tail);
  std::string text(static_cast<std::size_t>(tail), '\0');
  in.read(text.data(), tail);
  if (text.find("END-ISO-10303-21") == std::string::npos)
    throw InputError("STEP file " + quoted(path) + " is truncated: it does not end with END-ISO-10303-21");
}

/// Which of the words a file holds, by index; it is read no farther than to the first of them.
std::vector<bool> words_in(const std::filesystem::path& path, const std::vector<std::string>& words) {
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  std::vector<bool> found(words.size(), false);
  std::ifstream in(path, std::ios::binary);
  std::size_t kept = 0;  // of the block before: a word may lie across
  for (const std::string& word : words) kept = std::max(kept, word.size());
  std::string text;
  while (in && !found.front()) {
    text.erase(0, text.size() - std::min(text.size(), kept));
    const std::size_t before = text.size();
    text.resize(before + kBlock);
    in.read(text.data() + before, kBlock);
    text.resize(before + static_cast<std::size_t>(in.gcount()));
    for (std::size_t i = 0; i < words.size(); ++i)
      found[i] = found[i] || text.find(words[i]) != std::string::npos;
  }
  return found;
}

/// Some systems write triangles for the shape and no faces. OCCT 7.6 crashes on such files.
void refuse_triangles_alone(const std::filesystem::path& path) {
  const std::vector<bool> found = words_in(path, {"ADVANCED_FACE", "FACE_SURFACE", "TRIANGULATED_FACE"});
  if (!found[0] && !found[1] && found[2])
    throw InputError(
        "STEP file " + quoted(path) +
        " has no faces but triangles (TRIANGULATED_FACE): export the part with its exact geometry");
}

/// Items of a kind that OCCT does not know (texts, leaders of notes) are null handles to it, and it crashes
/// where it looks for the names of faces among them. Returns how many there were.
int drop_unknown_items(const Handle(Interface_InterfaceModel) & model) {
  int dropped = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto owner = Handle(StepRepr_Representation)::DownCast(model->Value(i));
    if (owner.IsNull()) continue;
    std::vector<Handle(StepRepr_RepresentationItem)> known;
    for (int k = 1; k <= owner->NbItems(); ++k)
      if (!owner->ItemsValue(k).IsNull()) known.push_back(owner->ItemsValue(k));
    const int count = static_cast<int>(known.size());
    if (count == owner->NbItems()) continue;
    Handle(StepRepr_HArray1OfRepresentationItem) items;
    if (count > 0) items = new StepRepr_HArray1OfRepresentationItem(1, count);
    for (int k = 0; k < count; ++k) items->SetValue(k + 1, known[static_cast<std::size_t>(k)]);
    dropped += owner->NbItems() - count;
    owner->SetItems(items);
  }
  return dropped;
}

/// Whether a part of the document has no geometry at all.
bool has_empty_part(const Handle(TDocStd_Document) & document) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence labels;
  shapes->GetShapes(labels);
  return std::any_of(labels.begin(), labels.end(), [](const TDF_Label& label) {
    if (XCAFDoc_ShapeTool::IsAssembly(label) && XCAFDoc_ShapeTool::NbComponents(label) > 0) return false;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    return shape.IsNull() || !TopExp_Explorer(shape, TopAbs_VERTEX).More();
  });
}

/// What to say of files that the parts are in, and that were not found beside this one or could not be read;
/// InputError where a part is empty without. Files without a suffix of STEP are drawings and texts about the
/// parts, and a file may name others that hold what it has itself.
std::optional<std::string> check_external_files(const STEPCAFControl_Reader& reader,
                                                const Handle(TDocStd_Document) & document,
                                                const std::filesystem::path& path) {
  constexpr std::size_t kNamed = 5;
  std::vector<std::string> missing;
  using Files = NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>;
  for (Files::Iterator it(reader.ExternFiles()); it.More(); it.Next()) {
    const std::filesystem::path name = it.Key().ToCString();
    const std::string suffix = lower(name.extension().string());
    const bool is_step = suffix == ".stp" || suffix == ".step" || suffix == ".p21";
    const bool is_read = it.Value()->GetLoadStatus() == IFSelect_RetDone && it.Value()->GetTransferStatus();
    if (is_step && !is_read) missing.push_back(quoted(name));
  }
  if (missing.empty()) return std::nullopt;
  std::sort(missing.begin(), missing.end());
  const std::size_t count = missing.size();
  missing.resize(std::min(count, kNamed));
  const std::string named = fmt::format("{}{}", fmt::join(missing, ", "), count > kNamed ? ", ..." : "");
  if (has_empty_part(document))
    throw InputError(fmt::format(
        "STEP file {} has parts in other files, {} of which were not found beside it or cannot be read: {}",
        quoted(path), count, named));
  return fmt::format(
      "{} file(s) that the STEP file names for its parts were not found beside it or cannot be read, but no "
      "part is empty: {}",
      count, named);
}

/// The number of a face or of the first of its parts, wherever it is placed, and a place on it.
std::string face_in(const TopoDS_Shape& shape, const TopoDS_Shape& face) {
  const TopTools_IndexedMapOfShape parts = sub_shapes(face, TopAbs_FACE),
                                   all = sub_shapes(shape, TopAbs_FACE);
  for (int f = 1; f <= all.Extent(); ++f)
    for (int part = 1; part <= parts.Extent(); ++part) {
      if (!all(f).IsPartner(parts(part))) continue;
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(TopExp_Explorer(all(f), TopAbs_VERTEX).Current()));
      return fmt::format("Face {} at ({:.6g}, {:.6g}, {:.6g})", f, p.X(), p.Y(), p.Z());
    }
  return "a face that is gone";
}

/// InputError where the shape is not what the file has.
void tell_of_sides(const KeepLoopSides& sides, CadDocument& document) {
  const auto told = [&](const std::vector<TopoDS_Shape>& faces) {
    return fmt::format(
        "{} face(s) on spheres or tori, the first is {}, came out of the CAD kernel's reader with "
        "another part of their surface than the file's",
        faces.size(), face_in(document.shape, faces.front()));
  };
  if (!sides.left().empty()) throw InputError(told(sides.left()) + ", and cannot be made anew");
  if (!sides.made().empty()) document.notes.push_back(told(sides.made()) + ", and were made anew");
}

CadDocument read_step(const std::filesystem::path& path) {
  require_step_end(path);
  refuse_triangles_alone(path);
  STEPCAFControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const ScopedSetting names("read.stepcaf.subshapes.name", 1);
  STEPCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  reader.SetMatMode(true);
  reader.SetPropsMode(false);
  // Files that it refers to are looked for beside it, which OCCT does right for an absolute path alone.
  if (reader.ReadFile(std::filesystem::absolute(path).string().c_str()) != IFSelect_RetDone)
    throw InputError("STEP file " + quoted(path) + " cannot be parsed: it is damaged or truncated");
  CadDocument result;
  if (const int dropped = drop_unknown_items(reader.Reader().WS()->Model()); dropped > 0)
    result.notes.push_back(fmt::format(
        "items of the STEP file that were passed over, for the CAD kernel does not know their kind "
        "(texts and leaders of notes, tessellations): {}",
        dropped));
  result.accuracy = stated_accuracy(reader.Reader().WS()->Model());
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) result.unit = lower(lengths.First().ToCString());
  ScopedDocument document;
  {
    const KeepLoopSides sides;
    if (reader.Transfer(document.get())) collect_labels(document.get(), result);
    tell_of_sides(sides, result);
  }
  result.ids = step_ids(reader.Reader());
  result.id_mark = "#";
  if (std::optional<std::string> note = check_external_files(reader, document.get(), path))
    result.notes.push_back(*std::move(note));
  return result;
}

std::string iges_unit(int flag, const std::string& name) {
  switch (flag) {
    case 1:
      return "inch";
    case 2:
      return "millimetre";
    case 4:
      return "foot";
    case 5:
      return "mile";
    case 6:
      return "metre";
    case 7:
      return "kilometre";
    case 8:
      return "mil";
    case 9:
      return "micron";
    case 10:
      return "centimetre";
    case 11:
      return "microinch";
    default:
      return name.empty() ? "millimetre" : lower(name);
  }
}

/// Which curves of an IGES file OCCT's reader goes by: now those in space, now those on the surfaces; those
/// on the surfaces alone; or those in space alone. Values of its `read.surfacecurve.mode`.
enum class IgesCurves { kEither = 0, kOnSurfaces = -2, kInSpace = -3 };

/// `precision`: mm, within which OCCT's reader joins what it reads; 0: what the file states.
CadDocument read_iges_by(const std::filesystem::path& path, IgesCurves curves, double precision = 0.0) {
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const ScopedSetting mode("read.surfacecurve.mode", static_cast<int>(curves));
  IGESCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  reader.SetLayerMode(true);
  if (reader.ReadFile(path.string().c_str()) != IFSelect_RetDone)
    throw InputError("IGES file " + quoted(path) + " cannot be parsed: it is damaged or truncated");
  CadDocument result;
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  double in_file_units = precision > 0.0 ? precision : Interface_Static::RVal("read.precision.val");
  if (!model.IsNull()) {
    const IGESData_GlobalSection& global = model->GlobalSection();
    if (precision > 0.0 && global.UnitValue() > 0.0) in_file_units = precision / global.UnitValue();
    const std::string name = global.UnitName().IsNull() ? "" : global.UnitName()->ToCString();
    result.unit = iges_unit(global.UnitFlag(), name);
  }
  const ScopedSetting whose("read.precision.mode", precision > 0.0 ? 1 : 0);
  const ScopedSetting value("read.precision.val", in_file_units);
  ScopedDocument document;
  if (reader.Transfer(document.get())) collect_labels(document.get(), result);
  result.ids = iges_ids(reader);
  result.id_mark = "D";
  return result;
}

/// Where loops are open by more than the precision that the file states, the reader leaves their faces
/// without anything inside.
CadDocument read_iges_joined(const std::filesystem::path& path) {
  CadDocument result = read_iges_by(path, IgesCurves::kEither);
  const std::vector<TopoDS_Shape> empty = empty_faces(result.shape);
  if (empty.empty()) return result;
  const int least = count_faces(result.shape) - static_cast<int>(empty.size());
  for (const IgesReading& how : other_readings(result.shape)) {
    if (how.in_space) continue;
    CadDocument joined = read_iges_by(path, IgesCurves::kEither, how.precision);
    if (count_faces(joined.shape) < least || !empty_faces(joined.shape).empty()) continue;
    joined.notes.push_back(
        note_of(how, face_in(result.shape, empty.front()) + " has nothing inside its loops"));
    return joined;
  }
  return result;
}

/// Where OCCT's reader goes by the curves in space it takes the part of a ball or a ring that their loop
/// encloses, whatever the file says, or part of a ring twice where the loop meets the seam.
CadDocument read_iges(const std::filesystem::path& path, const IgesReading& how) {
  if (how.in_space) return read_iges_by(path, IgesCurves::kInSpace, how.precision);
  CadDocument result =
      how.precision > 0.0 ? read_iges_by(path, IgesCurves::kEither, how.precision) : read_iges_joined(path);
  if (!has_closed_surface(result.shape)) return result;
  CadDocument other = read_iges_by(path, IgesCurves::kOnSurfaces);
  const auto [faces, believed] = other_parts(result.shape, other.shape);
  if (faces.empty()) return result;
  CadDocument& taken = believed ? other : result;
  taken.notes.push_back(
      fmt::format("{} face(s) on balls or rings, the first is {}, came out of the CAD kernel's reader with "
                  "another part of their surface than the file's loops in (u,v) bound; {}",
                  faces.size(), face_in(result.shape, faces.front()),
                  believed ? "the file was read by these"
                           : "these do not fit the curves in space, by which they were read"));
  return std::move(taken);
}

/// OCCT's parser never looks at the stream's state and loops for ever at an early end: the stream throws.
CadDocument read_brep(const std::filesystem::path& path) {
  CadDocument result;
  BRep_Builder builder;
  std::ifstream in(path, std::ios::binary);
  try {
    in.exceptions(std::ios::failbit | std::ios::badbit);
    BRepTools::Read(result.shape, in, builder);
  } catch (const std::ios_base::failure&) {
    throw InputError("BREP file " + quoted(path) + " cannot be parsed: it is damaged or truncated");
  }
  bound_swept_hyperbolas(result.shape);
  return result;
}

}  // namespace

std::vector<IgesReading> other_readings(const TopoDS_Shape& shape) {
  const double diagonal = diagonal_of(box_of(shape));
  return {{1e-6 * diagonal}, {1e-5 * diagonal}, {1e-4 * diagonal}, {0.0, true}};
}

std::string note_of(const IgesReading& how, const std::string& cause) {
  return how.in_space
             ? fmt::format("read by its curves in space alone, for by those on surfaces {}", cause)
             : fmt::format("read with a precision of {:.3g} mm, for with what the IGES file states {}",
                           how.precision, cause);
}

CadDocument read_document(const std::filesystem::path& path, FileKind kind, const IgesReading& how) {
  CadDocument result;
  try {
    switch (kind) {
      case FileKind::kStep:
        result = read_step(path);
        break;
      case FileKind::kIges:
        result = read_iges(path, how);
        break;
      case FileKind::kBrep:
        result = read_brep(path);
        break;
    }
  } catch (const Standard_Failure& failure) {
    throw InputError(fmt::format("file {} cannot be read: {}", quoted(path), cause_of(failure)));
  }
  if (result.shape.IsNull() || !TopExp_Explorer(result.shape, TopAbs_FACE).More())
    throw InputError("file " + quoted(path) + " holds no shape with faces");
  return result;
}

}  // namespace octet
