// SPDX-License-Identifier: BSD-3-Clause
// Coarse octants beside finer ones are looked at, until none is to be split.
#include "octree/even_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/blocks.h"
#include "geom/facet_bvh.h"
#include "geom/opposite.h"
#include "octree/balance.h"

namespace octet {
namespace {

/// Octants that are not split and share a face, an edge or a corner with a split one
/// of their size: by the one-level difference the only ones that touch smaller octants.
std::vector<OctantId> beside_smaller(const Octree& tree) {
  const SplitKeys splits = split_keys(tree.octants());
  std::vector<std::uint8_t> is_beside(tree.size(), 0);
  for (std::size_t level = 1; level < splits.at.size(); ++level) {
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

/// Whether the boundary in the octant has a smaller octant across a thin wall or gap. By the facets: most
/// octants that are asked about have no wall, and what is a little off a wall's thickness does not matter.
bool is_coarser_than_across(const Model& model, const Octree& tree, OctantId o) {
  constexpr double kFacing = 0.7;      // cosine of the normals' angle
  constexpr double kSameSheet = 0.02;  // of the reach: facets of one sheet lie on one another
  const double length = tree.length(tree[o].level), reach = kThinWall * kSpacingPerOctant * length;
  const Box3 box = tree.box(o);
  if (!model.near_boundary(box)) return false;
  const auto foot = model.bvh().nearest(box.centre(), 0.5 * std::sqrt(3.0) * length);
  if (!foot || !box.contains(foot->point)) return false;
  const int face = model.facets().face[foot->triangle];
  const auto& uv = model.facets().uv[foot->triangle];
  const Vec3& w = foot->weights;
  const Vec3 normal = model.face_normal(face, w[0] * uv[0] + w[1] * uv[1] + w[2] * uv[2]);
  bool found = false;
  for (const int side : {-1, 1}) {
    const Vec3 axis = side * normal;
    const int between = model.face(face).region[side > 0 ? 1 : 0];
    model.bvh().visit_segment(foot->point, foot->point + reach * axis, [&](std::uint32_t t) {
      if (found || t == foot->triangle || !looks_back(model, t, axis, between, kFacing)) return;
      const auto [a, b, c] = facet_corners(model.facets(), t);
      const Vec3 across = (b - a).cross(c - a);
      const double thickness = across.dot(a - foot->point) / across.dot(axis);
      found = thickness > kSameSheet * reach && thickness <= reach &&
              tree.length_at(foot->point + thickness * axis) < length;
    });
  }
  return found;
}

}  // namespace

Octree with_even_walls(const Model& model, Octree tree) {
  constexpr std::size_t kOctantsATask = 64;
  while (true) {
    const std::vector<OctantId> beside = beside_smaller(tree);
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
