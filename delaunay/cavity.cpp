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
  const Vec3 &a = complex.point(v[0]), &b = complex.point(v[1]), &c = complex.point(v[2]),
             &d = complex.point(v[3]);
  if (const int sign = insphere_filtered(a, b, c, d, point); sign != 0) return sign > 0;
  if (const int sign = insphere_on_lattice(ranks); sign != 0) return sign > 0;
  return insphere_ranked_exactly(a, b, c, d, point, ranks) > 0;
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
  const TetMesh& mesh = complex.mesh;
  auto& cavity = inserter.cavity;
  cavity.clear();
  inserter.faces.clear();
  if (!inserter.block.holds(mesh.tets[seed])) return false;
  complex.mark[seed] = conflicting;
  cavity.push_back(seed);
  for (std::size_t k = 0; k < cavity.size(); ++k) {
    const TetId t = cavity[k];
    const auto around = mesh.neighbours[t];
    for (std::int8_t f = 0; f < 4; ++f) {
      const TetId n = around[f];
      const bool ours = inserter.block.holds(mesh.tets[n]);  // to mark
      if (ours && complex.mark[n] == conflicting) continue;
      if (!(ours && complex.mark[n] == tested) && in_conflict(complex, n, point, rank)) {
        if (!ours) return false;
        complex.mark[n] = conflicting;
        cavity.push_back(n);
        continue;
      }
      if (ours) complex.mark[n] = tested;
      inserter.faces.push_back({t, n, f});
    }
  }
  return true;
}

void find_cavity(const Complex& complex, TetId seed, const Vec3& point, std::uint64_t rank,
                 std::vector<TetId>& cavity) {
  VisitSet met;
  met.insert(seed);
  cavity.assign(1, seed);
  for (std::size_t k = 0; k < cavity.size(); ++k) {
    const auto around = complex.mesh.neighbours[cavity[k]];
    for (const TetId n : around)
      if (met.insert(n) && in_conflict(complex, n, point, rank)) cavity.push_back(n);
  }
}

void replace_cavity(Complex& complex, Inserter& inserter, VertexId v) {
  TetMesh& mesh = complex.mesh;
  auto& [block, free_slots, epoch, last, cavity, created, faces, rim] = inserter;
  created.clear();
  rim.begin(3 * faces.size() / 2);

  // Each face around the cavity gets a tetrahedron: the inner one with its opposite vertex replaced by v,
  // which keeps the orientation. Those on two sides of an edge find each other by it: until all are put in,
  // its place in the table stands for the neighbour.
  for (const auto& [inner, outer, i] : faces) {
    const TetId fresh = free_slots.back();
    free_slots.pop_back();
    auto& vertices = mesh.tets[fresh];
    vertices = mesh.tets[inner];
    vertices[i] = v;
    mesh.neighbours[outer][face_beyond(complex, outer, inner, i)] = fresh;
    auto& around = mesh.neighbours[fresh];
    around[i] = outer;
    const auto& [p, q, r] = kTetFace[i];
    around[p] = TetId(rim.put(vertices[q], vertices[r], fresh));
    around[q] = TetId(rim.put(vertices[r], vertices[p], fresh));
    around[r] = TetId(rim.put(vertices[p], vertices[q], fresh));
    for (const VertexId w : vertices) {
      if (w != kGhostVertex) complex.vertex_tet[w] = fresh;
    }
    created.push_back(fresh);
  }
  for (std::size_t n = 0; n < created.size(); ++n) {
    auto& around = mesh.neighbours[created[n]];
    for (const int f : kTetFace[faces[n].face]) around[f] = rim.beyond(around[f].index(), created[n]);
  }
  for (const TetId t : cavity) {
    mesh.tets[t][0] = VertexId();
    complex.mark[t] = 0;
    free_slots.push_back(t);
  }
  last = created.back();
}

}  // namespace octet
