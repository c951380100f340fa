// SPDX-License-Identifier: BSD-3-Clause
// One query a facet; in nearly all the segment meets its own face once and nothing else.
#include "classify/dual_crossings.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "geom/facet_bvh.h"
#include "mesh/circumcentre.h"

namespace octet {
namespace {

struct DualEnd {
  Vec3 point;
  bool exact;
};

DualEnd dual_end(const TetMesh& mesh, TetId tet, const Vec3& fallback) {
  if (!mesh.ghost(tet)) {
    const Circumcentre c = circumcentre(mesh, tet);
    if (c.reliable) return {c.point, true};
  }
  return {fallback, false};
}

bool share_an_entity(const Model& model, int a, int b) {
  const ModelFace &first = model.face(a), &second = model.face(b);
  for (const int v : first.vertices)
    if (std::binary_search(second.vertices.begin(), second.vertices.end(), v)) return true;
  for (const FaceBoundary& side : first.boundary) {
    const auto& faces = model.edge(side.edge).faces;
    if (std::binary_search(faces.begin(), faces.end(), b)) return true;
  }
  return false;
}

/// Whether the segment comes near no other face, and goes through all facets of this one that it comes near
/// the same way: then it crosses the face once at most, for it would have to come back to cross it again.
bool crosses_once(const Model& model, int face, const Vec3& p, const Vec3& q) {
  constexpr double kThrough = 0.5;  // cosine; facets are trusted to 30 degrees
  const bool is_plane = model.is_plane(face);
  const Facets& facets = model.facets();
  const Vec3 way = q - p;
  const double length = way.norm();
  bool alone = true, there = false, back = false;
  model.bvh().visit_segment(p, q, [&](std::uint32_t t) {
    alone &= facets.face[t] == face;
    if (is_plane || !alone) return;
    const auto [a, b, c] = facet_corners(facets, t);
    const Vec3 normal = (b - a).cross(c - a);
    const double along = normal.dot(way), least = kThrough * normal.norm() * length;
    there |= !(along < -least);
    back |= !(along > least);
  });
  return alone && !(there && back);
}

/// Whether the crossings are more than the one of `face`, among its neighbours at most.
bool is_more_than(const Model& model, int face, const std::vector<Hit>& hits) {
  int own = 0;
  for (const Hit& hit : hits) {
    if (hit.kind == HitKind::kTangent) continue;
    if (hit.on.dim == 2 ? hit.on.tag == face : model.in_closure(hit.on, model_face(face)))
      ++own;
    else if (!share_an_entity(model, face, hit.face))
      return true;
  }
  return own > 1;
}

}  // namespace

DualSegment dual_segment(const TetMesh& mesh, TetId tet, int local) {
  const auto& v = mesh.tets[tet];
  const Vec3 a = mesh.points[v[kTetFace[local][0]]], b = mesh.points[v[kTetFace[local][1]]],
             c = mesh.points[v[kTetFace[local][2]]];
  const Vec3 centroid = (a + b + c) / 3.0;
  const double reach = std::max({(a - centroid).norm(), (b - centroid).norm(), (c - centroid).norm()});
  const Vec3 across = (b - a).cross(c - a);
  const Vec3 normal = across.norm() > 0.0 ? across.normalized() : Vec3::UnitX();
  const DualEnd inner = dual_end(mesh, tet, centroid - reach * normal);
  const DualEnd outer = dual_end(mesh, mesh.neighbours[tet][local], centroid + reach * normal);
  return {inner.point, outer.point, inner.exact && outer.exact};
}

std::vector<Gap> find_dual_crossings(Band& band, const TetMesh& mesh, std::span<const ModelRef> on) {
  const Model& model = band.model();
  const std::vector<BoundaryFacet>& facets = band.facets(mesh, on);
  std::vector<std::uint8_t> crossed(facets.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, facets.size(), 128), [&](const auto& range) {
    std::vector<Hit> hits;
    for (std::size_t n = range.begin(); n != range.end(); ++n) {
      const BoundaryFacet& facet = facets[n];
      if (facet.face == 0) continue;
      const DualSegment dual = dual_segment(mesh, facet.tet, facet.local);
      if (!dual.exact || crosses_once(model, facet.face, dual.inner, dual.outer)) continue;
      hits.clear();
      model.intersect(dual.inner, dual.outer, hits);
      if (!is_more_than(model, facet.face, hits)) continue;
      crossed[n] = band.region_of(dual.inner) == band.region(facet.tet) &&
                   band.region_of(dual.outer) == band.region(mesh.neighbours[facet.tet][facet.local]);
    }
  });
  std::vector<Gap> gaps;
  for (std::size_t n = 0; n < facets.size(); ++n) {
    if (!crossed[n]) continue;
    const BoundaryFacet& facet = facets[n];
    Gap gap;
    gap.kind = GapKind::kDualCrossing;
    gap.entity = model_face(facet.face);
    gap.place = (mesh.points[facet.v[0]] + mesh.points[facet.v[1]] + mesh.points[facet.v[2]]) / 3.0;
    gap.tet = facet.tet;
    gap.local = facet.local;
    gaps.push_back(gap);
  }
  return gaps;
}

}  // namespace octet
