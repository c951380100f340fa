// SPDX-License-Identifier: BSD-3-Clause
// The invariants of a triangulation, tested one by one.
#include <string>

#include "base/predicates.h"
#include "delaunay/triangulation.h"

namespace octet {
namespace {

std::string at(const char* what, TetId t) {
  return std::string(what) + " at tetrahedron " + std::to_string(t.index());
}

// The vertices of face f of t, as sorted numbers.
std::array<VertexId, 3> face_key(const TetMesh& mesh, TetId t, int f) {
  std::array<VertexId, 3> key{};
  for (int i = 0; i < 3; ++i) key[i] = mesh.tets[t][kTetFace[f][i]];
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  if (key[1] > key[2]) std::swap(key[1], key[2]);
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  return key;
}

std::string check_faces(const TetMesh& mesh, TetId t) {
  for (int f = 0; f < 4; ++f) {
    const TetId n = mesh.neighbours[t][f];
    if (!n.valid() || n.index() >= mesh.tets.size() || !mesh.alive(n)) return at("no live neighbour", t);
    int back = -1;
    for (int g = 0; g < 4; ++g) {
      if (mesh.neighbours[n][g] == t) back = g;
    }
    if (back < 0) return at("a neighbour does not point back", t);
    if (face_key(mesh, t, f) != face_key(mesh, n, back)) return at("neighbours do not share their face", t);
  }
  return {};
}

std::string check_vertices(const TetMesh& mesh, TetId t) {
  const auto& v = mesh.tets[t];
  for (int i = 0; i < 4; ++i) {
    if (v[i] == kGhostVertex ? i != 3 : v[i].index() >= mesh.points.size()) return at("a wrong vertex", t);
  }
  if (mesh.ghost(t)) return mesh.ghost(mesh.neighbours[t][3]) ? at("a ghost on no hull facet", t) : "";
  const int sign = orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  return sign > 0 ? "" : at("not positive", t);
}

// Whether the point of vertex w lies strictly inside the (ranked) sphere of t, or beyond t's hull facet.
bool holds(const Triangulation& triangulation, TetId t, VertexId w) {
  const TetMesh& mesh = triangulation.mesh();
  const auto point = [&](VertexId v) -> const Vec3& { return mesh.points[v]; };
  if (mesh.ghost(t)) {
    const auto& g = mesh.tets[t];
    const int side = orient3d(point(g[0]), point(g[1]), point(g[2]), point(w));
    if (side != 0) return side > 0;
    t = mesh.neighbours[t][3];
  }
  const auto& v = mesh.tets[t];
  if (w == v[0] || w == v[1] || w == v[2] || w == v[3]) return false;
  const std::uint64_t rank[5] = {triangulation.rank(v[0]), triangulation.rank(v[1]), triangulation.rank(v[2]),
                                 triangulation.rank(v[3]), triangulation.rank(w)};
  return insphere_ranked(point(v[0]), point(v[1]), point(v[2]), point(v[3]), point(w), rank) > 0;
}

// Empty spheres across every face make all spheres empty.
std::string check_spheres(const Triangulation& triangulation, TetId t) {
  const TetMesh& mesh = triangulation.mesh();
  for (int f = 0; f < 4; ++f) {
    const TetId n = mesh.neighbours[t][f];
    for (int g = 0; g < 4; ++g) {
      const VertexId w = mesh.tets[n][g];
      if (mesh.neighbours[n][g] == t && w != kGhostVertex && holds(triangulation, t, w)) {
        return at("a sphere is not empty", t);
      }
    }
  }
  return {};
}

}  // namespace

std::string check_triangulation(const Triangulation& triangulation) {
  const TetMesh& mesh = triangulation.mesh();
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    if (std::string fault = check_faces(mesh, t); !fault.empty()) return fault;
    if (std::string fault = check_vertices(mesh, t); !fault.empty()) return fault;
    if (std::string fault = check_spheres(triangulation, t); !fault.empty()) return fault;
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const TetId t = triangulation.tet_at(VertexId(i));
    if (!t.valid()) continue;
    const auto& v = mesh.tets[t];
    if (v[0] != VertexId(i) && v[1] != VertexId(i) && v[2] != VertexId(i) && v[3] != VertexId(i)) {
      return "vertex " + std::to_string(i) + " names a tetrahedron without it";
    }
  }
  return {};
}

}  // namespace octet
