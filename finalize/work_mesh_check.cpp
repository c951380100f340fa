// SPDX-License-Identifier: BSD-3-Clause
// The invariants of WorkMesh, tested word by word.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/predicates.h"
#include "finalize/shape.h"
#include "finalize/work_mesh.h"

namespace octet {
namespace {

std::string check_tet(const WorkMesh& mesh, TetId t) {
  const auto& v = mesh.tets[t];
  for (const VertexId id : v) {
    if (id.index() >= mesh.points.size() || !mesh.alive(id))
      return fmt::format("tet {}: lost vertex", t.index());
  }
  const Vec3 &a = mesh.point(t, 0), &b = mesh.point(t, 1), &c = mesh.point(t, 2), &d = mesh.point(t, 3);
  if (orient3d(a, b, c, d) <= 0) return fmt::format("tet {}: volume not positive", t.index());
  if (std::abs(mesh.quality[t] - shape(a, b, c, d)) > 1e-9)
    return fmt::format("tet {}: stale quality", t.index());
  return {};
}

std::string check_face(const WorkMesh& mesh, TetId t, int f) {
  const TetId n = mesh.neighbours[t][f];
  const std::int32_t tag = mesh.face_on[t][f];
  const auto frozen = [&](int corner) { return mesh.frozen(mesh.tets[t][corner]); };
  const bool seam = frozen(kTetFace[f][0]) && frozen(kTetFace[f][1]) && frozen(kTetFace[f][2]);
  if (!n.valid())
    return tag != 0 || seam ? "" : fmt::format("tet {} face {}: outer and not classified", t.index(), f);
  if (!mesh.alive(n)) return fmt::format("tet {} face {}: dead neighbour", t.index(), f);
  int back = 0;
  while (back < 4 && mesh.neighbours[n][back] != t) ++back;
  if (back == 4) return fmt::format("tet {} face {}: neighbour does not point back", t.index(), f);
  for (int c = 0; c < 3; ++c) {
    const int corner = corner_of(mesh, n, mesh.tets[t][kTetFace[f][c]]);
    if (corner < 0 || corner == back) return fmt::format("tet {} face {}: other vertices", t.index(), f);
  }
  if (mesh.face_on[n][back] != -tag)
    return fmt::format("tet {} face {}: tags of the two sides", t.index(), f);
  if (tag == 0 && mesh.region[t] != mesh.region[n]) {
    return fmt::format("tet {} face {}: between regions and not classified", t.index(), f);
  }
  return {};
}

std::string check_pieces(const WorkMesh& mesh) {
  std::vector<std::int32_t> count(mesh.pieces_on_edge.size(), 0);
  for (const auto& [key, tag] : mesh.pieces) {
    const VertexId ends[2] = {VertexId(key & 0xffffffffu), VertexId(key >> 32)};
    for (const VertexId v : ends) {
      if (!mesh.alive(v)) return "a piece has a removed end";
      if (mesh.on[v].dim > 1 || (mesh.on[v].dim == 1 && mesh.on[v].tag != std::abs(tag))) {
        return fmt::format("vertex {}: end of a piece of another edge", v.index());
      }
    }
    ++count[static_cast<std::size_t>(std::abs(tag))];
  }
  return count == mesh.pieces_on_edge ? "" : "piece counts";
}

}  // namespace

std::string check_work_mesh(const WorkMesh& mesh) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) {
      if (std::find(mesh.free_tets.begin(), mesh.free_tets.end(), t) == mesh.free_tets.end())
        return "lost slot";
      continue;
    }
    if (std::string fault = check_tet(mesh, t); !fault.empty()) return fault;
    for (int f = 0; f < 4; ++f) {
      if (std::string fault = check_face(mesh, t, f); !fault.empty()) return fault;
    }
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const VertexId v(i);
    if (mesh.alive(v) && (!mesh.alive(mesh.tet_of[v]) || corner_of(mesh, mesh.tet_of[v], v) < 0)) {
      return fmt::format("vertex {}: tet_of is no tetrahedron of it", i);
    }
  }
  return check_pieces(mesh);
}

}  // namespace octet
