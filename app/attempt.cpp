// SPDX-License-Identifier: BSD-3-Clause
// From a tree to a classified band, step by step.
#include "app/attempt.h"

#include <algorithm>

namespace octet {
namespace {

/// The least side of the box around a face.
double least_extent(const Model& model, int face) {
  const Facets& facets = model.facets();
  Box3 box;
  for (std::size_t n = 0; n < facets.triangles.size(); ++n) {
    if (facets.face[n] != face) continue;
    for (const Vec3& corner : facet_corners(facets, n)) box.add(corner);
  }
  return box.size().minCoeff();
}

}  // namespace

int Attempt::region_of(const Model& model, const Vec3& p) const {
  const Vec3 x = p - tree.origin();
  if ((x.array() < 0.0).any() || (x.array() > tree.root_size()).any()) return 0;
  const OctantId o = tree.find(p);
  switch (labels.type[o.index()]) {
    case OctantType::kOut:
      return 0;
    case OctantType::kIn:
      return labels.region[o.index()];
    default:
      return model.region_at(p);
  }
}

void Attempt::forget_band() {
  band.reset();
  chains.reset();
  triangulation = Triangulation();
  on = {};
  cuts = {};
  seeds = {};
  split.band = {};
}

void cut_tree(Attempt& attempt, const Model& model) {
  attempt.vertices = octree_vertices(attempt.tree);
  const OctantTypes types = octant_types(model, attempt.tree);
  attempt.cuts = cut_octant_edges(model, attempt.tree, attempt.vertices, types);
  attempt.labels = label_vertices(model, attempt.tree, attempt.vertices, types, attempt.cuts);
}

void place_points(Attempt& attempt, const Model& model, double size) {
  attempt.seeds = seed_points(model, attempt.tree, attempt.vertices, attempt.labels, attempt.cuts, size);
  attempt.split = split_interior(model, attempt.tree, attempt.vertices, attempt.labels, attempt.seeds, size);
}

void triangulate(Attempt& attempt, const Model& model) {
  attempt.triangulation.insert_all(attempt.split.band.position, attempt.split.band.order);
  attempt.on = attempt.split.band.on;
  attempt.chains = std::make_unique<EdgeChains>(attempt.seeds.pieces);
  attempt.band = std::make_unique<Band>(
      model, [&attempt, &model](const Vec3& p) { return attempt.region_of(model, p); });
}

void classify(Attempt& attempt, const Model& model, double size, AttributeLimits limits, Observer& observer) {
  const TetMesh& mesh = attempt.triangulation.mesh();
  std::vector<TetId> all;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    if (mesh.alive(TetId(i))) all.emplace_back(i);
  attempt.band->update(mesh, attempt.on, all);
  const EdgeIndex edges(model, size);
  limits.cell_at = [&](const Vec3& p) { return std::size_t{attempt.tree.find(p).index()}; };
  attempt.closed =
      close_gaps(attempt.triangulation, *attempt.band, *attempt.chains, attempt.on, edges, limits, observer);
}

std::optional<Octree> subdivide_at_gaps(const Attempt& attempt, const Model& model, double finest) {
  std::vector<OctantId> octants;
  const auto take = [&](const Octree& tree, OctantId o, double longest) {
    if (tree.length(tree[o].level) > longest * (1.0 + 1e-9) && tree[o].level < kLatticeLevels)
      octants.push_back(o);
  };
  const auto take_around = [&](const Octree& tree, const Vec3& place, double longest) {
    const double half = 0.5 * tree.size_at(place);
    for (int i = 0; i < 27; ++i)
      take(tree, tree.find(place + half * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)), longest);
  };
  for (const Gap& gap : attempt.closed.gaps) take_around(attempt.tree, gap.place, finest);
  for (const std::size_t cell : attempt.closed.crowded) take(attempt.tree, OctantId(cell), finest);
  std::optional<Octree> finer;
  const auto refine_taken = [&](const Octree& tree) {
    std::sort(octants.begin(), octants.end());
    octants.erase(std::unique(octants.begin(), octants.end()), octants.end());
    finer = refine(tree, octants);
    octants.clear();
  };
  if (!octants.empty()) refine_taken(attempt.tree);
  // A face that lies between the octants' edges is met by octants of half its extent.
  for (const Gap& gap : attempt.closed.gaps) {
    if (gap.kind != GapKind::kBareFace) continue;
    const double longest = std::max(finest, 0.5 * least_extent(model, gap.entity.tag));
    while (finer) {
      take_around(*finer, gap.place, longest);
      if (octants.empty()) break;
      refine_taken(*finer);
    }
  }
  return finer;
}

}  // namespace octet
