// SPDX-License-Identifier: BSD-3-Clause
// Coarse octants beside finer ones are looked at, until none is to be split.
#include "octree/even_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/blocks.h"
#include "geom/facet_bvh.h"
#include "octree/balance.h"

namespace octet {
namespace {

/// Octants, no longer than that, which are not split and share a face, an edge or a corner with a split one
/// of their size: by the one-level difference the only ones that touch smaller octants.
std::vector<OctantId> beside_smaller(const Octree& tree, double longest) {
  const SplitKeys splits = split_keys(tree.octants());
  std::vector<std::uint8_t> is_beside(tree.size(), 0);
  for (std::size_t level = 1; level < splits.at.size(); ++level) {
    if (tree.length(static_cast<int>(level)) > longest) continue;
    const std::vector<MortonKey>& keys = splits.at[level];
    const std::vector<OctantId> here = collect<OctantId>(keys.size(), [&](std::size_t i, auto& beside) {
      const Octant split = octant_of(keys[i], static_cast<int>(level));
      for (int k = 0; k < 27; ++k) {
        const std::array<int, 3> step{k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
        Lattice corner{};
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::int64_t at =
              std::int64_t{split.corner[axis]} + step[axis] * std::int64_t{split.extent()};
          inside = inside && at >= 0 && at < std::int64_t{kLatticeExtent};
          corner[axis] = static_cast<std::uint32_t>(at);
        }
        if (!inside) continue;
        const OctantId o = tree.find(corner);
        if (tree[o].level == split.level) beside.push_back(o);
      }
    });
    for (const OctantId o : here) is_beside[o.index()] = 1;
  }
  return collect<OctantId>(tree.size(), [&](std::size_t i, auto& found) {
    if (is_beside[i] != 0) found.emplace_back(i);
  });
}

/// The place of the boundary that is nearest to the box's centre, by the facets; none outside of the box.
std::optional<FacetFoot> nearest_within(const Model& model, const Box3& box) {
  const Vec3 centre = box.centre();
  std::optional<FacetFoot> nearest;
  model.bvh().any_in_box(box, [&](std::uint32_t t) {
    const auto [a, b, c] = facet_corners(model.facets(), t);
    FacetFoot foot = closest_on_triangle(centre, a, b, c);
    foot.triangle = t;
    if (!nearest || foot.distance < nearest->distance) nearest = foot;
    return false;
  });
  if (nearest && !box.contains(nearest->point)) nearest.reset();
  return nearest;
}

/// Whether the boundary in the octant has a smaller octant across a thin wall or gap. By the facets: most
/// octants that are asked about have no wall, and what is a little off a wall's thickness does not matter.
bool is_coarser_than_across(const Model& model, const Octree& tree, OctantId o) {
  constexpr double kFacing = 0.7;      // cosine of the normals' angle
  constexpr double kSameSheet = 0.02;  // of the reach: facets of one sheet lie on one another
  const double length = tree.length(tree[o].level), reach = kThinWall * kSpacingPerOctant * length;
  const Box3 box = tree.box(o);
  const std::optional<FacetFoot> foot = nearest_within(model, box);
  if (!foot) return false;
  const Facets& facets = model.facets();
  const auto& uv = facets.uv[foot->triangle];
  const int face = facets.face[foot->triangle];
  const Vec3 normal =
      model.face_normal(face, foot->weights[0] * uv[0] + foot->weights[1] * uv[1] + foot->weights[2] * uv[2]);
  bool found = false;
  for (const int side : {-1, 1}) {
    const Vec3 axis = side * normal;
    const int between = model.face(face).region[side > 0 ? 1 : 0];
    model.bvh().visit_segment(foot->point, foot->point + reach * axis, [&](std::uint32_t t) {
      if (found || t == foot->triangle) return;
      const auto [a, b, c] = facet_corners(facets, t);
      const Vec3 other = (b - a).cross(c - a);
      const double along = other.dot(axis);
      if (std::abs(along) < kFacing * other.norm()) return;
      if (model.face(facets.face[t]).region[along < 0.0 ? 1 : 0] != between) return;
      const double thickness = other.dot(a - foot->point) / along;
      found = thickness > kSameSheet * reach && thickness <= reach &&
              tree.length_at(foot->point + thickness * axis) < length;
    });
  }
  return found;
}

}  // namespace

Octree with_even_walls(const Model& model, Octree tree, double longest) {
  constexpr std::size_t kOctantsATask = 64;
  while (true) {
    const std::vector<OctantId> beside = beside_smaller(tree, longest);
    const std::vector<OctantId> coarser = collect<OctantId>(
        beside.size(),
        [&](std::size_t i, auto& found) {
          if (is_coarser_than_across(model, tree, beside[i])) found.push_back(beside[i]);
        },
        kOctantsATask);
    if (coarser.empty()) return tree;
    tree = refine(tree, coarser);
  }
}

}  // namespace octet
