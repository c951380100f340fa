// SPDX-License-Identifier: BSD-3-Clause
// What `octet improve` promises: better shapes, the same part, and no improvement of what is no mesh of it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "app/improve_mesh.h"
#include "geom/analytic.h"
#include "geom/occt/read_part.h"
#include "io/write.h"
#include "mesh/soundness.h"
#include "tests/app/program.h"

namespace octet {
namespace {

TEST(ImproveCommand, BettersAMeshAndKeepsItRight) {
  const TemporaryDirectory out;
  const std::string part = model_file("plate_with_hole.step");
  const std::string raw = out.file("raw.msh"), better = out.file("better.msh");
  ASSERT_EQ(run_octet({"mesh", part, "-o", raw, "--no-finalize", "--quiet"}).exit_code, kExitComplete);
  const auto run = run_octet({"improve", raw, part, "-o", better, "--report", out.file("report.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  EXPECT_NE(run.out.find("before"), std::string::npos);
  const QualitySummary before = quality_summary(read_mesh(raw)), after = quality_summary(read_mesh(better));
  EXPECT_GT(after.min_dihedral, before.min_dihedral);
  EXPECT_GT(after.p1_min_dihedral, 0.5);
  EXPECT_GT(after.mean_mean_ratio, before.mean_mean_ratio);
  const auto report = nlohmann::json::parse(read_bytes(out.file("report.json")));
  EXPECT_EQ(report["status"], "complete");
  EXPECT_NEAR(report["quality"]["mean_mean_ratio"].get<double>(), after.mean_mean_ratio, 1e-9);
  EXPECT_EQ(run_octet({"check", better, part}).exit_code, kExitComplete);
}

TEST(ImproveCommand, KeepsTheOrderOfTheElementsOrRaisesIt) {
  const TemporaryDirectory out;
  const std::string part = model_file("cylinder.step");
  const std::string first = out.file("1.msh"), second = out.file("2.msh"), better = out.file("better.msh");
  ASSERT_EQ(run_octet({"mesh", part, "-o", first, "--no-finalize", "--quiet"}).exit_code, kExitComplete);
  ASSERT_EQ(run_octet({"improve", first, part, "-o", second, "--order", "2"}).exit_code, kExitComplete);
  EXPECT_FALSE(read_mesh(second).mid.empty());
  ASSERT_EQ(run_octet({"improve", second, part, "-o", better}).exit_code, kExitComplete);
  EXPECT_FALSE(read_mesh(better).mid.empty());
  EXPECT_EQ(run_octet({"check", better, part}).exit_code, kExitComplete);
  ASSERT_EQ(run_octet({"improve", second, part, "-o", better, "--order", "1"}).exit_code, kExitComplete);
  EXPECT_TRUE(read_mesh(better).mid.empty());
}

TEST(ImproveCommand, GivesTheSameBytesFromOneAndTwoThreads) {
  const TemporaryDirectory out;
  const std::string part = model_file("cylinder.step"), raw = out.file("raw.msh");
  ASSERT_EQ(run_octet({"mesh", part, "-o", raw, "--no-finalize", "--quiet"}).exit_code, kExitComplete);
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(
        run_octet({"improve", raw, part, "-o", out.file(threads + ".msh"), "--threads", threads}).exit_code,
        kExitComplete);
  }
  EXPECT_TRUE(read_bytes(out.file("1.msh")) == read_bytes(out.file("2.msh")));
}

TEST(ImproveCommand, RefusesTheMeshOfAnotherPartAndNamesTheClaim) {
  const TemporaryDirectory out;
  const std::string raw = out.file("raw.msh");
  ASSERT_EQ(run_octet({"mesh", model_file("box.step"), "-o", raw, "--quiet"}).exit_code, kExitComplete);
  const auto run = run_octet({"improve", raw, model_file("ball.step"), "-o", out.file("better.msh")});
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_NE(run.err.find("claim"), std::string::npos) << run.err;
  EXPECT_EQ(out.names(), (std::vector<std::string>{"raw.msh"}));
}

TEST(ImproveCommand, BettersBodiesThatTouchAndAreKeptApart) {
  const TemporaryDirectory out;
  const std::string part = model_file("two_boxes.step"), raw = out.file("raw.msh"),
                    better = out.file("b.msh");
  ASSERT_EQ(run_octet({"mesh", part, "-o", raw, "--no-fuse", "--no-finalize"}).exit_code, kExitComplete);
  const auto run = run_octet({"improve", raw, part, "-o", better, "--no-fuse"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  EXPECT_GT(quality_summary(read_mesh(better)).p1_min_dihedral,
            quality_summary(read_mesh(raw)).p1_min_dihedral);
  EXPECT_EQ(run_octet({"check", better, part, "--no-fuse"}).exit_code, kExitComplete);
}

TEST(ImproveMesh, GivesSeamsToTheirFaces) {
  const Model model = read_part(model_file("cylinder.step"));
  int seam = 1;
  while (model.edge(seam).use != EdgeUse::kSeam) ++seam;
  Mesh mesh;
  mesh.points.assign(3, Vec3::Zero());
  mesh.point_on = {model_vertex(1), model_edge(seam), model_edge(1)};
  mesh.edges = {{0, 1}, {0, 2}};
  mesh.edge_on = {seam, 1};
  release_seams(mesh, model);
  EXPECT_EQ(mesh.point_on[1], model_face(model.edge(seam).faces.front()));
  EXPECT_EQ(mesh.point_on[2], model_edge(1));
  EXPECT_EQ(mesh.edges, (std::vector<std::array<Mesh::Index, 2>>{{0, 2}}));
  EXPECT_EQ(mesh.edge_on, (std::vector<std::int32_t>{1}));
}

}  // namespace
}  // namespace octet
