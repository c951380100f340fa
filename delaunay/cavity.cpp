// SPDX-License-Identifier: BSD-3-Clause
// Conflict search and refilling of cavities.
#include "delaunay/cavity.h"

#include "base/predicates.h"
#include "delaunay/visit_set.h"

namespace octet {
namespace {

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
// whether t is met for the first time; `keep(t)` is called for each that conflicts, and ends the search when
// it returns false.
template <class FirstVisit, class Keep>
bool search_conflicts(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                      std::vector<TetId>& cavity, FirstVisit&& first_visit, Keep&& keep) {
  cavity.clear();
  first_visit(seed);
  if (!keep(seed)) return false;
  cavity.push_back(seed);
  for (std::size_t k = 0; k < cavity.size(); ++k) {
    const auto around = complex.mesh.neighbours[cavity[k]];
    for (const TetId n : around) {
      if (!first_visit(n) || !in_conflict(complex, n, point, rank)) continue;
      if (!keep(n)) return false;
      cavity.push_back(n);
    }
  }
  return true;
}

// The face of `outer` that it shares with face `face` of `inner`, by its vertices: `outer` may be on the rim
// of another inserter's block, which writes neighbours of its own there.
int face_beyond(const Complex& complex, TetId outer, TetId inner, int face) {
  const auto &v = complex.mesh.tets[outer], &w = complex.mesh.tets[inner];
  const auto all = [](const std::array<VertexId, 4>& q) {
    return q[0].index() ^ q[1].index() ^ q[2].index() ^ q[3].index();
  };
  return complex.index_of(outer, VertexId(all(v) ^ all(w) ^ w[face].index()));
}

// Index of `n` among the neighbours of t; requires that it is one.
int face_towards(const Complex& complex, TetId t, TetId n) {
  const auto& around = complex.mesh.neighbours[t];
  return around[0] == n ? 0 : around[1] == n ? 1 : around[2] == n ? 2 : 3;
}

// The boundary facet next to `start` around the edge that faces start.face and `across` of start.inner share,
// found by turning around that edge through the cavity; and the index, in the new tetrahedron on that facet,
// of the face that holds the edge and the new vertex.
struct Turn {
  TetId fresh;
  int face;
};
Turn turn_around_edge(const Complex& complex, const CavityFace& start, int across,
                      std::uint32_t cavity_mark) {
  TetId t = start.inner;
  int pivot = start.face;
  for (;;) {
    const TetId n = complex.mesh.neighbours[t][across];
    if (complex.mark[n] != cavity_mark) return {n, pivot};
    const VertexId opposite = complex.mesh.tets[t][pivot];
    pivot = face_towards(complex, n, t);
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

bool mark_cavity(Complex& complex, Inserter& inserter, TetId seed, const Vec3& point, std::uint64_t rank) {
  const std::uint32_t tested = 2 * ++inserter.epoch, conflicting = tested + 1;
  const Block& block = inserter.block;
  return search_conflicts(
      complex, seed, point, rank, inserter.cavity,
      [&](TetId t) {
        if (!block.holds(complex.mesh.tets[t])) return true;  // not ours to mark
        if (complex.mark[t] >= tested) return false;
        complex.mark[t] = tested;
        return true;
      },
      [&](TetId t) {
        if (!block.holds(complex.mesh.tets[t])) return false;
        complex.mark[t] = conflicting;
        return true;
      });
}

void find_cavity(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity) {
  VisitSet met;
  search_conflicts(
      complex, seed, point, rank, cavity, [&](TetId t) { return met.insert(t); }, [](TetId) { return true; });
}

void replace_cavity(Complex& complex, Inserter& inserter, VertexId v) {
  TetMesh& mesh = complex.mesh;
  const std::uint32_t cavity_mark = 2 * inserter.epoch + 1;
  auto& [block, free_slots, epoch, last, cavity, created, boundary] = inserter;
  created.clear();
  boundary.clear();

  // Each boundary facet gets a tetrahedron: the inner one with its opposite vertex replaced by v, which keeps
  // the orientation. The inner one then points to the new one.
  for (const TetId t : cavity) {
    for (int i = 0; i < 4; ++i) {
      const TetId outer = mesh.neighbours[t][i];
      if (complex.mark[outer] == cavity_mark) continue;
      const TetId fresh = free_slots.back();
      free_slots.pop_back();
      auto vertices = mesh.tets[t];
      vertices[i] = v;
      mesh.tets[fresh] = vertices;
      mesh.neighbours[fresh] = {};
      mesh.neighbours[fresh][i] = outer;
      mesh.neighbours[outer][face_beyond(complex, outer, t, i)] = fresh;
      mesh.neighbours[t][i] = fresh;
      boundary.push_back({t, i});
      created.push_back(fresh);
    }
  }
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const TetId fresh = created[k];
    for (int j = 0; j < 4; ++j) {
      if (mesh.neighbours[fresh][j].valid()) continue;
      const Turn other = turn_around_edge(complex, boundary[k], j, cavity_mark);
      mesh.neighbours[fresh][j] = other.fresh;
      mesh.neighbours[other.fresh][other.face] = fresh;
    }
    for (const VertexId w : mesh.tets[fresh]) {
      if (w != kGhostVertex) complex.vertex_tet[w] = fresh;
    }
  }
  for (const TetId t : cavity) {
    mesh.tets[t][0] = VertexId();
    complex.mark[t] = 0;
    free_slots.push_back(t);
  }
  last = created.back();
}

}  // namespace octet
