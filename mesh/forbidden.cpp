// SPDX-License-Identifier: BSD-3-Clause
// Where the part itself forbids good elements of the size asked for.
#include "mesh/forbidden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "mesh/tet_links.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

using Index = Mesh::Index;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Angle between the planes (a, b, c) and (a, b, d) at edge ab.
double angle_at_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 axis = b - a;
  return angle_between(axis.cross(c - a), axis.cross(d - a));
}

/// A tetrahedron at a mesh edge that lies on a model edge.
struct AtPiece {
  std::array<Index, 2> piece;
  Index tet;
  double angle;
};

std::vector<std::array<Index, 2>> sorted_pieces(const Mesh& mesh) {
  std::vector<std::array<Index, 2>> pieces = mesh.edges;
  for (auto& piece : pieces) std::sort(piece.begin(), piece.end());
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

std::vector<AtPiece> tets_at_pieces(const Mesh& mesh) {
  const auto pieces = sorted_pieces(mesh);
  std::vector<char> at_edge(mesh.points.size(), 0);
  for (const auto& piece : pieces) at_edge[piece[0]] = at_edge[piece[1]] = 1;
  std::vector<AtPiece> found;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    for (int e = 0; e < 6; ++e) {
      const Index a = v[kTetEdge[e][0]], b = v[kTetEdge[e][1]];
      if (!at_edge[a] || !at_edge[b]) continue;
      const std::array<Index, 2> piece{std::min(a, b), std::max(a, b)};
      if (!std::binary_search(pieces.begin(), pieces.end(), piece)) continue;
      const Index c = v[kTetEdge[5 - e][0]], d = v[kTetEdge[5 - e][1]];
      const double angle = angle_at_edge(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
      found.push_back({piece, static_cast<Index>(t), angle});
    }
  }
  std::sort(found.begin(), found.end(), [](const AtPiece& p, const AtPiece& q) {
    return std::tie(p.piece, p.tet) < std::tie(q.piece, q.tet);
  });
  return found;
}

/// The angle of the wedge between walls that tetrahedron `from` of the group around one piece lies in.
double wedge_angle(const Mesh& mesh, const TetLinks& links, const AtPiece* group, std::size_t count,
                   std::size_t from, std::vector<char>& seen) {
  std::vector<std::size_t> wedge{from};
  seen[from] = 1;
  double sum = 0.0;
  for (std::size_t i = 0; i < wedge.size(); ++i) {
    const AtPiece& at = group[wedge[i]];
    sum += at.angle;
    for (int f = 0; f < 4; ++f) {
      // Across faces that hold the piece.
      const Index apex = mesh.tets[at.tet][f];
      if (links.wall[at.tet][f] || apex == at.piece[0] || apex == at.piece[1]) continue;
      for (std::size_t j = 0; j < count; ++j) {
        if (seen[j] || group[j].tet != links.neighbour[at.tet][f]) continue;
        seen[j] = 1;
        wedge.push_back(j);
      }
    }
  }
  return sum;
}

void flag_sharp_edges(const Mesh& mesh, const TetLinks& links, std::vector<char>& flagged) {
  const std::vector<AtPiece> at = tets_at_pieces(mesh);
  std::vector<char> seen;
  for (std::size_t i = 0; i < at.size();) {
    std::size_t end = i + 1;
    while (end < at.size() && at[end].piece == at[i].piece) ++end;
    seen.assign(end - i, 0);
    for (std::size_t j = i; j < end; ++j) {
      if (seen[j - i] || wedge_angle(mesh, links, &at[i], end - i, j - i, seen) >= kSharpAngle) continue;
      flagged[at[i].piece[0]] = flagged[at[i].piece[1]] = 1;
    }
    i = end;
  }
}

void flag_sharp_corners(const Mesh& mesh, std::vector<char>& flagged) {
  std::vector<std::array<Index, 2>> ends;  // model vertex, the other end of a piece
  for (const auto& [a, b] : mesh.edges) {
    if (mesh.point_on[a].dim == 0) ends.push_back({a, b});
    if (mesh.point_on[b].dim == 0) ends.push_back({b, a});
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vec3& corner = mesh.points[ends[i][0]];
    for (std::size_t j = i + 1; j < ends.size() && ends[j][0] == ends[i][0]; ++j) {
      if (angle_between(mesh.points[ends[i][1]] - corner, mesh.points[ends[j][1]] - corner) < kSharpAngle)
        flagged[ends[i][0]] = 1;
    }
  }
}

void flag_narrow_places(const Mesh& mesh, std::span<const double> size, std::vector<char>& flagged) {
  const auto pieces = sorted_pieces(mesh);
  for (const auto& v : mesh.tets) {
    for (const auto& e : kTetEdge) {
      const Index a = std::min(v[e[0]], v[e[1]]), b = std::max(v[e[0]], v[e[1]]);
      const ModelRef p = mesh.point_on[a], q = mesh.point_on[b];
      if (p.dim > 1 || q.dim > 1 || p == q) continue;
      if ((mesh.points[a] - mesh.points[b]).norm() >= kNarrow * std::min(size[a], size[b])) continue;
      if (p.dim != q.dim && std::binary_search(pieces.begin(), pieces.end(), std::array{a, b})) continue;
      flagged[a] = flagged[b] = 1;
    }
  }
}

/// Squared distance from p to the line segment ab.
double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (a + share * along - p).squaredNorm();
}

/// Cusps of faces, where the vertices of one edge stand between those of the other.
void flag_narrow_cusps(const Mesh& mesh, std::span<const double> size, std::vector<char>& flagged) {
  const auto pieces = sorted_pieces(mesh);
  for (const auto& v : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Index apex = v[i], a = v[(i + 1) % 3], b = v[(i + 2) % 3];
      const ModelRef on = mesh.point_on[apex];
      if (on.dim > 1 || mesh.point_on[a].dim > 1 || mesh.point_on[b].dim > 1) continue;
      if (on.dim == 1 && (on == mesh.point_on[a] || on == mesh.point_on[b])) continue;
      const double near = kNarrow * std::min({size[apex], size[a], size[b]});
      if (squared_distance(mesh.points[apex], mesh.points[a], mesh.points[b]) >= near * near) continue;
      if (!std::binary_search(pieces.begin(), pieces.end(), std::array{std::min(a, b), std::max(a, b)}))
        continue;
      flagged[apex] = flagged[a] = flagged[b] = 1;
    }
  }
}

/// A face of a tetrahedron met by a ray.
struct Exit {
  int face = -1;
  double distance = 0.0;
};

/// Where the ray leaves the tetrahedron, by another face than it came in by.
Exit leave(const Mesh& mesh, Index tet, int entered, const Vec3& from, const Vec3& direction) {
  Exit exit;
  const auto& v = mesh.tets[tet];
  for (int f = 0; f < 4; ++f) {
    if (f == entered) continue;
    const Vec3& a = mesh.points[v[kTetFace[f][0]]];
    const Vec3 normal =
        (mesh.points[v[kTetFace[f][1]]] - a).cross(mesh.points[v[kTetFace[f][2]]] - a).normalized();
    const double speed = normal.dot(direction);
    if (speed <= 1e-12) continue;
    const double distance = normal.dot(a - from) / speed;
    if (exit.face < 0 || distance < exit.distance) exit = {f, distance};
  }
  return exit;
}

/// Flags the wall on both sides when the one straight behind face `face` of `tet` is within `reach`.
void flag_thin_wall(const Mesh& mesh, const TetLinks& links, Index tet, int face, double reach,
                    std::vector<char>& flagged) {
  constexpr int kMaxSteps = 64;
  const auto corners = [&](Index t, int f) {
    const auto& v = mesh.tets[t];
    return std::array<Index, 3>{v[kTetFace[f][0]], v[kTetFace[f][1]], v[kTetFace[f][2]]};
  };
  const auto normal = [&](const std::array<Index, 3>& c) -> Vec3 {
    return (mesh.points[c[1]] - mesh.points[c[0]]).cross(mesh.points[c[2]] - mesh.points[c[0]]).normalized();
  };
  const auto wall = corners(tet, face);
  const Vec3 middle = (mesh.points[wall[0]] + mesh.points[wall[1]] + mesh.points[wall[2]]) / 3.0;
  const Vec3 inward = -normal(wall);
  Index at = tet;
  int entered = face;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Exit exit = leave(mesh, at, entered, middle, inward);
    if (exit.face < 0 || exit.distance > reach) return;
    if (links.wall[at][exit.face]) {
      const auto other = corners(at, exit.face);
      if (normal(other).dot(inward) < std::cos(kSharpAngle)) return;
      for (const Index v : wall) flagged[v] = 1;
      for (const Index v : other) flagged[v] = 1;
      return;
    }
    const Index next = links.neighbour[at][exit.face];
    if (next == kNoTet) return;
    const auto& back = links.neighbour[next];
    entered = static_cast<int>(std::find(back.begin(), back.end(), at) - back.begin());
    at = next;
  }
}

}  // namespace

std::vector<char> forbidding_vertices(const Mesh& mesh, std::span<const double> size) {
  std::vector<char> flagged(mesh.points.size(), 0);
  const TetLinks links = tet_links(mesh);
  flag_sharp_edges(mesh, links, flagged);
  flag_sharp_corners(mesh, flagged);
  flag_narrow_places(mesh, size, flagged);
  flag_narrow_cusps(mesh, size, flagged);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      if (!links.wall[t][f]) continue;
      flag_thin_wall(mesh, links, static_cast<Index>(t), f, size[mesh.tets[t][kTetFace[f][0]]], flagged);
    }
  }
  return flagged;
}

bool touches(const std::array<Mesh::Index, 4>& tet, const std::vector<char>& flagged) {
  return std::any_of(tet.begin(), tet.end(), [&](Index v) { return flagged[v] != 0; });
}

}  // namespace octet
