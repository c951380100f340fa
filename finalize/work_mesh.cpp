// SPDX-License-Identifier: BSD-3-Clause
// The mesh that can be edited: tetrahedra with neighbours and classification.
#include "finalize/work_mesh.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "base/check.h"
#include "finalize/shape.h"
#include "mesh/sort_triple.h"

namespace octet {
namespace {

using FaceKey = std::array<std::uint32_t, 3>;

/// The vertices of face f of t in ascending order, and whether its outward listing is odd.
struct FaceName {
  FaceKey key{};
  bool odd = false;
};

FaceName name_of(const WorkMesh& work, TetId t, int f) {
  FaceName name;
  for (int c = 0; c < 3; ++c) name.key[c] = work.tets[t][kTetFace[f][c]].index();
  name.odd = sort_triple(name.key);
  return name;
}

/// Local number of the face of t across which n stands.
int face_towards(const WorkMesh& work, TetId t, TetId n) {
  const auto& across = work.neighbours[t];
  return static_cast<int>(std::find(across.begin(), across.end(), n) - across.begin());
}

/// The faces met so far, each by its first side, in buckets by the smallest vertex: a dozen each, so that
/// looking through one is quicker than sorting all.
class MetFaces {
 public:
  explicit MetFaces(const WorkMesh& work) : begin_(work.points.size() + 1, 0) {
    for (const auto& v : work.tets) {
      for (const auto& f : kTetFace) ++begin_[std::min({v[f[0]], v[f[1]], v[f[2]]}).index() + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    sides_.resize(begin_.back());
    end_.assign(begin_.begin(), begin_.end() - 1);
  }

  struct Side {
    std::uint64_t rest = 0;  ///< the other two vertices
    TetId tet;
    int face = 0;
  };

  /// Null where the face has not been met.
  [[nodiscard]] const Side* find(const FaceKey& key) const {
    const std::uint64_t rest = rest_of(key);
    for (std::uint32_t i = begin_[key[0]]; i < end_[key[0]]; ++i)
      if (sides_[i].rest == rest) return &sides_[i];
    return nullptr;
  }
  void add(const FaceKey& key, TetId t, int f) { sides_[end_[key[0]]++] = {rest_of(key), t, f}; }

 private:
  static std::uint64_t rest_of(const FaceKey& key) { return std::uint64_t{key[1]} << 32 | key[2]; }
  std::vector<std::uint32_t> begin_, end_;
  std::vector<Side> sides_;
};

void link_neighbours(WorkMesh& work, MetFaces& faces) {
  for (std::size_t i = 0; i < work.tets.size(); ++i) {
    const TetId t(i);
    for (int f = 0; f < 4; ++f) {
      const FaceKey key = name_of(work, t, f).key;
      if (const MetFaces::Side* met = faces.find(key)) {
        OCTET_CHECK(!work.neighbours[met->tet][met->face].valid());  // no face has three tetrahedra
        work.neighbours[t][f] = met->tet;
        work.neighbours[met->tet][met->face] = t;
      } else {
        faces.add(key, t, f);
      }
    }
  }
}

void tag_faces(WorkMesh& work, const Mesh& mesh, const MetFaces& faces) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    FaceKey key{mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]};
    const bool odd = sort_triple(key);
    const MetFaces::Side* met = faces.find(key);
    OCTET_CHECK(met != nullptr);
    const TetId t = met->tet, n = work.neighbours[t][met->face];
    const std::int32_t tag =
        name_of(work, t, met->face).odd == odd ? mesh.triangle_on[i] : -mesh.triangle_on[i];
    work.face_on[t][met->face] = tag;
    if (n.valid()) work.face_on[n][face_towards(work, n, t)] = -tag;
  }
}

void freeze_pinched(WorkMesh& work) {
  IdVector<VertexId, std::uint32_t> degree(work.points.size(), 0);
  for (const auto& v : work.tets) {
    for (const VertexId id : v) ++degree[id];
  }
  std::vector<TetId> tets;
  for (std::size_t i = 0; i < work.points.size(); ++i) {
    const VertexId v(i);
    if (work.on[v].dim > 1 || work.frozen(v) || !work.alive(v)) continue;
    star(work, v, tets);
    if (tets.size() != degree[v]) work.hold[v] = Hold::kFrozen;
  }
}

/// kEvenRest[i][j]: the other two corners k, l such that (i, j, k, l) is an even permutation.
constexpr std::array<std::array<std::array<int, 2>, 4>, 4> even_rests() {
  std::array<std::array<std::array<int, 2>, 4>, 4> table{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      int k = 0;
      while (k == i || k == j) ++k;
      const int l = 6 - i - j - k;
      const int p[4] = {i, j, k, l};
      int inversions = 0;
      for (int x = 0; x < 4; ++x) {
        for (int y = x + 1; y < 4; ++y) inversions += p[x] > p[y];
      }
      table[i][j] = inversions % 2 == 0 ? std::array<int, 2>{k, l} : std::array<int, 2>{l, k};
    }
  }
  return table;
}
constexpr auto kEvenRest = even_rests();

/// The corners of t besides a and b, such that (a, b, they) is positive.
const std::array<int, 2>& even_rest(const WorkMesh& mesh, TetId t, VertexId a, VertexId b) {
  return kEvenRest[corner_of(mesh, t, a)][corner_of(mesh, t, b)];
}

void resize_tets(WorkMesh& mesh, std::size_t count) {
  mesh.tets.resize(count);
  mesh.neighbours.resize(count);
  mesh.face_on.resize(count);
  mesh.region.resize(count);
  mesh.quality.resize(count);
  mesh.tet_mark.resize(count);
}

void resize_vertices(WorkMesh& mesh, std::size_t count) {
  mesh.points.resize(count);
  mesh.on.resize(count);
  mesh.tet_of.resize(count);
  mesh.hold.resize(count);
  mesh.vertex_mark.resize(count);
}

}  // namespace

std::int32_t piece_on(const WorkMesh& mesh, VertexId a, VertexId b) {
  if (mesh.on[a].dim > 1 || mesh.on[b].dim > 1) return 0;
  const auto it = mesh.pieces.find(piece_key(a, b));
  if (it == mesh.pieces.end()) return 0;
  return a < b ? it->second : -it->second;
}

void add_piece(WorkMesh& mesh, VertexId a, VertexId b, std::int32_t signed_tag) {
  const bool fresh = mesh.pieces.emplace(piece_key(a, b), a < b ? signed_tag : -signed_tag).second;
  OCTET_CHECK(fresh);
  const std::size_t tag = static_cast<std::size_t>(std::abs(signed_tag));
  if (mesh.pieces_on_edge.size() <= tag) mesh.pieces_on_edge.resize(tag + 1, 0);
  ++mesh.pieces_on_edge[tag];
  if (mesh.journal.open) mesh.journal.pieces.push_back({a, b, signed_tag, true});
}

void remove_piece(WorkMesh& mesh, VertexId a, VertexId b) {
  const auto it = mesh.pieces.find(piece_key(a, b));
  OCTET_CHECK(it != mesh.pieces.end());
  --mesh.pieces_on_edge[static_cast<std::size_t>(std::abs(it->second))];
  if (mesh.journal.open) mesh.journal.pieces.push_back({a, b, a < b ? it->second : -it->second, false});
  mesh.pieces.erase(it);
}

void open_journal(WorkMesh& mesh) {
  Journal& journal = mesh.journal;
  OCTET_CHECK(!journal.open);
  journal.tets.clear();
  journal.vertices.clear();
  journal.pieces.clear();
  journal.free_tets.clear();
  journal.tet_count = mesh.tets.size();
  journal.vertex_count = mesh.points.size();
  journal.open = true;
}

void close_journal(WorkMesh& mesh) { mesh.journal.open = false; }

void take_back(WorkMesh& mesh) {
  Journal& journal = mesh.journal;
  OCTET_CHECK(journal.open);
  journal.open = false;
  for (auto p = journal.pieces.rbegin(); p != journal.pieces.rend(); ++p) {
    if (p->added) {
      remove_piece(mesh, p->from, p->to);
    } else {
      add_piece(mesh, p->from, p->to, p->signed_tag);
    }
  }
  for (auto s = journal.free_tets.rbegin(); s != journal.free_tets.rend(); ++s) {
    if (s->second) {
      mesh.free_tets.pop_back();
    } else {
      mesh.free_tets.push_back(s->first);
    }
  }
  for (auto t = journal.tets.rbegin(); t != journal.tets.rend(); ++t) {
    mesh.tets[t->tet] = t->vertices;
    mesh.neighbours[t->tet] = t->neighbours;
    mesh.face_on[t->tet] = t->face_on;
    mesh.region[t->tet] = t->region;
    mesh.quality[t->tet] = t->quality;
  }
  for (auto v = journal.vertices.rbegin(); v != journal.vertices.rend(); ++v) {
    mesh.points[v->vertex] = v->point;
    mesh.tet_of[v->vertex] = v->tet_of;
  }
  resize_tets(mesh, journal.tet_count);
  resize_vertices(mesh, journal.vertex_count);
}

void release_alone(WorkMesh& mesh, const std::vector<Mesh::Index>& alone) {
  if (alone.empty()) return;
  std::vector<std::size_t> degree(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets.values())
    for (const VertexId v : tet) ++degree[v.index()];
  std::vector<TetId> tets;
  for (const Mesh::Index v : alone) {
    star(mesh, VertexId(v), tets);
    if (tets.size() == degree[v]) mesh.hold[VertexId(v)] = Hold::kAlone;
  }
}

WorkMesh to_work_mesh(const Mesh& mesh, std::size_t fixed) {
  WorkMesh work;
  const std::size_t vertices = mesh.points.size(), tets = mesh.tets.size();
  work.points.values() = mesh.points;
  work.on.values() = mesh.point_on;
  work.tet_of.assign(vertices, TetId());
  work.hold.assign(vertices, Hold::kFree);
  std::fill_n(work.hold.begin(), fixed, Hold::kFrozen);
  work.vertex_mark.assign(vertices, 0);
  work.tets.resize(tets);
  work.neighbours.resize(tets);
  work.face_on.resize(tets);
  work.quality.resize(tets);
  work.tet_mark.assign(tets, 0);
  work.region.values() = mesh.tet_in;
  for (std::size_t i = 0; i < tets; ++i) {
    const TetId t(i);
    for (int c = 0; c < 4; ++c) {
      work.tets[t][c] = VertexId(mesh.tets[i][c]);
      work.tet_of[work.tets[t][c]] = t;
    }
  }
  tbb::parallel_for(std::size_t{0}, tets, [&](std::size_t i) {
    const TetId t(i);
    work.quality[t] = shape(work.point(t, 0), work.point(t, 1), work.point(t, 2), work.point(t, 3));
  });
  MetFaces faces(work);
  link_neighbours(work, faces);
  tag_faces(work, mesh, faces);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    add_piece(work, VertexId(mesh.edges[i][0]), VertexId(mesh.edges[i][1]), mesh.edge_on[i]);
  }
  freeze_pinched(work);
  return work;
}

Mesh to_mesh(const WorkMesh& work) {
  Mesh mesh;
  std::vector<Mesh::Index> number(work.points.size(), 0);
  for (std::size_t i = 0; i < work.points.size(); ++i) {
    const VertexId v(i);
    if (!work.alive(v)) continue;
    number[i] = static_cast<Mesh::Index>(mesh.points.size());
    mesh.points.push_back(work.points[v]);
    mesh.point_on.push_back(work.on[v]);
  }
  for (const auto& [key, tag] : work.pieces) {
    const Mesh::Index lo = number[key & 0xffffffffu], hi = number[key >> 32];
    mesh.edges.push_back(tag > 0 ? std::array{lo, hi} : std::array{hi, lo});
    mesh.edge_on.push_back(std::abs(tag));
  }
  for (std::size_t i = 0; i < work.tets.size(); ++i) {
    const TetId t(i);
    if (!work.alive(t)) continue;
    const auto& v = work.tets[t];
    mesh.tets.push_back(
        {number[v[0].index()], number[v[1].index()], number[v[2].index()], number[v[3].index()]});
    mesh.tet_in.push_back(work.region[t]);
    for (int f = 0; f < 4; ++f) {
      const std::int32_t tag = work.face_on[t][f];
      // Each triangle once: from the side that its normal leaves, or from its only side.
      if (tag == 0 || (tag < 0 && work.neighbours[t][f].valid())) continue;
      std::array<Mesh::Index, 3> triangle;
      for (int c = 0; c < 3; ++c) triangle[c] = number[v[kTetFace[f][c]].index()];
      if (tag < 0) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
      mesh.triangle_on.push_back(std::abs(tag));
    }
  }
  sort_boundary(mesh);
  return mesh;
}

void sort_boundary(Mesh& mesh) {
  const auto sort = [](auto& elements, auto& on) {
    using Element = typename std::decay_t<decltype(elements)>::value_type;
    std::vector<std::pair<std::int32_t, Element>> all(on.size());
    for (std::size_t i = 0; i < on.size(); ++i) all[i] = {on[i], elements[i]};
    tbb::parallel_sort(all.begin(), all.end());
    for (std::size_t i = 0; i < on.size(); ++i) std::tie(on[i], elements[i]) = all[i];
  };
  for (auto& t : mesh.triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  sort(mesh.triangles, mesh.triangle_on);
  sort(mesh.edges, mesh.edge_on);
}

void star(WorkMesh& mesh, VertexId v, std::vector<TetId>& tets) {
  star_while(mesh, v, tets, [](TetId) { return true; });
}

TetId tet_with_edge(WorkMesh& mesh, VertexId a, VertexId b) {
  std::vector<TetId> tets;
  star(mesh, a, tets);
  for (const TetId t : tets) {
    if (corner_of(mesh, t, b) >= 0) return t;
  }
  return TetId();
}

bool edge_ring(const WorkMesh& mesh, TetId t, VertexId a, VertexId b, EdgeRing& ring, std::size_t most) {
  ring.a = a;
  ring.b = b;
  ring.closed = true;
  TetId first = t;
  // Forwards until it closes; where it does not, again from the outer boundary.
  while (true) {
    ring.tets.clear();
    ring.rim.clear();
    ring.face_on.clear();
    for (TetId s = first;;) {
      const auto [c, d] = even_rest(mesh, s, a, b);
      if (ring.tets.size() == most) return false;
      ring.tets.push_back(s);
      ring.rim.push_back(mesh.tets[s][c]);
      ring.face_on.push_back(mesh.face_on[s][d]);
      const TetId next = mesh.neighbours[s][c];
      if (next == first) return true;
      if (!next.valid()) {
        ring.rim.push_back(mesh.tets[s][d]);
        ring.face_on.push_back(mesh.face_on[s][c]);
        break;
      }
      s = next;
    }
    if (!ring.closed) return true;
    ring.closed = false;
    const TetId start = first;
    while (true) {
      const TetId previous = mesh.neighbours[first][even_rest(mesh, first, a, b)[1]];
      if (!previous.valid()) break;
      first = previous;
    }
    if (first == start) return true;
  }
}

double worst_quality(const WorkMesh& mesh, const std::vector<TetId>& tets) {
  double worst = 1.0;
  for (const TetId t : tets) worst = std::min(worst, mesh.quality[t]);
  return worst;
}

bool is_whole(WorkMesh& mesh, const EdgeRing& ring) {
  std::vector<TetId> tets;
  star(mesh, ring.a, tets);
  const auto around =
      std::count_if(tets.begin(), tets.end(), [&](TetId t) { return corner_of(mesh, t, ring.b) >= 0; });
  return static_cast<std::size_t>(around) == ring.tets.size();
}

}  // namespace octet
