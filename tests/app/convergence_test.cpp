// SPDX-License-Identifier: BSD-3-Clause
// Volume and area converge at second order, per entity; planar parts are exact; Euler numbers are the
// model's.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "app/mesh_part.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "octree/octree.h"

namespace octet {
namespace {

struct Measures {
  std::vector<double> length, area, volume;  ///< per tag, [0] unused
};

Measures measure(const Mesh& mesh, const Model& model) {
  Measures m;
  m.length.resize(static_cast<std::size_t>(model.count(1)) + 1);
  m.area.resize(static_cast<std::size_t>(model.count(2)) + 1);
  m.volume.resize(static_cast<std::size_t>(model.count(3)) + 1);
  const auto& p = mesh.points;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    m.length[static_cast<std::size_t>(mesh.edge_on[e])] += (p[mesh.edges[e][1]] - p[mesh.edges[e][0]]).norm();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    m.area[static_cast<std::size_t>(mesh.triangle_on[t])] += triangle_area(p[v[0]], p[v[1]], p[v[2]]);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    m.volume[static_cast<std::size_t>(mesh.tet_in[t])] += signed_volume(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
  }
  return m;
}

/// Relative to the whole, summed over entities so that no two errors cancel.
struct Errors {
  double length = 0.0, area = 0.0, volume = 0.0;
};

Errors errors_of(const Measures& m, const Model& model) {
  Errors errors;
  double length = 0.0, area = 0.0, volume = 0.0;
  for (int e = 1; e <= model.count(1); ++e) {
    if (model.edge(e).use != EdgeUse::kReal) continue;
    errors.length += std::abs(m.length[static_cast<std::size_t>(e)] - model.edge(e).length);
    length += model.edge(e).length;
  }
  for (int f = 1; f <= model.count(2); ++f) {
    errors.area += std::abs(m.area[static_cast<std::size_t>(f)] - model.face(f).area);
    area += model.face(f).area;
  }
  for (int r = 1; r <= model.count(3); ++r) {
    errors.volume += std::abs(m.volume[static_cast<std::size_t>(r)] - model.region(r).volume);
    volume += model.region(r).volume;
  }
  if (length > 0.0) errors.length /= length;
  errors.area /= area;
  errors.volume /= volume;
  return errors;
}

template <std::size_t N>
void add_simplices(const std::array<Mesh::Index, N>& v, std::set<Mesh::Index>& vertices,
                   std::set<std::array<Mesh::Index, 2>>& edges, std::set<std::array<Mesh::Index, 3>>& faces) {
  std::array<Mesh::Index, N> s = v;
  std::sort(s.begin(), s.end());
  for (std::size_t i = 0; i < N; ++i) {
    vertices.insert(s[i]);
    for (std::size_t j = i + 1; j < N; ++j) {
      edges.insert({s[i], s[j]});
      for (std::size_t k = j + 1; k < N; ++k) faces.insert({s[i], s[j], s[k]});
    }
  }
}

/// Euler characteristic of the triangles on each model face.
std::vector<long> face_eulers(const Mesh& mesh, const Model& model) {
  std::vector<long> euler(static_cast<std::size_t>(model.count(2)) + 1);
  for (int f = 1; f <= model.count(2); ++f) {
    std::set<Mesh::Index> vertices;
    std::set<std::array<Mesh::Index, 2>> edges;
    std::set<std::array<Mesh::Index, 3>> faces;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (mesh.triangle_on[t] == f) add_simplices(mesh.triangles[t], vertices, edges, faces);
    euler[static_cast<std::size_t>(f)] = static_cast<long>(vertices.size()) -
                                         static_cast<long>(edges.size()) + static_cast<long>(faces.size());
  }
  return euler;
}

/// Euler characteristic of the tetrahedra as a solid.
long solid_euler(const Mesh& mesh) {
  std::set<Mesh::Index> vertices;
  std::set<std::array<Mesh::Index, 2>> edges;
  std::set<std::array<Mesh::Index, 3>> faces;
  for (const auto& tet : mesh.tets) add_simplices(tet, vertices, edges, faces);
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(faces.size()) - static_cast<long>(mesh.tets.size());
}

/// `octant`: length of the octants; `angle`: turning per element where the part is curved, 0: the same size
/// everywhere.
MeshResult mesh_at(const Model& model, double octant, double angle = 0.0) {
  MeshOptions options;
  options.size = octant * kEdgePerOctant;
  options.wall_elements = 0.0;  // a cone is a wall at its apex
  options.curvature_angle = angle;
  return mesh_part(model, options);
}

void expect_complete(const MeshResult& result, double size) {
  EXPECT_EQ(result.report.status, MeshStatus::kComplete) << "size " << size;
  for (const Fault& fault : result.report.faults) ADD_FAILURE() << fault.cause;
}

void expect_eulers(const Mesh& mesh, const Model& model, long solid) {
  const auto eulers = face_eulers(mesh, model);
  for (int f = 1; f <= model.count(2); ++f)
    EXPECT_EQ(eulers[static_cast<std::size_t>(f)], model.face(f).euler) << model.describe(model_face(f));
  EXPECT_EQ(solid_euler(mesh), solid);
}

/// Three sizes, each half of the one before.
void expect_planar_exact(const Model& model, double size, long solid) {
  for (int i = 0; i < 3; ++i, size *= 0.5) {
    const MeshResult result = mesh_at(model, size);
    expect_complete(result, size);
    const Errors errors = errors_of(measure(result.mesh, model), model);
    EXPECT_LT(errors.length, 1e-12) << "size " << size;
    EXPECT_LT(errors.area, 1e-12) << "size " << size;
    EXPECT_LT(errors.volume, 1e-12) << "size " << size;
    expect_eulers(result.mesh, model, solid);
  }
}

/// One error at sizes that halve. Each halving divides it by at least `least`, and by 3.5 in the (geometric)
/// mean.
void expect_ratios(const std::vector<double>& errors, double least, const char* what) {
  const auto halvings = static_cast<double>(errors.size() - 1);
  EXPECT_GE(std::pow(errors.front() / errors.back(), 1.0 / halvings), 3.5) << what;
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_GE(errors[i - 1] / errors[i], least) << what << ", halving " << i;
}

struct Sizes {
  double first;  ///< the others are each half of the one before
  int count = 3;
  double angle_per_size = 0.0;  ///< turning per element over size, radians per length
};

void expect_second_order(const Model& model, const Sizes& sizes, long solid, double least = 3.5) {
  std::vector<double> volume, area, length;
  double size = sizes.first;
  for (int i = 0; i < sizes.count; ++i, size *= 0.5) {
    const MeshResult result = mesh_at(model, size, sizes.angle_per_size * size);
    expect_complete(result, size);
    const Errors errors = errors_of(measure(result.mesh, model), model);
    expect_eulers(result.mesh, model, solid);
    volume.push_back(errors.volume);
    area.push_back(errors.area);
    length.push_back(errors.length);
  }
  expect_ratios(volume, least, "volume");
  expect_ratios(area, least, "area");
  if (length.front() > 1e-12) expect_ratios(length, least, "length");
}

AnalyticOptions turned() {
  AnalyticOptions options;
  options.frame.origin = Vec3(0.3, -0.7, 1.1);
  options.frame.axes = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
  return options;
}

TEST(Convergence, BoxIsExact) { expect_planar_exact(analytic_box(Vec3(1, 1.5, 2)), 0.4, 1); }
TEST(Convergence, RotatedBoxIsExact) { expect_planar_exact(analytic_box(Vec3(1, 1.5, 2), turned()), 0.4, 1); }
TEST(Convergence, TwoBoxesAreExact) { expect_planar_exact(analytic_two_boxes(Vec3(1, 1.5, 1)), 0.4, 1); }
TEST(Convergence, BallIsSecondOrder) { expect_second_order(analytic_ball(1.0), {0.4}, 1); }
TEST(Convergence, CylinderIsSecondOrder) { expect_second_order(analytic_cylinder(1.0, 1.5), {0.4}, 1); }
/// At a uniform size a cone's area is not of second order: its curvature is 1/r, so the relative error
/// (size/r)^2 summed over the face is size^2 log(1/size). Measured over the square of the size: 0.178 at 0.3,
/// 0.219 at 0.075, 0.282 at 0.019, so that the last halving divides by 3.3. From 0.25 on: at 0.3 there are
/// 900 tetrahedra, and the first ratio is chance (3.0 to 3.4).
TEST(Convergence, ConeAtAUniformSizeIsSecondOrderButForALogarithm) {
  expect_second_order(analytic_cone(1.0, 1.5), {.first = 0.25, .count = 4}, 1, 3.3);
}
/// Graded towards the apex, as its curvature asks, the logarithm goes.
TEST(Convergence, ConeGradedByCurvatureIsSecondOrder) {
  expect_second_order(analytic_cone(1.0, 1.5), {.first = 0.2, .angle_per_size = 0.5}, 1);
}
/// From half the tube's radius on: at 0.25 an element turns by 36 degrees, and the first ratio is 3.4.
TEST(Convergence, TorusIsSecondOrder) { expect_second_order(analytic_torus(1.0, 0.4), {0.2}, 0); }
TEST(Convergence, BoxMinusBallIsSecondOrder) {
  expect_second_order(analytic_box_minus_ball(2.0, 0.6), {0.2}, 2);
}

/// An L with a hole, its outer edge and its inner corner rounded; every feature is larger than the sizes
/// below.
TopoDS_Shape filleted_bracket() {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, z] : {std::pair{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 50}, {0, 50}})
    outline.Add(gp_Pnt(x, 0, z));
  outline.Close();
  const TopoDS_Shape angle = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()), gp_Vec(0, 40, 0));
  const gp_Ax2 axis(gp_Pnt(45, 20, -1), gp_Dir(0, 0, 1));
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis, 8, 30).Shape();
  const TopoDS_Shape sharp = BRepAlgoAPI_Cut(angle, drill).Shape();
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (TopExp_Explorer it(sharp, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    const bool along_y = std::abs(a.Y() - b.Y()) > 39;
    const auto lies_at = [&](double x, double z) {
      return along_y && std::abs(a.X() - x) < 1e-9 && std::abs(a.Z() - z) < 1e-9;
    };
    if (lies_at(20, 20) || lies_at(0, 0)) fillet.Add(10.0, edge);
  }
  return fillet.Shape();
}

TEST(Convergence, FilletedBracketIsSecondOrder) {
  const Model bracket = model_from_shape(filleted_bracket());
  ASSERT_EQ(bracket.count(2), 11);  // eight planes, the hole, two fillets
  // The fillets and the hole err with opposite signs in the one volume: at 4 and 2 its ratio is still 3.49.
  expect_second_order(bracket, {3.0}, 0);
}

}  // namespace
}  // namespace octet
