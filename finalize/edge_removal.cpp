// SPDX-License-Identifier: BSD-3-Clause
// Edge removal: the tetrahedra around an edge are replaced by the best ones without it.
#include "finalize/edge_removal.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "finalize/cavity.h"
#include "finalize/mean_shape.h"
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
  double value = 0.0;
  std::uint64_t work = 0;  ///< evaluations of `shape`
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

/// What a triangulation is judged by: the worst of its tetrahedra, or the sum of their merits where none is
/// as bad as `floor`.
struct Aim {
  bool mean = false;
  double floor = 0.0;

  [[nodiscard]] double of_none() const { return mean ? 0.0 : 1.0; }
  [[nodiscard]] double join(double p, double q) const { return mean ? p + q : std::min(p, q); }
  /// -1 (worst) or minus infinity (mean) for what may not be.
  [[nodiscard]] double of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    const double value = shape(a, b, c, d);
    if (!mean) return value;
    return value > floor ? merit(a, b, c, d) : -std::numeric_limits<double>::infinity();
  }
};

Triangulation2D triangulate(const WorkMesh& mesh, const EdgeRing& ring, const Sector& sector,
                            const Aim& aim) {
  const int n = static_cast<int>(sector.rim.size());
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  std::array<Vec3, kMaxRim + 1> p;
  for (int i = 0; i < n; ++i) p[i] = mesh.points[sector.rim[i]];
  std::array<std::array<double, kMaxRim + 1>, kMaxRim + 1> best{};
  Triangulation2D result;
  const double nothing = aim.mean ? -std::numeric_limits<double>::infinity() : 0.0;
  for (int i = 0; i + 1 < n; ++i) best[i][i + 1] = aim.of_none();
  for (int span = 2; span < n; ++span) {
    for (int i = 0; i + span < n; ++i) {
      const int j = i + span;
      best[i][j] = nothing;
      for (int k = i + 1; k < j; ++k) {
        double value = aim.join(best[i][k], best[k][j]);
        // Worst: a bound; mean: each further tetrahedron adds kMeritOfPerfect at most.
        const double bar = aim.mean ? best[i][j] : std::max(best[i][j], aim.floor);
        const double hope = aim.mean ? kMeritOfPerfect : 0.0;
        if (value + 2.0 * hope <= bar) continue;
        value = aim.join(value, aim.of(p[i], p[k], p[j], b));
        ++result.work;
        if (value + hope <= bar) continue;
        value = aim.join(value, aim.of(p[i], p[j], p[k], a));
        ++result.work;
        if (value <= bar) continue;
        best[i][j] = value;
        result.split[i][j] = static_cast<std::int8_t>(k);
      }
    }
  }
  result.value = best[0][n - 1];
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

bool swap_fits(const Workshop& shop, const SurfaceSwap& swap) {
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
  double value = 0.0;
  std::uint64_t work = 0;
};

/// An operation for the mean must win this much.
constexpr double kLeastMeritGain = 0.02;
/// Rings whose tetrahedra have this merit on average are left alone, and those beyond so many vertices.
constexpr double kSatisfied = 0.0;
constexpr std::size_t kMaxRimForMean = 7;

double merit_of(const WorkMesh& mesh, const std::vector<TetId>& tets) {
  double sum = 0.0;
  for (const TetId t : tets)
    sum += merit(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
  return sum;
}

/// Plans to remove the edge of plan.ring for a value above `least`, as far as shapes and geometry go; whether
/// the surface would touch itself is left to `carry_out`.
bool fill_plan(const Workshop& shop, const Aim& aim, double least, Plan& plan) {
  const WorkMesh& mesh = shop.mesh;
  const VertexId a = plan.ring.a, b = plan.ring.b;
  if (piece_on(mesh, a, b) != 0 || (mesh.frozen[a] && mesh.frozen[b])) return false;
  if (!collect_sectors(mesh, plan.ring, plan.sectors)) return false;
  plan.value = aim.of_none();
  for (const Sector& sector : plan.sectors) {
    plan.triangulations.push_back(triangulate(mesh, plan.ring, sector, aim));
    plan.value = aim.join(plan.value, plan.triangulations.back().value);
    plan.work += plan.triangulations.back().work;
    if (!aim.mean && plan.value <= least) return false;
  }
  if (plan.value <= least) return false;
  if (plan.sectors[0].face_on == 0) return true;
  return swap_fits(shop, surface_swap(plan.ring, plan.sectors[0]));
}

bool plan_for_mean(const Workshop& shop, const EdgeRing& ring, double floor, Plan& plan) {
  const double merits = merit_of(shop.mesh, ring.tets);
  if (ring.rim.size() > kMaxRimForMean || merits > kSatisfied * static_cast<double>(ring.tets.size()))
    return false;
  plan.ring = ring;
  return fill_plan(shop, {true, floor}, merits + kLeastMeritGain, plan);
}

bool carry_out(Workshop& shop, const Plan& plan) {
  if (plan.sectors[0].face_on != 0 && !chord_is_free(shop, plan.sectors)) return false;
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

}  // namespace

double edge_removal_shape(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  Plan plan;
  edge_ring(shop.mesh, t, a, b, plan.ring);
  const bool better = fill_plan(shop, {false, floor}, floor, plan);
  shop.work += plan.work;
  const bool free = better && (plan.sectors[0].face_on == 0 || chord_is_free(shop, plan.sectors));
  return free ? plan.value : 0.0;
}

bool remove_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  Plan plan;
  edge_ring(shop.mesh, t, a, b, plan.ring);
  const bool better = fill_plan(shop, {false, floor}, floor, plan);
  shop.work += plan.work;
  return better && carry_out(shop, plan);
}

bool edge_removal_raises_mean(const Workshop& shop, const EdgeRing& ring, double floor) {
  Plan plan;
  return plan_for_mean(shop, ring, floor, plan);
}

bool remove_edge_for_mean(Workshop& shop, const EdgeRing& ring, double floor) {
  Plan plan;
  return plan_for_mean(shop, ring, floor, plan) && carry_out(shop, plan);
}

}  // namespace octet
