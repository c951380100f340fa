// SPDX-License-Identifier: BSD-3-Clause
// One function per invariant of mesh/mesh.h; the first that fails is told.
#include "mesh/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/predicates.h"
#include "mesh/face_uses.h"

namespace octet {
namespace {

template <std::size_t N>
std::string told(const char* kind, std::size_t number, const std::array<Mesh::Index, N>& v,
                 const std::string& fault) {
  return fmt::format("{} {} (vertices {}): {}", kind, number, fmt::join(v, " "), fault);
}

std::string place(const Vec3& p) { return fmt::format("at ({:.9g}, {:.9g}, {:.9g})", p.x(), p.y(), p.z()); }

std::string check_sizes(const Mesh& mesh) {
  if (mesh.points.size() != mesh.point_on.size()) return "points and point_on differ in size";
  if (mesh.edges.size() != mesh.edge_on.size()) return "edges and edge_on differ in size";
  if (mesh.triangles.size() != mesh.triangle_on.size()) return "triangles and triangle_on differ in size";
  if (mesh.tets.size() != mesh.tet_in.size()) return "tets and tet_in differ in size";
  return {};
}

template <std::size_t N>
std::string check_indices(const char* kind, const std::vector<std::array<Mesh::Index, N>>& elements,
                          std::vector<char>& used) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (const Mesh::Index v : elements[i])
      if (v >= used.size()) return told(kind, i, elements[i], "a vertex number is out of range");
    for (const Mesh::Index v : elements[i]) used[v] = 1;
  }
  return {};
}

template <std::size_t N>
bool all_below(std::size_t count, const std::vector<std::array<Mesh::Index, N>>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [&](const auto& each) {
    return std::all_of(each.begin(), each.end(), [&](const Mesh::Index i) { return i < count; });
  });
}

std::string check_mid_arrays(const Mesh& mesh) {
  const MidNodes& mid = mesh.mid;
  if (mid.empty()) return {};
  const std::size_t nodes = mid.points.size();
  if (mid.on.size() != nodes || mid.between.size() != nodes)
    return "nodes of second order differ in number from what they are on or between";
  if (mid.of_edges.size() != mesh.edges.size() || mid.of_triangles.size() != mesh.triangles.size() ||
      mid.of_tets.size() != mesh.tets.size())
    return "some elements have nodes of second order and others have not";
  const bool in_range =
      all_below(mesh.points.size(), mid.between) && all_below(nodes, mid.of_triangles) &&
      all_below(nodes, mid.of_tets) &&
      std::all_of(mid.of_edges.begin(), mid.of_edges.end(), [&](const Mesh::Index i) { return i < nodes; });
  return in_range ? "" : "the number of a node of second order is out of range";
}

/// A repeated vertex within an element, or two elements with the same vertices.
template <std::size_t N>
std::string check_twice(const char* kind, const std::vector<std::array<Mesh::Index, N>>& elements) {
  std::vector<std::pair<std::array<Mesh::Index, N>, std::size_t>> keys(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    keys[i] = {elements[i], i};
    std::sort(keys[i].first.begin(), keys[i].first.end());
    if (std::adjacent_find(keys[i].first.begin(), keys[i].first.end()) != keys[i].first.end())
      return told(kind, i, elements[i], "names a vertex twice");
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first)
      return told(kind, keys[i].second, elements[keys[i].second],
                  fmt::format("is the same as {} {}", kind, keys[i - 1].second));
  return {};
}

std::string check_vertices_used(const Mesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  if (auto s = check_indices("edge", mesh.edges, used); !s.empty()) return s;
  if (auto s = check_indices("triangle", mesh.triangles, used); !s.empty()) return s;
  if (auto s = check_indices("tetrahedron", mesh.tets, used); !s.empty()) return s;
  const auto unused = std::find(used.begin(), used.end(), 0);
  if (unused == used.end()) return {};
  const auto v = static_cast<std::size_t>(unused - used.begin());
  return fmt::format("vertex {} {}: no element uses it", v, place(mesh.points[v]));
}

std::string check_given_once(const Mesh& mesh) {
  if (auto s = check_twice("edge", mesh.edges); !s.empty()) return s;
  if (auto s = check_twice("triangle", mesh.triangles); !s.empty()) return s;
  return check_twice("tetrahedron", mesh.tets);
}

std::string check_positive(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto& t = mesh.tets[i];
    const int sign = orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    if (sign > 0) continue;
    return told(
        "tetrahedron", i, t,
        fmt::format("its volume is {} {}", sign == 0 ? "zero" : "negative", place(mesh.points[t[0]])));
  }
  return {};
}

/// Faces of the tetrahedra: at most two uses, on opposite sides; boundary and interfaces are triangles.
std::string check_faces(const Mesh& mesh) {
  std::vector<std::array<Mesh::Index, 3>> triangles(mesh.triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = sorted_face(mesh.triangles[i]).v;
  std::sort(triangles.begin(), triangles.end());
  const FaceUses uses(mesh);
  for (std::size_t i = 0; i < uses.all().size();) {
    const auto group = uses.group(i);
    i += group.size();
    const auto& v = group[0].v;
    const std::string where = place(mesh.points[v[0]]);
    if (group.size() > 2) return told("face of tetrahedron", group[0].tet, v, "has more than two " + where);
    if (group.size() == 2 && group[0].even == group[1].even)
      return told("face of tetrahedron", group[0].tet, v, "has both its tetrahedra on one side " + where);
    const bool asked = group.size() == 1 || mesh.tet_in[group[0].tet] != mesh.tet_in[group[1].tet];
    if (asked && !std::binary_search(triangles.begin(), triangles.end(), v))
      return told("face of tetrahedron", group[0].tet, v,
                  (group.size() == 1 ? "is on the boundary, but no triangle "
                                     : "is between two regions, "
                                       "but no triangle ") +
                      where);
  }
  return {};
}

struct Side {
  std::array<Mesh::Index, 2> v;  ///< ascending
  std::int32_t face = 0;
  bool forward = true;
  std::size_t triangle = 0;
  auto operator<=>(const Side&) const = default;
};

/// What of invariant 4 can be seen without the part: two triangles of a model face that share a side, and
/// are the only ones there, run it in opposite directions.
std::string check_orientation(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto a = mesh.triangles[i][k];
      const auto b = mesh.triangles[i][(k + 1) % 3];
      sides.push_back({{std::min(a, b), std::max(a, b)}, mesh.triangle_on[i], a < b, i});
    }
  std::sort(sides.begin(), sides.end());
  const auto same = [](const Side& a, const Side& b) { return a.v == b.v && a.face == b.face; };
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t n = i + 1;
    while (n < sides.size() && same(sides[i], sides[n])) ++n;
    if (n == i + 2 && sides[i].forward == sides[i + 1].forward)
      return told(
          "triangle", sides[i].triangle, mesh.triangles[sides[i].triangle],
          fmt::format("is oriented against its neighbour {} on the same model face", sides[i + 1].triangle));
    i = n;
  }
  return {};
}

template <std::size_t N>
std::string check_classified(const char* kind, int dim, const Mesh& mesh,
                             const std::vector<std::array<Mesh::Index, N>>& elements,
                             const std::vector<std::int32_t>& on) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (on[i] <= 0) return told(kind, i, elements[i], "is on no model entity");
    for (const Mesh::Index v : elements[i]) {
      const ModelRef ref = mesh.point_on[v];
      if (ref.dim < dim || ref == ModelRef{dim, on[i]}) continue;
      return told(
          kind, i, elements[i],
          fmt::format("lies on model entity {} of dimension {}, its vertex {} does not", on[i], dim, v));
    }
  }
  return {};
}

std::string check_classification(const Mesh& mesh) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (!mesh.point_on[v].valid() || mesh.point_on[v].dim > 3)
      return fmt::format("vertex {} {}: is on no model entity", v, place(mesh.points[v]));
  if (auto s = check_classified("edge", 1, mesh, mesh.edges, mesh.edge_on); !s.empty()) return s;
  if (auto s = check_classified("triangle", 2, mesh, mesh.triangles, mesh.triangle_on); !s.empty()) return s;
  return check_classified("tetrahedron", 3, mesh, mesh.tets, mesh.tet_in);
}

}  // namespace

std::string check_mesh_arrays(const Mesh& mesh) {
  if (auto s = check_sizes(mesh); !s.empty()) return s;
  const std::size_t n = mesh.points.size();
  if (!all_below(n, mesh.edges) || !all_below(n, mesh.triangles) || !all_below(n, mesh.tets))
    return "a vertex number is out of range";
  return check_mid_arrays(mesh);
}

std::string check_mesh_soundness(const Mesh& mesh) {
  if (auto s = check_sizes(mesh); !s.empty()) return s;
  if (auto s = check_vertices_used(mesh); !s.empty()) return s;
  if (auto s = check_given_once(mesh); !s.empty()) return s;
  if (auto s = check_positive(mesh); !s.empty()) return s;
  if (auto s = check_faces(mesh); !s.empty()) return s;
  if (auto s = check_orientation(mesh); !s.empty()) return s;
  return check_classification(mesh);
}

}  // namespace octet
