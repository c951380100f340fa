// SPDX-License-Identifier: BSD-3-Clause
// Faces embedded in a solid, as baffles and cracks are, are meshed; what else lies within one is left out.
#include <gtest/gtest.h>

#include <BOPAlgo_Builder.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <map>
#include <set>

#include "app/exit_code.h"
#include "app/mesh_part.h"
#include "base/constants.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "tests/app/program.h"

namespace octet {
namespace {

/// The solids among the pieces, with what lies in them.
Model fragments(const std::vector<TopoDS_Shape>& shapes) {
  BOPAlgo_Builder builder;
  for (const TopoDS_Shape& shape : shapes) builder.AddArgument(shape);
  builder.Perform();
  TopoDS_Compound solids;
  BRep_Builder().MakeCompound(solids);
  for (TopExp_Explorer it(builder.Shape(), TopAbs_SOLID); it.More(); it.Next())
    BRep_Builder().Add(solids, it.Current());
  return model_from_shape(solids);
}

/// A square of the plane's first two axes, its sides `half` from the origin.
TopoDS_Shape square(const gp_Ax3& place, double half) {
  return BRepBuilderAPI_MakeFace(gp_Pln(place), -half, half, -half, half).Shape();
}

TopoDS_Shape cube() { return BRepPrimAPI_MakeBox(2, 2, 2).Shape(); }

std::vector<int> embedded_faces(const Model& model) {
  std::vector<int> faces;
  for (int f = 1; f <= model.count(2); ++f)
    if (model.is_embedded(f)) faces.push_back(f);
  return faces;
}

/// Complete, with triangles on the face and a tetrahedron of the region on either side of each: by what the
/// mesh says, not by the claims.
void expect_sheet(const MeshResult& result, const Model& model, int face, double area_error = 1e-9) {
  const Mesh& mesh = result.mesh;
  std::map<std::set<Mesh::Index>, int> sides;
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangle_on[i] == face) {
      const auto& t = mesh.triangles[i];
      sides[{t[0], t[1], t[2]}] = 0;
      area +=
          0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm();
    }
  EXPECT_NEAR(area, model.face(face).area, area_error);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    for (int skipped = 0; skipped < 4; ++skipped) {
      std::set<Mesh::Index> corners(mesh.tets[i].begin(), mesh.tets[i].end());
      corners.erase(mesh.tets[i][static_cast<std::size_t>(skipped)]);
      const auto at = sides.find(corners);
      if (at == sides.end()) continue;
      ++at->second;
      EXPECT_EQ(mesh.tet_in[i], model.face(face).region[0]);
    }
  EXPECT_FALSE(sides.empty());
  EXPECT_TRUE(std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 2; }));
}

void expect_sheets(const Model& model, std::size_t count, double size, double area_error = 1e-9) {
  EXPECT_TRUE(check_model(model).empty());
  const std::vector<int> faces = embedded_faces(model);
  ASSERT_EQ(faces.size(), count);
  MeshOptions options;
  options.size = size;
  const MeshResult result = mesh_part(model, options);
  EXPECT_EQ(result.report.status, MeshStatus::kComplete);
  EXPECT_TRUE(result.report.faults.empty());
  EXPECT_GT(result.report.quality.min_dihedral, 20.0 * kDegree);
  for (const int f : faces) expect_sheet(result, model, f, area_error);
}

TEST(Embedded, ASquareInACube) {
  const Model model = fragments({cube(), square(gp_Ax3({1, 1, 1}, {0.1, 0.2, 1}), 0.5)});
  expect_sheets(model, 1, 0.3);
}

/// One is parted by the other, which gets an edge within.
TEST(Embedded, SquaresThatCross) {
  expect_sheets(
      fragments({cube(), square(gp_Ax3({1, 1, 1}, gp::DZ()), 0.5), square(gp_Ax3({1, 1, 1}, gp::DX()), 0.4)}),
      3, 0.3);
}

TEST(Embedded, ABaffleThatMeetsAWall) {
  const Model model = fragments({cube(), square(gp_Ax3({0, 1, 1}, gp::DZ()), 0.7)});
  expect_sheets(model, 1, 0.3);
}

TEST(Embedded, ASheetThroughTwoSolidsIsOneFaceInEach) {
  expect_sheets(fragments({cube(), BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 0), gp_Pnt(4, 2, 2)).Shape(),
                           square(gp_Ax3({2, 1, 1}, gp::DZ()), 0.7)}),
                2, 0.3);
}

TEST(Embedded, ATubeWithoutLids) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2({1, 1, 0.5}, gp::DZ()), 0.6, 1).Shape();
  expect_sheets(fragments({cube(), TopExp_Explorer(rod, TopAbs_FACE).Current()}), 1, 0.2, 0.02);
}

TEST(Embedded, ASheetCloseToAWallAndOneBesideIt) {
  expect_sheets(fragments({cube(), square(gp_Ax3({1, 1, 1.95}, gp::DZ()), 0.5),
                           square(gp_Ax3({1, 1, 1.9}, gp_Dir(0.02, 0, 1)), 0.5)}),
                2, 0.3);
}

TEST(Embedded, EdgesAndVerticesAloneAreLeftOut) {
  for (const TopoDS_Shape& thing :
       {TopoDS_Shape(BRepBuilderAPI_MakeEdge(gp_Pnt(0.5, 0.5, 0.5), gp_Pnt(1, 1, 2))),
        TopoDS_Shape(BRepBuilderAPI_MakeVertex(gp_Pnt(1, 1, 1)))}) {
    const Model model = fragments({cube(), thing});
    EXPECT_EQ(model.count(2), 6);
    EXPECT_EQ(mesh_part(model).report.status, MeshStatus::kComplete);
    EXPECT_TRUE(std::any_of(model.notes().begin(), model.notes().end(), [](const std::string& note) {
      return note.find("are left out") != std::string::npos;
    }));
  }
}

TEST(Embedded, AFaceOutsideOfAllSolidsIsAFaultAndNothingElse) {
  ModelParts parts = fragments({cube(), square(gp_Ax3({1, 1, 1}, gp::DZ()), 0.5)}).parts();
  const auto at = std::find_if(parts.faces.begin() + 1, parts.faces.end(),
                               [](const ModelFace& face) { return face.region[0] == face.region[1]; });
  const int face = static_cast<int>(at - parts.faces.begin());
  at->region = {0, 0};
  std::erase(parts.regions[1].faces, face);
  const MeshResult result = mesh_part(Model(std::move(parts)));
  EXPECT_EQ(result.report.status, MeshStatus::kIncomplete);
  ASSERT_EQ(result.report.faults.size(), 1u);
  EXPECT_EQ(result.report.faults[0].entity, model_face(face));
  EXPECT_NEAR(result.report.faults[0].place.z(), 1.0, 1e-9);
  EXPECT_TRUE(result.report.acceptance.holds());
  EXPECT_NEAR(result.report.volume, 8.0, 1e-9);
}

/// A cube and a square beside it, in it, or through its wall, which share nothing.
class EmbedCommand : public ::testing::Test {
 protected:
  void write(const gp_Ax3& place, double half = 0.5) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, cube());
    builder.Add(all, square(place, half));
    ASSERT_TRUE(BRepTools::Write(all, part_.c_str()));
  }
  TemporaryDirectory out_;
  std::string part_ = out_.file("part.brep"), mesh_ = out_.file("part.msh");
};

TEST_F(EmbedCommand, LooseFacesAreLeftOutUnlessItIsAskedFor) {
  write(gp_Ax3({1, 1, 1}, gp::DZ()));
  const ProgramRun without = run_octet({"mesh", part_, "-o", mesh_});
  EXPECT_EQ(without.exit_code, kExitComplete);
  EXPECT_NE(without.out.find("1 Face number(s) of the file bound no volume and are left out"),
            std::string::npos);
  const ProgramRun with = run_octet({"mesh", part_, "-o", mesh_, "--embed", "--size-at", "Face7=0.1"});
  ASSERT_EQ(with.exit_code, kExitComplete) << with.out << with.err;
  EXPECT_NE(with.out.find("1 loose face(s) are embedded in solids, the first is Face 7"), std::string::npos)
      << with.out;
  EXPECT_EQ(with.out.find("left out"), std::string::npos) << with.out;
  EXPECT_EQ(run_octet({"check", mesh_, part_, "--embed"}).exit_code, kExitComplete);
  EXPECT_EQ(run_octet({"check", mesh_, part_}).exit_code, kExitIncomplete);
  const ProgramRun info = run_octet({"info", part_, "--embed"});
  EXPECT_NE(info.out.find("embedded faces   Face7"), std::string::npos) << info.out;
  EXPECT_EQ(info.out.find("free edges"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("area 25 mm^2"), std::string::npos) << info.out;
}

TEST_F(EmbedCommand, OnlyWhatIsWithinIsEmbeddedAndTheWallGetsTheEdge) {
  write(gp_Ax3({0, 1, 1}, gp::DZ()));
  const ProgramRun with = run_octet({"mesh", part_, "-o", mesh_, "--embed"});
  ASSERT_EQ(with.exit_code, kExitComplete) << with.out << with.err;
  EXPECT_EQ(with.out.find("touches"), std::string::npos) << with.out;
  const ProgramRun info = run_octet({"info", part_, "--embed"});
  EXPECT_NE(info.out.find("area 24.5 mm^2"), std::string::npos) << info.out;
}

TEST_F(EmbedCommand, AFaceOutsideIsToldAndNoneIsAskedForWithoutFusing) {
  write(gp_Ax3({5, 1, 1}, gp::DZ()));
  const ProgramRun with = run_octet({"mesh", part_, "-o", mesh_, "--embed"});
  EXPECT_EQ(with.exit_code, kExitComplete);
  EXPECT_NE(with.out.find("no loose face lies in a solid"), std::string::npos) << with.out;
  EXPECT_EQ(run_octet({"mesh", part_, "-o", mesh_, "--embed", "--no-fuse"}).exit_code, kExitBadInput);
}

TEST_F(EmbedCommand, AFaceAcrossASolidPartsIt) {
  write(gp_Ax3({1, 1, 0.5}, gp::DZ()), 3);
  const ProgramRun with = run_octet({"mesh", part_, "-o", mesh_, "--embed"});
  ASSERT_EQ(with.exit_code, kExitComplete) << with.out << with.err;
  EXPECT_NE(with.out.find("1 solid(s) are parted by faces that reach across them"), std::string::npos)
      << with.out;
  EXPECT_NE(with.out.find("regions  2"), std::string::npos) << with.out;
}

}  // namespace
}  // namespace octet
