// SPDX-License-Identifier: BSD-3-Clause
// Layers along walls.
#include "finalize/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/exit_code.h"
#include "app/layer_mesh.h"
#include "app/mesh_part.h"
#include "base/error.h"
#include "geom/analytic.h"
#include "tests/app/program.h"

namespace octet {
namespace {

MeshResult mesh_with(const Model& model, double size, const std::vector<std::string>& words) {
  MeshOptions options;
  options.size = size;
  for (const std::string& text : words) options.layers.push_back(parse_layers(text));
  return mesh_part(model, options);
}

void expect_complete(const MeshResult& result) {
  EXPECT_EQ(result.report.status, MeshStatus::kComplete)
      << (result.report.faults.empty() ? "" : result.report.faults[0].cause);
}

int face_at(const Model& model, const Vec3& p) {
  for (int f = 1; f <= model.count(2); ++f)
    if (model.face_closest(f, p).distance < 1e-9) return f;
  return 0;
}

std::string face_word(const Model& model, const Vec3& p) {
  return "Face" + std::to_string(face_at(model, p));
}

/// How far from z = 0 the points below `most` are, each figure once to within a millionth.
std::set<double> heights_below(const Mesh& mesh, double most) {
  std::set<double> heights;
  for (const Vec3& p : mesh.points)
    if (p.z() < most) heights.insert(std::round(1e6 * p.z()) / 1e6);
  return heights;
}

TEST(Layers, StandOnAPlaneAsHighAsTheyAreAskedFor) {
  const Model box = analytic_box(Vec3(10.0, 8.0, 6.0));
  const MeshResult plain = mesh_with(box, 1.0, {}),
                   result = mesh_with(box, 1.0, {face_word(box, Vec3(5, 4, 0)) + "=0.02,4,1.5"});
  expect_complete(result);
  ASSERT_TRUE(result.report.layers.has_value());
  const LayerReport& layers = *result.report.layers;
  EXPECT_EQ(layers.bare, 0u);
  EXPECT_EQ(layers.thinner, 0u);
  EXPECT_TRUE(result.report.notes.empty()) << result.report.notes.front();
  // Three tetrahedra a triangle and layer; heights 0.02, 0.03, 0.045, 0.0675.
  const int wall = face_at(box, Vec3(5, 4, 0));
  const auto triangles = static_cast<std::size_t>(
      std::count(result.mesh.triangle_on.begin(), result.mesh.triangle_on.end(), wall));
  EXPECT_EQ(layers.tets, 3 * 4 * triangles);
  EXPECT_EQ(triangles, static_cast<std::size_t>(
                           std::count(plain.mesh.triangle_on.begin(), plain.mesh.triangle_on.end(), wall)));
  EXPECT_EQ(heights_below(result.mesh, 0.17), (std::set<double>{0.0, 0.02, 0.05, 0.095, 0.1625}));
  EXPECT_GT(result.report.quality.min_dihedral, 0.35);
  EXPECT_NEAR(result.report.volume, 480.0, 1e-9);
}

TEST(Layers, FollowCurvedWallsAndEdgesThatGoInwards) {
  const Model cylinder = analytic_cylinder(4.0, 12.0);
  const std::string wall = face_word(cylinder, Vec3(4.0, 0.0, 6.0));
  const MeshResult result = mesh_with(cylinder, 0.8, {wall + "=0.03,5,1.3"});
  expect_complete(result);
  const LayerReport& layers = *result.report.layers;
  EXPECT_EQ(layers.bare, 0u);
  EXPECT_EQ(layers.thinner, 0u);
  // Nodes at the first layer's far side: of a circle's chords, whose normals are off the radius by chance.
  std::size_t first = 0;
  for (const Vec3& p : result.mesh.points) {
    const double depth = 4.0 - std::hypot(p.x(), p.y());
    EXPECT_TRUE(depth < 1e-9 || depth > 0.029) << depth;
    first += depth > 0.029 && depth < 0.031 ? 1 : 0;
  }
  EXPECT_EQ(first, layers.nodes);
}

TEST(Layers, OnAllOfAPartMeetAtItsEdges) {
  const Model box = analytic_box(Vec3(10.0, 8.0, 6.0));
  const MeshResult result = mesh_with(box, 1.0, {"Face:*=0.02,3"});
  expect_complete(result);
  EXPECT_EQ(result.report.layers->bare, 0u);
  EXPECT_GT(result.report.layers->least, 0.9);
  EXPECT_NEAR(result.report.volume, 480.0, 1e-9);
  // A void's wall is convex to its outside: the same.
  const Model with_void = analytic_box_minus_ball(10.0, 2.0);
  const MeshResult around =
      mesh_with(with_void, 1.0, {face_word(with_void, Vec3(2.0, 0.0, 0.0)) + "=0.05,4"});
  expect_complete(around);
  EXPECT_EQ(around.report.layers->bare, 0u);
}

/// The elements beyond are made anew in between, where layers are as high as these or higher.
TEST(Layers, MayBeHigherThanTheElementsBeyond) {
  const Model box = analytic_box(Vec3(10.0, 10.0, 10.0));
  const std::string wall = face_word(box, Vec3(5, 5, 0));
  const MeshResult high = mesh_with(box, 1.0, {wall + "=0.1,5,1.3"});  // 0.9 together
  expect_complete(high);
  EXPECT_EQ(high.report.layers->thinner, 0u);
  EXPECT_GT(high.report.quality.min_dihedral, 0.45);
  const MeshResult higher = mesh_with(box, 1.0, {wall + "=0.3,6"});  // 3.0
  expect_complete(higher);
  EXPECT_GT(higher.report.layers->least, 0.5);
  EXPECT_NEAR(higher.report.volume, 1000.0, 1e-9);
}

TEST(Layers, AreThinnerWhereThereIsNoRoomAndSaySo) {
  const Model box = analytic_box(Vec3(10.0, 10.0, 1.0));
  const MeshResult result = mesh_with(box, 1.0, {"Face:*=0.2,3"});
  expect_complete(result);
  EXPECT_LT(result.report.layers->least, 0.9);
  ASSERT_FALSE(result.report.notes.empty());
  EXPECT_NE(result.report.notes[0].find("thinner than asked for"), std::string::npos)
      << result.report.notes[0];
}

TEST(Layers, ThinOutWhereWallsOfOtherDirectionsMeet) {
  const Model wedge = analytic_wedge(0.25, 10.0, 4.0);
  const MeshResult result = mesh_with(wedge, 0.5, {"Face:*=0.02,3"});
  expect_complete(result);
  EXPECT_GT(result.report.layers->nodes, 100u);
  // At the sharp edge, and there alone: 4 long, in elements of half or more.
  EXPECT_GT(result.report.layers->bare, 3u);
  EXPECT_LT(result.report.layers->bare, 40u);
}

TEST(Layers, WordsThatMeanNothingAreRefused) {
  for (const char* text :
       {"Face1", "=1,2", "Face1=", "Face1=1", "Face1=0,3", "Face1=-1,3", "Face1=1,0", "Face1=1,2.5",
        "Face1=1,3,0.5", "Face1=1,3,4", "Face1=1,2,1.2,3", "Face1=x,3", "box:0,0,0,1,1,1=1,2"})
    EXPECT_THROW((void)parse_layers(text), InputError) << text;
  const Model boxes = analytic_two_boxes(Vec3(1.0, 1.0, 1.0));
  const auto wishes = [&](const std::vector<std::string>& words) {
    std::vector<LayerRequest> requests;
    for (const std::string& text : words) requests.push_back(parse_layers(text));
    return layer_wishes(boxes, requests);
  };
  EXPECT_THROW((void)wishes({"Face99=1,2"}), InputError);
  EXPECT_THROW((void)wishes({"Edge1=1,2"}), InputError);
  EXPECT_THROW((void)wishes({"Face1=1,2", "Face2=1,3"}), InputError);
  EXPECT_THROW((void)wishes({face_word(boxes, Vec3(1.0, 0.5, 0.5)) + "=1,2"}), InputError);
  MeshOptions options;
  options.layers.push_back(parse_layers("Face1=0.1,2"));
  options.size = 0.3;
  options.max_elements = 5000;
  EXPECT_EQ(mesh_part(analytic_box(Vec3(1.0, 1.0, 1.0)), options).report.status, MeshStatus::kComplete);
  options.layers = {parse_layers("Face:*=0.001,50")};
  EXPECT_THROW((void)mesh_part(analytic_box(Vec3(1.0, 1.0, 1.0)), options), LimitError);
  options.order = 2;
  EXPECT_THROW((void)mesh_part(analytic_box(Vec3(1.0, 1.0, 1.0)), options), InputError);
}

TEST(LayersCommand, TellsAndGivesTheSameBytesWithAnyThreads) {
  const TemporaryDirectory out;
  const std::string part = model_file("bracket.step"), one = out.file("1.msh"), two = out.file("2.msh");
  const auto run =
      run_octet({"mesh", part, "-o", one, "--size", "6", "--layers", "Face1-3=0.2,3", "--threads", "1"});
  ASSERT_EQ(run.exit_code, kExitComplete) << run.err;
  EXPECT_NE(run.out.find("  layers"), std::string::npos);
  ASSERT_EQ(run_octet({"mesh", part, "-o", two, "--size", "6", "--layers", "Face1-3=0.2,3", "--threads", "2"})
                .exit_code,
            kExitComplete);
  EXPECT_EQ(read_bytes(one), read_bytes(two));
  EXPECT_EQ(run_octet({"check", one, part}).exit_code, kExitComplete);
}

}  // namespace
}  // namespace octet
