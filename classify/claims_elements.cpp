// SPDX-License-Identifier: BSD-3-Clause
// Claims about elements and nodes: numbers, volumes, conformity, classified boundary, orphans, duplicates.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "base/blocks.h"
#include "base/bucket_sort.h"
#include "base/predicates.h"
#include "classify/claims.h"

namespace octet {
namespace {

template <std::size_t N>
bool repeats_vertex(const std::array<Mesh::Index, N>& v) {
  bool repeats = false;
  for (std::size_t i = 1; i < N; ++i)
    for (std::size_t j = 0; j < i; ++j) repeats |= v[i] == v[j];
  return repeats;
}

template <std::size_t N>
void check_numbers(ClaimBuilder& claim, const Mesh& mesh, const char* kind, int dim, int tags,
                   const std::vector<std::array<Mesh::Index, N>>& elements,
                   const std::vector<std::int32_t>& on) {
  if (elements.size() != on.size()) {
    claim.fault(1.0, {dim, 0}, Vec3::Zero(), fmt::format("the {} arrays differ in size", kind), kBadMesh);
    return;
  }
  const auto is_in_range = [&](const auto& v) {
    return std::all_of(v.begin(), v.end(), [&](auto k) { return k < mesh.points.size(); });
  };
  const auto bad = collect<std::size_t>(elements.size(), [&](std::size_t i, std::vector<std::size_t>& found) {
    if (!is_in_range(elements[i]) || repeats_vertex(elements[i]) || on[i] < 1 || on[i] > tags)
      found.push_back(i);
  });
  for (const std::size_t i : bad) {
    const auto& v = elements[i];
    const bool in_range = is_in_range(v);
    claim.fault(1.0, {dim, on[i]}, in_range ? mesh.points[v[0]] : Vec3::Zero(),
                fmt::format("{} {} on entity {} has vertices {}", kind, i, on[i], fmt::join(v, " ")),
                kBadMesh);
  }
}

/// Faces of tetrahedra that should be triangles and are none.
template <class Asked>
void report_unclassified(const ClaimInput& in, ClaimBuilder& claim, const char* cause, const Asked& asked) {
  const auto& triangles = in.triangle_keys;
  for (std::size_t i = 0; i < in.uses.all().size();) {
    const auto group = in.uses.group(i);
    i += group.size();
    if (!asked(group) || std::binary_search(triangles.begin(), triangles.end(), group[0].v)) continue;
    claim.fault(in.cross(group[0].v).norm(), model_region(in.mesh.tet_in[group[0].tet]),
                in.centroid(group[0].v), cause, kFiner);
  }
}

/// The pieces in which tetrahedra hang together by faces.
///
/// Where the faces are known to be pairs, the tetrahedra at a vertex off the surface fill all space around it
/// and so hang together by faces: such vertices stand for their tetrahedra, and only tetrahedra with all
/// vertices on the surface stand for themselves. Where nothing is known all do.
class Pieces {
 public:
  explicit Pieces(const ClaimInput& in) : in_(in), by_vertices_(in.sweep.proves_pairs()) {
    if (by_vertices_) {
      for (const std::uint32_t t : in.sweep.outer)
        if (inner_vertex(t) == nullptr) alone_.push_back(t);
    }
    parent_.resize(by_vertices_ ? in.mesh.points.size() + alone_.size() : in.mesh.tets.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    if (by_vertices_) join_by_vertices();
    for (std::size_t i = 0; i < in.uses.all().size();) {
      const auto group = in.uses.group(i);
      i += group.size();
      if (group.size() < 2 || in.mesh.tet_in[group[0].tet] != in.mesh.tet_in[group[1].tet]) continue;
      join(stand_in(group[0].tet), stand_in(group[1].tet));
    }
    met_.assign(parent_.size(), 0);
  }

  /// Whether no tetrahedron of this one's piece has been asked for before.
  [[nodiscard]] bool is_new(std::uint32_t tet) {
    return std::exchange(met_[root_of(parent_, stand_in(tet))], std::uint8_t{1}) == 0;
  }

 private:
  [[nodiscard]] const Mesh::Index* inner_vertex(std::uint32_t tet) const {
    const auto& t = in_.mesh.tets[tet];
    const auto at = std::find_if(t.begin(), t.end(), [&](auto v) { return in_.sweep.on_surface[v] == 0; });
    return at == t.end() ? nullptr : &*at;
  }
  [[nodiscard]] std::uint32_t stand_in(std::uint32_t tet) const {
    if (!by_vertices_) return tet;
    if (const Mesh::Index* v = inner_vertex(tet)) return *v;
    const auto at = std::lower_bound(alone_.begin(), alone_.end(), tet) - alone_.begin();
    return static_cast<std::uint32_t>(in_.mesh.points.size()) + static_cast<std::uint32_t>(at);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root_of(parent_, a);
    b = root_of(parent_, b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  void join_by_vertices() {
    for (const auto& t : in_.mesh.tets) {
      std::uint32_t first = UINT32_MAX;
      for (const Mesh::Index v : t) {
        if (in_.sweep.on_surface[v] != 0) continue;
        if (first == UINT32_MAX) first = v;
        if (parent_[v] != parent_[first]) join(first, v);
      }
    }
  }

  const ClaimInput& in_;
  bool by_vertices_;
  std::vector<std::uint32_t> alone_;  ///< tetrahedra that stand for themselves among vertices; ascending
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> met_;
};

/// Sorts by place, then by vertex: the places of a mesh's vertices fill their range.
void sort_along(std::vector<std::pair<double, Mesh::Index>>& places) {
  if (places.empty()) return;
  const auto [first, last] = std::minmax_element(places.begin(), places.end());
  const double start = first->first, width = last->first - start;
  const double share = width > 0.0 ? static_cast<double>(places.size() - 1) / width : 0.0;
  bucket_sort(
      places, places.size(),
      [&](const auto& place) {
        return std::min(places.size() - 1, static_cast<std::size_t>((place.first - start) * share));
      },
      std::less<>());
}

}  // namespace

Claim claim_numbers(const Mesh& mesh, const Model& model) {
  ClaimBuilder claim("numbers", "All indices and entity tags are in range, no element repeats a vertex.");
  if (mesh.points.size() != mesh.point_on.size())
    claim.fault(1.0, {}, Vec3::Zero(), "the vertex arrays differ in size", kBadMesh);
  for (std::size_t v = 0; v < std::min(mesh.points.size(), mesh.point_on.size()); ++v) {
    const ModelRef ref = mesh.point_on[v];
    if (mesh.points[v].allFinite() && ref.valid() && ref.dim <= 3 && ref.tag <= model.count(ref.dim))
      continue;
    claim.fault(1.0, ref, mesh.points[v], fmt::format("vertex {} lies on no entity of the part", v),
                kBadMesh);
  }
  check_numbers(claim, mesh, "edge", 1, model.count(1), mesh.edges, mesh.edge_on);
  check_numbers(claim, mesh, "triangle", 2, model.count(2), mesh.triangles, mesh.triangle_on);
  check_numbers(claim, mesh, "tetrahedron", 3, model.count(3), mesh.tets, mesh.tet_in);
  return claim.counted();
}

Claim claim_positive_volume(const ClaimInput& in) {
  ClaimBuilder claim("positive-volume",
                     "Every tetrahedron has positive volume (exact sign); worst: smallest.");
  for (const std::uint32_t i : in.sweep.not_positive) {
    const auto& t = in.mesh.tets[i];
    const int sign = orient3d(in.point(t[0]), in.point(t[1]), in.point(t[2]), in.point(t[3]));
    claim.fault(-in.volume(t), model_region(in.mesh.tet_in[i]), in.centroid(t),
                fmt::format("tetrahedron {} has {} volume", i, sign == 0 ? "zero" : "negative"), kFiner);
  }
  return claim.measured(in.sweep.smallest_volume, 0.0);
}

Claim claim_conforming(const ClaimInput& in) {
  ClaimBuilder claim("conforming", "No face has more than two tetrahedra, or both on one side.");
  for (std::size_t i = 0; i < in.uses.all().size();) {
    const auto group = in.uses.group(i);
    i += group.size();
    const bool one_side = group.size() == 2 && group[0].even == group[1].even;
    if (group.size() <= 2 && !one_side) continue;
    claim.fault(static_cast<double>(group.size()), model_region(in.mesh.tet_in[group[0].tet]),
                in.centroid(group[0].v),
                one_side ? "two tetrahedra lie on one side of a face"
                         : fmt::format("a face has {} tetrahedra", group.size()),
                kBadMesh);
  }
  return claim.counted();
}

Claim claim_boundary_classified(const ClaimInput& in) {
  ClaimBuilder claim("boundary-classified",
                     "Every face with one tetrahedron lies on a model face; no triangle is given twice.");
  report_unclassified(in, claim, "a face with one tetrahedron lies on no model face",
                      [](const auto& group) { return group.size() == 1; });
  const auto& triangles = in.triangle_keys;
  for (std::size_t i = 1; i < triangles.size(); ++i)
    if (triangles[i] == triangles[i - 1])
      claim.fault(1.0, {2, 0}, in.centroid(triangles[i]), "a triangle is given twice", kBadMesh);
  return claim.counted();
}

Claim claim_interfaces_classified(const ClaimInput& in) {
  ClaimBuilder claim("interfaces-classified", "Every face between two regions lies on a model face.");
  report_unclassified(in, claim, "a face between two regions lies on no model face", [&](const auto& group) {
    return group.size() == 2 && in.mesh.tet_in[group[0].tet] != in.mesh.tet_in[group[1].tet];
  });
  return claim.counted();
}

Claim claim_regions_connected(const ClaimInput& in) {
  ClaimBuilder claim("regions-connected", "Every region's tetrahedra hang together by faces.");
  Pieces pieces(in);
  std::vector<int> seen(static_cast<std::size_t>(in.model.count(3)) + 1, 0);
  for (std::uint32_t i = 0; i < in.mesh.tets.size(); ++i) {
    const std::int32_t region = in.mesh.tet_in[i];
    if (!pieces.is_new(i) || ++seen[region] == 1) continue;
    claim.fault(1.0, model_region(region), in.centroid(in.mesh.tets[i]),
                fmt::format("piece {} of the region touches the others by no face", seen[region]), kFiner);
  }
  for (int region = 1; region <= in.model.count(3); ++region)
    if (seen[region] == 0)
      claim.fault(2.0, model_region(region), in.model.box().centre(), "the region has no tetrahedron",
                  kFiner);
  return claim.counted();
}

Claim claim_orphan_nodes(const ClaimInput& in) {
  ClaimBuilder claim("orphan-nodes",
                     "Every vertex is used by an element, those on a model entity by one on that entity.");
  // Whether an element has the vertex, and whether one on the vertex's own entity has.
  std::vector<std::uint8_t> used = in.sweep.in_own, on_own = in.sweep.in_own;
  const auto mark = [&](const auto& element, ModelRef on) {
    for (const Mesh::Index v : element) {
      used[v] = 1;
      if (in.mesh.point_on[v] == on) on_own[v] = 1;
    }
  };
  const Mesh& mesh = in.mesh;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) mark(mesh.edges[i], model_edge(mesh.edge_on[i]));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    mark(mesh.triangles[i], model_face(mesh.triangle_on[i]));
  for (const std::uint32_t i : in.sweep.outer) mark(mesh.tets[i], model_region(mesh.tet_in[i]));
  for (Mesh::Index v = 0; v < used.size(); ++v) {
    const ModelRef ref = in.mesh.point_on[v];
    // What lies on a seam or on a vertex needs no element of that entity.
    const bool own_asked = ref.dim >= 2 || (ref.dim == 1 && in.model.edge(ref.tag).use == EdgeUse::kReal);
    if (used[v] == 0) {
      claim.fault(2.0, ref, in.point(v), fmt::format("vertex {} belongs to no element", v), kBadMesh);
    } else if (own_asked && on_own[v] == 0) {
      claim.fault(1.0, ref, in.point(v), fmt::format("vertex {} belongs to no element of its entity", v),
                  kFiner);
    }
  }
  return claim.counted();
}

// Sorted along a direction in which no lattice of points has many at one place, so that only a few vertices
// come within the tolerance of each other.
Claim claim_duplicate_nodes(const ClaimInput& in) {
  ClaimBuilder claim("duplicate-nodes", "No two vertices are at one place.");
  const Vec3 direction(0.5773502691896258, 0.6180339887498949, 0.5348);
  const double tolerance = in.model.tolerance();
  std::vector<std::pair<double, Mesh::Index>> along;
  along.reserve(in.mesh.points.size());
  for (Mesh::Index v = 0; v < in.mesh.points.size(); ++v) along.emplace_back(direction.dot(in.point(v)), v);
  sort_along(along);
  for (std::size_t i = 0; i < along.size(); ++i)
    for (std::size_t j = i + 1; j < along.size() && along[j].first <= along[i].first + tolerance; ++j) {
      const Mesh::Index a = along[i].second, b = along[j].second;
      if ((in.point(a) - in.point(b)).norm() > tolerance) continue;
      claim.fault(1.0, in.mesh.point_on[a], in.point(a),
                  fmt::format("vertices {} and {} are at one place", std::min(a, b), std::max(a, b)),
                  kBadMesh);
    }
  return claim.counted();
}

}  // namespace octet
