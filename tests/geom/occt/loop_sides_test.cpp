// SPDX-License-Identifier: BSD-3-Clause
// Solids with faces on spheres and tori that loops cut at the seam, through STEP and back.
#include "geom/occt/loop_sides.h"
#include "base/constants.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include "geom/model_check.h"
#include "geom/occt/holed_torus.h"
#include "geom/occt/read_part.h"
#include "geom/occt/shape_measures.h"
#include "geom/occt/silence.h"
#include "geom/occt/sphere_loops.h"
#include "geom/occt/sub_shapes.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

namespace fs = std::filesystem;

// ---------------------------------------------------------------------------------------------------- loops

/// A circle of half angle `opening` about an axis, counter-clockwise about it, in `sides` pieces.
SphereLoop circle(const Vec3& axis, double opening, int sides) {
  const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
  SphereLoop loop;
  constexpr int kPieces = 40;
  for (int s = 0; s < sides; ++s) {
    SphereSide& side = loop.emplace_back();
    for (int i = 0; i <= kPieces; ++i) {
      const double a = 2.0 * kPi * (s + i / double(kPieces)) / sides;
      side.at.push_back(std::cos(opening) * axis + std::sin(opening) * (std::cos(a) * x + std::sin(a) * y));
    }
  }
  return loop;
}

double cap(double opening) { return 2.0 * kPi * (1.0 - std::cos(opening)); }

TEST(SphereLoops, ALoopHasACapToItsLeft) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0.6, -0.64, 0.48)})
    for (const double opening : {0.05, 0.7, 1.5, 1.6, 2.5, 3.0})
      for (const int sides : {1, 2, 5})
        EXPECT_NEAR(left_area(circle(axis, opening, sides)), cap(opening), 0.01 * cap(opening));
}

TEST(SphereLoops, HolesAreTakenOffTheSphere) {
  // Seen from the middle of a hole, a loop runs clockwise.
  const std::vector<SphereLoop> loops = {circle({-1, 0, 0}, kPi - 0.4, 2), circle({0, -1, 0}, kPi - 0.3, 3)};
  EXPECT_NEAR(area_between(loops), 4.0 * kPi - cap(0.4) - cap(0.3), 1e-2);
}

/// That the loops are clear of the poles and of the cut, and go around as the frame says.
void expect_clear(const std::vector<SphereLoop>& loops) {
  const auto frame = clear_frame(loops);
  ASSERT_TRUE(frame);
  EXPECT_NEAR(frame->up.norm(), 1.0, 1e-12);
  EXPECT_NEAR(frame->up.dot(frame->across), 0.0, 1e-12);
  const Vec3 y = frame->up.cross(frame->across);
  for (std::size_t j = 0; j < loops.size(); ++j) {
    double turn = 0.0;
    for (const SphereSide& side : loops[j])
      for (std::size_t i = 1; i < side.at.size(); ++i) {
        // 0 to one turn, from the cut on.
        const auto u = [&](const Vec3& d) { return kPi + std::atan2(-d.dot(y), -d.dot(frame->across)); };
        EXPECT_GE(std::acos(std::abs(side.at[i].dot(frame->up))), frame->clearance - 1e-9);
        const double step = u(side.at[i]) - u(side.at[i - 1]);
        turn += std::remainder(step, 2.0 * kPi);
        if (frame->ring < 0) {
          EXPECT_LT(std::abs(step), kPi) << "the loop crosses the cut";
        }
      }
    EXPECT_NEAR(turn, static_cast<int>(j) == frame->ring ? -2.0 * kPi : 0.0, 1e-9);
  }
}

TEST(SphereLoops, AFrameIsClearOfThem) {
  expect_clear({circle({1, 0, 0}, 0.4, 2)});         // a cap
  expect_clear({circle({1, 0, 0}, 0.5 * kPi, 4)});   // half a sphere
  expect_clear({circle({-1, 0, 0}, kPi - 0.4, 2)});  // a sphere with a hole
  expect_clear({circle({0, 0, 1}, kPi - 0.4, 1), circle({0, 0, -1}, kPi - 0.4, 2)});
  expect_clear({circle({0, 0, 1}, 1.0, 3), circle({0, 0, -1}, kPi - 0.5, 2)});  // a ring
}

// ---------------------------------------------------------------------------------------------------- files

/// A STEP file that goes with it.
class StepFile {
 public:
  StepFile()
      : path_(fs::path(testing::TempDir()) /
              ("octet_loop_sides_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) + "_" +
               std::to_string(::getpid()) + ".step")) {}
  ~StepFile() { fs::remove(path_); }
  StepFile(const StepFile&) = delete;
  StepFile& operator=(const StepFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// `curves`: with curves in (u,v), which STEP files of most systems lack.
Model through_step(const TopoDS_Shape& shape, bool curves) {
  const StepFile file;
  {
    const Silence silence;
    STEPControl_Writer writer;
    Interface_Static::SetIVal("write.surfacecurve.mode", curves ? 1 : 0);
    const bool written = writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
                         writer.Write(file.path().c_str()) == IFSelect_RetDone;
    Interface_Static::SetIVal("write.surfacecurve.mode", 1);
    if (!written) throw std::runtime_error("cannot write " + file.path().string());
  }
  return read_part(file.path());
}

TopoDS_Shape block() { return BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, -50), gp_Pnt(50, 50, 50)).Shape(); }
TopoDS_Shape ball(const gp_Pnt& at, double radius) { return BRepPrimAPI_MakeSphere(at, radius).Shape(); }
TopoDS_Shape rod(const gp_Pnt& from, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, along), radius, length).Shape();
}
TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
TopoDS_Shape fused(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

TopoDS_Shape turned(const TopoDS_Shape& shape) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp::Origin(), gp_Dir(0.3, 0.4, 0.5)), 1.2);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

struct Case {
  std::string name;
  std::function<TopoDS_Shape()> make;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  // The opening has the seam of the ball in its middle, or its other side, or beside it.
  for (const double depth : {1.0, 5.0, 9.7, -4.0})
    for (const auto& [side, out] : {std::pair{"seam", gp_Dir(1, 0, 0)}, std::pair{"back", gp_Dir(-1, 0, 0)},
                                    std::pair{"beside", gp_Dir(0, 1, 0)}, std::pair{"pole", gp_Dir(0, 0, 1)}})
      all.push_back(
          {std::string("hollow_") + side + "_" + std::to_string(static_cast<int>(10 * depth)),
           [depth, out = out] { return cut(block(), ball(gp_Pnt(out.XYZ() * (50.0 - depth)), 10.5)); }});
  all.push_back({"bump", [] { return fused(block(), ball({55, 0, 0}, 10.5)); }});
  all.push_back({"low_bump", [] { return fused(block(), ball({42, 0, 0}, 10.5)); }});
  all.push_back({"ball_on_rod", [] { return fused(rod({0, 0, 0}, {1, 0, 0}, 3, 40), ball({0, 0, 0}, 8)); }});
  all.push_back({"ball_on_askew_rod", [] {
                   return fused(rod({0, 0, 0}, {1, 0.1, 0.2}, 3, 40), ball({0, 0, 0}, 8));
                 }});
  all.push_back({"bead", [] { return fused(rod({-30, 0, 0}, {1, 0, 0}, 3, 60), ball({0, 0, 0}, 8)); }});
  all.push_back({"drilled", [] { return cut(ball({0, 0, 0}, 20), rod({-30, 0, 0}, {1, 0, 0}, 3, 60)); }});
  all.push_back({"two_balls", [] { return fused(ball({0, 0, 0}, 10), ball({12, 0, 0}, 8)); }});
  all.push_back({"ball_less_a_ball", [] { return cut(ball({0, 0, 0}, 10), ball({12, 0, 0}, 8)); }});
  all.push_back({"bubble_in_a_corner", [] { return cut(block(), ball({46, 46, 46}, 10.5)); }});
  return all;
}

/// The torus of a ring sunk into the block, and its edges, turned with the torus to their left from outside.
struct Sunk {
  gp_Torus torus;
  std::vector<TopoDS_Edge> border;
  double area = 0.0;
};

Sunk sunk_ring(const gp_Pnt& at, const gp_Dir& axis) {
  const TopoDS_Shape whole = fused(block(), BRepPrimAPI_MakeTorus(gp_Ax2(at, axis), 12, 6).Shape());
  for (TopExp_Explorer it(whole, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    const auto surface = Handle(Geom_ToroidalSurface)::DownCast(BRep_Tool::Surface(face));
    if (surface.IsNull()) continue;
    Sunk ring{surface->Torus(), {}, area_of(face)};
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
      if (!BRep_Tool::IsClosed(TopoDS::Edge(edge.Current()), face))
        ring.border.push_back(TopoDS::Edge(edge.Current()));
    return ring;
  }
  throw std::runtime_error("no torus");
}

TEST(HoledTorus, IsTheTorusButForTheHole) {
  // The hole across the outer equator, where v = 0, and across u = 0; and upright.
  for (const gp_Dir& axis : {gp_Dir(0, 0, 1), gp_Dir(0, 1, 0), gp_Dir(0, 1, 1)}) {
    const Sunk ring = sunk_ring({65, 0, 0}, axis);
    const TopoDS_Face made = holed_torus(ring.torus, ring.border);
    ASSERT_FALSE(made.IsNull());
    EXPECT_NEAR(area_of(made), ring.area, 1e-6 * ring.area);
    EXPECT_LT(ring.area, 4.0 * kPi * kPi * 12.0 * 6.0);
    const TopTools_IndexedMapOfShape edges = sub_shapes(made, TopAbs_EDGE);
    for (const TopoDS_Edge& edge : ring.border) EXPECT_TRUE(edges.Contains(edge));
  }
}

TEST(HoledTorus, OtherSidesAreNotMade) {
  Sunk ring = sunk_ring({65, 0, 0}, {0, 0, 1});
  for (TopoDS_Edge& edge : ring.border) edge.Reverse();
  EXPECT_TRUE(holed_torus(ring.torus, ring.border).IsNull()) << "the hole itself";
  const Sunk halved = sunk_ring({50, 0, 0}, {0, 0, 1});
  EXPECT_TRUE(holed_torus(halved.torus, halved.border).IsNull()) << "two rims that go around the tube";
}

class LoopSides : public ::testing::TestWithParam<Case> {};

TEST_P(LoopSides, ComeThroughStep) {
  const TopoDS_Shape made = GetParam().make();
  for (const bool turn : {false, true})
    for (const bool curves : {false, true}) {
      const TopoDS_Shape shape = turn ? turned(made) : made;
      const Model model = through_step(shape, curves);
      EXPECT_EQ(check_model(model), "");
      ASSERT_EQ(model.count(3), 1);
      EXPECT_NEAR(model.region(1).volume, volume_of(shape), 1e-5 * volume_of(shape)) << turn << curves;
      double area = 0.0;
      for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
      EXPECT_NEAR(area, area_of(shape), 1e-5 * area_of(shape)) << turn << curves;
    }
}

INSTANTIATE_TEST_SUITE_P(Solids, LoopSides, ::testing::ValuesIn(cases()), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', 'm');
  return name;
});

TEST(LoopSides, OneThatWasMadeAnewIsTold) {
  const Model model = through_step(cut(block(), ball({45, 0, 0}, 10)), true);
  int round = 0;
  for (int f = 1; f <= model.count(2); ++f)
    if (model.surface(f).kind() == std::string_view("sphere")) round = f;
  EXPECT_TRUE(
      has_note(model, "1 face(s) on spheres or tori, the first is Face " + std::to_string(round) + " at "));
  const Model other = through_step(cut(block(), ball({0, 45, 0}, 10)), true);
  EXPECT_FALSE(has_note(other, "on spheres"));
}

TEST(LoopSides, OneThatWasMadeAnewKeepsItsColour) {
  const TopoDS_Shape shape = cut(block(), ball({45, 0, 0}, 10));
  const StepFile file;
  {
    const Silence silence;
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label part = shapes->AddShape(shape, false);
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      const bool round =
          !Handle(Geom_SphericalSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(it.Current()))).IsNull();
      XCAFDoc_DocumentTool::ColorTool(document->Main())
          ->SetColor(shapes->AddSubShape(part, it.Current()),
                     Quantity_Color(round ? Quantity_NOC_RED : Quantity_NOC_GREEN), XCAFDoc_ColorSurf);
    }
    STEPCAFControl_Writer writer;
    ASSERT_TRUE(writer.Transfer(document, STEPControl_AsIs));
    ASSERT_EQ(writer.Write(file.path().c_str()), IFSelect_RetDone);
    XCAFApp_Application::GetApplication()->Close(document);
  }
  const Model model = read_part(file.path());
  EXPECT_TRUE(has_note(model, "on spheres"));
  int red = 0;
  for (int f = 1; f <= model.count(2); ++f) {
    const bool round = model.face(f).colour == "#ff0000";
    red += round;
    EXPECT_EQ(model.face(f).colour, round ? "#ff0000" : "#00ff00") << f;
    if (round) {
      EXPECT_GT(model.face(f).area, 0.7 * 4.0 * kPi * 100.0);
    }
  }
  EXPECT_EQ(red, 1);
}

}  // namespace
}  // namespace octet::test
