// SPDX-License-Identifier: BSD-3-Clause
// Claims that nothing overlaps. Positive tetrahedra that fill what their boundary encloses, behind a boundary
// that does not meet itself, cannot overlap; so the boundary is all that must be searched.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>

#include "base/blocks.h"
#include "classify/claims.h"
#include "classify/triangle_crossing.h"

namespace octet {
namespace {

/// Sides a task.
constexpr std::size_t kOverlapBlock = 1024;

Box3 box_of(const ClaimInput& in, const std::array<Mesh::Index, 2>& side) {
  Box3 box;
  for (const Mesh::Index v : side) box.add(in.point(v));
  return box;
}

/// Whether a side meets a triangle anywhere but in the vertices that they share.
bool side_meets(const ClaimInput& in, const std::array<Mesh::Index, 2>& side,
                const std::array<Mesh::Index, 3>& triangle) {
  int shared = 0, corner = 0;
  Mesh::Index other = side[1];
  for (int k = 0; k < 3; ++k)
    for (int s = 0; s < 2; ++s)
      if (triangle[k] == side[s]) {
        ++shared;
        corner = k;
        other = side[1 - s];
      }
  if (shared == 2) return false;
  const auto corner_at = [&](int k) -> const Vec3& { return in.point(triangle[(corner + k) % 3]); };
  if (shared == 1) return segment_enters_triangle(corner_at(0), in.point(other), corner_at(1), corner_at(2));
  return segment_meets_triangle(in.point(side[0]), in.point(side[1]), corner_at(0), corner_at(1),
                                corner_at(2));
}

}  // namespace

Claim claim_volumes_add_up(const ClaimInput& in) {
  ClaimBuilder claim("volumes-add-up",
                     "The tetrahedra of every region fill what its triangles enclose; worst: relative.");
  const std::size_t n = static_cast<std::size_t>(in.model.count(3)) + 1;
  const std::vector<double>& filled = in.sweep.filled;
  std::vector<double> enclosed(n, 0.0);
  const Vec3 origin = in.model.box().centre();
  for (std::size_t i = 0; i < in.mesh.triangles.size(); ++i) {
    const auto& t = in.mesh.triangles[i];
    const ModelFace& face = in.model.face(in.mesh.triangle_on[i]);
    const double cone = (in.point(t[0]) - origin).dot(in.cross(t)) / 6.0;
    enclosed[face.region[0]] += cone;
    enclosed[face.region[1]] -= cone;
  }
  const double limit = 1e-9;
  double worst = 0.0;
  for (int tag = 1; tag <= in.model.count(3); ++tag) {
    const double scale = std::max(std::abs(filled[tag]), std::abs(enclosed[tag]));
    // Rounding is that of sums over the whole box, whatever the region's own volume.
    const double box = std::pow(in.model.diagonal(), 3) * 1e-3;
    const double share = scale == 0.0 ? 0.0 : std::abs(filled[tag] - enclosed[tag]) / std::max(scale, box);
    worst = std::max(worst, share);
    if (share > limit)
      claim.fault(share, model_region(tag), origin,
                  fmt::format("the tetrahedra fill {:.12g}, the triangles enclose {:.12g}", filled[tag],
                              enclosed[tag]),
                  kBadMesh);
  }
  return claim.measured(worst, limit);
}

Claim claim_no_overlap(const ClaimInput& in) {
  ClaimBuilder claim("no-overlap",
                     "The triangles meet only in the vertices and edges they share (exact signs).");
  struct Meeting {
    std::size_t side;
    std::uint32_t triangle;
    auto operator<=>(const Meeting&) const = default;
  };
  struct Near {
    FloatBox box;
    std::array<Mesh::Index, 3> vertices;
    std::uint32_t triangle;
  };
  const auto meetings = [&](std::size_t first, std::size_t last) {
    std::vector<Meeting> met;
    std::vector<Near> near;
    for (std::size_t i = first, end = first; i < last; i = end) {
      // One search for all sides that run up from a vertex.
      Box3 box;
      for (; end < last && in.sides[end].v[0] == in.sides[i].v[0]; ++end)
        box.add(box_of(in, in.sides[end].v));
      near.clear();
      in.surface.any_item_in_box(box, [&](std::uint32_t item) {
        const std::uint32_t triangle = in.surface.triangle(item);
        near.push_back({in.surface.box_of(item), in.mesh.triangles[triangle], triangle});
        return false;
      });
      for (std::size_t n = i; n < end; ++n) {
        const auto& side = in.sides[n].v;
        if (n > 0 && in.sides[n - 1].v == side) continue;
        const FloatBox own = FloatBox::around(box_of(in, side));
        for (const Near& other : near)
          if (!other.box.apart(own) && side_meets(in, side, other.vertices))
            met.push_back({n, other.triangle});
      }
    }
    std::sort(met.begin(), met.end());
    return met;
  };
  for (const auto& met : map_blocks<std::vector<Meeting>>(in.sides.size(), kOverlapBlock, meetings))
    for (const auto& [side, triangle] : met)
      claim.fault(1.0, model_face(in.mesh.triangle_on[triangle]), in.centroid(in.mesh.triangles[triangle]),
                  fmt::format("triangle {} is pierced by a side of a triangle on {}", triangle,
                              in.model.describe(model_face(in.sides[side].face))),
                  kFiner);
  return claim.counted();
}

}  // namespace octet
