// SPDX-License-Identifier: BSD-3-Clause
// Regions by circumcentre, faces by common closure, distance and normal.
#include "classify/band.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "base/blocks.h"
#include "mesh/circumcentre.h"

namespace octet {
namespace {

constexpr std::int32_t kUnknown = -1;
constexpr std::uint8_t kAllFaces = 0b1111;
/// A facet may turn away from its face by at most 60 degrees ...
constexpr double kNormal = 0.5;
/// ... and its centroid may be at most this share of its longest edge away from it: the sagitta of an
/// equilateral triangle whose edges turn by 60 degrees.
constexpr double kDistance = 0.1;

/// Region of the octree vertices of a tetrahedron: kUnknown where it has none, or some of different regions.
/// Octree vertices keep 0.6 of the size from the surface, so what holds one lies where it lies.
std::int32_t region_of_octree_vertices(const TetMesh& mesh, std::span<const ModelRef> on, TetId t) {
  std::int32_t region = kUnknown;
  for (const VertexId v : mesh.tets[t]) {
    const ModelRef ref = on[v.index()];
    if (ref.dim != 3) continue;
    if (region != kUnknown && region != ref.tag) return kUnknown;
    region = ref.tag;
  }
  return region;
}

/// Four times the squared area of face f.
double squared_area(const TetMesh& mesh, TetId t, int f) {
  const auto& v = mesh.tets[t];
  const Vec3 a = mesh.points[v[kTetFace[f][0]]];
  return (mesh.points[v[kTetFace[f][1]]] - a).cross(mesh.points[v[kTetFace[f][2]]] - a).squaredNorm();
}

/// Per region tag; grown, so that a segment that meets a face meets its box.
std::vector<std::vector<Box3>> boxes_of_embedded_faces(const Model& model) {
  std::vector<std::vector<Box3>> boxes(static_cast<std::size_t>(model.count(3)) + 1);
  const Facets& facets = model.facets();
  std::vector<Box3> of_face(static_cast<std::size_t>(model.count(2)) + 1);
  for (std::size_t i = 0; i < facets.triangles.size(); ++i)
    if (model.is_embedded(facets.face[i]))
      for (const std::uint32_t node : facets.triangles[i])
        of_face[static_cast<std::size_t>(facets.face[i])].add(facets.nodes[node]);
  for (int f = 1; f <= model.count(2); ++f) {
    if (!model.is_embedded(f)) continue;
    const Box3& box = of_face[static_cast<std::size_t>(f)];
    boxes[static_cast<std::size_t>(model.face(f).region[0])].push_back(
        box.grown(facets.deviation[static_cast<std::size_t>(f)] + model.tolerance()));
  }
  return boxes;
}

}  // namespace

EdgeChains::EdgeChains(std::vector<EdgePiece> pieces) : pieces_(std::move(pieces)) {
  by_ends_.reserve(2 * pieces_.size());
  for (std::uint32_t n = 0; n < pieces_.size(); ++n) {
    const EdgePiece& p = pieces_[n];
    by_ends_.emplace(key(p.a, p.b), n);
    if (by_edge_.size() <= static_cast<std::size_t>(p.edge)) by_edge_.resize(p.edge + 1);
    by_edge_[p.edge].push_back(n);
  }
}

std::uint32_t EdgeChains::find(VertexId a, VertexId b) const {
  const auto found = by_ends_.find(key(a.index(), b.index()));
  return found == by_ends_.end() ? UINT32_MAX : found->second;
}

std::uint32_t EdgeChains::piece_at(int edge, double t) const {
  const auto& chain = by_edge_[edge];
  auto at = std::lower_bound(chain.begin(), chain.end(), t,
                             [&](std::uint32_t n, double value) { return pieces_[n].tb < value; });
  if (at == chain.end()) --at;
  return *at;
}

void EdgeChains::split(std::uint32_t n, VertexId point, double t) {
  const EdgePiece old = pieces_[n];
  const auto added = static_cast<std::uint32_t>(pieces_.size());
  by_ends_.erase(key(old.a, old.b));
  pieces_[n] = {old.a, point.index(), old.ta, t, old.edge};
  pieces_.push_back({point.index(), old.b, t, old.tb, old.edge});
  by_ends_[key(old.a, point.index())] = n;
  by_ends_[key(point.index(), old.b)] = added;
  auto& chain = by_edge_[old.edge];
  chain.insert(std::find(chain.begin(), chain.end(), n) + 1, added);
}

Band::Band(const Model& model, RegionOf region_of) : model_(&model), region_of_(std::move(region_of)) {
  vertex_faces_.resize(static_cast<std::size_t>(model.count(0)) + 1);
  face_itself_.resize(static_cast<std::size_t>(model.count(2)) + 1);
  for (int f = 1; f <= model.count(2); ++f) {
    face_itself_[f] = {f};
    for (const int v : model.face(f).vertices) vertex_faces_[v].push_back(f);
  }
  embedded_ = boxes_of_embedded_faces(model);
  has_embedded_ = std::any_of(embedded_.begin(), embedded_.end(), [](const auto& of) { return !of.empty(); });
}

const std::vector<int>& Band::faces_of(ModelRef on) const {
  static const std::vector<int> kNone;
  switch (on.dim) {
    case 0:
      return vertex_faces_[on.tag];
    case 1:
      return model_->edge(on.tag).faces;
    case 2:
      return face_itself_[on.tag];
    default:
      return kNone;
  }
}

std::optional<int> Band::own_region(const TetMesh& mesh, std::span<const ModelRef> on, TetId t) const {
  if (mesh.ghost(t)) return 0;
  const std::int32_t region = region_of_octree_vertices(mesh, on, t);
  if (region != kUnknown) return region;
  const Circumcentre c = circumcentre(mesh, t);
  if (!c.reliable) return std::nullopt;
  return region_of_(place_of(mesh, on, t, c.point));
}

void Band::update(const TetMesh& mesh, std::span<const ModelRef> on, std::span<const TetId> created) {
  facets_are_current_ = false;
  region_.resize(mesh.tets.size(), kUnknown);
  std::vector<std::uint8_t> is_flat(created.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, created.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const TetId t = created[i];
      if (!mesh.alive(t)) continue;
      const std::optional<int> own = own_region(mesh, on, t);
      is_flat[i] = !own;
      region_[t] = own.value_or(kUnknown);
    }
  });
  std::vector<TetId> flat;
  for (std::size_t i = 0; i < created.size(); ++i) {
    if (!voice_.empty()) voice_.erase(created[i].index());
    if (!mesh.alive(created[i])) continue;
    if (is_flat[i]) flat.push_back(created[i]);
    if (!facets_.empty()) forget_facets(mesh, created[i]);  // else none was asked for so far
  }
  label_flat(mesh, flat);
}

/// Where a tetrahedron of boundary points is asked for its region: at its circumcentre, or, where it spans a
/// wall or gap far thinner than itself, in the middle of the edge across. On a thin curved sheet the
/// circumcentre lies by its sagitta beyond the sheet, so that a shell thinner than that would vanish.
Vec3 Band::place_of(const TetMesh& mesh, std::span<const ModelRef> on, TetId t, const Vec3& centre) const {
  constexpr double kThin = 0.25;  // of the circumradius
  const auto& v = mesh.tets[t];
  double shortest = kThin * kThin * (mesh.points[v[0]] - centre).squaredNorm();
  Vec3 place = centre;
  for (const auto& e : kTetEdge) {
    const VertexId a = v[e[0]], b = v[e[1]];
    const double length = (mesh.points[a] - mesh.points[b]).squaredNorm();
    if (length >= shortest || share_a_face(on[a.index()], on[b.index()])) continue;
    shortest = length;
    place = 0.5 * (mesh.points[a] + mesh.points[b]);
  }
  return place;
}

bool Band::share_a_face(ModelRef a, ModelRef b) const {
  const std::vector<int>&first = faces_of(a), &second = faces_of(b);
  return std::any_of(first.begin(), first.end(),
                     [&](int f) { return std::binary_search(second.begin(), second.end(), f); });
}

/// Beside an embedded face what is flat has its place where a neighbour has its own.
void Band::forget_facets(const TetMesh& mesh, TetId t) {
  facets_are_current_ = false;
  forget_faces_of(mesh, t);
  if (!has_embedded_) return;
  for (const TetId n : mesh.neighbours[t])
    if (!mesh.ghost(n) && !circumcentre(mesh, n).reliable) forget_faces_of(mesh, n);
}

void Band::forget_faces_of(const TetMesh& mesh, TetId t) {
  stale_.push_back({t, kAllFaces});
  for (const TetId n : mesh.neighbours[t]) {
    unsigned shared = 0;
    for (int g = 0; g < 4; ++g) shared |= unsigned{mesh.neighbours[n][g] == t} << g;
    stale_.push_back({n, static_cast<std::uint8_t>(shared)});
  }
}

std::size_t Band::repair_singly(const TetMesh& mesh, std::span<const ModelRef> on) {
  constexpr int kPasses = 8;
  std::size_t moved = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::size_t moved_now = 0;
    for (const BoundaryFacet& facet : facets(mesh, on)) {
      if (facet.face != 0) continue;
      const TetId t = facet.tet, n = mesh.neighbours[t][facet.local];
      const int here = region_[t], there = region_[n];
      if (here == there) continue;  // moved in this pass
      for (const auto& [tet, to] : {std::pair{t, there}, std::pair{n, here}}) {
        if (!movable(mesh, on, tet)) continue;
        if (misfits(mesh, on, tet, to) >= misfits(mesh, on, tet, region_[tet])) continue;
        move(mesh, tet, to);
        ++moved_now;
        break;
      }
    }
    moved += moved_now;
    if (moved_now == 0) break;
  }
  return moved;
}

bool Band::movable(const TetMesh& mesh, std::span<const ModelRef> on, TetId t) const {
  if (mesh.ghost(t)) return false;
  return std::all_of(mesh.tets[t].begin(), mesh.tets[t].end(),
                     [&](VertexId v) { return on[v.index()].dim < 3; });
}

bool Band::misfit(const TetMesh& mesh, std::span<const ModelRef> on, TetId t, std::int8_t f, int behind,
                  int front) const {
  if (behind == front) return false;
  const auto& v = mesh.tets[t];
  const BoundaryFacet facet{t, f, kUnknown, {v[kTetFace[f][0]], v[kTetFace[f][1]], v[kTetFace[f][2]]}};
  return classify_facet(mesh, on, facet, behind, front) == 0;
}

/// Facets of t that would fit no model face if t lay in `region`.
int Band::misfits(const TetMesh& mesh, std::span<const ModelRef> on, TetId t, int region) const {
  int count = 0;
  for (std::int8_t f = 0; f < 4; ++f) count += misfit(mesh, on, t, f, region, region_[mesh.neighbours[t][f]]);
  return count;
}

void Band::move(const TetMesh& mesh, TetId t, int region) {
  region_[t] = region;
  forget_facets(mesh, t);
}

/// A flat tetrahedron takes the region across its largest face: either choice gives a triangulation of the
/// same four coplanar points.
void Band::label_flat(const TetMesh& mesh, const std::vector<TetId>& flat) {
  for (std::size_t pass = 0; pass <= flat.size(); ++pass) {
    bool open = false;
    for (const TetId t : flat) {
      if (region_[t] != kUnknown) continue;
      double largest = -1.0;
      int best = kUnknown;
      for (int f = 0; f < 4; ++f) {
        const int r = region_[mesh.neighbours[t][f]];
        if (r == kUnknown) continue;
        const double area = squared_area(mesh, t, f);
        if (area > largest) {
          largest = area;
          best = r;
        }
      }
      region_[t] = best;
      open = open || best == kUnknown;
    }
    if (!open) return;
  }
  for (const TetId t : flat)
    if (region_[t] == kUnknown) region_[t] = 0;
}

/// Where a tetrahedron stands with regard to faces embedded in its region: at its circumcentre; one that is
/// flat, where its neighbour across its largest face does, whatever that leaves for its other three. Not at
/// its octree vertices: the way from one of these to another may pass beyond the border of a face though the
/// facet between is on it.
Vec3 Band::side_place(const TetMesh& mesh, TetId t, int steps) const {
  const auto& v = mesh.tets[t];
  const Circumcentre c = circumcentre(mesh, t);
  const Vec3 middle = 0.25 * (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]] + mesh.points[v[3]]);
  if (c.reliable) {
    // One that lies on the face itself goes where the tetrahedron is.
    constexpr double kAside = 1e-3;
    const auto& boxes = embedded_[static_cast<std::size_t>(region_[t])];
    const bool is_near =
        std::any_of(boxes.begin(), boxes.end(), [&](const Box3& box) { return box.contains(c.point); });
    const double on_it = kAside * kAside * (c.point - mesh.points[v[0]]).norm();
    return is_near && model_->closest(c.point, on_it) ? Vec3(c.point + kAside * (middle - c.point)) : c.point;
  }
  int largest = 0;
  for (int f = 1; f < 4; ++f)
    if (squared_area(mesh, t, f) > squared_area(mesh, t, largest)) largest = f;
  const TetId n = mesh.neighbours[t][largest];
  return steps == 0 || region_[n] != region_[t] ? middle : side_place(mesh, n, steps - 1);
}

/// Whether what goes through the boundary there goes through an embedded face: at an edge only where that
/// goes on beyond it.
bool Band::is_through_embedded(const Hit& hit) const {
  if (hit.kind != HitKind::kTransversal || !model_->is_embedded(hit.face)) return false;
  if (hit.on.dim != 1) return hit.on.dim == 2;
  int uses = 0;
  for (const int f : model_->edge(hit.on.tag).faces)
    for (const FaceBoundary& side : model_->face(f).boundary) uses += side.edge == hit.on.tag ? 1 : 0;
  return uses == 2;
}

int Band::passage(const TetMesh& mesh, TetId from, TetId to) const {
  constexpr int kSteps = 4;
  const bool swapped = to < from;  // one answer for both
  const Vec3 p = side_place(mesh, swapped ? to : from, kSteps),
             q = side_place(mesh, swapped ? from : to, kSteps);
  Box3 way;
  way.add(p);
  way.add(q);
  const auto& boxes = embedded_[static_cast<std::size_t>(region_[from])];
  if (std::none_of(boxes.begin(), boxes.end(), [&](const Box3& box) { return box.overlaps(way); })) return 0;
  std::vector<Hit> hits;
  model_->intersect(p, q, hits);
  std::erase_if(hits, [&](const Hit& hit) { return !is_through_embedded(hit); });
  if (hits.size() % 2 == 0) return 0;
  return (hits.front().normal.dot(q - p) > 0.0) != swapped ? 1 : -1;
}

bool Band::is_facet(const TetMesh& mesh, TetId t, std::int8_t f) const {
  const TetId n = mesh.neighbours[t][f];
  if (region_[n] != region_[t]) return true;
  return !embedded_[static_cast<std::size_t>(region_[t])].empty() && passage(mesh, t, n) != 0;
}

/// Those of the faces that are facets.
void Band::list_facets(const TetMesh& mesh, TetId t, std::uint8_t faces,
                       std::vector<BoundaryFacet>& found) const {
  if (!mesh.alive(t) || region_[t] == 0) return;
  const bool has_embedded = !embedded_[static_cast<std::size_t>(region_[t])].empty();
  for (std::int8_t f = 0; f < 4; ++f) {
    if ((faces >> f & 1) == 0) continue;
    const TetId n = mesh.neighbours[t][f];
    if (region_[n] > region_[t]) continue;
    if (region_[n] == region_[t] && !(has_embedded && passage(mesh, t, n) == 1)) continue;
    const auto& v = mesh.tets[t];
    found.push_back({t, f, kUnknown, {v[kTetFace[f][0]], v[kTetFace[f][1]], v[kTetFace[f][2]]}});
  }
}

/// All other facets are what they were, but those of tetrahedra that are gone.
void Band::list_stale_facets(const TetMesh& mesh) {
  tbb::parallel_sort(stale_.begin(), stale_.end(),
                     [](const Stale& a, const Stale& b) { return a.tet < b.tet; });
  std::size_t count = 0;
  for (const Stale& s : stale_) {
    if (count > 0 && stale_[count - 1].tet == s.tet)
      stale_[count - 1].faces |= s.faces;
    else
      stale_[count++] = s;
  }
  stale_.resize(count);
  std::vector<BoundaryFacet> kept, found;
  for (const Stale& s : stale_) list_facets(mesh, s.tet, s.faces, found);
  auto stale = stale_.begin();
  for (const BoundaryFacet& facet : facets_) {
    while (stale != stale_.end() && stale->tet < facet.tet) ++stale;
    const bool is_stale =
        stale != stale_.end() && stale->tet == facet.tet && (stale->faces >> facet.local & 1) != 0;
    if (!is_stale && mesh.alive(facet.tet))
      kept.push_back(facet);
    else
      changed_.insert(changed_.end(), facet.v.begin(), facet.v.end());
  }
  for (const BoundaryFacet& facet : found) changed_.insert(changed_.end(), facet.v.begin(), facet.v.end());
  facets_.clear();
  std::merge(kept.begin(), kept.end(), found.begin(), found.end(), std::back_inserter(facets_),
             [](const BoundaryFacet& a, const BoundaryFacet& b) {
               return a.tet != b.tet ? a.tet < b.tet : a.local < b.local;
             });
}

const std::vector<BoundaryFacet>& Band::facets(const TetMesh& mesh, std::span<const ModelRef> on) {
  if (facets_are_current_) return facets_;
  facets_are_current_ = true;
  if (facets_.empty()) {
    facets_ = collect<BoundaryFacet>(mesh.tets.size(), [&](std::size_t i, std::vector<BoundaryFacet>& found) {
      list_facets(mesh, TetId(i), kAllFaces, found);
    });
  } else {
    list_stale_facets(mesh);
  }
  stale_.clear();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facets_.size(), 128), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      BoundaryFacet& facet = facets_[i];
      if (facet.face == kUnknown)
        facet.face = classify_facet(mesh, on, facet, region_[facet.tet],
                                    region_[mesh.neighbours[facet.tet][facet.local]]);
    }
  });
  return facets_;
}

int Band::classify_facet(const TetMesh& mesh, std::span<const ModelRef> on, const BoundaryFacet& facet,
                         int region_behind, int region_front) const {
  std::array<const std::vector<int>*, 3> lists;
  for (int i = 0; i < 3; ++i) lists[i] = &faces_of(on[facet.v[i].index()]);
  std::sort(lists.begin(), lists.end(), [](const auto* a, const auto* b) { return a->size() < b->size(); });
  const Vec3 centre = (mesh.points[facet.v[0]] + mesh.points[facet.v[1]] + mesh.points[facet.v[2]]) / 3.0;
  const double slack = slack_of(on, facet);
  struct Candidate {
    bool beyond;  ///< the centre lies beside the face, beyond its border
    double distance;
    int face;
    FaceFoot foot;  ///< of the centre on the surface
    bool operator<(const Candidate& other) const {
      return std::tie(beyond, distance, face) < std::tie(other.beyond, other.distance, other.face);
    }
  };
  std::vector<Candidate> fitting;
  for (const int f : *lists[0]) {
    const auto& r = model_->face(f).region;
    const bool sides =
        (r[0] == region_behind && r[1] == region_front) || (r[1] == region_behind && r[0] == region_front);
    if (!sides) continue;
    if (!std::binary_search(lists[1]->begin(), lists[1]->end(), f)) continue;
    if (!std::binary_search(lists[2]->begin(), lists[2]->end(), f)) continue;
    fitting.push_back({false, 0.0, f, model_->face_project(f, centre)});
  }
  if (fitting.size() > 1)
    for (Candidate& c : fitting) {
      c.distance = model_->face_closest(c.face, centre).distance;
      c.beyond = c.distance > (c.foot.point - centre).norm() + slack;
    }
  std::sort(fitting.begin(), fitting.end());
  // A facet over a narrow groove is no part of the face that the groove is in, however near its border.
  for (const Candidate& c : fitting) {
    if (c.beyond && !fitting.front().beyond) break;
    if (fits(mesh, facet, c.face, c.foot, slack, region_front)) return c.face;
  }
  return 0;
}

/// The CAD itself knows its edges and vertices no better than this.
double Band::slack_of(std::span<const ModelRef> on, const BoundaryFacet& facet) const {
  double slack = 0.0;
  for (const VertexId v : facet.v) slack = std::max(slack, 2.0 * model_->tolerance_of(on[v.index()]));
  return slack;
}

bool Band::fits(const TetMesh& mesh, const BoundaryFacet& facet, int face, const FaceFoot& foot, double slack,
                int region_front) const {
  const Vec3 a = mesh.points[facet.v[0]], b = mesh.points[facet.v[1]], c = mesh.points[facet.v[2]];
  const Vec3 centre = (a + b + c) / 3.0;
  Vec3 normal = (b - a).cross(c - a);
  const double twice_area = normal.norm();
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double longest = std::max({ab, bc, ca});
  if (!foot.converged || (foot.point - centre).norm() > kDistance * (ab + bc + ca) / 3.0 + slack)
    return false;
  // A needle of coplanar points, or one as thin as the CAD is vague, has no normal worth asking for; its
  // neighbours decide.
  if (twice_area < longest * std::max(1e-6 * longest, slack)) return true;
  if (model_->face(face).region[1] != region_front) normal = -normal;
  return normal.dot(foot.normal) >= kNormal * twice_area;
}

}  // namespace octet
