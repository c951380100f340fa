// SPDX-License-Identifier: BSD-3-Clause
// What `octet mesh`, `info` and `check` promise about their outputs, on the bracket.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "geom/occt/read_part.h"
#include "io/write.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using Json = nlohmann::json;

std::string bracket() { return model_file("bracket.step"); }

/// The bracket at its default size, with these options more.
ProgramRun mesh_bracket(const std::string& output, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments{"mesh", bracket(), "-o", output};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_octet(arguments);
}

TEST(MeshCommand, MeshesTheBracketCompletely) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(out.file("a.msh"), {"--report", out.file("a.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  EXPECT_EQ(run.err, "");  // no progress where stderr is no terminal
  EXPECT_NE(run.out.find("complete"), std::string::npos) << run.out;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  EXPECT_EQ(report["status"], "complete");
  EXPECT_GT(report["tets"].get<int>(), 100);
  EXPECT_TRUE(report["faults"].empty());
  EXPECT_LT(std::abs(report["volume"]["relative_error"].get<double>()), 0.02);
  const double of_faces = report["area"]["faces_relative_error"].get<double>();
  EXPECT_GT(of_faces, std::abs(report["area"]["relative_error"].get<double>()));
  EXPECT_LT(of_faces, 0.01);
  EXPECT_GT(report["distance"]["largest"].get<double>(), 0.0);
  EXPECT_LT(report["distance"]["largest"].get<double>(), 0.1 * report["size"].get<double>());
  EXPECT_NE(run.out.find("distance " + fmt::format("{:.3g} mm", report["distance"]["largest"].get<double>())),
            std::string::npos)
      << run.out;
  EXPECT_EQ(out.names(), (std::vector<std::string>{"a.json", "a.msh"}));
}

TEST(MeshCommand, WritesOneMeshIntoSeveralFiles) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(
      out.file("a.msh"), {"-o", out.file("a.vtu"), "-o", out.file("a.inp"), "--report", out.file("a.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  EXPECT_EQ(report["mesh"], out.file("a.msh"));
  EXPECT_EQ(report["copies"], Json({out.file("a.vtu"), out.file("a.inp")}));
  EXPECT_NE(run.out.find(out.file("a.msh") + ", " + out.file("a.vtu") + ", " + out.file("a.inp")),
            std::string::npos)
      << run.out;
  for (const std::string name : {"a.msh", "a.vtu", "a.inp"}) {
    const std::string alone = out.file("alone_" + name);
    ASSERT_EQ(mesh_bracket(alone).exit_code, kExitComplete);
    EXPECT_EQ(read_bytes(out.file(name)), read_bytes(alone)) << name;
  }
}

TEST(MeshCommand, RefusesOutputsThatCannotAllBeWritten) {
  const TemporaryDirectory out;
  const auto twice = mesh_bracket(out.file("a.msh"), {"-o", out.file("a.msh")});
  EXPECT_EQ(twice.exit_code, kExitBadInput);
  EXPECT_NE(twice.err.find("are the same file"), std::string::npos) << twice.err;
  const auto format = mesh_bracket(out.file("a.msh"), {"-o", out.file("a.inp"), "--format", "msh22"});
  EXPECT_EQ(format.exit_code, kExitBadInput);
  EXPECT_NE(format.err.find("--format is for one output"), std::string::npos) << format.err;
  const auto unknown = mesh_bracket(out.file("a.msh"), {"-o", out.file("a.xyz")});
  EXPECT_EQ(unknown.exit_code, kExitBadInput);
  EXPECT_TRUE(out.names().empty());
}

TEST(MeshCommand, TellsWhereAllOfItsTimeWent) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(out.file("a.msh"), {"--report", out.file("a.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  std::vector<std::string> stages;
  double told = 0.0;
  for (const Json& time : report["times"]) {
    stages.push_back(time["stage"]);
    told += time["seconds"].get<double>();
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"reading", "sizes", "octree", "cuts", "points", "triangulation",
                                              "classification", "extraction", "finalization", "interior",
                                              "acceptance", "summary", "writing"}));
  // The program's start is all that no stage has.
  EXPECT_GT(told, 0.5 * run.seconds);
  EXPECT_LE(told, run.seconds);
}

TEST(MeshCommand, MakesElementsOfSecondOrderThatFollowTheCad) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(out.file("2.msh"), {"--order", "2", "--report", out.file("2.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  ASSERT_EQ(mesh_bracket(out.file("1.msh"), {"--report", out.file("1.json")}).exit_code, kExitComplete);
  const Json first = Json::parse(read_bytes(out.file("1.json"))),
             second = Json::parse(read_bytes(out.file("2.json")));
  EXPECT_EQ(first["order"], 1);
  EXPECT_EQ(second["order"], 2);
  EXPECT_EQ(first["tets"], second["tets"]);
  const auto off = [](const Json& report) {
    return std::abs(report["volume"]["relative_error"].get<double>());
  };
  EXPECT_LT(off(second), 0.05 * off(first));
  const auto of_faces = [](const Json& report) {
    return report["area"]["faces_relative_error"].get<double>();
  };
  EXPECT_LT(of_faces(second), 0.1 * of_faces(first));
  EXPECT_LT(second["distance"]["largest"].get<double>(), first["distance"]["largest"].get<double>());
  const Json& curve = second["second_order"];
  EXPECT_GT(curve["curved_edges"].get<int>(), 1000);
  EXPECT_LT(curve["held_edges"].get<int>(), 20);
  EXPECT_GE(curve["least_scaled_jacobian"].get<double>(), 0.2);
  const Mesh mesh = read_mesh(out.file("2.msh"));
  EXPECT_EQ(mesh.points.size() + mesh.mid.points.size(), second["nodes"].get<std::size_t>());
  const auto check = run_octet({"check", out.file("2.msh"), bracket()});
  EXPECT_EQ(check.exit_code, kExitComplete) << check.out;
  EXPECT_NE(check.out.find("curved-elements"), std::string::npos) << check.out;
}

TEST(MeshCommand, SecondOrderGivesTheSameBytesFromOneAndTwoThreads) {
  const TemporaryDirectory out;
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(mesh_bracket(out.file(threads + ".msh"), {"--order", "2", "--threads", threads}).exit_code,
              kExitComplete);
  }
  EXPECT_TRUE(read_bytes(out.file("1.msh")) == read_bytes(out.file("2.msh")));
}

TEST(MeshCommand, OrdersOtherThanOneAndTwoAreRefused) {
  const TemporaryDirectory out;
  for (const char* order : {"0", "3", "two"}) {
    EXPECT_EQ(mesh_bracket(out.file("a.msh"), {"--order", order}).exit_code, kExitBadInput) << order;
  }
  EXPECT_TRUE(out.names().empty());
}

TEST(MeshCommand, SaysWhichLengthToDefeatureBy) {
  const TemporaryDirectory out;
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape();
  const gp_Pnt low(0.006, 0.006, 10.0), high(9.994, 9.994, 12.0);
  const std::string part = out.file("ledge.brep");
  ASSERT_TRUE(BRepTools::Write(BRepAlgoAPI_Fuse(block, BRepPrimAPI_MakeBox(low, high).Shape()).Shape(),
                               part.c_str()));
  const auto as_it_is = run_octet({"mesh", part, "-o", out.file("a.msh"), "--size", "3"});
  EXPECT_EQ(as_it_is.exit_code, kExitComplete) << as_it_is.out;
  const std::string option = "--defeature ";
  const std::size_t at = as_it_is.out.find(option);
  ASSERT_NE(at, std::string::npos) << as_it_is.out;
  const std::string length = as_it_is.out.substr(
      at + option.size(), as_it_is.out.find(' ', at + option.size()) - at - option.size());
  const auto after = run_octet({"mesh", part, "-o", out.file("b.msh"), "--size", "3", "--defeature", length});
  EXPECT_EQ(after.exit_code, kExitComplete) << after.out;
  EXPECT_NE(after.out.find("became edges"), std::string::npos) << after.out;
  EXPECT_EQ(after.out.find(option), std::string::npos) << after.out;
}

TEST(MeshCommand, SaysWhereThePartTouchesItself) {
  const TemporaryDirectory out;
  const std::string part = out.file("steps.brep"), report = out.file("report.json");
  const TopoDS_Shape low = BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape(),
                     across = BRepPrimAPI_MakeBox(gp_Pnt(10.0, 10.0, 0.0), 10.0, 10.0, 10.0).Shape();
  ASSERT_TRUE(BRepTools::Write(BRepAlgoAPI_Fuse(low, across).Shape(), part.c_str()));
  const auto run = run_octet({"mesh", part, "-o", out.file("a.msh"), "--size", "5", "--report", report});
  EXPECT_EQ(run.exit_code, kExitComplete) << run.out;
  const std::size_t line = run.out.find("touches  itself along Edge");
  ASSERT_NE(line, std::string::npos) << run.out;
  const Json contact = Json::parse(read_bytes(report)).at("touches_itself");
  ASSERT_EQ(contact.at("edges").size(), 1u);
  EXPECT_NE(run.out.find(fmt::format("Edge{}: the boundary", contact.at("edges")[0].get<int>()), line),
            std::string::npos)
      << run.out;
  EXPECT_TRUE(contact.at("vertices").empty());
  EXPECT_EQ(run_octet({"mesh", bracket(), "-o", out.file("b.msh")}).out.find("touches"), std::string::npos);
}

/// Reading and writing included.
TEST(MeshCommand, OneThreadKeepsToOneCore) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(
      out.file("a.msh"), {"--threads", "1", "--size", "1.5", "--fast", "--report", out.file("a.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  for (const Json& stage : report["times"])
    EXPECT_LE(stage["cpu_seconds"].get<double>(), stage["seconds"].get<double>() + 1e-3) << stage;
}

TEST(MeshCommand, SameBytesFromTwoRunsAndFromOneAndTwoThreads) {
  const TemporaryDirectory out;
  ASSERT_EQ(mesh_bracket(out.file("a.msh"), {"--threads", "1"}).exit_code, kExitComplete);
  ASSERT_EQ(mesh_bracket(out.file("b.msh"), {"--threads", "1"}).exit_code, kExitComplete);
  ASSERT_EQ(mesh_bracket(out.file("c.msh"), {"--threads", "2"}).exit_code, kExitComplete);
  const std::string bytes = read_bytes(out.file("a.msh"));
  EXPECT_FALSE(bytes.empty());
  EXPECT_TRUE(bytes == read_bytes(out.file("b.msh")));
  EXPECT_TRUE(bytes == read_bytes(out.file("c.msh")));
}

TEST(MeshCommand, CheckAgreesWithTheRunInEveryFormat) {
  const TemporaryDirectory out;
  for (const std::string format : {"msh41", "msh41-ascii", "msh22", "msh22-ascii", "vtu"}) {
    const std::string file = out.file(format == "vtu" ? "a.vtu" : format + ".msh");
    ASSERT_EQ(mesh_bracket(file, {"--format", format, "--quiet"}).exit_code, kExitComplete) << format;
    const auto check = run_octet({"check", file, bracket(), "--json"});
    EXPECT_EQ(check.exit_code, kExitComplete) << format << check.out << check.err;
    EXPECT_EQ(Json::parse(check.out)["status"], "complete");
  }
}

TEST(MeshCommand, CheckFindsAMeshOfAnotherSizeBroken) {
  const TemporaryDirectory out;
  ASSERT_EQ(mesh_bracket(out.file("a.msh"), {"--quiet"}).exit_code, kExitComplete);
  const auto check = run_octet({"check", out.file("a.msh"), bracket(), "--unit", "cm"});
  EXPECT_EQ(check.exit_code, kExitIncomplete);
  EXPECT_NE(check.out.find("BROKEN"), std::string::npos) << check.out;
}

TEST(MeshCommand, UnitScalesTheSizeAndTheCoordinates) {
  const TemporaryDirectory out;
  const Json info = Json::parse(run_octet({"info", bracket(), "--json"}).out);
  const double size = info["default_size"];
  ASSERT_EQ(mesh_bracket(out.file("mm.msh"), {"--size", std::to_string(size)}).exit_code, kExitComplete);
  const auto inches =
      mesh_bracket(out.file("in.msh"), {"--unit", "inch", "--size", std::to_string(size / 25.4)});
  ASSERT_EQ(inches.exit_code, kExitComplete) << inches.out << inches.err;
  Box3 mm, in;
  for (const Vec3& p : read_mesh(out.file("mm.msh")).points) mm.add(p);
  for (const Vec3& p : read_mesh(out.file("in.msh")).points) in.add(p);
  EXPECT_NEAR(in.diagonal() * 25.4, mm.diagonal(), 1e-9 * mm.diagonal());
  EXPECT_EQ(run_octet({"check", out.file("in.msh"), bracket(), "--unit", "in"}).exit_code, kExitComplete);
}

TEST(MeshCommand, QuietPrintsNothing) {
  const TemporaryDirectory out;
  const auto run = mesh_bracket(out.file("a.msh"), {"--quiet"});
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
}

TEST(MeshCommand, DumpsEveryStage) {
  const TemporaryDirectory out;
  ASSERT_EQ(mesh_bracket(out.file("a.msh"), {"--dump-stages", out.file("stages")}).exit_code, kExitComplete);
  std::size_t dumps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out.file("stages"))) {
    EXPECT_FALSE(read_mesh(entry.path()).tets.empty()) << entry.path();
    ++dumps;
  }
  EXPECT_GE(dumps, 2u);
}

TEST(InfoCommand, CountsAsTheModelDoes) {
  const auto run = run_octet({"info", bracket(), "--json"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  const Json info = Json::parse(run.out);
  const Model model = read_part(bracket());
  EXPECT_EQ(info["counts"]["regions"], model.count(3));
  EXPECT_EQ(info["counts"]["faces"], model.count(2));
  EXPECT_EQ(info["counts"]["edges"], model.count(1));
  EXPECT_EQ(info["counts"]["vertices"], model.count(0));
  EXPECT_EQ(info["faces"].size(), static_cast<std::size_t>(model.count(2)));
  EXPECT_TRUE(info["free_edges"].empty());
  EXPECT_NEAR(info["diagonal"].get<double>(), model.diagonal(), 0.01 * model.diagonal());
}

TEST(InfoCommand, NamesTheUnitAndTheSmallestFeatures) {
  const auto run = run_octet({"info", bracket()});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  for (const std::string word : {"millimetre", "smallest edge", "smallest face", "regions"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " in " << run.out;
}

TEST(InfoCommand, ShowsTheAssemblyItsContactsAndItsNames) {
  const auto run = run_octet({"info", model_file("fixture.step"), "--entities"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  for (const std::string word :
       {"\"pin\" as \"pin:2\"", "material \"steel\" (7.85 g/cm^3)", "layer \"hardware\"", "contacts 3",
        "thinnest wall", "\"seat\" #ff0000", "as read"})
    EXPECT_NE(run.out.find(word), std::string::npos) << word << " in " << run.out;
  const Json info = Json::parse(run_octet({"info", model_file("fixture.step"), "--json"}).out);
  EXPECT_EQ(info["tree"].size(), 5u);
  EXPECT_EQ(info["interfaces"].size(), 3u);
  EXPECT_TRUE(info["overlaps"].empty());
  EXPECT_TRUE(info["left_out"].empty());
  EXPECT_NEAR(info["thinnest_wall"]["thickness"].get<double>(), 4.0, 1e-9);
  for (const Json& region : info["regions"]) EXPECT_FALSE(region["name"].get<std::string>().empty());
  for (const Json& face : info["faces"]) EXPECT_FALSE(face["as_read"].empty());
}

TEST(MeshCommand, NamesOfAnAssemblyComeOutInTheMesh) {
  const TemporaryDirectory out;
  const std::string part = model_file("fixture.step");
  ASSERT_EQ(run_octet({"mesh", part, "-o", out.file("a.msh"), "--format", "msh41-ascii"}).exit_code,
            kExitComplete);
  const std::string msh = read_bytes(out.file("a.msh"));
  for (const std::string name : {"\"plate\"", "\"block\"", "\"pin Solid3\"", "\"pin Solid4\"", "\"seat\""})
    EXPECT_NE(msh.find(name), std::string::npos) << name;
  ASSERT_EQ(run_octet({"mesh", part, "-o", out.file("a.vtu")}).exit_code, kExitComplete);
  const std::string vtu = read_bytes(out.file("a.vtu"));
  for (const std::string name : {"region_names", "region_materials", "region_layers", "face_names", "colour"})
    EXPECT_NE(vtu.find("Name=\"" + name + "\""), std::string::npos) << name;
  EXPECT_EQ(run_octet({"check", out.file("a.vtu"), part}).exit_code, kExitComplete);
}

TEST(MeshCommand, NoFuseMeshesEachSolidByItself) {
  const TemporaryDirectory out;
  const std::string part = model_file("fixture.step");
  const auto run =
      run_octet({"mesh", part, "-o", out.file("a.msh"), "--no-fuse", "--report", out.file("a.json")});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  const Json report = Json::parse(read_bytes(out.file("a.json")));
  EXPECT_LT(std::abs(report["volume"]["relative_error"].get<double>()), 0.01);
  const Mesh mesh = read_mesh(out.file("a.msh"));
  std::vector<int> regions(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    for (const Mesh::Index v : mesh.tets[i]) {
      EXPECT_TRUE(regions[v] == 0 || regions[v] == mesh.tet_in[i]);
      regions[v] = mesh.tet_in[i];
    }
  EXPECT_EQ(run_octet({"check", out.file("a.msh"), part, "--no-fuse"}).exit_code, kExitComplete);
  EXPECT_EQ(run_octet({"check", out.file("a.msh"), part}).exit_code, kExitIncomplete);
}

TEST(MeshCommand, DefeatureTakesNarrowFacesAwayAndSaysSo) {
  const TemporaryDirectory out;
  const std::string part = model_file("bugs/foot_under_round.step");
  const auto whole = run_octet({"mesh", part, "-o", out.file("a.msh")});
  ASSERT_EQ(whole.exit_code, kExitComplete) << whole.out << whole.err;
  EXPECT_EQ(whole.out.find("became edges"), std::string::npos) << whole.out;
  const auto run = run_octet({"mesh", part, "-o", out.file("b.msh"), "--defeature", "0.05"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.out << run.err;
  EXPECT_NE(run.out.find("or than 0.05 mm, and became edges: Face 13, Face 15"), std::string::npos)
      << run.out;
  EXPECT_LT(read_mesh(out.file("b.msh")).tets.size(), read_mesh(out.file("a.msh")).tets.size());
  EXPECT_EQ(run_octet({"check", out.file("b.msh"), part, "--defeature", "0.05"}).exit_code, kExitComplete);
  const auto other = run_octet({"check", out.file("b.msh"), part});
  EXPECT_EQ(other.exit_code, kExitIncomplete);
  EXPECT_NE(other.out.find("is checked with the same --defeature"), std::string::npos) << other.out;
  EXPECT_EQ(run_octet({"mesh", part, "-o", out.file("c.msh"), "--defeature", "-1"}).exit_code, kExitBadInput);
  const auto bracket_run =
      run_octet({"mesh", bracket(), "-o", out.file("c.msh"), "--defeature", "4", "--size", "20"});
  EXPECT_NE(bracket_run.out.find("features were taken away here"), std::string::npos) << bracket_run.out;
  EXPECT_EQ(bracket_run.out.find("mend the part there"), std::string::npos) << bracket_run.out;
}

TEST(Help, NamesEveryExitCode) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"mesh", "--help"}, {"info", "--help"}, {"check", "--help"}}) {
    const auto run = run_octet(arguments);
    EXPECT_EQ(run.exit_code, 0);
    for (const std::string code : {"0  complete", "2  bad input", "3  incomplete", "4  failed"})
      EXPECT_NE(run.out.find(code), std::string::npos) << run.out;
  }
}

TEST(Version, IsPrinted) { EXPECT_EQ(run_octet({"--version"}).out.rfind("octet ", 0), 0u); }

}  // namespace
}  // namespace octet
