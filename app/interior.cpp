// SPDX-License-Identifier: BSD-3-Clause
// Template octants: their points kept out of the band, their tetrahedra written down.
#include "app/interior.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "base/blocks.h"

namespace octet {
namespace {

/// Octants and vertices a task.
constexpr std::size_t kGrain = 4096;

template <class Body>
void parallel_over(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// From several threads at once.
void flag(std::uint8_t& flagged) { std::atomic_ref(flagged).store(1, std::memory_order_relaxed); }

/// Vertices on the octants for which `wanted`.
template <class Wanted>
std::vector<std::uint8_t> vertices_of(const OctreeVertices& vertices, std::size_t octants,
                                      const Wanted& wanted) {
  std::vector<std::uint8_t> flags(vertices.size(), 0);
  parallel_over(octants, [&](std::size_t o) {
    if (wanted(o)) for_each_vertex(vertices, OctantId(o), [&](std::uint32_t v) { flag(flags[v]); });
  });
  return flags;
}

/// Deep octants that share a vertex with one that is of the band become near.
void part_near_from_deep(const OctreeVertices& vertices, std::vector<OctantRole>& role) {
  const std::vector<std::uint8_t> beside =
      vertices_of(vertices, role.size(), [&](std::size_t o) { return role[o] == OctantRole::kBand; });
  parallel_over(role.size(), [&](std::size_t i) {
    const auto& corners = vertices.corners[i];
    if (role[i] == OctantRole::kDeep &&
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return beside[v] != 0; }))
      role[i] = OctantRole::kNear;
  });
}

/// Corners (x fastest) of the upper face of an octant, per axis, counter-clockwise seen from above.
constexpr std::array<std::array<std::uint8_t, 4>, 3> kUpperFace{{{1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}}};

/// Two template octants of one level that share a face, and the four tetrahedra there:
///
///       f3 ------ f2       l is the centre of the lower octant, u of the upper, f the corners of the face
///       |    u    |        counter-clockwise seen from u: tetrahedra (l, u, f[i], f[i+1]). The lattice of
///       |    l    |        vertices and centres has no other tetrahedra, and no ties.
///       f0 ------ f1
struct SharedFace {
  std::uint32_t lower = 0, upper = 0;  ///< octants
  std::uint8_t axis = 0;
};

template <class Number>
void add_tets(const OctreeVertices& vertices, const SharedFace& face, const Number& number_of,
              std::array<std::uint32_t, 4>* tets) {
  std::array<std::uint32_t, 4> rim;
  for (int i = 0; i < 4; ++i) rim[i] = number_of(vertices.corners[face.lower][kUpperFace[face.axis][i]]);
  const std::uint32_t lower = number_of(vertices.centre(OctantId(face.lower)));
  const std::uint32_t upper = number_of(vertices.centre(OctantId(face.upper)));
  for (int i = 0; i < 4; ++i) tets[i] = {lower, upper, rim[i], rim[(i + 1) % 4]};
}

void find_faces(const Octree& tree, BandAndInterior& split) {
  split.near = split.deep = OctantFaces(tree.size());
  parallel_over(tree.size(), [&](std::size_t o) {
    if (split.role[o] == OctantRole::kBand) return;
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<OctantId> upper = tree.across(OctantId(o), axis, true);
      if (!upper) continue;
      const OctantRole lower_role = std::min(split.role[o], split.role[upper->index()]);
      if (lower_role == OctantRole::kBand) continue;
      OctantFaces& faces = lower_role == OctantRole::kNear ? split.near : split.deep;
      faces.add(o, axis, true);
      faces.add(upper->index(), axis, false);
    }
  });
}

/// Each once, with its octants.
std::vector<SharedFace> shared_faces(const Octree& tree, const OctantFaces& faces) {
  return collect<SharedFace>(tree.size(), [&](std::size_t o, std::vector<SharedFace>& found) {
    if (!faces.any(o)) return;
    for (std::uint8_t axis = 0; axis < 3; ++axis)
      if (faces.has(o, axis, true))
        found.push_back({static_cast<std::uint32_t>(o), tree.across(OctantId(o), axis, true)->index(), axis});
  });
}

/// The octree vertices of deep tetrahedra.
struct DeepVertices {
  std::vector<std::uint32_t> shared;  ///< of near or band tetrahedra too; ascending
  std::vector<std::uint32_t> own;     ///< ascending
};

DeepVertices deep_vertices(const Octree& tree, const OctreeVertices& vertices, const BandAndInterior& split) {
  std::vector<std::uint8_t> other =
      vertices_of(vertices, tree.size(), [&](std::size_t o) { return split.role[o] != OctantRole::kDeep; });
  std::vector<std::uint8_t> deep(vertices.size(), 0);
  parallel_over(tree.size(), [&](std::size_t o) {
    if (!split.deep.any(o)) return;
    const std::uint32_t centre = vertices.centre(OctantId(o));
    flag(deep[centre]);
    if (!split.deep.all(o)) flag(other[centre]);
    for (int axis = 0; axis < 3; ++axis)
      if (split.deep.has(o, axis, true))
        for (const std::uint8_t corner : kUpperFace[axis]) flag(deep[vertices.corners[o][corner]]);
  });
  const auto those = [&](bool shared) {
    return collect<std::uint32_t>(deep.size(), [&](std::size_t v, std::vector<std::uint32_t>& found) {
      if (deep[v] != 0 && (other[v] != 0) == shared) found.push_back(static_cast<std::uint32_t>(v));
    });
  };
  return {those(true), those(false)};
}

/// Whether the place lies in the four tetrahedra between two template octants: in the pyramid of one of them
/// over a face to the other.
bool is_between_templates(const Octree& tree, const BandAndInterior& split, const Vec3& place) {
  const OctantId o = tree.find(place);
  if (split.role[o.index()] == OctantRole::kBand) return false;
  const Vec3 off = place - tree.box(o).centre();
  Eigen::Index axis = 0;
  off.cwiseAbs().maxCoeff(&axis);
  const int side = static_cast<int>(axis);
  return split.near.has(o.index(), side, off[axis] > 0.0) || split.deep.has(o.index(), side, off[axis] > 0.0);
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
  part_near_from_deep(vertices, split.role);
  find_faces(tree, split);
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
  const std::vector<SharedFace> faces = shared_faces(tree, split.near);
  extra.tets.resize(4 * faces.size());
  extra.region.resize(4 * faces.size());
  for (std::size_t n = 0; n < faces.size(); ++n) add_tets(vertices, faces[n], number_of, &extra.tets[4 * n]);
  parallel_over(faces.size(),
                [&](std::size_t n) { std::fill_n(&extra.region[4 * n], 4, labels.region[faces[n].lower]); });
  for (const std::uint32_t v : deep_vertices(tree, vertices, split).shared)
    extra.first.push_back(number_of(v));
  extra.covers = [&split, &tree](const Vec3& centroid) {
    return is_between_templates(tree, split, centroid);
  };
  // Between template octants are octree vertices alone.
  const std::vector<std::uint64_t>& order = split.band.order;
  extra.first_covered = static_cast<std::uint32_t>(
      std::find_if(order.begin(), order.end(), is_octree_vertex_rank) - order.begin());
  extra.last_covered = static_cast<std::uint32_t>(order.size());
  return extra;
}

std::vector<double> deep_volumes(const Octree& tree, const OctreeLabels& labels, const BandAndInterior& split,
                                 int regions) {
  std::vector<double> volume(static_cast<std::size_t>(regions) + 1, 0.0);
  for (std::size_t o = 0; o < tree.size(); ++o) {
    if (!split.deep.any(o)) continue;
    const double length = tree.length(tree[OctantId(o)].level);
    for (int axis = 0; axis < 3; ++axis)
      if (split.deep.has(o, axis, true)) volume[labels.region[o]] += length * length * length / 3.0;
  }
  return volume;
}

std::size_t append_deep(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, Mesh& mesh) {
  const std::vector<SharedFace> faces = shared_faces(tree, split.deep);
  const DeepVertices deep = deep_vertices(tree, vertices, split);
  const std::size_t first_point = mesh.points.size(), first_tet = mesh.tets.size();

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
  resize_exactly(mesh.tets, first_tet + 4 * faces.size());
  resize_exactly(mesh.tet_in, first_tet + 4 * faces.size());
  parallel_over(faces.size(), [&](std::size_t n) {
    const std::size_t at = first_tet + 4 * n;
    add_tets(
        vertices, faces[n], [&](std::uint32_t v) { return number[v]; }, &mesh.tets[at]);
    std::fill_n(&mesh.tet_in[at], 4, labels.region[faces[n].lower]);
  });
  return mesh.tets.size() - first_tet;
}

}  // namespace octet
