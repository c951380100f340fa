// SPDX-License-Identifier: BSD-3-Clause
// A walk down an XCAF document that places each label's shape where the instance stands.
#include "geom/occt/labels.h"

#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_Material.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace octet {
namespace {

/// A text of the file on one line. Writers end a line within a long text where it is full, and OCCT's reader
/// leaves out the second of the two characters that some end it with: what is left of it is no part of the
/// text. Other characters that print nothing count as spaces.
std::string on_one_line(std::string text) {
  std::erase(text, '\r');
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

std::string utf8(const TCollection_ExtendedString& wide) {
  std::string text(static_cast<std::size_t>(wide.LengthOfCString()) + 1, '\0');
  Standard_PCharacter start = text.data();
  wide.ToUTF8CString(start);
  text.resize(text.find('\0'));
  return on_one_line(std::move(text));
}

std::string label_name(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (!label.FindAttribute(TDataStd_Name::GetID(), attribute)) return {};
  std::string text = utf8(attribute->Get());
  // OCCT writes its own marks where the file has no name.
  if (text == "NONE" || text.rfind("=>[", 0) == 0) return {};
  return text;
}

std::string label_colour(const TDF_Label& label) {
  Quantity_Color colour;
  const Handle(XCAFDoc_ColorTool) tool = XCAFDoc_DocumentTool::ColorTool(label);
  if (!tool->GetColor(label, XCAFDoc_ColorSurf, colour) && !tool->GetColor(label, XCAFDoc_ColorGen, colour) &&
      !tool->GetColor(label, XCAFDoc_ColorCurv, colour))
    return {};
  Standard_Real r = 0, g = 0, b = 0;
  colour.Values(r, g, b, Quantity_TOC_sRGB);
  const auto byte = [](double x) { return static_cast<int>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(r), byte(g), byte(b));
}

std::string label_layer(const TDF_Label& label) {
  const Handle(TColStd_HSequenceOfExtendedString) layers =
      XCAFDoc_DocumentTool::LayerTool(label)->GetLayers(label);
  std::string text;
  if (layers.IsNull()) return text;
  std::set<std::string> seen;
  for (const TCollection_ExtendedString& layer : *layers)
    if (const std::string name = utf8(layer); seen.insert(name).second)
      text += (text.empty() ? "" : ", ") + name;
  return text;
}

void add_material(const TDF_Label& label, Marks& marks) {
  Handle(TDataStd_TreeNode) node;
  if (!label.FindAttribute(XCAFDoc::MaterialRefGUID(), node) || !node->HasFather()) return;
  Handle(XCAFDoc_Material) material;
  if (!node->Father()->FindAttribute(XCAFDoc_Material::GetID(), material)) return;
  if (!material->GetName().IsNull()) marks.material = on_one_line(material->GetName()->ToCString());
  marks.density = material->GetDensity();
}

Marks marks_of(const TDF_Label& label) {
  Marks marks;
  marks.name = label_name(label);
  marks.colour = label_colour(label);
  marks.layer = label_layer(label);
  add_material(label, marks);
  return marks;
}

void take_missing(std::string& text, const std::string& other) {
  if (text.empty()) text = other;
}

bool says_something(const Marks& marks) {
  return !marks.name.empty() || !marks.colour.empty() || !marks.layer.empty() || !marks.material.empty();
}

class LabelWalk {
 public:
  explicit LabelWalk(CadDocument& result) : result_(result) {}

  void visit(const TDF_Label& label, const TopLoc_Location& place, int parent) {
    TDF_Label target = label;
    if (XCAFDoc_ShapeTool::IsReference(label)) XCAFDoc_ShapeTool::GetReferredShape(label, target);
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(target);
    if (shape.IsNull()) return;
    const TopoDS_Shape placed = shape.Moved(place);
    // What is said of this use of the part goes before what is said of the part, but for its name.
    const Marks use = marks_of(label), part = label == target ? use : marks_of(target);
    Marks marks = use;
    take_missing(marks.name = part.name, use.name);
    take_missing(marks.colour, part.colour);
    take_missing(marks.layer, part.layer);
    if (marks.material.empty())
      std::tie(marks.material, marks.density) = std::tie(part.material, part.density);
    add(placed, marks, XCAFDoc_ShapeTool::IsAssembly(target));
    const int node = add_node(placed, target, marks, use.name, parent);
    visit_components(target, place, node);
    visit_sub_shapes(target, place);
  }

 private:
  void visit_components(const TDF_Label& target, const TopLoc_Location& place, int node) {
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(target, components);
    for (const TDF_Label& component : components)
      visit(component, place * XCAFDoc_ShapeTool::GetLocation(component), node);
  }

  void visit_sub_shapes(const TDF_Label& target, const TopLoc_Location& place) {
    TDF_LabelSequence parts;
    XCAFDoc_ShapeTool::GetSubShapes(target, parts);
    for (const TDF_Label& part : parts) {
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(part);
      if (!shape.IsNull()) add(shape.Moved(place), marks_of(part), false);
    }
  }

  void add(const TopoDS_Shape& shape, const Marks& marks, bool is_assembly) {
    if (says_something(marks)) result_.labels.push_back({shape, marks, is_assembly});
  }

  /// The index of the new node; the parent's where the shape holds no solid and no shell (IGES files list
  /// thousands of loose faces as parts).
  int add_node(const TopoDS_Shape& shape, const TDF_Label& target, const Marks& marks,
               const std::string& instance, int parent) {
    if (!TopExp_Explorer(shape, TopAbs_SHELL).More()) return parent;
    PartNode node;
    node.name = marks.name;
    if (instance != marks.name) node.instance = instance;
    node.parent = parent;
    node.colour = marks.colour;
    node.layer = marks.layer;
    node.material = marks.material;
    node.density = marks.density;
    const auto first = std::find(targets_.begin(), targets_.end(), target);
    node.first_use = static_cast<int>(first - targets_.begin());
    targets_.push_back(target);
    result_.tree.push_back({node, shape});
    return static_cast<int>(result_.tree.size()) - 1;
  }

  CadDocument& result_;
  std::vector<TDF_Label> targets_;  ///< of the nodes
};

}  // namespace

void collect_labels(const Handle(TDocStd_Document) & document, CadDocument& result) {
  const Handle(XCAFDoc_ShapeTool) tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence free;
  tool->GetFreeShapes(free);
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  LabelWalk walk(result);
  TopoDS_Shape only;
  int count = 0;
  for (const TDF_Label& label : free) {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) continue;
    only = shape;
    ++count;
    builder.Add(all, shape);
    // Of an IGES file it may be a use of a part, with a place of its own.
    walk.visit(label, XCAFDoc_ShapeTool::GetLocation(label), -1);
  }
  if (count > 0) result.shape = count == 1 ? only : TopoDS_Shape(all);
}

}  // namespace octet
