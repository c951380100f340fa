// SPDX-License-Identifier: BSD-3-Clause
// Incremental insertion: first tetrahedron, then point by point.
#include "delaunay/triangulation.h"

#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/predicates.h"
#include "delaunay/cavity.h"
#include "delaunay/complex.h"
#include "delaunay/locate.h"
#include "delaunay/spatial_order.h"
#include "delaunay/visit_set.h"

namespace octet {
namespace {

// Collinear points are coplanar with every fourth point, so with three that span space with `a`.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int k = 0; k < 3; ++k) {
    Vec3 q = a;
    q[k] = q[k] == 0 ? 1.0 : -q[k];
    if (orient3d(a, b, c, q) != 0) return false;
  }
  return true;
}

// The first four points in the order that span space, as a positive tetrahedron.
std::array<std::uint32_t, 4> first_four(std::span<const Vec3> points, std::span<const std::uint32_t> order) {
  std::array<std::uint32_t, 4> chosen{};
  int count = 0;
  for (const std::uint32_t i : order) {
    const auto p = [&](int k) -> const Vec3& { return points[chosen[k]]; };
    const Vec3& q = points[i];
    const bool independent = count == 0 || (count == 1 && q != p(0)) ||
                             (count == 2 && !collinear(p(0), p(1), q)) ||
                             (count == 3 && orient3d(p(0), p(1), p(2), q) != 0);
    if (!independent) continue;
    chosen[count++] = i;
    if (count < 4) continue;
    if (orient3d(p(0), p(1), p(2), p(3)) < 0) std::swap(chosen[0], chosen[1]);
    return chosen;
  }
  throw InputError("the points to be triangulated all lie in one plane");
}

// A finite tetrahedron and the four ghosts on its faces.
void make_first_tets(Complex& complex, const std::array<VertexId, 4>& v) {
  TetMesh& mesh = complex.mesh;
  const TetId first = complex.add_tet(v);
  std::array<TetId, 4> ghosts;
  for (int f = 0; f < 4; ++f) {
    ghosts[f] = complex.add_tet({v[kTetFace[f][0]], v[kTetFace[f][1]], v[kTetFace[f][2]], kGhostVertex});
    mesh.neighbours[first][f] = ghosts[f];
    complex.vertex_tet[v[f]] = first;
  }
  for (int f = 0; f < 4; ++f) {
    for (int i = 0; i < 3; ++i) mesh.neighbours[ghosts[f]][i] = ghosts[kTetFace[f][i]];
    mesh.neighbours[ghosts[f]][3] = first;
  }
  complex.last = first;
}

// The vertex of t at exactly this place, or an invalid one.
VertexId vertex_at(const Complex& complex, TetId t, const Vec3& point) {
  for (const VertexId v : complex.mesh.tets[t]) {
    if (v != kGhostVertex && complex.point(v) == point) return v;
  }
  return {};
}

}  // namespace

struct Triangulation::Data : Complex {
  std::vector<TetId> cavity;   // reused between insertions
  std::vector<TetId> created;  // for insert_all

  // Joins the vertex to the triangulation unless another is at its place; returns the one that is there.
  VertexId join(VertexId v, TetId near, std::vector<TetId>& made) {
    const Vec3 p = point(v);
    const TetId seed = walk_to(*this, p, near);
    const VertexId present = vertex_at(*this, seed, p);
    if (present.valid()) return present;
    mark_cavity(*this, seed, p, rank[v], cavity);
    replace_cavity(*this, v, cavity, made);
    return v;
  }
};

Triangulation::Triangulation() : data_(std::make_unique<Data>()) {}
Triangulation::~Triangulation() = default;
Triangulation::Triangulation(Triangulation&&) noexcept = default;
Triangulation& Triangulation::operator=(Triangulation&&) noexcept = default;

void Triangulation::insert_all(std::span<const Vec3> points, std::span<const std::uint64_t> ranks) {
  OCTET_CHECK(points.size() == ranks.size());
  Data& d = *data_;
  const std::size_t base = d.mesh.points.size();
  const std::vector<std::uint32_t> order = spatial_order(points);
  std::array<std::uint32_t, 4> first{};
  const bool begin = !d.last.valid();
  if (begin) {
    OCTET_CHECK(base == 0);
    first = first_four(points, order);
    d.mesh.tets.reserve(7 * points.size());
    d.mesh.neighbours.reserve(7 * points.size());
    d.mark.reserve(7 * points.size());
  }
  d.mesh.points.reserve(base + points.size());
  for (std::size_t i = 0; i < points.size(); ++i) d.add_vertex(points[i], ranks[i]);
  if (begin)
    make_first_tets(d, {VertexId(first[0]), VertexId(first[1]), VertexId(first[2]), VertexId(first[3])});
  for (const std::uint32_t i : order) {
    if (begin && (i == first[0] || i == first[1] || i == first[2] || i == first[3])) continue;
    d.join(VertexId(base + i), d.last, d.created);
  }
}

VertexId Triangulation::insert(const Vec3& point, std::uint64_t rank, TetId near,
                               std::vector<TetId>& created) {
  Data& d = *data_;
  created.clear();
  const TetId seed = walk_to(d, point, near);
  const VertexId present = vertex_at(d, seed, point);
  if (present.valid()) return present;
  const VertexId v = d.add_vertex(point, rank);
  mark_cavity(d, seed, point, rank, d.cavity);
  replace_cavity(d, v, d.cavity, created);
  return v;
}

void Triangulation::conflicts(const Vec3& point, std::uint64_t rank, TetId near,
                              std::vector<TetId>& tets) const {
  tets.clear();
  const TetId seed = walk_to(*data_, point, near);
  if (vertex_at(*data_, seed, point).valid()) return;
  find_cavity(*data_, seed, point, rank, tets);
}

TetId Triangulation::locate(const Vec3& point, TetId near) const { return walk_to(*data_, point, near); }

const TetMesh& Triangulation::mesh() const { return data_->mesh; }
std::uint64_t Triangulation::rank(VertexId v) const { return data_->rank[v]; }
TetId Triangulation::tet_at(VertexId v) const { return data_->vertex_tet[v]; }

void Triangulation::star(VertexId v, std::vector<TetId>& tets) const {
  tets.clear();
  const TetId first = tet_at(v);
  if (!first.valid()) return;
  VisitSet met;
  met.insert(first);
  tets.push_back(first);
  for (std::size_t k = 0; k < tets.size(); ++k) {
    const TetId t = tets[k];
    const auto& vertices = data_->mesh.tets[t];
    for (int f = 0; f < 4; ++f) {
      const TetId n = data_->mesh.neighbours[t][f];
      if (vertices[f] != v && met.insert(n)) tets.push_back(n);
    }
  }
}

}  // namespace octet
