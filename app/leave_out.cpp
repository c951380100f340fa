// SPDX-License-Identifier: BSD-3-Clause
// Which regions the gaps touch, and the mesh without them.
#include "app/leave_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mesh/sort_triple.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

bool has(const std::vector<int>& sorted, int value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

void add_regions_of_face(const Model& model, int face, std::set<int>& regions) {
  for (const int r : model.face(face).region)
    if (r != 0) regions.insert(r);
}

std::set<int> regions_at(const Attempt& attempt, const Model& model, const Gap& gap) {
  std::set<int> regions;
  if (gap.tet.valid()) {
    const TetId other = attempt.triangulation.mesh().neighbours[gap.tet][gap.local];
    for (const int r : {attempt.band->region(gap.tet), attempt.band->region(other)})
      if (r != 0) regions.insert(r);
  }
  if (gap.entity.dim == 2) add_regions_of_face(model, gap.entity.tag, regions);
  if (gap.entity.dim == 1)
    for (const int f : model.edge(gap.entity.tag).faces) add_regions_of_face(model, f, regions);
  return regions;
}

bool bounds_a_sound_region(const Model& model, int edge, const std::vector<int>& broken) {
  const std::vector<int>& faces = model.edge(edge).faces;
  return std::any_of(faces.begin(), faces.end(), [&](int f) {
    const auto& region = model.face(f).region;
    return std::any_of(region.begin(), region.end(), [&](int r) { return r != 0 && !has(broken, r); });
  });
}

std::array<Mesh::Index, 3> sorted(std::array<Mesh::Index, 3> v) {
  static_cast<void>(sort_triple(v));
  return v;
}

std::array<Mesh::Index, 2> sorted(std::array<Mesh::Index, 2> v) {
  if (v[1] < v[0]) std::swap(v[0], v[1]);
  return v;
}

/// Edges of tetrahedra that may lie on model edges, ascending.
std::vector<std::array<Mesh::Index, 2>> edges_along_model_edges(const Mesh& mesh) {
  std::vector<std::array<Mesh::Index, 2>> pairs;
  for (const auto& t : mesh.tets)
    for (const auto& e : kTetEdge) {
      const std::array<Mesh::Index, 2> v{t[e[0]], t[e[1]]};
      if (mesh.point_on[v[0]].dim <= 1 && mesh.point_on[v[1]].dim <= 1) pairs.push_back(sorted(v));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Keeps the elements for which keep(i) holds, with what lies beside them.
template <class Element, class Keep>
void filter(std::vector<Element>& elements, std::vector<std::int32_t>& beside, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (!keep(i)) continue;
    elements[kept] = elements[i];
    beside[kept++] = beside[i];
  }
  elements.resize(kept);
  beside.resize(kept);
}

template <class Elements>
void renumber(Elements& elements, const std::vector<Mesh::Index>& number) {
  for (auto& element : elements)
    for (Mesh::Index& v : element) v = number[v];
}

}  // namespace

std::vector<int> broken_regions(const Attempt& attempt, const Model& model) {
  std::set<int> broken;
  for (const Gap& gap : attempt.closed.gaps) broken.merge(regions_at(attempt, model, gap));
  if (broken.size() == static_cast<std::size_t>(model.count(3))) return {};
  return {broken.begin(), broken.end()};
}

void leave_out_octants(Attempt& attempt, const std::vector<int>& broken) {
  for (std::size_t o = 0; o < attempt.tree.size(); ++o)
    if (attempt.labels.type[o] == OctantType::kIn && has(broken, attempt.labels.region[o]))
      attempt.split.role[o] = OctantRole::kBand;
}

void leave_out(Mesh& mesh, const Model& model, const std::vector<int>& broken) {
  filter(mesh.tets, mesh.tet_in, [&](std::size_t i) { return !has(broken, mesh.tet_in[i]); });
  std::vector<std::array<Mesh::Index, 3>> faces;
  faces.reserve(4 * mesh.tets.size());
  for (const auto& t : mesh.tets)
    for (int skipped = 0; skipped < 4; ++skipped)
      faces.push_back(sorted({t[(skipped + 1) % 4], t[(skipped + 2) % 4], t[(skipped + 3) % 4]}));
  std::sort(faces.begin(), faces.end());
  filter(mesh.triangles, mesh.triangle_on, [&](std::size_t i) {
    return std::binary_search(faces.begin(), faces.end(), sorted(mesh.triangles[i]));
  });
  std::vector<Mesh::Index> number(mesh.points.size(), 0);
  for (const auto& t : mesh.tets)
    for (const Mesh::Index v : t) number[v] = 1;
  const auto pairs = edges_along_model_edges(mesh);
  filter(mesh.edges, mesh.edge_on, [&](std::size_t i) {
    return std::binary_search(pairs.begin(), pairs.end(), sorted(mesh.edges[i])) &&
           bounds_a_sound_region(model, mesh.edge_on[i], broken);
  });
  Mesh::Index kept = 0;
  for (Mesh::Index v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    mesh.points[kept] = mesh.points[v];
    mesh.point_on[kept] = mesh.point_on[v];
    number[v] = kept++;
  }
  mesh.points.resize(kept);
  mesh.point_on.resize(kept);
  renumber(mesh.tets, number);
  renumber(mesh.triangles, number);
  renumber(mesh.edges, number);
}

std::vector<Fault> describe_left_out(const Attempt& attempt, const Model& model,
                                     const std::vector<int>& broken) {
  std::vector<Fault> faults;
  for (const int r : broken) {
    std::size_t holes = 0;
    Fault fault;
    for (const Gap& gap : attempt.closed.gaps) {
      if (regions_at(attempt, model, gap).count(r) == 0) continue;
      if (holes++ == 0) fault.place = gap.place;
    }
    fault.entity = model_region(r);
    fault.cause =
        fmt::format("{} is left out: {} holes in its boundary could not be closed, the first is here",
                    model.describe(fault.entity), holes);
    fault.advice = "repair the faces named, or ask for a smaller size here";
    faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace octet
