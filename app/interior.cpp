// SPDX-License-Identifier: BSD-3-Clause
// Template octants: their points kept out of the band, their tetrahedra looked up.
#include "app/interior.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "delaunay/templates.h"

namespace octet {
namespace {

/// Octants and vertices a task.
constexpr std::size_t kGrain = 4096;

bool hangs(const Octree& tree, const OctreeVertices& vertices, OctantId o) {
  const OctantLattice lattice = octant_lattice(tree, vertices, o);
  return std::any_of(kHangingPoint.begin(), kHangingPoint.end(),
                     [&](std::uint8_t p) { return lattice[p] != kNoVertex; });
}

void flag_lattice(const Octree& tree, const OctreeVertices& vertices, OctantId o,
                  std::vector<std::uint8_t>& flags) {
  for (const std::uint32_t v : octant_lattice(tree, vertices, o))
    if (v != kNoVertex) flags[v] = 1;
}

/// Deep octants that hang, or share a vertex with one that hangs or is of the band, become near.
void part_near_from_deep(const Octree& tree, const OctreeVertices& vertices, std::vector<OctantRole>& role) {
  std::vector<std::uint8_t> beside(vertices.size(), 0);
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] == OctantRole::kDeep) {
      if (!hangs(tree, vertices, OctantId(i))) continue;
      role[i] = OctantRole::kNear;
    }
    flag_lattice(tree, vertices, OctantId(i), beside);
  }
  for (std::size_t i = 0; i < role.size(); ++i) {
    const auto& corners = vertices.corners[i];
    if (role[i] == OctantRole::kDeep &&
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return beside[v] != 0; }))
      role[i] = OctantRole::kNear;
  }
}

/// The octree vertices of deep octants.
struct DeepVertices {
  std::vector<std::uint32_t> shared;  ///< on near or band octants too; ascending
  std::vector<std::uint32_t> own;     ///< ascending
};

DeepVertices deep_vertices(const Octree& tree, const OctreeVertices& vertices, const BandAndInterior& split) {
  std::vector<std::uint8_t> deep(vertices.size(), 0), other(vertices.size(), 0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (split.role[i] == OctantRole::kDeep) {
      for (const std::uint32_t v : vertices.corners[i]) deep[v] = 1;
    } else {
      flag_lattice(tree, vertices, OctantId(i), other);
    }
  }
  DeepVertices result;
  for (std::uint32_t v = 0; v < deep.size(); ++v) {
    if (deep[v] != 0) (other[v] != 0 ? result.shared : result.own).push_back(v);
  }
  return result;
}

const OctantTets& template_of(TemplateTable& table, const OctreeVertices& vertices,
                              const OctantLattice& lattice) {
  OctantPattern pattern;
  for (std::size_t b = 0; b < kHangingPoint.size(); ++b)
    if (lattice[kHangingPoint[b]] != kNoVertex) pattern.hanging |= 1u << b;
  for (std::size_t p = 0; p < lattice.size(); ++p)
    if (lattice[p] != kNoVertex) pattern.rank[p] = vertices.rank(lattice[p]);
  return table.tets(pattern);
}

/// Whether an odd number of the octant's coordinates are odd at its own level. It decides the template of an
/// octant where nothing hangs: the four corners that are odd at that level outweigh the others, equally.
bool odd_octant(const Octant& o) { return (((o.corner[0] ^ o.corner[1] ^ o.corner[2]) & o.extent()) != 0); }

/// The two templates of octants without hanging vertices, over their corners (x fastest).
std::array<OctantTets, 2> plain_templates() {
  TemplateTable table;
  std::array<OctantTets, 2> result;
  for (const std::uint32_t odd : {0u, 1u}) {
    OctantPattern pattern;
    for (std::uint32_t c = 0; c < 8; ++c)
      pattern.rank[kCornerPoint[c]] = octree_vertex_rank(2 + odd + (c & 1u), 2 + (c >> 1 & 1u), 2 + (c >> 2));
    for (std::array<std::uint8_t, 4> t : table.tets(pattern)) {
      for (std::uint8_t& p : t)
        p = static_cast<std::uint8_t>(std::find(kCornerPoint.begin(), kCornerPoint.end(), p) -
                                      kCornerPoint.begin());
      result[odd].push_back(t);
    }
  }
  return result;
}

template <class Body>
void parallel_over(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// Without the room to grow that resize() leaves.
template <class Item>
void resize_exactly(std::vector<Item>& items, std::size_t n) {
  items.reserve(n);
  items.resize(n);
}

}  // namespace

BandAndInterior split_interior(const Model& model, const Octree& tree, const OctreeVertices& vertices,
                               const OctreeLabels& labels, const Seeds& seeds, double length) {
  BandAndInterior split;
  const std::vector<OctantId> templates =
      template_octants(model, tree, vertices, labels, seeds.octree_vertex_kept, seeds.points);
  split.templates = templates.size();
  split.role.assign(tree.size(), OctantRole::kBand);
  for (const OctantId o : templates) split.role[o.index()] = OctantRole::kDeep;
  part_near_from_deep(tree, vertices, split.role);
  const std::vector<std::uint8_t> in_band =
      band_vertices(tree, vertices, templates, seeds.octree_vertex_kept, length);
  const SeedPoints& all = seeds.points;
  const auto take = [&](std::size_t n) {
    split.band.add(all.position[n], all.on[n], all.order[n], all.spacing[n]);
    return static_cast<std::uint32_t>(split.band.size() - 1);
  };
  for (std::size_t n = 0; n < seeds.surface_points; ++n) take(n);
  split.band_point.assign(vertices.size(), UINT32_MAX);
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (in_band[v] != 0) split.band_point[v] = take(seeds.octree_point[v]);
  return split;
}

ExtraTets near_tets(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                    const BandAndInterior& split, std::vector<Vec3>& points, std::vector<ModelRef>& on) {
  std::vector<std::uint32_t> number = split.band_point;
  const auto number_of = [&](std::uint32_t v) {
    if (number[v] == UINT32_MAX) {
      number[v] = static_cast<std::uint32_t>(points.size());
      points.push_back(tree.position(vertices.at[v]));
      on.push_back(model_region(labels.vertex_region[v]));
    }
    return number[v];
  };
  ExtraTets extra;
  TemplateTable table;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (split.role[i] != OctantRole::kNear) continue;
    const OctantLattice lattice = octant_lattice(tree, vertices, OctantId(i));
    for (const auto& t : template_of(table, vertices, lattice)) {
      extra.tets.push_back({number_of(lattice[t[0]]), number_of(lattice[t[1]]), number_of(lattice[t[2]]),
                            number_of(lattice[t[3]])});
      extra.region.push_back(labels.region[i]);
    }
  }
  for (const std::uint32_t v : deep_vertices(tree, vertices, split).shared)
    extra.first.push_back(number_of(v));
  extra.covers = [&split, &tree](const Vec3& centroid) {
    return split.role[tree.find(centroid).index()] != OctantRole::kBand;
  };
  return extra;
}

std::vector<double> deep_volumes(const Octree& tree, const OctreeLabels& labels, const BandAndInterior& split,
                                 int regions) {
  std::vector<double> volume(static_cast<std::size_t>(regions) + 1, 0.0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (split.role[i] != OctantRole::kDeep) continue;
    const double length = tree.length(tree[OctantId(i)].level);
    volume[labels.region[i]] += length * length * length;
  }
  return volume;
}

std::size_t append_deep(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, Mesh& mesh) {
  const auto templates = plain_templates();
  std::vector<std::uint32_t> octants;
  for (std::uint32_t i = 0; i < tree.size(); ++i)
    if (split.role[i] == OctantRole::kDeep) octants.push_back(i);
  const DeepVertices deep = deep_vertices(tree, vertices, split);
  const std::size_t first_point = mesh.points.size(), first_tet = mesh.tets.size();
  const std::size_t each = templates[0].size();

  std::vector<std::uint32_t> number(vertices.size(), UINT32_MAX);
  for (std::uint32_t n = 0; n < deep.shared.size(); ++n) number[deep.shared[n]] = n;
  resize_exactly(mesh.points, first_point + deep.own.size());
  resize_exactly(mesh.point_on, first_point + deep.own.size());
  parallel_over(deep.own.size(), [&](std::size_t n) {
    const std::uint32_t v = deep.own[n];
    number[v] = static_cast<std::uint32_t>(first_point + n);
    mesh.points[first_point + n] = tree.position(vertices.at[v]);
    mesh.point_on[first_point + n] = model_region(labels.vertex_region[v]);
  });
  resize_exactly(mesh.tets, first_tet + each * octants.size());
  resize_exactly(mesh.tet_in, first_tet + each * octants.size());
  parallel_over(octants.size(), [&](std::size_t n) {
    const std::uint32_t o = octants[n];
    const auto& corners = vertices.corners[o];
    std::size_t at = first_tet + each * n;
    for (const auto& t : templates[odd_octant(tree[OctantId(o)]) ? 1 : 0]) {
      mesh.tets[at] = {number[corners[t[0]]], number[corners[t[1]]], number[corners[t[2]]],
                       number[corners[t[3]]]};
      mesh.tet_in[at++] = labels.region[o];
    }
  });
  return mesh.tets.size() - first_tet;
}

}  // namespace octet
