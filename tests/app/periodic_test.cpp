// SPDX-License-Identifier: BSD-3-Clause
// Meshes that fit their own images: cells and sectors.
#include "app/periodic_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/exit_code.h"
#include "app/periodic_words.h"
#include "base/error.h"
#include "classify/periodic.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "tests/app/program.h"

namespace octet {
namespace {

MeshResult mesh_with(const Model& model, double size, const std::vector<std::string>& words, int order = 1) {
  MeshOptions options;
  options.size = size;
  options.order = order;
  for (const std::string& text : words) options.periodic.push_back(parse_periodic(text));
  return mesh_part(model, options);
}

/// That each face that is an image has the triangles of its source, moved; looked at by nothing but the nodes
/// that the links pair.
void expect_images(const MeshResult& result, std::size_t faces) {
  const Mesh& mesh = result.mesh;
  std::size_t found = 0;
  for (const PeriodicLink& link : result.report.links) {
    Eigen::Matrix4d motion;
    for (int i = 0; i < 16; ++i) motion(i / 4, i % 4) = link.motion[static_cast<std::size_t>(i)];
    const auto node = [&](std::uint32_t n) {
      return n < mesh.points.size() ? mesh.points[n] : mesh.mid.points[n - mesh.points.size()];
    };
    std::map<std::uint32_t, std::uint32_t> image;
    for (const auto& [to, from] : link.nodes) {
      const Vec3 p = (motion * node(from).homogeneous()).head<3>();
      EXPECT_LT((p - node(to)).norm(), 1e-6);
      image[from] = to;
    }
    if (link.entity.dim != 2) continue;
    ++found;
    std::multiset<std::array<std::uint32_t, 3>> there, moved;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> corners = mesh.triangles[t];
      if (mesh.triangle_on[t] == link.source.tag) {
        for (std::uint32_t& v : corners) v = image.at(v);
        std::sort(corners.begin(), corners.end());
        moved.insert(corners);
      } else if (mesh.triangle_on[t] == link.entity.tag) {
        std::sort(corners.begin(), corners.end());
        there.insert(corners);
      }
    }
    EXPECT_FALSE(there.empty());
    EXPECT_EQ(there, moved) << "Face " << link.entity.tag;
  }
  EXPECT_EQ(found, faces);
}

void expect_complete(const MeshResult& result) {
  EXPECT_EQ(result.report.status, MeshStatus::kComplete)
      << (result.report.faults.empty() ? "" : result.report.faults[0].cause);
}

/// A cube of 10 with balls at its corners and in its middle: as bodies of their own, or as voids.
Model centred_cubic(bool voids) {
  const TopoDS_Shape cube = BRepPrimAPI_MakeBox(10.0, 10.0, 10.0).Shape();
  std::vector<TopoDS_Shape> balls{BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), 3.2).Shape()};
  for (int corner = 0; corner < 8; ++corner)
    balls.push_back(BRepPrimAPI_MakeSphere(
                        gp_Pnt(10.0 * (corner & 1), 10.0 * (corner >> 1 & 1), 10.0 * (corner >> 2)), 3.2)
                        .Shape());
  TopoDS_Shape matrix = cube;
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& ball : balls) {
    matrix = BRepAlgoAPI_Cut(matrix, ball).Shape();
    builder.Add(all, BRepAlgoAPI_Common(ball, cube).Shape());
  }
  if (voids) return model_from_shape(matrix);
  builder.Add(all, matrix);
  return model_from_shape(all);
}

TEST(Periodic, CellsFitAlongAllAxes) {
  for (const double size : {0.8, 2.0}) {
    const MeshResult result = mesh_with(centred_cubic(true), size, {"x", "y", "z"});
    expect_complete(result);
    expect_images(result, 3);
    EXPECT_GT(result.report.quality.p1_min_dihedral, 0.5);
  }
}

TEST(Periodic, SoDoTheirInclusionsAndNodesInTheMiddlesOfEdges) {
  const MeshResult result = mesh_with(centred_cubic(false), 1.2, {"x", "y", "z"}, 2);
  expect_complete(result);
  expect_images(result, 3 + 3 * 4);
}

TEST(Periodic, SectorsFitAboutTheirAxis) {
  AnalyticOptions turned;
  turned.frame.origin = Vec3(10.0, 0.0, 3.0);
  turned.frame.axes = Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (const double angle : {0.5, 1.3, 2.4}) {
    const Model wedge = analytic_wedge(angle, 4.0, 3.0, turned);
    const auto place = [&](double a) {
      const Vec3 p =
          turned.frame.origin + turned.frame.axes * Vec3(2.0 * std::cos(a), 2.0 * std::sin(a), 1.0);
      return fmt::format("Face@{},{},{}", p.x(), p.y(), p.z());
    };
    const MeshResult result = mesh_with(wedge, 0.4, {place(0.0) + "=" + place(angle)});
    expect_complete(result);
    expect_images(result, 1);
  }
}

/// Bores along x, one of which has its seam elsewhere at its end: an edge in two pieces there.
TEST(Periodic, VerticesMayLieWhereTheImageHasNone) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(10.0, 6.0, 6.0).Shape();
  const gp_Ax2 one(gp_Pnt(-1, 3, 3), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0)),
      other(gp_Pnt(6, 3, 3), gp_Dir(1, 0, 0), gp_Dir(0, 0, 1));
  const TopoDS_Shape first = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(one, 1.5, 4.0).Shape()).Shape();
  const Model model =
      model_from_shape(BRepAlgoAPI_Cut(first, BRepPrimAPI_MakeCylinder(other, 1.5, 9.0).Shape()).Shape());
  const MeshResult result = mesh_with(model, 1.0, {"x"});
  expect_complete(result);
  expect_images(result, 1);
  const Periodicity periodicity(model, {faces_across(model, 0)});
  EXPECT_EQ(std::count_if(periodicity.pieces().begin(), periodicity.pieces().end(),
                          [&](const auto& orbit) { return !periodicity.is_whole(orbit); }),
            2);
}

/// What is finer at one of two faces is so at the other.
TEST(Periodic, SizesOfEitherSideCount) {
  const Model box = analytic_box(Vec3(10.0, 10.0, 10.0));
  MeshOptions options;
  options.size = 3.0;
  const PeriodicFaces across = faces_across(box, 0);
  options.attributes.push_back(parse_size_attribute("Face" + std::to_string(across.images[0]) + "=0.8"));
  options.periodic.push_back(parse_periodic("x"));
  const MeshResult result = mesh_part(box, options);
  expect_complete(result);
  expect_images(result, 1);
  EXPECT_GT(std::count(result.mesh.triangle_on.begin(), result.mesh.triangle_on.end(), across.faces[0]), 200);
}

TEST(Periodic, TheClaimFailsWhereTheMeshesDoNotFit) {
  const Model box = analytic_box(Vec3(10.0, 10.0, 10.0));
  const MeshResult plain = mesh_with(box, 3.0, {});
  const Periodicity periodicity(box, {faces_across(box, 0)});
  const MeshResult fitting = mesh_with(box, 3.0, {"x"});
  EXPECT_TRUE(match_periodic(fitting.mesh, box, periodicity).claim.holds);
  const auto is_inside = [&](const Mesh& mesh, int face) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      if (mesh.point_on[v] == model_face(face)) return v;
    return mesh.points.size();
  };
  Mesh moved = fitting.mesh;
  const int image = faces_across(box, 0).images[0];
  const std::size_t v = is_inside(moved, image);
  ASSERT_LT(v, moved.points.size());
  moved.points[v].y() += 1e-3;
  const PeriodicMatch match = match_periodic(moved, box, periodicity);
  EXPECT_FALSE(match.claim.holds);
  ASSERT_FALSE(match.claim.faults.empty());
  EXPECT_EQ(match.claim.faults[0].entity, model_face(image));
  EXPECT_LT((match.claim.faults[0].place - fitting.mesh.points[v]).norm(), 1e-9);
  // One diagonal the other way: the nodes fit, the triangles do not.
  Mesh swapped = fitting.mesh;
  bool done = false;
  for (std::size_t a = 0; a < swapped.triangles.size() && !done; ++a)
    for (std::size_t b = 0; b < a && !done; ++b) {
      if (swapped.triangle_on[a] != image || swapped.triangle_on[b] != image) continue;
      auto &p = swapped.triangles[a], &q = swapped.triangles[b];
      for (int i = 0; i < 3 && !done; ++i)
        for (int j = 0; j < 3 && !done; ++j)
          if (p[i] == q[(j + 1) % 3] && p[(i + 1) % 3] == q[j]) {
            const auto c = p[(i + 2) % 3], d = q[(j + 2) % 3], from = p[i], to = p[(i + 1) % 3];
            p = {c, from, d};
            q = {d, to, c};
            done = true;
          }
    }
  ASSERT_TRUE(done);
  const PeriodicMatch of_swapped = match_periodic(swapped, box, periodicity);
  EXPECT_FALSE(of_swapped.claim.holds);
  ASSERT_FALSE(of_swapped.claim.faults.empty());
  EXPECT_NE(of_swapped.claim.faults[0].cause.find("a triangle has no image"), std::string::npos);
}

TEST(Periodic, WordsThatMeanNothingAreRefused) {
  const Model box = analytic_box(Vec3(1.0, 1.0, 1.0));
  for (const char* text : {"w", "", "=Face1", "Face1=", "Face1", "box:0,0,0,1,1,1=Face1"})
    EXPECT_THROW((void)parse_periodic(text), InputError) << text;
  for (const char* text : {"Edge1=Face1", "Face1=Face77", "Face1=nothing*"})
    EXPECT_THROW((void)periodic_faces(box, {parse_periodic(text)}), InputError) << text;
  const PeriodicWish wish = parse_periodic("Face1,Face3=Face2,Face4-5");
  const std::vector<PeriodicFaces> faces = periodic_faces(box, {wish});
  EXPECT_EQ(faces.at(0).faces, (std::vector<int>{1, 3}));
  EXPECT_EQ(faces.at(0).images, (std::vector<int>{2, 4, 5}));
}

TEST(PeriodicCommand, TellsCheckedAndWritten) {
  const TemporaryDirectory out;
  const std::string box = model_file("box.step"), mesh = out.file("box.msh"), again = out.file("again.msh"),
                    report = out.file("box.json");
  const std::vector<std::string> words{"mesh",       box, "-o",         mesh, "--size",   "4",
                                       "--periodic", "x", "--periodic", "y",  "--report", report};
  const auto made = run_octet(words);
  ASSERT_EQ(made.exit_code, kExitComplete) << made.err;
  EXPECT_NE(made.out.find("2 faces are images of others"), std::string::npos) << made.out;
  const auto json = nlohmann::json::parse(read_bytes(report));
  std::size_t faces = 0;
  for (const auto& link : json["periodic"]) faces += link["dim"] == 2 ? 1 : 0;
  EXPECT_EQ(faces, 2u);
  EXPECT_EQ(run_octet({"check", mesh, box, "--periodic", "x", "--periodic", "y"}).exit_code, kExitComplete);
  EXPECT_EQ(run_octet({"check", mesh, box, "--periodic", "z"}).exit_code, kExitIncomplete);
  ASSERT_EQ(run_octet({"mesh", box, "-o", again, "--size", "4", "--periodic", "x", "--periodic", "y",
                       "--threads", "1"})
                .exit_code,
            kExitComplete);
  EXPECT_EQ(read_bytes(mesh), read_bytes(again));
}

}  // namespace
}  // namespace octet
