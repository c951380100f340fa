// SPDX-License-Identifier: BSD-3-Clause
// Incremental insertion: first tetrahedron, then point by point.
#include "delaunay/triangulation.h"

#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/predicates.h"
#include "delaunay/cavity.h"
#include "delaunay/complex.h"
#include "delaunay/insertion.h"
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

// A finite tetrahedron and the four ghosts on its faces, in the first five slots.
void make_first_tets(Complex& complex, const std::array<VertexId, 4>& v) {
  TetMesh& mesh = complex.mesh;
  complex.add_slots(5);
  const TetId first(0);
  const std::array<TetId, 4> ghosts{TetId(1), TetId(2), TetId(3), TetId(4)};
  mesh.tets[first] = v;
  for (int f = 0; f < 4; ++f) {
    mesh.tets[ghosts[f]] = {v[kTetFace[f][0]], v[kTetFace[f][1]], v[kTetFace[f][2]], kGhostVertex};
    mesh.neighbours[first][f] = ghosts[f];
    complex.vertex_tet[v[f]] = first;
  }
  for (int f = 0; f < 4; ++f) {
    for (int i = 0; i < 3; ++i) mesh.neighbours[ghosts[f]][i] = ghosts[kTetFace[f][i]];
    mesh.neighbours[ghosts[f]][3] = first;
  }
}

// The vertex of t at exactly this place, or an invalid one.
VertexId vertex_at(const Complex& complex, TetId t, const Vec3& point) {
  for (const VertexId v : complex.mesh.tets[t]) {
    if (v != kGhostVertex && complex.point(v) == point) return v;
  }
  return {};
}

// Inserts the points of one round. Large rounds go in blocks, then in blocks with other bounds what reached
// beyond these, and at last what is left by then, some per cent.
void insert_round(Complex& complex, Inserter& inserter, const SpatialOrder& order, std::size_t round,
                  std::vector<std::uint8_t>& pending, const Question& question) {
  constexpr std::array<double, 3> kShifts{0.0, 0.28125, 0.6};
  const std::span<const std::uint32_t> so_far = std::span(order.points).first(order.round_end[round]);
  const std::size_t begin = round == 0 ? 0 : order.round_end[round - 1];
  if (so_far.size() < 2 * kBlockVertices) {
    insert_pending(complex, inserter, so_far.subspan(begin), pending, question);
    return;
  }
  std::vector<std::uint32_t> curve;
  for (const double shift : kShifts) {
    curve = shift == 0.0 ? order.along_curve_until(round)
                         : along_curve(complex.mesh.points.values(), so_far, shift);
    insert_in_blocks(complex, inserter, curve, pending, question);
  }
  insert_pending(complex, inserter, curve, pending, question);
}

}  // namespace

struct Triangulation::Data : Complex {
  Inserter inserter;

  // `near` where that is alive, else the tetrahedron made last.
  [[nodiscard]] TetId start(TetId near) const {
    const bool usable = near.valid() && near.index() < mesh.tets.size() && mesh.alive(near);
    return usable ? near : inserter.last;
  }
};

Triangulation::Triangulation() : data_(std::make_unique<Data>()) {}
Triangulation::~Triangulation() = default;
Triangulation::Triangulation(Triangulation&&) noexcept = default;
Triangulation& Triangulation::operator=(Triangulation&&) noexcept = default;

void Triangulation::insert_all(std::span<const Vec3> points, std::span<const std::uint64_t> ranks,
                               const std::function<bool()>& cancelled) {
  OCTET_CHECK(points.size() == ranks.size());
  const Question question(cancelled);
  Data& d = *data_;
  const std::size_t base = d.mesh.points.size();
  SpatialOrder order = spatial_order(points, ranks);
  constexpr std::size_t kLaterShare = 16;  // room for so many of all to come one by one
  d.reserve_vertices(base + points.size() + points.size() / kLaterShare);
  for (std::size_t i = 0; i < points.size(); ++i) d.add_vertex(points[i], ranks[i]);
  std::vector<std::uint8_t> pending(base + points.size(), 1);
  if (base > 0) {
    for (std::uint32_t& i : order.points) i += static_cast<std::uint32_t>(base);
    insert_pending(d, d.inserter, order.points, pending, question);
    return;
  }
  const std::array<std::uint32_t, 4> first = first_four(points, order.points);
  for (const std::uint32_t i : first) pending[i] = 0;
  d.reserve_slots(kSlotsPerVertex * points.size());
  make_first_tets(d, {VertexId(first[0]), VertexId(first[1]), VertexId(first[2]), VertexId(first[3])});
  d.inserter.last = TetId(0);
  for (std::size_t r = 0; r < order.round_end.size(); ++r)
    insert_round(d, d.inserter, order, r, pending, question);
}

VertexId Triangulation::insert(const Vec3& point, std::uint64_t rank, TetId near,
                               std::vector<TetId>& created) {
  Data& d = *data_;
  created.clear();
  const TetId seed = locate(point, near);
  const VertexId present = vertex_at(d, seed, point);
  if (present.valid()) return present;
  const VertexId v = d.add_vertex(point, rank);
  d.inserter.last = seed;
  OCTET_CHECK(join_vertex(d, d.inserter, v) == Insertion::kDone);
  created = d.inserter.created;
  return v;
}

void Triangulation::conflicts(const Vec3& point, std::uint64_t rank, TetId near,
                              std::vector<TetId>& tets) const {
  tets.clear();
  const TetId seed = locate(point, near);
  if (vertex_at(*data_, seed, point).valid()) return;
  find_cavity(*data_, seed, point, rank, tets);
}

TetId Triangulation::locate(const Vec3& point, TetId near) const {
  return walk_to(*data_, Block(), point, data_->start(near));
}

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
