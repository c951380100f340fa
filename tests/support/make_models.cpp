// SPDX-License-Identifier: BSD-3-Clause
// Writes the sample parts of models/ as STEP files: octet_make_models DIRECTORY.
#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "tests/support/families.h"

namespace {

TopoDS_Shape cylinder(double x, double y, double z, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), along), radius, length);
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& tool) {
  return BRepAlgoAPI_Cut(from, tool).Shape();
}
TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

/// Rounds the edges that `choose` picks by their middle point.
TopoDS_Shape round_edges(const TopoDS_Shape& shape, double radius,
                         const std::function<bool(const gp_Pnt&)>& choose) {
  BRepFilletAPI_MakeFillet fillet(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges(i)), first, last);
    if (!curve.IsNull() && choose(curve->Value(0.5 * (first + last))))
      fillet.Add(radius, TopoDS::Edge(edges(i)));
  }
  return fillet.Shape();
}

bool near(double a, double b) { return std::abs(a - b) < 1e-6; }

TopoDS_Shape rib(double y) {
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(8, y, 8), gp_Pnt(38, y, 8), gp_Pnt(8, y, 38), true);
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()), gp_Vec(0, 5, 0));
}

/// An L of two plates 8 thick, 100 x 60 and 60 x 70, with two ribs, holes, a slot and rounded edges.
TopoDS_Shape bracket() {
  TopoDS_Shape part = fuse(BRepPrimAPI_MakeBox(100, 60, 8).Shape(), BRepPrimAPI_MakeBox(8, 60, 70).Shape());
  // The corners of both plates, the outer bend and the inner bend.
  part = round_edges(part, 10.0, [](const gp_Pnt& p) {
    return (near(p.X(), 100) && near(p.Z(), 4)) || (near(p.X(), 4) && near(p.Z(), 70));
  });
  part = round_edges(part, 6.0, [](const gp_Pnt& p) { return near(p.X(), 8) && near(p.Z(), 8); });
  part = fuse(part, rib(8));
  part = fuse(part, rib(47));
  for (const double y : {15.0, 45.0}) part = cut(part, cylinder(82, y, -1, gp::DZ(), 5, 20));
  part = cut(part, cylinder(60, 30, -1, gp::DZ(), 9, 20));
  part = cut(part, cylinder(60, 30, 5, gp::DZ(), 13, 20));
  part = cut(part, cylinder(-1, 30, 50, gp::DX(), 8, 20));
  TopoDS_Shape slot =
      fuse(BRepPrimAPI_MakeBox(gp_Pnt(24, 27, -1), gp_Pnt(36, 33, 20)).Shape(),
           fuse(cylinder(24, 30, -1, gp::DZ(), 3, 21), cylinder(36, 30, -1, gp::DZ(), 3, 21)));
  part = cut(part, slot);
  // The lower rim, all around.
  return round_edges(part, 2.0, [](const gp_Pnt& p) {
    return near(p.Z(), 0) && (near(p.X(), 0) || near(p.Y(), 0) || near(p.Y(), 60) || p.X() > 90);
  });
}

/// Two cubes of side 10 that share the face x = 10.
TopoDS_Shape two_boxes() {
  BOPAlgo_Builder builder;
  builder.AddArgument(BRepPrimAPI_MakeBox(10, 10, 10).Shape());
  builder.AddArgument(BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), gp_Pnt(20, 10, 10)).Shape());
  builder.Perform();
  return builder.Shape();
}

TopoDS_Wire profile(double z, double chord, double thickness, double twist) {
  constexpr int kPoints = 9;
  TColgp_Array1OfPnt upper(1, kPoints), lower(1, kPoints);
  const auto place = [&](double x, double y) {
    return gp_Pnt(std::cos(twist) * x - std::sin(twist) * y, std::sin(twist) * x + std::cos(twist) * y, z);
  };
  for (int i = 0; i < kPoints; ++i) {
    const double s = i / (kPoints - 1.0);
    const double bow = 4.0 * s * (1.0 - s);
    upper.SetValue(i + 1, place(chord * (s - 0.5), thickness * bow + 0.15 * chord * bow));
    lower.SetValue(kPoints - i, place(chord * (s - 0.5), -thickness * bow + 0.15 * chord * bow));
  }
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(upper).Curve()));
  wire.Add(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(lower).Curve()));
  return wire.Wire();
}

/// A square prism without a quarter: what refinement towards an edge is tried on.
TopoDS_Shape l_domain() {
  return cut(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), gp_Pnt(10, 10, 4)),
             BRepPrimAPI_MakeBox(gp_Pnt(0, -20, -1), gp_Pnt(20, 0, 5)));
}

/// A twisted, tapered blade: two B-spline sheets that meet in sharp edges, and two flat ends.
TopoDS_Shape blade() {
  BRepOffsetAPI_ThruSections loft(true, false);
  loft.AddWire(profile(0, 40, 4, 0.0));
  loft.AddWire(profile(30, 34, 3.4, 0.2));
  loft.AddWire(profile(60, 28, 2.8, 0.45));
  loft.AddWire(profile(90, 22, 2.2, 0.7));
  loft.Build();
  return loft.Shape();
}

bool write(const TopoDS_Shape& shape, const std::string& directory, const std::string& name) {
  Interface_Static::SetCVal("write.step.product.name", name.c_str());
  STEPControl_Writer writer;
  const std::string path = directory + "/" + name + ".step";
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone ||
      writer.Write(path.c_str()) != IFSelect_RetDone) {
    std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return false;
  }
  return true;
}

Handle(TCollection_HAsciiString) ascii(const char* text) { return new TCollection_HAsciiString(text); }

/// An XCAF document under construction.
class Assembly {
 public:
  explicit Assembly(const std::string& name) {
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document_);
    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document_->Main());
    top_ = shapes_->NewShape();
    TDataStd_Name::Set(top_, name.c_str());
  }

  TDF_Label part(const TopoDS_Shape& shape, const char* name, const Quantity_Color& colour) {
    const TDF_Label label = shapes_->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    XCAFDoc_DocumentTool::ColorTool(document_->Main())->SetColor(label, colour, XCAFDoc_ColorGen);
    return label;
  }

  void use(const TDF_Label& part, const char* name, const gp_Vec& place) {
    gp_Trsf move;
    move.SetTranslation(place);
    TDataStd_Name::Set(shapes_->AddComponent(top_, part, TopLoc_Location(move)), name);
  }

  void material(const TDF_Label& part, const char* name, double density) {
    XCAFDoc_DocumentTool::MaterialTool(document_->Main())
        ->SetMaterial(part, ascii(name), ascii(""), density, ascii("density measure"),
                      ascii("POSITIVE_RATIO_MEASURE"));
  }

  void layer(const TDF_Label& part, const char* name) {
    XCAFDoc_DocumentTool::LayerTool(document_->Main())->SetLayer(part, TCollection_ExtendedString(name));
  }

  TDF_Label last_face(const TDF_Label& part, const char* name, const Quantity_Color& colour) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(XCAFDoc_ShapeTool::GetShape(part), TopAbs_FACE, faces);
    const TDF_Label label = shapes_->AddSubShape(part, faces(faces.Extent()));
    TDataStd_Name::Set(label, name);
    XCAFDoc_DocumentTool::ColorTool(document_->Main())->SetColor(label, colour, XCAFDoc_ColorSurf);
    return label;
  }

  bool write(const std::string& directory, const std::string& name) {
    shapes_->UpdateAssemblies();
    Interface_Static::SetCVal("write.step.product.name", name.c_str());
    STEPCAFControl_Writer writer;  // the parameter exists only once there was one
    Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
    writer.SetLayerMode(true);
    writer.SetMaterialMode(true);
    const std::string path = directory + "/" + name + ".step";
    const bool done =
        writer.Transfer(document_, STEPControl_AsIs) && writer.Write(path.c_str()) == IFSelect_RetDone;
    if (!done) std::fprintf(stderr, "cannot write %s\n", path.c_str());
    return done;
  }

 private:
  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  TDF_Label top_;
};

/// A box without its first face.
TopoDS_Shape open_box(double x, double y, double z) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  TopExp_Explorer face(BRepPrimAPI_MakeBox(x, y, z).Shape(), TopAbs_FACE);
  for (face.Next(); face.More(); face.Next()) builder.Add(shell, face.Current());
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// A plate 40 x 20 x 4 with a block 12 x 12 x 8 and two pins of radius 2 and length 10 standing on it.
bool write_fixture(const std::string& directory, const std::string& name, const TopoDS_Shape& block_shape) {
  Assembly fixture(name);
  const TDF_Label plate = fixture.part(BRepPrimAPI_MakeBox(40, 20, 4).Shape(), "plate",
                                       Quantity_Color(0, 0, 1, Quantity_TOC_RGB));
  const TDF_Label block = fixture.part(block_shape, "block", Quantity_Color(0, 1, 0, Quantity_TOC_RGB));
  const TDF_Label pin =
      fixture.part(BRepPrimAPI_MakeCylinder(2, 10).Shape(), "pin", Quantity_Color(1, 1, 0, Quantity_TOC_RGB));
  fixture.use(plate, "plate:1", gp_Vec(0, 0, 0));
  fixture.use(block, "block:1", gp_Vec(4, 4, 4));
  fixture.use(pin, "pin:1", gp_Vec(24, 10, 4));
  fixture.use(pin, "pin:2", gp_Vec(34, 10, 4));
  fixture.material(plate, "steel", 7.85);
  fixture.material(block, "aluminium", 2.7);
  fixture.layer(pin, "hardware");
  fixture.last_face(block, "seat", Quantity_Color(1, 0, 0, Quantity_TOC_RGB));
  return fixture.write(directory, name);
}

/// Small parts on which attribute points once ran away, or of which nothing was left: an edge over a face
/// that it does not bound, a thin sheet that octree vertices beyond it reached through, a shell thinner than
/// its elements' sagitta, and straight sides that are bent in (u,v), beyond which the facets bulged,
/// a corner where sheets touch, and a void that touches the outside, and a face
/// that is folded onto its neighbour.
bool write_bugs(const std::string& directory) {
  for (const auto& part : octet::test::family_parts())
    for (const char* name : {"roof_over_rod", "plate_0_1", "hollow_ball_0_01", "skewed_roof",
                             "foot_under_round", "boss_over_void", "folded_top"})
      if (part.name == name && !write(part.build(), directory, part.name)) return false;
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: octet_make_models DIRECTORY\n");
    return 2;
  }
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Controller::Init();
  const std::string directory = argv[1];
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  const TopoDS_Shape centred = BRepPrimAPI_MakeBox(gp_Pnt(-15, -15, -15), gp_Pnt(15, 15, 15)).Shape();
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(40, 30, 1).Shape();
  const bool done = write(bracket(), directory, "bracket") &&
                    write(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), directory, "box") &&
                    write(two_boxes(), directory, "two_boxes") && write(ball, directory, "ball") &&
                    write(BRepPrimAPI_MakeCylinder(5, 20).Shape(), directory, "cylinder") &&
                    write(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), directory, "cone") &&
                    write(BRepPrimAPI_MakeTorus(20, 5).Shape(), directory, "torus") &&
                    write(cut(centred, ball), directory, "box_minus_ball") &&
                    write(cut(plate, cylinder(20, 15, -1, gp::DZ(), 6, 3)), directory, "plate_with_hole") &&
                    write(blade(), directory, "blade") && write(l_domain(), directory, "l_domain") &&
                    write_fixture(directory, "fixture", BRepPrimAPI_MakeBox(12, 12, 8).Shape()) &&
                    write_fixture(directory, "fixture_open_block", open_box(12, 12, 8)) &&
                    write_bugs(directory + "/bugs");
  return done ? 0 : 1;
}
