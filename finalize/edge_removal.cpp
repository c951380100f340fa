// SPDX-License-Identifier: BSD-3-Clause
// Edge removal: the tetrahedra around an edge are replaced by the best ones without it.
#include "finalize/edge_removal.h"

#include <algorithm>
#include <cstdlib>

#include "finalize/cavity.h"
#include "finalize/shape.h"
#include "mesh/quality.h"

namespace octet {
namespace {

/// Rims beyond this are not tried: edges with so many tetrahedra are seldom removed for the better.
constexpr int kMaxRim = 10;

/// A stretch of the rim within one region; where it is bounded by two triangles on a model face, the chord
/// from its last vertex to its first closes it.
struct Sector {
  std::vector<VertexId> rim;
  std::int32_t region = 0;
  std::int32_t face_on =
      0;  ///< signed tag of both bounding triangles as seen from the sector; 0: a full ring
};

/// The best triangulation of the polygon rim[0..n-1] [Klincsek's dynamic programming]: split[i][j] is the
/// third vertex of the triangle on chord (i, j).
struct Triangulation2D {
  double worst = 1.0;
  std::array<std::array<std::int8_t, kMaxRim + 1>, kMaxRim + 1> split{};
};

bool collect_sectors(const WorkMesh& mesh, const EdgeRing& ring, std::vector<Sector>& sectors) {
  const std::size_t n = ring.rim.size();
  if (n > kMaxRim + 1) return false;
  std::vector<std::size_t> walls;
  for (std::size_t i = 0; i < n; ++i) {
    if (ring.face_on[i] != 0) walls.push_back(i);
  }
  if (walls.empty()) {
    if (n < 3 || !ring.closed) return false;
    sectors.push_back({ring.rim, mesh.region[ring.tets[0]], 0});
    return true;
  }
  if (walls.size() != 2 || std::abs(ring.face_on[walls[0]]) != std::abs(ring.face_on[walls[1]])) return false;
  const auto [p, q] = std::pair(walls[0], walls[1]);
  // On a closed ring the second wall is seen from the tetrahedron behind it, so its sign is turned.
  if (ring.face_on[p] != (ring.closed ? -ring.face_on[q] : ring.face_on[q])) return false;
  sectors.push_back({{ring.rim.begin() + static_cast<std::ptrdiff_t>(p),
                      ring.rim.begin() + static_cast<std::ptrdiff_t>(q) + 1},
                     mesh.region[ring.tets[p]],
                     ring.face_on[p]});
  if (ring.closed) {
    Sector other{{}, mesh.region[ring.tets[q]], ring.face_on[q]};
    for (std::size_t i = q; i <= p + n; ++i) other.rim.push_back(ring.rim[i % n]);
    sectors.push_back(other);
  } else if (p != 0 || q + 1 != n) {
    return false;
  }
  return true;
}

Triangulation2D triangulate(Workshop& shop, const EdgeRing& ring, const Sector& sector, double floor) {
  const WorkMesh& mesh = shop.mesh;
  const int n = static_cast<int>(sector.rim.size());
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  std::array<Vec3, kMaxRim + 1> p;
  for (int i = 0; i < n; ++i) p[i] = mesh.points[sector.rim[i]];
  std::array<std::array<double, kMaxRim + 1>, kMaxRim + 1> best{};
  Triangulation2D result;
  for (int i = 0; i + 1 < n; ++i) best[i][i + 1] = 1.0;
  for (int span = 2; span < n; ++span) {
    for (int i = 0; i + span < n; ++i) {
      const int j = i + span;
      best[i][j] = 0.0;
      for (int k = i + 1; k < j; ++k) {
        double value = std::min(best[i][k], best[k][j]);
        const double bar = std::max(best[i][j], floor);
        if (value <= bar) continue;
        value = std::min(value, shape(p[i], p[k], p[j], b));
        ++shop.work;
        if (value <= bar) continue;
        value = std::min(value, shape(p[i], p[j], p[k], a));
        ++shop.work;
        if (value <= bar) continue;
        best[i][j] = value;
        result.split[i][j] = static_cast<std::int8_t>(k);
      }
    }
  }
  result.worst = best[0][n - 1];
  return result;
}

void emit(const EdgeRing& ring, const Sector& sector, const Triangulation2D& plan, int i, int j,
          std::vector<NewTet>& added) {
  if (j - i < 2) return;
  const int k = plan.split[i][j];
  const auto& rim = sector.rim;
  added.push_back({{rim[i], rim[k], rim[j], ring.b}, sector.region});
  added.push_back({{rim[i], rim[j], rim[k], ring.a}, sector.region});
  emit(ring, sector, plan, i, k, added);
  emit(ring, sector, plan, k, j, added);
}

/// The triangles on the model face before and after a surface swap.
struct SurfaceSwap {
  std::array<NewTriangle, 2> before, after;
};

SurfaceSwap surface_swap(const EdgeRing& ring, const Sector& sector) {
  const VertexId s = sector.rim.front(), e = sector.rim.back(), a = ring.a, b = ring.b;
  const int face = std::abs(sector.face_on);
  // As listed, the normals point out of the sector.
  SurfaceSwap swap{{NewTriangle{{b, a, s}, face}, NewTriangle{{a, b, e}, face}},
                   {NewTriangle{{s, b, e}, face}, NewTriangle{{s, e, a}, face}}};
  if (sector.face_on < 0) {
    for (auto* pair : {&swap.before, &swap.after}) {
      for (NewTriangle& triangle : *pair) std::swap(triangle.vertices[1], triangle.vertices[2]);
    }
  }
  return swap;
}

bool swap_fits(Workshop& shop, const SurfaceSwap& swap) {
  Fit before, after;
  double longest = 0.0;
  for (const NewTriangle& t : swap.before) {
    before.add(shop.guard.fit(shop.mesh, t.face, t.vertices));
    longest = std::max(longest, (shop.mesh.points[t.vertices[2]] - shop.mesh.points[t.vertices[0]]).norm());
  }
  for (const NewTriangle& t : swap.after) after.add(shop.guard.fit(shop.mesh, t.face, t.vertices));
  if (!shop.guard.planar(swap.before[0].face)) {
    longest = std::min(longest, shop.size_at(shop.mesh.points[swap.before[0].vertices[0]]));
  }
  return BoundaryGuard::within(after, BoundaryGuard::bound(before, longest));
}

/// The chord from the first to the last vertex must be new, or, where it is the far edge of a tetrahedron
/// that is dropped, have nothing on the model around it: else the surface would touch itself along it.
bool chord_is_free(Workshop& shop, const std::vector<Sector>& sectors) {
  const VertexId s = sectors[0].rim.front(), e = sectors[0].rim.back();
  if (shop.mesh.frozen[s] || shop.mesh.frozen[e]) return false;
  const TetId t = tet_with_edge(shop.mesh, s, e);
  if (!t.valid()) return true;
  const bool drops =
      std::any_of(sectors.begin(), sectors.end(), [](const Sector& x) { return x.rim.size() == 2; });
  if (!drops) return false;
  EdgeRing around;
  edge_ring(shop.mesh, t, s, e, around);
  return around.closed &&
         std::all_of(around.face_on.begin(), around.face_on.end(), [](int f) { return f == 0; });
}

/// The change of each sector's region by a surface swap on a curved face; none on a planar one.
std::vector<VolumeChange> volume_changes(const Workshop& shop, const std::vector<Sector>& sectors,
                                         const EdgeRing& ring) {
  if (sectors[0].face_on == 0 || shop.guard.planar(std::abs(sectors[0].face_on))) return {};
  const WorkMesh& mesh = shop.mesh;
  const VertexId s = sectors[0].rim.front(), e = sectors[0].rim.back();
  // What the first sector loses is the tetrahedron between the two pairs of triangles; the other gains it.
  const double lost = signed_volume(mesh.points[ring.a], mesh.points[ring.b], mesh.points[s], mesh.points[e]);
  std::vector<VolumeChange> changes{{sectors[0].region, -lost}};
  if (sectors.size() > 1) changes.push_back({sectors[1].region, lost});
  return changes;
}

struct Plan {
  EdgeRing ring;
  std::vector<Sector> sectors;
  std::vector<Triangulation2D> triangulations;
  double worst = 1.0;
};

bool make_plan(Workshop& shop, TetId t, VertexId a, VertexId b, double floor, Plan& plan) {
  const WorkMesh& mesh = shop.mesh;
  if (piece_on(mesh, a, b) != 0 || (mesh.frozen[a] && mesh.frozen[b])) return false;
  edge_ring(mesh, t, a, b, plan.ring);
  if (!collect_sectors(mesh, plan.ring, plan.sectors)) return false;
  for (const Sector& sector : plan.sectors) {
    plan.triangulations.push_back(triangulate(shop, plan.ring, sector, floor));
    plan.worst = std::min(plan.worst, plan.triangulations.back().worst);
    if (plan.worst <= floor) return false;
  }
  if (plan.sectors[0].face_on == 0) return true;
  return swap_fits(shop, surface_swap(plan.ring, plan.sectors[0])) && chord_is_free(shop, plan.sectors);
}

}  // namespace

double edge_removal_shape(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  Plan plan;
  return make_plan(shop, t, a, b, floor, plan) ? plan.worst : 0.0;
}

bool remove_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  Plan plan;
  if (!make_plan(shop, t, a, b, floor, plan)) return false;
  std::vector<NewTet> added;
  for (std::size_t i = 0; i < plan.sectors.size(); ++i) {
    emit(plan.ring, plan.sectors[i], plan.triangulations[i], 0,
         static_cast<int>(plan.sectors[i].rim.size()) - 1, added);
  }
  CavityChange change{plan.ring.tets, added};
  SurfaceSwap swap;
  if (plan.sectors[0].face_on != 0) {
    swap = surface_swap(plan.ring, plan.sectors[0]);
    change.triangles = swap.after;
  }
  const std::vector<VolumeChange> volumes = volume_changes(shop, plan.sectors, plan.ring);
  if (!shop.guard.admits(volumes) || !replace_cavity(shop.mesh, change, shop.made)) return false;
  shop.guard.take(volumes);
  ++shop.report.edge_removals;
  return true;
}

}  // namespace octet
