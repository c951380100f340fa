// SPDX-License-Identifier: BSD-3-Clause
// --cap: an open shell is meshed as the solid that plane faces over its openings make of it.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepTools.hxx>
#include <TopExp_Explorer.hxx>

#include "app/exit_code.h"
#include "tests/app/program.h"

namespace octet {
namespace {

/// The round face of a cylinder.
void write_tube(const std::string& path) {
  const TopExp_Explorer face(BRepPrimAPI_MakeCylinder(1.0, 4.0).Solid(), TopAbs_FACE);
  ASSERT_TRUE(BRepTools::Write(face.Current(), path.c_str()));
}

TEST(CapCommand, MeshesATubeAsARod) {
  const TemporaryDirectory out;
  const std::string part = out.file("tube.brep");
  write_tube(part);
  const auto refused = run_octet({"mesh", part, "-o", out.file("a.msh")});
  EXPECT_EQ(refused.exit_code, kExitBadInput);
  EXPECT_NE(refused.err.find("2 opening(s) lie in planes: --cap closes such"), std::string::npos)
      << refused.err;
  const auto capped =
      run_octet({"mesh", part, "-o", out.file("a.msh"), "--cap", "--size-at", "Face:cap*=0.3"});
  ASSERT_EQ(capped.exit_code, kExitComplete) << capped.out << capped.err;
  EXPECT_NE(capped.out.find("2 opening(s) that lie in planes were closed by a plane face each"),
            std::string::npos)
      << capped.out;
  EXPECT_NE(read_bytes(out.file("a.msh")).find("\"cap 2\""), std::string::npos);
  EXPECT_EQ(run_octet({"check", out.file("a.msh"), part, "--cap"}).exit_code, kExitComplete);
  EXPECT_EQ(run_octet({"check", out.file("a.msh"), part}).exit_code, kExitBadInput);
}

TEST(CapCommand, MayStandInAConfigurationFile) {
  const TemporaryDirectory out;
  const std::string part = out.file("tube.brep");
  write_tube(part);
  write_bytes(out.file("options.json"), R"({"cap": true})");
  const auto run = run_octet({"mesh", part, "-o", out.file("a.msh"), "--config", out.file("options.json")});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
}

}  // namespace
}  // namespace octet
