// SPDX-License-Identifier: BSD-3-Clause
// Analytic parts with lattice meshes of them.
#include "tests/finalize/parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/soundness.h"

namespace octet::testing {

namespace {

/// The walls of the mesh that lie in the plane of the face at a place, a plane through the origin, are
/// classified on that face.
void classify_walls_in_plane(Part& part, const Vec3& place) {
  Mesh& mesh = part.mesh;
  int face = 1;
  while (part.model.face_closest(face, place).distance > 1e-12) ++face;
  const Vec3 normal = part.model.face_project(face, place).normal;
  for (auto triangle : walls(mesh)) {
    const Vec3 &p = mesh.points[triangle[0]], &q = mesh.points[triangle[1]], &r = mesh.points[triangle[2]];
    const Vec3 own = (q - p).cross(r - p);
    if (std::abs(normal.dot(p)) + normal.cross(own).norm() > 1e-12) continue;
    if (own.dot(normal) < 0.0) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
    mesh.triangle_on.push_back(face);
  }
}

}  // namespace

Part box_part(const Vec3& size, int nx, int ny, int nz, bool turned) {
  AnalyticOptions options;
  if (turned) {
    options.frame.axes = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
    options.frame.origin = Vec3(0.1, -0.7, 0.3);
  }
  Part part{analytic_box(size, options), {}};
  part.mesh = lattice(nx, ny, nz, [&](const Vec3& p) -> Vec3 {
    return options.frame.origin + options.frame.axes * p.cwiseProduct(size);
  });
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part two_boxes_part(int n) {
  Part part{analytic_two_boxes({1, 1, 1}), {}};
  part.mesh = lattice(2 * n, n, n, [](const Vec3& p) -> Vec3 { return {2.0 * p.x(), p.y(), p.z()}; });
  for (std::size_t t = 0; t < part.mesh.tets.size(); ++t) {
    Vec3 centre = Vec3::Zero();
    for (const Mesh::Index v : part.mesh.tets[t]) centre += 0.25 * part.mesh.points[v];
    part.mesh.tet_in[t] = part.model.region_at(centre);
  }
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part ball_part(int n) {
  Part part{analytic_ball(1.0), {}};
  part.mesh = lattice(n, n, n, [](const Vec3& p) -> Vec3 {
    const Vec3 q = 2.0 * p - Vec3::Ones();
    const double length = q.norm();
    return length > 0.0 ? Vec3(q * (q.lpNorm<Eigen::Infinity>() / length)) : q;
  });
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part shell_part(int n, double inner) {
  Part part{analytic_hollow_ball(1.0, inner), {}};
  const double core = 1.0 - 2.0 / n;
  const auto cube_radius = [](const Vec3& p) { return (2.0 * p - Vec3::Ones()).lpNorm<Eigen::Infinity>(); };
  Mesh cube = lattice(n, n, n, [](const Vec3& p) -> Vec3 { return p; });
  std::vector<int> number(cube.points.size(), -1);
  for (const auto& v : cube.tets) {
    const Vec3 centre = (cube.points[v[0]] + cube.points[v[1]] + cube.points[v[2]] + cube.points[v[3]]) / 4.0;
    if (cube_radius(centre) < core) continue;
    std::array<Mesh::Index, 4> tet;
    for (int c = 0; c < 4; ++c) {
      if (number[v[c]] < 0) {
        number[v[c]] = static_cast<int>(part.mesh.points.size());
        const bool outer = cube_radius(cube.points[v[c]]) > 1.0 - 1.0 / n;
        part.mesh.points.push_back((outer ? 1.0 : inner) *
                                   (2.0 * cube.points[v[c]] - Vec3::Ones()).normalized());
      }
      tet[c] = static_cast<Mesh::Index>(number[v[c]]);
    }
    part.mesh.tets.push_back(tet);
    part.mesh.tet_in.push_back(1);
  }
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part cylinder_part(int n) {
  Part part{analytic_cylinder(1.0, 2.0), {}};
  part.mesh = lattice(n, n, n, [](const Vec3& p) -> Vec3 {
    const Vec2 q = 2.0 * p.head<2>() - Vec2::Ones();
    const double length = q.norm();
    const Vec2 round = length > 0.0 ? Vec2(q * (q.lpNorm<Eigen::Infinity>() / length)) : q;
    return {round.x(), round.y(), 2.0 * p.z()};
  });
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part jittered(Part part, double amount, std::uint64_t seed) {
  Dice dice(seed);
  jitter(part.mesh, part.model, amount, dice);
  return part;
}

Part spindle_part(int n) {
  Part part{analytic_ball(1.0), {}};
  part.mesh.points = {{0, 0, -1}, {0, 0, 1}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3) / n;
    part.mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    part.mesh.tets.push_back(
        {0, 1, static_cast<Mesh::Index>(2 + i), static_cast<Mesh::Index>(2 + (i + 1) % n)});
    part.mesh.tet_in.push_back(1);
  }
  classify_by_nearness(part.mesh, part.model);
  return part;
}

Part cells_about_edge(const Cells& without) {
  Part part{analytic_box({2, 2, 3}), {}};
  Mesh all = lattice(2, 2, 3, [](const Vec3& p) -> Vec3 {
    return p.cwiseProduct(Vec3(2.0, 2.0, 3.0)) - Vec3(1.0, 1.0, 0.0);
  });
  for (const auto& tet : all.tets) {
    Vec3 centre = Vec3::Zero();
    for (const Mesh::Index v : tet) centre += 0.25 * all.points[v];
    const bool gone = std::any_of(without.begin(), without.end(), [&](const auto& cell) {
      return std::abs(centre.z() - 1.5) < 0.5 && centre.x() * cell[0] > 0.0 && centre.y() * cell[1] > 0.0;
    });
    if (gone) continue;
    part.mesh.tets.push_back(tet);
    part.mesh.tet_in.push_back(1);
  }
  part.mesh.points = all.points;
  part.mesh.point_on.assign(all.points.size(), model_region(1));
  int edge = 1;
  while (part.model.edge_closest(edge, {0, 0, 1.5}).distance > 1e-12) ++edge;
  const auto number = [&](double z) {
    return static_cast<Mesh::Index>(std::find(all.points.begin(), all.points.end(), Vec3(0, 0, z)) -
                                    all.points.begin());
  };
  for (const double z : {1.0, 2.0}) part.mesh.point_on[number(z)] = model_edge(edge);
  part.mesh.edges = {{number(1.0), number(2.0)}};
  part.mesh.edge_on = {edge};
  for (const Vec3& beside : {Vec3(0, 1, 1.5), Vec3(1, 0, 1.5)}) classify_walls_in_plane(part, beside);
  return part;
}

FinalizeOptions options_of_size(double size) {
  FinalizeOptions options;
  options.size_at = [size](const Vec3&) { return size; };
  return options;
}

VertexId vertex_near(const WorkMesh& mesh, const Vec3& p) {
  VertexId best;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const VertexId v(i);
    if (!mesh.alive(v)) continue;
    if (!best.valid() || (mesh.points[v] - p).norm() < (mesh.points[best] - p).norm()) best = v;
  }
  return best;
}

std::string faults_of(const Mesh& mesh, const Model& model, const std::vector<int>& euler) {
  if (std::string fault = check_mesh_soundness(mesh); !fault.empty()) return fault;
  if (face_euler(mesh, model.count(2)) != euler) return "Euler characteristic of a face changed";
  if (largest_misplacement(mesh, model) > 1e-9 * model.diagonal()) return "a vertex left its entity";
  return {};
}

}  // namespace octet::testing
