// SPDX-License-Identifier: BSD-3-Clause
// Edge removal: the tetrahedra around an edge are replaced by the best ones without it.
#include "finalize/edge_removal.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "finalize/mean_shape.h"
#include "finalize/replace.h"
#include "finalize/rim_gain.h"
#include "finalize/shape.h"
#include "mesh/quality.h"

namespace octet {
namespace {

/// Rims beyond this are not tried: edges with so many tetrahedra are seldom removed for the better.
constexpr int kMaxRim = 10;

/// A stretch of the rim within one region; where it is bounded by two triangles on a model face, the chord
/// from its last vertex to its first closes it.
struct Sector {
  std::array<VertexId, kMaxRim + 1> rim;
  int count = 0;
  std::int32_t region = 0;
  std::int32_t face_on =
      0;  ///< signed tag of both bounding triangles as seen from the sector; 0: a full ring

  [[nodiscard]] VertexId first() const { return rim[0]; }
  [[nodiscard]] VertexId last() const { return rim[static_cast<std::size_t>(count) - 1]; }
};

/// The one or two sectors of an edge's surroundings.
struct Sectors {
  std::array<Sector, 2> list;
  std::size_t count = 0;

  [[nodiscard]] const Sector& operator[](std::size_t i) const { return list[i]; }
  [[nodiscard]] const Sector* begin() const { return list.data(); }
  [[nodiscard]] const Sector* end() const { return list.data() + count; }
};

/// The best triangulation of the polygon rim[0..n-1] [Klincsek's dynamic programming]: split[i][j] is the
/// third vertex of the triangle on chord (i, j).
struct Triangulation2D {
  double value = 0.0;
  std::uint64_t work = 0;  ///< evaluations of `shape`
  std::array<std::array<std::int8_t, kMaxRim + 1>, kMaxRim + 1> split;
};

/// The stretch of the rim from number `from` to `to`, around the ring where that is closed.
void add_sector(const WorkMesh& mesh, const EdgeRing& ring, std::size_t from, std::size_t to,
                Sectors& sectors) {
  Sector& sector = sectors.list[sectors.count++];
  sector.count = 0;
  for (std::size_t i = from; i <= to; ++i) {
    sector.rim[static_cast<std::size_t>(sector.count++)] = ring.rim[i % ring.rim.size()];
  }
  sector.region = mesh.region[ring.tets[from]];
  sector.face_on = ring.face_on[from];
}

bool collect_sectors(const WorkMesh& mesh, const EdgeRing& ring, Sectors& sectors) {
  const std::size_t n = ring.rim.size();
  if (n > kMaxRim + 1) return false;
  sectors.count = 0;
  std::array<std::size_t, 2> walls{};
  std::size_t found = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (ring.face_on[i] == 0) continue;
    if (found == 2) return false;
    walls[found++] = i;
  }
  if (found == 0) {
    if (n < 3 || !ring.closed) return false;
    add_sector(mesh, ring, 0, n - 1, sectors);
    return true;
  }
  const auto [p, q] = walls;
  if (found != 2 || std::abs(ring.face_on[p]) != std::abs(ring.face_on[q])) return false;
  // On a closed ring the second wall is seen from the tetrahedron behind it, so its sign is turned.
  if (ring.face_on[p] != (ring.closed ? -ring.face_on[q] : ring.face_on[q])) return false;
  if (!ring.closed && (p != 0 || q + 1 != n)) return false;
  add_sector(mesh, ring, p, q, sectors);
  if (ring.closed) add_sector(mesh, ring, q, p + n, sectors);
  return true;
}

/// What a triangulation is judged by: the worst of its tetrahedra, or the sum of their merits where none is
/// as bad as `floor`.
struct Aim {
  bool mean = false;
  double floor = 0.0;

  [[nodiscard]] double of_none() const { return mean ? 0.0 : 1.0; }
  [[nodiscard]] double join(double p, double q) const { return mean ? p + q : std::min(p, q); }
  /// Minus infinity (mean) for what is not above `least` or may not be.
  [[nodiscard]] double of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double least) const {
    if (!mean) return shape(a, b, c, d);
    const double value = merit(a, b, c, d);
    return value > least && shape(a, b, c, d) > floor ? value : -std::numeric_limits<double>::infinity();
  }
};

/// For the mean, values not above `least` are not of interest: what is found then means nothing.
Triangulation2D triangulate(const WorkMesh& mesh, const EdgeRing& ring, const Sector& sector, const Aim& aim,
                            double least) {
  const int n = sector.count;
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  std::array<Vec3, kMaxRim + 1> p;
  for (int i = 0; i < n; ++i) p[i] = mesh.points[sector.rim[i]];
  std::array<std::array<double, kMaxRim + 1>, kMaxRim + 1> best;
  Triangulation2D result;
  for (int i = 0; i + 1 < n; ++i) best[i][i + 1] = aim.of_none();
  for (int span = 2; span < n; ++span) {
    // For the mean, what is of use leaves no more to the other triangles than they can have.
    const double nothing = aim.mean ? least - 2.0 * (n - 1 - span) * kMeritOfPerfect : 0.0;
    for (int i = 0; i + span < n; ++i) {
      const int j = i + span;
      best[i][j] = nothing;
      for (int k = i + 1; k < j; ++k) {
        double value = aim.join(best[i][k], best[k][j]);
        // Worst: a bound; mean: each further tetrahedron adds kMeritOfPerfect at most.
        const double bar = aim.mean ? best[i][j] : std::max(best[i][j], aim.floor);
        const double hope = aim.mean ? kMeritOfPerfect : 0.0;
        if (value + 2.0 * hope <= bar) continue;
        value = aim.join(value, aim.of(p[i], p[k], p[j], b, bar - value - hope));
        ++result.work;
        if (value + hope <= bar) continue;
        value = aim.join(value, aim.of(p[i], p[j], p[k], a, bar - value));
        ++result.work;
        if (value <= bar) continue;
        best[i][j] = value;
        result.split[i][j] = static_cast<std::int8_t>(k);
      }
      if (aim.mean && span + 1 < n && best[i][j] == nothing)
        best[i][j] = -std::numeric_limits<double>::infinity();
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
  const VertexId s = sector.first(), e = sector.last(), a = ring.a, b = ring.b;
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
    longest = std::min(longest, shop.options.size_at(shop.mesh.points[swap.before[0].vertices[0]]));
  }
  const double room = shop.room_at(shop.mesh.points[swap.before[0].vertices[0]]);
  return BoundaryGuard::within(after, shop.guard.bound(before, longest, room));
}

/// The chord from the first to the last vertex must be new, or, where it is the far edge of a tetrahedron
/// that is dropped, have nothing on the model around it: else the surface would touch itself along it.
bool chord_is_free(Workshop& shop, const Sectors& sectors) {
  const VertexId s = sectors[0].first(), e = sectors[0].last();
  if (shop.mesh.held(s) || shop.mesh.held(e)) return false;
  const TetId t = tet_with_edge(shop.mesh, s, e);
  if (!t.valid()) return true;
  const bool drops =
      std::any_of(sectors.begin(), sectors.end(), [](const Sector& x) { return x.count == 2; });
  if (!drops) return false;
  EdgeRing around;
  edge_ring(shop.mesh, t, s, e, around);
  return around.closed &&
         std::all_of(around.face_on.begin(), around.face_on.end(), [](int f) { return f == 0; });
}

/// The change of each sector's region and of the face by a surface swap on a curved face; none on a planar
/// one.
std::vector<MeasureChange> measure_changes(const Workshop& shop, const Sectors& sectors,
                                           const EdgeRing& ring) {
  if (sectors[0].face_on == 0 || shop.guard.planar(std::abs(sectors[0].face_on))) return {};
  const WorkMesh& mesh = shop.mesh;
  const VertexId s = sectors[0].first(), e = sectors[0].last();
  // What the first sector loses is the tetrahedron between the two pairs of triangles; the other gains it.
  const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
  const Vec3 &p = mesh.points[s], &q = mesh.points[e];
  const double lost = signed_volume(a, b, p, q);
  std::vector<MeasureChange> changes;
  add_change(changes, model_region(sectors[0].region), -lost);
  if (sectors.count > 1) add_change(changes, model_region(sectors[1].region), lost);
  add_change(
      changes, model_face(std::abs(sectors[0].face_on)),
      triangle_area(p, q, a) + triangle_area(p, q, b) - triangle_area(a, b, p) - triangle_area(a, b, q));
  return changes;
}

struct RemovalPlan {
  Sectors sectors;
  std::array<Triangulation2D, 2> triangulations;
  double value = 0.0;
  std::uint64_t work = 0;
};

/// An operation for the mean must win this much.
constexpr double kLeastMeritGain = 0.02;

double merit_of(const WorkMesh& mesh, const std::vector<TetId>& tets) {
  double sum = 0.0;
  for (const TetId t : tets)
    sum += merit(mesh.point(t, 0), mesh.point(t, 1), mesh.point(t, 2), mesh.point(t, 3));
  return sum;
}

/// Plans to remove the edge of plan.ring for a value above `least`, as far as shapes and geometry go; whether
/// the surface would touch itself is left to `carry_out`.
bool fill_plan(const Workshop& shop, const EdgeRing& ring, const Aim& aim, double least, RemovalPlan& plan) {
  const WorkMesh& mesh = shop.mesh;
  if (piece_on(mesh, ring.a, ring.b) != 0 || (mesh.frozen(ring.a) && mesh.frozen(ring.b))) return false;
  if (!collect_sectors(mesh, ring, plan.sectors)) return false;
  const bool held = mesh.held(ring.a) && mesh.held(ring.b);
  if (held && plan.sectors[0].face_on != 0) return false;
  plan.value = aim.of_none();
  for (std::size_t i = 0; i < plan.sectors.count; ++i) {
    // What the sectors still to come can add to the mean at most.
    double hope = 0.0;
    for (std::size_t k = i + 1; k < plan.sectors.count; ++k)
      hope += 2.0 * std::max(plan.sectors[k].count - 2, 0) * kMeritOfPerfect;
    const double needed = least - plan.value - hope;
    plan.triangulations[i] = triangulate(mesh, ring, plan.sectors[i], aim, needed);
    if (aim.mean && plan.triangulations[i].value <= needed) return false;
    plan.value = aim.join(plan.value, plan.triangulations[i].value);
    plan.work += plan.triangulations[i].work;
    if (!aim.mean && plan.value <= least) return false;
  }
  if (plan.value <= least) return false;
  return plan.sectors[0].face_on == 0 || swap_fits(shop, surface_swap(ring, plan.sectors[0]));
}

bool plan_for_mean(const Workshop& shop, const EdgeRing& ring, double floor, RemovalPlan& plan) {
  // Nine of ten end here. The share left to rounding lets nothing be missed.
  constexpr double kSurelyLess = 0.999 * kLeastMeritGain;
  if (ring.rim.size() >= 3 && ring.rim.size() <= kSmallRim &&
      !(most_gain_of_removal(shop.mesh, ring) > kSurelyLess))
    return false;
  double worst = 1.0;
  for (const TetId t : ring.tets) worst = std::min(worst, shop.mesh.quality[t]);
  return fill_plan(shop, ring, {true, std::min(floor, better_than(worst))},
                   merit_of(shop.mesh, ring.tets) + kLeastMeritGain, plan);
}

bool carry_out(Workshop& shop, const EdgeRing& ring, const RemovalPlan& plan) {
  if (plan.sectors[0].face_on != 0 && !chord_is_free(shop, plan.sectors)) return false;
  std::vector<NewTet> added;
  for (std::size_t i = 0; i < plan.sectors.count; ++i) {
    emit(ring, plan.sectors[i], plan.triangulations[i], 0, plan.sectors[i].count - 1, added);
  }
  CavityChange change{ring.tets, added};
  SurfaceSwap swap;
  if (plan.sectors[0].face_on != 0) {
    swap = surface_swap(ring, plan.sectors[0]);
    change.triangles = swap.after;
  }
  const std::vector<MeasureChange> changes = measure_changes(shop, plan.sectors, ring);
  if (!shop.guard.admits(changes) || !replace(shop, change)) return false;
  shop.guard.take(changes);
  ++shop.report.edge_removals;
  return true;
}

}  // namespace

double edge_removal_shape(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  RemovalPlan plan;
  edge_ring(shop.mesh, t, a, b, shop.ring);
  const bool better = fill_plan(shop, shop.ring, {false, floor}, floor, plan);
  shop.work += plan.work;
  const bool free = better && (plan.sectors[0].face_on == 0 || chord_is_free(shop, plan.sectors));
  return free ? plan.value : 0.0;
}

bool remove_edge(Workshop& shop, TetId t, VertexId a, VertexId b, double floor) {
  RemovalPlan plan;
  edge_ring(shop.mesh, t, a, b, shop.ring);
  const bool better = fill_plan(shop, shop.ring, {false, floor}, floor, plan);
  shop.work += plan.work;
  return better && carry_out(shop, shop.ring, plan);
}

bool edge_removal_raises_mean(const Workshop& shop, const EdgeRing& ring, double floor) {
  RemovalPlan plan;
  return plan_for_mean(shop, ring, floor, plan);
}

bool remove_edge_for_mean(Workshop& shop, const EdgeRing& ring, double floor) {
  RemovalPlan plan;
  return plan_for_mean(shop, ring, floor, plan) && carry_out(shop, ring, plan);
}

}  // namespace octet
