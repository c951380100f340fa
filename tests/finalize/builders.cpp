// SPDX-License-Identifier: BSD-3-Clause
// Small valid classified meshes, made for the tests.
#include "tests/finalize/builders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/predicates.h"
#include "mesh/quality.h"
#include "mesh/tet_mesh.h"

namespace octet::testing {
namespace {

using Index = Mesh::Index;
using Triangle = std::array<Index, 3>;

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

ModelRef nearest_entity(const Model& model, const Vec3& p, double tolerance) {
  for (int v = 1; v <= model.count(0); ++v) {
    if ((model.vertex(v).point - p).norm() < tolerance) return model_vertex(v);
  }
  for (int e = 1; e <= model.count(1); ++e) {
    if (model.edge(e).use == EdgeUse::kReal && model.edge_closest(e, p).distance < tolerance)
      return model_edge(e);
  }
  int best = 0;
  double distance = 1e300;
  for (int f = 1; f <= model.count(2); ++f) {
    const double d = model.face_closest(f, p).distance;
    if (d < distance) {
      distance = d;
      best = f;
    }
  }
  return model_face(best);
}

int common_face(const Mesh& mesh, const Model& model, const Triangle& t) {
  const Vec3 centre = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
  int best = 0;
  double distance = 1e300;
  for (int f = 1; f <= model.count(2); ++f) {
    if (!std::all_of(t.begin(), t.end(),
                     [&](Index v) { return model.in_closure(mesh.point_on[v], model_face(f)); })) {
      continue;
    }
    const double d = model.face_closest(f, centre).distance;
    if (d < distance) {
      distance = d;
      best = f;
    }
  }
  return best;
}

int common_edge(const Mesh& mesh, const Model& model, Index a, Index b) {
  for (int e = 1; e <= model.count(1); ++e) {
    if (model.edge(e).use != EdgeUse::kReal) continue;
    if (!model.in_closure(mesh.point_on[a], model_edge(e)) ||
        !model.in_closure(mesh.point_on[b], model_edge(e))) {
      continue;
    }
    const Vec3 middle = 0.5 * (mesh.points[a] + mesh.points[b]);
    if (model.edge_closest(e, middle).distance < 0.2 * (mesh.points[a] - mesh.points[b]).norm()) return e;
  }
  return 0;
}

void classify_triangles(Mesh& mesh, const Model& model, const std::vector<Triangle>& faces) {
  for (Triangle t : faces) {
    const int face = common_face(mesh, model, t);
    const Vec3 normal = (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
    const Vec3 centre = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
    if (normal.dot(model.face_project(face, centre).normal) < 0.0) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
    mesh.triangle_on.push_back(face);
  }
}

void classify_edges(Mesh& mesh, const Model& model) {
  std::map<std::array<Index, 2>, std::set<int>> faces_at;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(mesh.triangles[i][c], mesh.triangles[i][(c + 1) % 3]);
      faces_at[{a, b}].insert(mesh.triangle_on[i]);
    }
  }
  for (const auto& [edge, faces] : faces_at) {
    if (faces.size() < 2) continue;
    const int e = common_edge(mesh, model, edge[0], edge[1]);
    if (e == 0) continue;
    const Vec3 middle = 0.5 * (mesh.points[edge[0]] + mesh.points[edge[1]]);
    const Vec3 along = model.edge_derivative(e, model.edge_closest(e, middle).t);
    const bool forward = along.dot(mesh.points[edge[1]] - mesh.points[edge[0]]) > 0.0;
    mesh.edges.push_back({edge[forward ? 0 : 1], edge[forward ? 1 : 0]});
    mesh.edge_on.push_back(e);
  }
}

bool positive(const Mesh& mesh, const std::array<Index, 4>& v) {
  return orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) > 0;
}

Vec3 onto_entity(const Model& model, ModelRef on, const Vec3& p) {
  if (on.dim == 1) return model.edge_closest(on.tag, p).point;
  if (on.dim == 2) return model.face_project(on.tag, p).point;
  return p;
}

}  // namespace

double Dice::roll() {
  state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
  return static_cast<double>(state_ >> 11) / 9007199254740992.0;
}

Mesh lattice(int nx, int ny, int nz, const std::function<Vec3(const Vec3&)>& place) {
  Mesh mesh;
  const auto number = [&](int i, int j, int k) {
    return static_cast<Index>((k * (ny + 1) + j) * (nx + 1) + i);
  };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i)
        mesh.points.push_back(place({double(i) / nx, double(j) / ny, double(k) / nz}));
    }
  }
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        for (const auto& order : kOrders) {
          int at[3] = {i, j, k};
          std::array<Index, 4> tet;
          tet[0] = number(at[0], at[1], at[2]);
          for (int step = 0; step < 3; ++step) {
            ++at[order[step]];
            tet[step + 1] = number(at[0], at[1], at[2]);
          }
          if (!positive(mesh, tet)) std::swap(tet[2], tet[3]);
          mesh.tets.push_back(tet);
          mesh.tet_in.push_back(1);
        }
      }
    }
  }
  return mesh;
}

std::vector<Triangle> walls(const Mesh& mesh) {
  std::map<Triangle, std::vector<std::pair<std::size_t, Triangle>>> sides;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const auto& f : kTetFace) {
      const Triangle face{mesh.tets[t][f[0]], mesh.tets[t][f[1]], mesh.tets[t][f[2]]};
      sides[sorted(face)].emplace_back(t, face);
    }
  }
  std::vector<Triangle> result;
  for (const auto& [key, list] : sides) {
    if (list.size() == 1 || mesh.tet_in[list[0].first] != mesh.tet_in[list[1].first]) {
      result.push_back(list[0].second);
    }
  }
  return result;
}

void classify_by_nearness(Mesh& mesh, const Model& model) {
  const std::vector<Triangle> faces = walls(mesh);
  mesh.point_on.assign(mesh.points.size(), {});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const Index v : mesh.tets[t]) mesh.point_on[v] = model_region(mesh.tet_in[t]);
  }
  std::set<Index> outer;
  for (const Triangle& t : faces) outer.insert(t.begin(), t.end());
  for (const Index v : outer)
    mesh.point_on[v] = nearest_entity(model, mesh.points[v], 1e-9 * model.diagonal());
  classify_triangles(mesh, model, faces);
  classify_edges(mesh, model);
}

void jitter(Mesh& mesh, const Model& model, double amount, Dice& dice) {
  std::vector<std::vector<std::size_t>> tets_at(mesh.points.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const Index v : mesh.tets[t]) tets_at[v].push_back(t);
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const double x = dice.roll(), y = dice.roll(), z = dice.roll();
    if (mesh.point_on[v].dim == 0) continue;
    const Vec3 before = mesh.points[v];
    const Vec3 offset = 2.0 * amount * (Vec3(x, y, z) - Vec3::Constant(0.5));
    mesh.points[v] = onto_entity(model, mesh.point_on[v], before + offset);
    const bool good = std::all_of(tets_at[v].begin(), tets_at[v].end(),
                                  [&](std::size_t t) { return positive(mesh, mesh.tets[t]); });
    if (!good) mesh.points[v] = before;
  }
}

int glue_flat_tets(Mesh& mesh, const Model& model) {
  std::map<std::array<Index, 2>, std::vector<std::size_t>> at_edge;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(mesh.triangles[i][c], mesh.triangles[i][(c + 1) % 3]);
      at_edge[{a, b}].push_back(i);
    }
  }
  std::vector<char> used(mesh.triangles.size(), 0);
  int glued = 0;
  for (const auto& [edge, pair] : at_edge) {
    if (pair.size() != 2 || used[pair[0]] || used[pair[1]]) continue;
    if (mesh.triangle_on[pair[0]] != mesh.triangle_on[pair[1]]) continue;
    if (model.face(mesh.triangle_on[pair[0]]).region[1] != 0) continue;
    Triangle& p = mesh.triangles[pair[0]];
    Triangle& q = mesh.triangles[pair[1]];
    while (p[0] == edge[0] || p[0] == edge[1]) std::rotate(p.begin(), p.begin() + 1, p.end());
    while (q[0] == edge[0] || q[0] == edge[1]) std::rotate(q.begin(), q.begin() + 1, q.end());
    // p = (r, a, b), q = (s, b, a), normals outwards: the tetrahedron on them has them as inward faces.
    const std::array<Index, 4> tet{p[0], p[1], p[2], q[0]};
    if (!positive(mesh, tet)) continue;
    const Index r = p[0], a = p[1], b = p[2], s = q[0];
    mesh.tets.push_back(tet);
    mesh.tet_in.push_back(mesh.tet_in[0]);
    p = {r, a, s};
    q = {s, b, r};
    used[pair[0]] = used[pair[1]] = 1;
    ++glued;
  }
  return glued;
}

double total_volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& v : mesh.tets) {
    sum += signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  }
  return sum;
}

std::vector<int> face_euler(const Mesh& mesh, int faces) {
  std::vector<std::set<Index>> vertices(static_cast<std::size_t>(faces) + 1);
  std::vector<std::set<std::array<Index, 2>>> edges(vertices.size());
  std::vector<int> euler(vertices.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t f = static_cast<std::size_t>(mesh.triangle_on[i]);
    ++euler[f];
    for (int c = 0; c < 3; ++c) {
      const auto [a, b] = std::minmax(mesh.triangles[i][c], mesh.triangles[i][(c + 1) % 3]);
      vertices[f].insert(a);
      vertices[f].insert(b);
      edges[f].insert({a, b});
    }
  }
  for (std::size_t f = 0; f < euler.size(); ++f) {
    euler[f] += static_cast<int>(vertices[f].size()) - static_cast<int>(edges[f].size());
  }
  return euler;
}

double largest_misplacement(const Mesh& mesh, const Model& model) {
  double worst = 0.0;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const ModelRef on = mesh.point_on[v];
    const Vec3& p = mesh.points[v];
    if (on.dim == 0) worst = std::max(worst, (model.vertex(on.tag).point - p).norm());
    if (on.dim == 1) worst = std::max(worst, model.edge_closest(on.tag, p).distance);
    if (on.dim == 2) worst = std::max(worst, model.face_closest(on.tag, p).distance);
  }
  return worst;
}

}  // namespace octet::testing
