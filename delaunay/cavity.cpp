// SPDX-License-Identifier: BSD-3-Clause
// Conflict search and refilling of cavities.
#include "delaunay/cavity.h"

#include "base/predicates.h"
#include "delaunay/visit_set.h"

namespace octet {
namespace {

constexpr std::uint32_t kLastEpoch = 0x7ffffffe;  // marks are twice the epoch, plus one

bool in_sphere(const Complex& complex, TetId t, const Vec3& point, std::uint64_t rank) {
  const auto& v = complex.mesh.tets[t];
  const std::uint64_t ranks[5] = {complex.rank[v[0]], complex.rank[v[1]], complex.rank[v[2]],
                                  complex.rank[v[3]], rank};
  // Half the questions are about octree vertices alone, and most of those are ties.
  if (const int sign = insphere_on_lattice(ranks); sign != 0) return sign > 0;
  const Vec3 &a = complex.point(v[0]), &b = complex.point(v[1]), &c = complex.point(v[2]),
             &d = complex.point(v[3]);
  return insphere_ranked(a, b, c, d, point, ranks) > 0;
}

// Breadth-first search over conflicting tetrahedra. `first_visit(t)` is asked once per meeting and tells
// whether t is met for the first time; `keep(t)` is called for each that conflicts.
template <class FirstVisit, class Keep>
void search_conflicts(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                      std::vector<TetId>& cavity, FirstVisit&& first_visit, Keep&& keep) {
  cavity.clear();
  first_visit(seed);
  keep(seed);
  cavity.push_back(seed);
  for (std::size_t k = 0; k < cavity.size(); ++k) {
    const auto around = complex.mesh.neighbours[cavity[k]];
    for (const TetId n : around) {
      if (!first_visit(n) || !in_conflict(complex, n, point, rank)) continue;
      keep(n);
      cavity.push_back(n);
    }
  }
}

// One facet of the cavity's boundary: face `face` of the cavity's tetrahedron `inner`.
struct Facet {
  TetId inner;
  int face;
};

// The boundary facet next to `start` around the edge that faces start.face and `across` of start.inner share,
// found by turning around that edge through the cavity; and the index, in the new tetrahedron on that facet,
// of the face that holds the edge and the new vertex.
struct Turn {
  TetId fresh;
  int face;
};
Turn turn_around_edge(const Complex& complex, const Facet& start, int across, std::uint32_t cavity_mark) {
  TetId t = start.inner;
  int pivot = start.face;
  for (;;) {
    const TetId n = complex.mesh.neighbours[t][across];
    if (complex.mark[n] != cavity_mark) return {n, pivot};
    const VertexId opposite = complex.mesh.tets[t][pivot];
    pivot = complex.face_towards(n, t);
    across = complex.index_of(n, opposite);
    t = n;
  }
}

}  // namespace

bool in_conflict(const Complex& complex, TetId t, const Vec3& point, std::uint64_t rank) {
  if (!complex.ghost(t)) return in_sphere(complex, t, point, rank);
  const auto& v = complex.mesh.tets[t];
  const int side = orient3d(complex.point(v[0]), complex.point(v[1]), complex.point(v[2]), point);
  if (side != 0) return side > 0;
  return in_sphere(complex, complex.mesh.neighbours[t][3], point, rank);
}

void mark_cavity(Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity) {
  if (++complex.epoch > kLastEpoch) {
    complex.mark.assign(complex.mark.size(), 0);
    complex.epoch = 1;
  }
  const std::uint32_t tested = 2 * complex.epoch, conflicting = tested + 1;
  search_conflicts(
      complex, seed, point, rank, cavity,
      [&](TetId t) {
        if (complex.mark[t] >= tested) return false;
        complex.mark[t] = tested;
        return true;
      },
      [&](TetId t) { complex.mark[t] = conflicting; });
}

void find_cavity(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity) {
  VisitSet met;
  search_conflicts(
      complex, seed, point, rank, cavity, [&](TetId t) { return met.insert(t); }, [](TetId) {});
}

void replace_cavity(Complex& complex, VertexId v, const std::vector<TetId>& cavity,
                    std::vector<TetId>& created) {
  TetMesh& mesh = complex.mesh;
  const std::uint32_t cavity_mark = 2 * complex.epoch + 1;
  created.clear();
  std::vector<Facet> facets;
  facets.reserve(4 * cavity.size());

  // Each boundary facet gets a tetrahedron: the inner one with its opposite vertex replaced by v, which keeps
  // the orientation. The inner one then points to the new one.
  for (const TetId t : cavity) {
    for (int i = 0; i < 4; ++i) {
      const TetId outer = mesh.neighbours[t][i];
      if (complex.mark[outer] == cavity_mark) continue;
      auto vertices = mesh.tets[t];
      vertices[i] = v;
      const TetId fresh = complex.add_tet(vertices);
      mesh.neighbours[fresh][i] = outer;
      mesh.neighbours[outer][complex.face_towards(outer, t)] = fresh;
      mesh.neighbours[t][i] = fresh;
      facets.push_back({t, i});
      created.push_back(fresh);
    }
  }
  for (std::size_t k = 0; k < facets.size(); ++k) {
    const TetId fresh = created[k];
    for (int j = 0; j < 4; ++j) {
      if (mesh.neighbours[fresh][j].valid()) continue;
      const Turn other = turn_around_edge(complex, facets[k], j, cavity_mark);
      mesh.neighbours[fresh][j] = other.fresh;
      mesh.neighbours[other.fresh][other.face] = fresh;
    }
    for (const VertexId w : mesh.tets[fresh]) {
      if (w != kGhostVertex) complex.vertex_tet[w] = fresh;
    }
  }
  for (const TetId t : cavity) complex.remove_tet(t);
  complex.last = created.back();
}

}  // namespace octet
