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
  auto& [block, free_slots, epoch, last, cavity, created, base, rim] = inserter;
  created.clear();
  base.clear();
  rim.begin(3 * most_replacements(cavity));

  // Each boundary facet gets a tetrahedron: the inner one with its opposite vertex replaced by v, which keeps
  // the orientation. Those on two sides of an edge find each other by it.
  for (const TetId t : cavity) {
    for (std::int8_t i = 0; i < 4; ++i) {
      const TetId outer = mesh.neighbours[t][i];
      if (complex.mark[outer] == cavity_mark) continue;
      const TetId fresh = free_slots.back();
      free_slots.pop_back();
      auto vertices = mesh.tets[t];
      vertices[i] = v;
      mesh.tets[fresh] = vertices;
      mesh.neighbours[fresh][i] = outer;
      mesh.neighbours[outer][face_beyond(complex, outer, t, i)] = fresh;
      const auto& f = kTetFace[i];
      for (int k = 0; k < 3; ++k) rim.put(vertices[f[k]], vertices[f[(k + 1) % 3]], fresh);
      created.push_back(fresh);
      base.push_back(i);
    }
  }
  for (std::size_t n = 0; n < created.size(); ++n) {
    const TetId fresh = created[n];
    const auto& vertices = mesh.tets[fresh];
    const auto& f = kTetFace[base[n]];
    for (int k = 0; k < 3; ++k)
      mesh.neighbours[fresh][f[(k + 2) % 3]] = rim.at(vertices[f[(k + 1) % 3]], vertices[f[k]]);
    for (const VertexId w : vertices) {
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
