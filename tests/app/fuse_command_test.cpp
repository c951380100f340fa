// SPDX-License-Identifier: BSD-3-Clause
// --fuse-tolerance: solids that miss each other by no more touch, in the mesh as well.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "io/write.h"
#include "tests/app/program.h"

namespace octet {
namespace {

/// Two cubes, a hundredth apart.
void write_boxes(const std::string& path, double side = 1.0) {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(side, side, side).Shape());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(side + 0.01, 0, 0), gp_Pnt(2.0 * side, side, side)).Shape());
  ASSERT_TRUE(BRepTools::Write(both, path.c_str()));
}

/// Whether a node is in tetrahedra of two regions.
bool regions_meet(const std::string& path) {
  const Mesh mesh = read_mesh(path);
  std::vector<int> regions(mesh.points.size(), 0);
  bool meet = false;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    for (const Mesh::Index v : mesh.tets[i]) {
      meet = meet || (regions[v] != 0 && regions[v] != mesh.tet_in[i]);
      regions[v] = mesh.tet_in[i];
    }
  return meet;
}

TEST(FuseCommand, SolidsThatMissEachOtherByNoMoreTouch) {
  const TemporaryDirectory out;
  const std::string part = out.file("boxes.brep"), mesh = out.file("a.msh");
  write_boxes(part);
  ASSERT_EQ(run_octet({"mesh", part, "-o", mesh}).exit_code, kExitComplete);
  EXPECT_FALSE(regions_meet(mesh));
  const auto joined = run_octet({"mesh", part, "-o", mesh, "--fuse-tolerance", "0.02"});
  ASSERT_EQ(joined.exit_code, kExitComplete) << joined.out << joined.err;
  EXPECT_TRUE(regions_meet(mesh));
  EXPECT_EQ(run_octet({"check", mesh, part, "--fuse-tolerance", "0.02"}).exit_code, kExitComplete);
}

TEST(FuseCommand, VerticesThatWereMovedToJoinSolidsExplainWhatTheVolumesAreOff) {
  const TemporaryDirectory out;
  const std::string part = out.file("boxes.brep"), mesh = out.file("a.msh");
  write_boxes(part, 10.0);
  for (const char* size : {"5", "2"}) {
    const auto joined = run_octet({"mesh", part, "-o", mesh, "--fuse-tolerance", "0.011", "--size", size});
    ASSERT_EQ(joined.exit_code, kExitComplete) << joined.out << joined.err;
    EXPECT_TRUE(regions_meet(mesh));
  }
}

TEST(FuseCommand, LengthsOfReadingAreInTheUnitOfTheCommandLine) {
  const TemporaryDirectory out;
  const std::string part = out.file("boxes.brep"), mesh = out.file("a.msh");
  write_boxes(part);
  const auto joined = run_octet({"mesh", part, "-o", mesh, "--fuse-tolerance", "20", "--unit", "um"});
  ASSERT_EQ(joined.exit_code, kExitComplete) << joined.out << joined.err;
  EXPECT_TRUE(regions_meet(mesh));
  EXPECT_EQ(run_octet({"check", mesh, part, "--fuse-tolerance", "20", "--unit", "um"}).exit_code,
            kExitComplete);
  const auto faces = [&](const std::string& unit) {
    const auto info = run_octet({"info", part, "--json", "--fuse-tolerance", "0.02", "--unit", unit});
    EXPECT_EQ(info.exit_code, kExitComplete) << info.err;
    return nlohmann::json::parse(info.out)["counts"]["faces"].get<int>();
  };
  EXPECT_EQ(faces("um"), 12);
  EXPECT_EQ(faces("mm"), 11);
}

TEST(FuseCommand, SolidsCannotBeJoinedAndKeptApart) {
  const TemporaryDirectory out;
  const std::string part = out.file("boxes.brep"), mesh = out.file("a.msh");
  write_boxes(part);
  const auto run = run_octet({"mesh", part, "-o", mesh, "--no-fuse", "--fuse-tolerance", "0.02"});
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_NE(run.err.find("--no-fuse"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace octet
