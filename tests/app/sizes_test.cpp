// SPDX-License-Identifier: BSD-3-Clause
// The sizes of finished meshes are those asked for, where they were asked for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <string_view>

#include "app/mesh_part.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/read_part.h"
#include "tests/app/edge_lengths.h"
#include "tests/app/program.h"

namespace octet {
namespace {

using test::edge_lengths;
using test::mean;
using test::median;

MeshOptions uniform(double size) {
  MeshOptions options;
  options.size = size;
  options.curvature_angle = 0.0;
  options.wall_elements = options.gap_elements = 0.0;
  options.short_edges = false;
  return options;
}

MeshResult complete(const Model& model, const MeshOptions& options) {
  MeshResult result = mesh_part(model, options);
  EXPECT_EQ(result.report.status, MeshStatus::kComplete);
  return result;
}

TEST(Sizes, TheSizeToldIsNoSmallerThanTheSmallest) {
  const Model model = analytic_box(Vec3(1, 2, 3));
  MeshOptions options;
  options.min_size = 0.8;
  EXPECT_EQ(mesh_part(model, options).report.size, 0.8);
}

TEST(Sizes, MeanEdgeLengthIsTheSizeAskedFor) {
  const auto ratio = [](const Model& model, double size) {
    const Mesh mesh = complete(model, uniform(size)).mesh;
    return mean(edge_lengths(mesh, mesh.tets)) / size;
  };
  const Model ball = analytic_ball(1.0, {{}, 1e-3});
  EXPECT_NEAR(ratio(ball, 0.2), 1.0, 0.1);
  EXPECT_NEAR(ratio(ball, 0.083), 1.0, 0.1);
  const Model plate = analytic_box(Vec3(4.0, 3.0, 0.25));
  EXPECT_NEAR(ratio(plate, 0.1), 1.0, 0.1);
  EXPECT_NEAR(ratio(plate, 0.08), 1.0, 0.1);
  const Model bracket = read_part(model_file("bracket.step"));
  EXPECT_NEAR(ratio(bracket, 2.1), 1.0, 0.1);
  EXPECT_NEAR(ratio(bracket, 3.3), 1.0, 0.1);
}

// --- attributes -------------------------------------------------------------------------------------------

/// A box of 3 x 2 x 2.5 with these wishes: the mesh.
Mesh box_with(const std::vector<std::string>& wishes, double size) {
  MeshOptions options = uniform(size);
  for (const std::string& wish : wishes) options.attributes.push_back(parse_size_attribute(wish));
  return complete(analytic_box(Vec3(3.0, 2.0, 2.5)), options).mesh;
}

void expect_median(const std::vector<double>& lengths, double size, const std::string& what) {
  ASSERT_FALSE(lengths.empty()) << what;
  EXPECT_NEAR(median(lengths) / size, 1.0, 0.25) << what;
  EXPECT_LT(lengths.back(), 2.0 * size) << what;
}

/// Edges farther than `away` from what `distance` measures from.
std::vector<double> lengths_beyond(const Mesh& mesh, double away,
                                   const std::function<double(const Vec3&)>& distance) {
  return edge_lengths(mesh, mesh.tets, [&](const Vec3& a, const Vec3& b) {
    return std::min(distance(a), distance(b)) > away;
  });
}

int face_with(const Model& model, const Vec3& p) {
  for (int f = 1; f <= model.count(2); ++f)
    if (model.face_closest(f, p).distance < 1e-9) return f;
  return 0;
}

TEST(Sizes, FacesGetTheirsAndTheRestItsOwn) {
  const Model model = analytic_box(Vec3(3.0, 2.0, 2.5));
  const int face = face_with(model, Vec3(0.0, 1.0, 1.0));
  const Mesh plain = box_with({}, 0.4);
  for (const double size : {0.05, 0.06, 0.07, 0.085, 0.1}) {
    const Mesh mesh = box_with({"Face" + std::to_string(face) + "=" + std::to_string(size)}, 0.4);
    const std::string what = "face of size " + std::to_string(size);
    expect_median(edge_lengths(mesh, test::triangles_on(mesh, face)), size, what);
    // Sizes double from octant to octant: beyond 0.4 + 0.2 + ... nothing is finer than before.
    const auto far = [](const Mesh& m) {
      return mean(lengths_beyond(m, 1.0, [](const Vec3& p) { return p.x(); }));
    };
    EXPECT_NEAR(far(mesh) / far(plain), 1.0, 0.35) << what;
  }
}

TEST(Sizes, EdgesGetTheirs) {
  for (const double size : {0.05, 0.06, 0.07, 0.085, 0.1}) {
    const Mesh mesh = box_with({"Edge2=" + std::to_string(size)}, 0.4);
    expect_median(edge_lengths(mesh, test::edges_on(mesh, 2)), size, "edge of size " + std::to_string(size));
  }
}

TEST(Sizes, EdgesGetTheNumberOfElementsAskedFor) {
  for (const int n : {9, 12, 17, 23, 40}) {
    const Mesh mesh = box_with({"Edge2=/" + std::to_string(n)}, 0.4);
    EXPECT_NEAR(static_cast<double>(test::edges_on(mesh, 2).size()) / n, 1.0, 0.2) << n;
  }
}

TEST(Sizes, VerticesShapesAndRegionsGetTheirs) {
  const auto near = [](const Mesh& mesh, const Vec3& centre, double radius) {
    return edge_lengths(mesh, mesh.tets, [&](const Vec3& a, const Vec3& b) {
      return std::max((a - centre).norm(), (b - centre).norm()) < radius;
    });
  };
  for (const double size : {0.05, 0.07, 0.1}) {
    const std::string value = fmt::format("={}", size), what = fmt::format("size {}", size);
    const Mesh vertex = box_with({"Vertex@0,0,0" + value}, 0.4);
    expect_median(near(vertex, Vec3::Zero(), 1.5 * size), size, "vertex of " + what);
    const Mesh ball = box_with({"ball:1,1,1,0.3" + value}, 0.4);
    expect_median(near(ball, Vec3(1, 1, 1), 0.3), size, "ball of " + what);
    const Mesh box = box_with({"box:0.7,0.7,0.7,1.3,1.3,1.3" + value}, 0.4);
    expect_median(near(box, Vec3(1, 1, 1), 0.3), size, "box of " + what);
    const Mesh cylinder = box_with({"cylinder:0.7,1,1,1.3,1,1,0.3" + value}, 0.4);
    expect_median(near(cylinder, Vec3(1, 1, 1), 0.3), size, "cylinder of " + what);
  }
}

TEST(Sizes, EveryWayToNameAnEntityGivesTheSameSizes) {
  const Model model = read_part(model_file("fixture.step"));
  int seat = 0;
  for (int f = 1; f <= model.count(2); ++f)
    if (model.face(f).name == "seat") seat = f;
  ASSERT_GT(seat, 0);
  const auto samples = [&](const std::string& place) {
    MeshOptions options = uniform(4.0);
    options.attributes.push_back(parse_size_attribute(place + "=1"));
    std::vector<Vec3> places;
    for (const SizeSample& sample : plan_sizes(model, options).samples) {
      EXPECT_EQ(sample.size, 1.0);
      places.push_back(sample.place);
    }
    return places;
  };
  const std::string number = std::to_string(seat);
  const std::vector<Vec3> wanted = samples("Face" + number);
  EXPECT_FALSE(wanted.empty());
  EXPECT_EQ(samples("Face" + number + "-" + number), wanted);
  EXPECT_EQ(samples("Face:se?t"), wanted);
  EXPECT_EQ(samples("seat"), wanted);
  EXPECT_EQ(samples(fmt::format("Face{}", model.face(seat).colour)), wanted);
  const Vec3 middle = model.face_closest(seat, Vec3(10.0, 10.0, 20.0)).point;
  EXPECT_EQ(samples(fmt::format("Face@{},{},{}", middle.x(), middle.y(), middle.z())), wanted);
}

TEST(Sizes, AFunctionOfThePlaceIsAField) {
  MeshOptions options = uniform(0.4);
  options.background = sampled_field([](const Vec3& p) { return p.x() < 1.0 ? 0.1 : 0.0; });
  const Mesh mesh = complete(analytic_box(Vec3(3.0, 2.0, 2.5)), options).mesh;
  const auto between = [&](double least, double most) {
    return edge_lengths(mesh, mesh.tets, [&](const Vec3& a, const Vec3& b) {
      return std::min(a.x(), b.x()) > least && std::max(a.x(), b.x()) < most;
    });
  };
  expect_median(between(-1.0, 0.9), 0.1, "where it says so");
  expect_median(between(2.2, 4.0), 0.4, "where it says nothing");
}

TEST(Sizes, ARegionMayBeFinerOrCoarserThanItsNeighbour) {
  const Model model = analytic_two_boxes(Vec3(1.0, 1.0, 1.0));
  for (const double size : {0.06, 0.3}) {
    MeshOptions options = uniform(0.12);
    options.attributes.push_back(parse_size_attribute("Region1=" + std::to_string(size)));
    const Mesh mesh = complete(model, options).mesh;
    std::vector<std::array<Mesh::Index, 4>> tets[2];
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) tets[mesh.tet_in[t] - 1].push_back(mesh.tets[t]);
    // Away from the interface the sizes are their own.
    const double plane = 1.0;
    const auto away = [&](const Vec3& a, const Vec3& b) {
      return std::min(std::abs(a.x() - plane), std::abs(b.x() - plane)) > 0.35;
    };
    EXPECT_NEAR(mean(edge_lengths(mesh, tets[0], away)) / size, 1.0, 0.25) << size;
    EXPECT_NEAR(mean(edge_lengths(mesh, tets[1], away)) / 0.12, 1.0, 0.25) << size;
  }
}

// --- the part's own sizes ---------------------------------------------------------------------------------

MeshOptions by_curvature(double size, double elements_on_circle) {
  MeshOptions options = uniform(size);
  options.curvature_angle = 2.0 * M_PI / elements_on_circle;
  options.curvature_floor = 1e-6;
  options.suit_curvature = true;
  return options;
}

TEST(Sizes, CurvatureGivesTheElementsAskedForOnCircles) {
  const double radius = 1.0, height = 2.5;
  const Model model = analytic_cylinder(radius, height, {{}, 1e-3});
  for (const int n : {12, 16, 20, 27, 40}) {
    const Mesh mesh = complete(model, by_curvature(1.0, n)).mesh;
    for (int e = 1; e <= model.count(1); ++e) {
      if (model.edge(e).use != EdgeUse::kReal) continue;
      const auto pieces = test::edges_on(mesh, e);
      EXPECT_NEAR(static_cast<double>(pieces.size()) / n, 1.0, 0.2) << n;
      // The chord of an n-th of a circle is radius (1 - cos(pi / n)) away from it.
      double sagitta = 0.0;
      for (const auto& piece : pieces)
        sagitta += radius - (0.5 * (mesh.points[piece[0]] + mesh.points[piece[1]])).head<2>().norm();
      sagitta /= static_cast<double>(pieces.size());
      EXPECT_NEAR(std::sqrt(sagitta / (radius * (1.0 - std::cos(M_PI / n)))), 1.0, 0.25) << n;
    }
  }
}

TEST(Sizes, CurvatureGivesTheElementsAskedForOnATorus) {
  const double minor = 0.4;
  const Model model = analytic_torus(1.2, minor, {{}, 1e-3});
  for (const int n : {10, 14, 18}) {
    const Mesh mesh = complete(model, by_curvature(0.6, n)).mesh;
    EXPECT_NEAR(2.0 * M_PI * minor / mean(edge_lengths(mesh, mesh.triangles)) / n, 1.0, 0.2) << n;
  }
}

TEST(Sizes, CurvatureGivesTheElementsAskedForOnFillets) {
  const double radius = 1.0;
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10.0, 8.0, 6.0).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer e(box, TopAbs_EDGE); e.More(); e.Next()) fillet.Add(radius, TopoDS::Edge(e.Current()));
  const Model model = model_from_shape(fillet.Shape());
  for (const int n : {16, 24, 32}) {
    const Mesh mesh = complete(model, by_curvature(2.0, n)).mesh;
    double arcs = 0.0, pieces = 0.0;
    for (int e = 1; e <= model.count(1); ++e) {
      if (model.edge(e).use != EdgeUse::kReal || std::string_view(model.curve(e).kind()) != "circle")
        continue;
      arcs += model.edge(e).length;
      pieces += static_cast<double>(test::edges_on(mesh, e).size());
    }
    EXPECT_NEAR(pieces / (n * arcs / (2.0 * M_PI * radius)), 1.0, 0.2) << n;
  }
}

/// Fewest mesh edges from any vertex on one face's closure to any on the other's.
int edges_across(const Model& model, const Mesh& mesh, int from, int to) {
  std::vector<std::vector<Mesh::Index>> beside(mesh.points.size());
  for (const auto& [a, b] : test::edges_of(mesh.tets)) {
    beside[a].push_back(b);
    beside[b].push_back(a);
  }
  std::vector<int> steps(mesh.points.size(), -1);
  std::vector<Mesh::Index> front;
  for (Mesh::Index v = 0; v < mesh.points.size(); ++v)
    if (model.in_closure(mesh.point_on[v], model_face(from))) {
      steps[v] = 0;
      front.push_back(v);
    }
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (model.in_closure(mesh.point_on[front[i]], model_face(to))) return steps[front[i]];
    for (const Mesh::Index v : beside[front[i]])
      if (steps[v] < 0) {
        steps[v] = steps[front[i]] + 1;
        front.push_back(v);
      }
  }
  return -1;
}

TEST(Sizes, WallsGetTheElementsAskedForAcross) {
  const Model plate = analytic_box(Vec3(1.6, 1.2, 0.3));
  const Model shell = analytic_hollow_ball(1.0, 0.75, {{}, 1e-3});
  const Model tube = model_from_shape(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1.0, 1.0).Shape(), BRepPrimAPI_MakeCylinder(0.75, 1.0).Shape())
          .Shape());
  const Model nested = model_from_shape(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(1.6, 1.4, 1.2).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(0.2, 0.2, 0.2), gp_Pnt(1.4, 1.2, 1.0)).Shape())
          .Shape());
  const Model fin = model_from_shape(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(1.5, 1.0, 1.2).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(0.2, -1.0, 0.4), gp_Pnt(3.0, 3.0, 3.0)).Shape())
          .Shape());
  const auto across = [](const Model& model, double size, int n, const Vec3& a, const Vec3& b) {
    MeshOptions options = uniform(size);
    options.wall_elements = n;
    options.wall_budget = 0.0;
    const Mesh mesh = complete(model, options).mesh;
    return edges_across(model, mesh, face_with(model, a), face_with(model, b));
  };
  for (const int n : {1, 2, 3, 4})
    EXPECT_GE(across(plate, 0.5, n, Vec3(0.8, 0.6, 0.0), Vec3(0.8, 0.6, 0.3)), n) << "plate";
  for (const int n : {2, 3})
    EXPECT_GE(across(tube, 0.6, n, Vec3(0.0, 1.0, 0.5), Vec3(0.0, 0.75, 0.5)), n) << "tube";
  for (const int n : {2, 3}) {
    EXPECT_GE(across(fin, 0.6, n, Vec3(0.0, 0.5, 0.9), Vec3(0.2, 0.5, 0.9)), n) << "fin";
  }
  EXPECT_GE(across(nested, 0.5, 2, Vec3(0.0, 0.7, 0.6), Vec3(0.2, 0.7, 0.6)), 2) << "nested boxes";
  EXPECT_GE(across(shell, 0.6, 2, Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, 0.75)), 2) << "shell";
}

TEST(Sizes, GapsAreAsFineAsAskedForOnBothSides) {
  // Two fins, 0.2 apart, on a foot.
  BRepAlgoAPI_Cut cut(BRepPrimAPI_MakeBox(2.2, 1.5, 1.5).Shape(),
                      BRepPrimAPI_MakeBox(gp_Pnt(1.0, -1.0, 0.5), gp_Pnt(1.2, 3.0, 3.0)).Shape());
  const Model model = model_from_shape(cut.Shape());
  for (const int n : {1, 2, 3}) {
    MeshOptions options = uniform(0.5);
    options.gap_elements = n;
    const Mesh mesh = complete(model, options).mesh;
    for (const double x : {1.0, 1.2}) {
      const int face = face_with(model, Vec3(x, 0.7, 1.0));
      EXPECT_LT(mean(edge_lengths(mesh, test::triangles_on(mesh, face))), 1.45 * 0.2 / n) << n;
    }
  }
}

}  // namespace
}  // namespace octet
