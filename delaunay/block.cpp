// SPDX-License-Identifier: BSD-3-Clause
// Gather, triangulate, certify; widen until certain.
#include "delaunay/block.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/predicates.h"
#include "delaunay/sphere_in_box.h"
#include "delaunay/triangulation.h"

namespace octet {
namespace {

bool owns(const Box3& block, const Box3& bounds, const Vec3& p) {
  for (int k = 0; k < 3; ++k) {
    const bool below_end = p[k] < block.hi[k] || (p[k] == block.hi[k] && p[k] == bounds.hi[k]);
    if (p[k] < block.lo[k] || !below_end) return false;
  }
  return true;
}

bool covers(const Box3& region, const Box3& bounds) {
  return region.contains(bounds.lo) && region.contains(bounds.hi);
}

// Whether no point of the bounds lies strictly beyond the plane of the ghost's facet.
bool nothing_beyond(const TetMesh& mesh, TetId ghost, const Box3& bounds) {
  const auto& v = mesh.tets[ghost];
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = ((corner >> k) & 1) != 0 ? bounds.hi[k] : bounds.lo[k];
    if (orient3d(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], p) > 0) return false;
  }
  return true;
}

// Whether every tetrahedron at an owned vertex is one of the whole triangulation.
bool certain(const TetMesh& mesh, const std::vector<bool>& owned, const Box3& region, const Box3& bounds) {
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t)) continue;
    const auto& v = mesh.tets[t];
    const auto at_owned = [&](VertexId w) { return w != kGhostVertex && owned[w.index()]; };
    if (std::none_of(v.begin(), v.end(), at_owned)) continue;
    const bool sure = mesh.ghost(t) ? nothing_beyond(mesh, t, bounds)
                                    : sphere_in_box(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]],
                                                    mesh.points[v[3]], region);
    if (!sure) return false;
  }
  return true;
}

// Rotates the smallest number to the front and the smallest of the rest next to it, by even permutations.
std::array<std::uint32_t, 4> canonical(std::array<std::uint32_t, 4> t) {
  const auto first = std::min_element(t.begin(), t.end()) - t.begin();
  if (first != 0) {
    std::swap(t[0], t[first]);
    std::swap(t[first == 1 ? 2 : 1], t[first == 3 ? 2 : 3]);
  }
  std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
  return t;
}

// The tetrahedra whose heaviest vertex is owned.
std::vector<std::array<std::uint32_t, 4>> owned_tets(const Triangulation& triangulation,
                                                     const std::vector<bool>& owned,
                                                     const std::vector<std::uint32_t>& number) {
  std::vector<std::array<std::uint32_t, 4>> tets;
  const TetMesh& mesh = triangulation.mesh();
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const TetId t(i);
    if (!mesh.alive(t) || mesh.ghost(t)) continue;
    const auto& v = mesh.tets[t];
    const VertexId heaviest = *std::max_element(v.begin(), v.end(), [&](VertexId a, VertexId b) {
      return triangulation.rank(a) < triangulation.rank(b);
    });
    if (!owned[heaviest.index()]) continue;
    tets.push_back(
        canonical({number[v[0].index()], number[v[1].index()], number[v[2].index()], number[v[3].index()]}));
  }
  std::sort(tets.begin(), tets.end());
  return tets;
}

}  // namespace

BlockTets block_tets(const PointIndex& all, std::span<const std::uint64_t> ranks, const Box3& block,
                     double halo) {
  OCTET_CHECK(halo > 0 && ranks.size() == all.points().size());
  BlockTets result;
  std::vector<std::uint32_t> number;
  for (;; halo *= 2) {
    const Box3 region = block.grown(halo);
    const bool whole = covers(region, all.bounds());
    ++result.rounds;
    all.gather(region, number);
    result.gathered = number.size();

    std::vector<Vec3> points;
    std::vector<std::uint64_t> local_ranks;
    std::vector<bool> owned;
    bool any = false;
    for (const std::uint32_t n : number) {
      points.push_back(all.points()[n]);
      local_ranks.push_back(ranks[n]);
      owned.push_back(owns(block, all.bounds(), points.back()));
      any = any || owned.back();
    }
    if (!any) return result;
    Triangulation triangulation;
    try {
      triangulation.insert_all(points, local_ranks);
    } catch (const InputError&) {  // the gathered points lie in one plane; all may not
      if (whole) throw;
      continue;
    }
    if (!whole && !certain(triangulation.mesh(), owned, region, all.bounds())) continue;
    result.tets = owned_tets(triangulation, owned, number);
    return result;
  }
}

}  // namespace octet
