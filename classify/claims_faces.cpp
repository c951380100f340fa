// SPDX-License-Identifier: BSD-3-Clause
// Claims about the mesh faces of each model face: a surface of the right topology, borders and orientation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <span>

#include "base/bucket_sort.h"
#include "classify/claims.h"

namespace octet {
namespace {

/// Sides of one mesh edge that belong to one face.
std::span<const TriangleSide> side_group(const ClaimInput& in, std::size_t i) {
  std::size_t n = i + 1;
  while (n < in.sides.size() && in.sides[n].v == in.sides[i].v && in.sides[n].face == in.sides[i].face) ++n;
  return {in.sides.data() + i, n - i};
}

struct FaceCount {
  std::size_t vertices = 0, edges = 0, triangles = 0;
  std::size_t parts = 0;   ///< that hang together by sides
  std::size_t pieces = 0;  ///< that hang together by sides or at model vertices
};

/// Parts and pieces per face: a loop may touch itself at a vertex.
void count_pieces(const ClaimInput& in, std::vector<FaceCount>& counts) {
  std::vector<std::uint32_t> parent(in.mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto join = [&](std::uint32_t s, std::uint32_t t) {
    const auto a = root_of(parent, s), b = root_of(parent, t);
    parent[std::max(a, b)] = std::min(a, b);
  };
  for (std::size_t i = 0; i < in.sides.size();) {
    const auto group = side_group(in, i);
    i += group.size();
    for (const TriangleSide& side : group) join(group[0].triangle, side.triangle);
  }
  for (std::uint32_t t = 0; t < parent.size(); ++t)
    if (parent[t] == t) ++counts[in.mesh.triangle_on[t]].parts;
  std::map<std::pair<Mesh::Index, std::int32_t>, std::uint32_t> at;
  for (std::uint32_t t = 0; t < parent.size(); ++t)
    for (const Mesh::Index v : in.mesh.triangles[t])
      if (in.mesh.point_on[v].dim == 0) join(at.try_emplace({v, in.mesh.triangle_on[t]}, t).first->second, t);
  for (std::uint32_t t = 0; t < parent.size(); ++t)
    if (parent[t] == t) ++counts[in.mesh.triangle_on[t]].pieces;
}

std::vector<FaceCount> count_faces(const ClaimInput& in) {
  std::vector<FaceCount> counts(in.triangles_on.size());
  for (std::size_t i = 0; i < in.sides.size(); i += side_group(in, i).size())
    ++counts[in.sides[i].face].edges;
  std::vector<std::int32_t> seen(in.mesh.points.size(), 0);
  for (std::size_t face = 1; face < counts.size(); ++face) {
    counts[face].triangles = in.triangles_on[face].size();
    for (const std::uint32_t t : in.triangles_on[face])
      for (const Mesh::Index v : in.mesh.triangles[t])
        if (seen[v] != static_cast<std::int32_t>(face)) {
          seen[v] = static_cast<std::int32_t>(face);
          ++counts[face].vertices;
        }
  }
  count_pieces(in, counts);
  return counts;
}

Vec3 place_on(const ClaimInput& in, int face) {
  const auto& triangles = in.triangles_on[face];
  if (!triangles.empty()) return in.centroid(in.mesh.triangles[triangles[0]]);
  const ModelFace& f = in.model.face(face);
  return f.vertices.empty() ? in.model.box().centre() : in.model.vertex(f.vertices[0]).point;
}

/// Uses of a model edge by a face: with the face on its left, and on its right.
std::array<std::size_t, 2> uses_of_edge(const ModelFace& face, int edge) {
  std::array<std::size_t, 2> uses{0, 0};
  for (const FaceBoundary& b : face.boundary)
    if (b.edge == edge) ++uses[b.sense > 0 ? 0 : 1];
  return uses;
}

/// Uses of a mesh edge from v[0] to v[1], and back.
std::array<std::size_t, 2> uses_of_side(std::span<const TriangleSide> group) {
  std::array<std::size_t, 2> uses{0, 0};
  for (const TriangleSide& side : group) ++uses[side.forward ? 0 : 1];
  return uses;
}

void check_border(const ClaimInput& in, ClaimBuilder& claim, std::span<const TriangleSide> group,
                  const EdgePieceRef* piece) {
  const auto found = uses_of_side(group);
  std::array<std::size_t, 2> asked{1, 1};
  const int face = group[0].face;
  if (piece != nullptr) {
    asked = uses_of_edge(in.model.face(face), in.mesh.edge_on[piece->edge]);
    if (!piece->forward) std::swap(asked[0], asked[1]);
  }
  if (found == asked) return;
  const std::string edge = piece == nullptr
                               ? "inside the face"
                               : "on " + in.model.describe(model_edge(in.mesh.edge_on[piece->edge]));
  claim.fault(1.0, model_face(face), 0.5 * (in.point(group[0].v[0]) + in.point(group[0].v[1])),
              fmt::format("a mesh edge {} has {} + {} triangles to its sides, not {} + {}", edge, found[0],
                          found[1], asked[0], asked[1]),
              kFiner);
}

/// Every piece of a model edge must have triangles of every face there.
void check_pieces(const ClaimInput& in, ClaimBuilder& claim) {
  auto side = in.sides.begin();
  for (const EdgePieceRef& piece : in.pieces) {
    while (side != in.sides.end() && side->v < piece.v) ++side;
    const ModelEdge& edge = in.model.edge(in.mesh.edge_on[piece.edge]);
    for (const int face : edge.faces) {
      bool found = false;
      for (auto s = side; s != in.sides.end() && s->v == piece.v; ++s) found = found || s->face == face;
      if (!found)
        claim.fault(1.0, model_face(face), 0.5 * (in.point(piece.v[0]) + in.point(piece.v[1])),
                    fmt::format("no triangle of the face meets a mesh edge on {}",
                                in.model.describe(model_edge(in.mesh.edge_on[piece.edge]))),
                    kFiner);
    }
  }
}

/// Number of fans that the triangles of a face form at vertex v: pieces linked by sides at v.
std::size_t fans_at(const ClaimInput& in, Mesh::Index v, std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto shares_side = [&](std::uint32_t a, std::uint32_t b) {
    int common = 0;
    for (const Mesh::Index p : in.mesh.triangles[a])
      for (const Mesh::Index q : in.mesh.triangles[b]) common += p == q && p != v ? 1 : 0;
    return common > 0;
  };
  std::size_t fans = triangles.size();
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j) {
      const auto a = root_of(parent, i), b = root_of(parent, j);
      if (a == b || !shares_side(triangles[i], triangles[j])) continue;
      parent[std::max(a, b)] = std::min(a, b);
      --fans;
    }
  return fans;
}

/// The triangles around each vertex inside a face are one fan; with two triangles at every side, one disk.
void check_fans(const ClaimInput& in, ClaimBuilder& claim) {
  std::vector<std::pair<Mesh::Index, std::uint32_t>> corners;
  corners.reserve(3 * in.mesh.triangles.size());
  for (std::uint32_t t = 0; t < in.mesh.triangles.size(); ++t)
    for (const Mesh::Index v : in.mesh.triangles[t])
      if (in.mesh.point_on[v].dim == 2) corners.emplace_back(v, t);
  bucket_sort(
      corners, in.mesh.points.size(), [](const auto& corner) { return corner.first; }, std::less<>());
  std::vector<std::uint32_t> around;
  for (std::size_t i = 0; i < corners.size();) {
    const Mesh::Index v = corners[i].first;
    around.clear();
    for (; i < corners.size() && corners[i].first == v; ++i) around.push_back(corners[i].second);
    if (fans_at(in, v, around) > 1)
      claim.fault(1.0, in.mesh.point_on[v], in.point(v), "the triangles around a vertex are not one disk",
                  kFiner);
  }
}

/// How often the loops of the face come to one of its vertices again; seams are no loops.
std::size_t touches_of_loops(const Model& model, const ModelFace& face) {
  std::map<int, std::size_t> ends;
  for (const FaceBoundary& b : face.boundary) {
    const auto is_same = [&](const FaceBoundary& other) { return other.edge == b.edge; };
    if (std::count_if(face.boundary.begin(), face.boundary.end(), is_same) > 1) continue;
    for (const int v : model.edge(b.edge).vertex) ++ends[v];
  }
  std::size_t touches = 0;
  for (const auto& [vertex, count] : ends) touches += count > 2 ? count / 2 - 1 : 0;
  return touches;
}

}  // namespace

Claim claim_face_euler(const ClaimInput& in) {
  ClaimBuilder claim("face-euler",
                     "The triangles on every face are one surface with the face's Euler characteristic.");
  const auto counts = count_faces(in);
  for (int face = 1; face <= in.model.count(2); ++face) {
    const FaceCount& n = counts[face];
    const long euler =
        static_cast<long>(n.vertices) - static_cast<long>(n.edges) + static_cast<long>(n.triangles);
    // The model's is that of a face in one part. Where a loop touches itself across the face it is in more.
    const std::size_t more = n.parts - std::min<std::size_t>(n.parts, 1);
    const long asked = in.model.face(face).euler + static_cast<long>(more);
    if (n.triangles == 0) {
      claim.fault(1e9, model_face(face), place_on(in, face), "no triangle lies on the face", kFiner);
    } else if (n.pieces != 1 || (more > 0 && more > touches_of_loops(in.model, in.model.face(face)))) {
      claim.fault(1e6, model_face(face), place_on(in, face),
                  fmt::format("the triangles on the face are {} pieces", n.parts), kFiner);
    } else if (euler != asked) {
      claim.fault(std::abs(static_cast<double>(euler - asked)), model_face(face), place_on(in, face),
                  fmt::format("the triangles have the Euler characteristic {}, the face {}", euler, asked),
                  kFiner);
    }
  }
  return claim.counted();
}

Claim claim_face_borders(const ClaimInput& in) {
  ClaimBuilder claim("face-borders",
                     "Inside a face every side has two triangles, in opposite directions; at its border the "
                     "sides are the pieces of its edges.");
  auto piece = in.pieces.begin();
  for (std::size_t i = 0; i < in.sides.size();) {
    const auto group = side_group(in, i);
    i += group.size();
    while (piece != in.pieces.end() && piece->v < group[0].v) ++piece;
    const bool on_edge = piece != in.pieces.end() && piece->v == group[0].v;
    check_border(in, claim, group, on_edge ? &*piece : nullptr);
  }
  check_pieces(in, claim);
  check_fans(in, claim);
  return claim.counted();
}

Claim claim_face_orientation(const ClaimInput& in) {
  ClaimBuilder claim("face-orientation",
                     "Every triangle's normal is within a right angle of its face's normal; worst: radians.");
  const double limit = 0.5 * std::acos(-1.0);
  double worst = 0.0;
  for (std::size_t t = 0; t < in.mesh.triangles.size(); ++t) {
    const Vec3& normal = in.triangle_foot[t].normal;
    const Vec3 own = in.cross(in.mesh.triangles[t]);
    if (normal.isZero()) continue;  // a pole or an apex: no normal to compare with
    // A triangle as thin as the CAD is vague about its corners has no side of its own.
    double vague = 0.0;
    for (const Mesh::Index v : in.mesh.triangles[t])
      vague = std::max(vague, in.model.tolerance_of(in.mesh.point_on[v]));
    if (own.norm() < 2.0 * vague * in.longest_side(in.mesh.triangles[t])) continue;
    const double angle = std::atan2(own.cross(normal).norm(), own.dot(normal));
    worst = std::max(worst, angle);
    if (angle < limit) continue;
    claim.fault(
        angle, model_face(in.mesh.triangle_on[t]), in.centroid(in.mesh.triangles[t]),
        fmt::format("triangle {} is turned by {:.0f} degrees against the face", t, angle * 90.0 / limit),
        kFiner);
  }
  return claim.measured(worst, limit);
}

}  // namespace octet
