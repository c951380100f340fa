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

/// Deep octants that share a vertex with one that is of the band become near.
void part_near_from_deep(const OctreeVertices& vertices, std::vector<OctantRole>& role) {
  std::vector<std::uint8_t> beside(vertices.size(), 0);
  for (std::size_t i = 0; i < role.size(); ++i)
    if (role[i] == OctantRole::kBand) flag_vertices(vertices, OctantId(i), beside);
  for (std::size_t i = 0; i < role.size(); ++i) {
    const auto& corners = vertices.corners[i];
    if (role[i] == OctantRole::kDeep &&
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) { return beside[v] != 0; }))
      role[i] = OctantRole::kNear;
  }
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

/// The faces between template octants whose lower role is this.
std::vector<SharedFace> shared_faces(const Octree& tree, const BandAndInterior& split, OctantRole wanted) {
  return collect<SharedFace>(tree.size(), [&](std::size_t o, std::vector<SharedFace>& faces) {
    if (split.role[o] < wanted) return;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      const std::optional<OctantId> upper = tree.across(OctantId(o), axis, true);
      if (upper && std::min(split.role[o], split.role[upper->index()]) == wanted)
        faces.push_back({static_cast<std::uint32_t>(o), upper->index(), axis});
    }
  });
}

/// The octree vertices of deep tetrahedra.
struct DeepVertices {
  std::vector<std::uint32_t> shared;  ///< of near or band tetrahedra too; ascending
  std::vector<std::uint32_t> own;     ///< ascending
};

DeepVertices deep_vertices(const Octree& tree, const OctreeVertices& vertices, const BandAndInterior& split,
                           const std::vector<SharedFace>& faces) {
  std::vector<std::uint8_t> deep(vertices.size(), 0), other(vertices.size(), 0), shares(tree.size(), 0);
  for (const SharedFace& face : faces) {
    for (const std::uint8_t corner : kUpperFace[face.axis]) deep[vertices.corners[face.lower][corner]] = 1;
    for (const std::uint32_t o : {face.lower, face.upper}) {
      deep[vertices.centre(OctantId(o))] = 1;
      ++shares[o];
    }
  }
  for (std::size_t o = 0; o < tree.size(); ++o) {
    if (split.role[o] != OctantRole::kDeep) flag_vertices(vertices, OctantId(o), other);
    if (shares[o] < 6) other[vertices.centre(OctantId(o))] = 1;
  }
  DeepVertices result;
  for (std::uint32_t v = 0; v < deep.size(); ++v) {
    if (deep[v] != 0) (other[v] != 0 ? result.shared : result.own).push_back(v);
  }
  return result;
}

template <class Body>
void parallel_over(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, kGrain), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
  });
}

/// Whether the place lies in the four tetrahedra between two template octants: in the pyramid of one of them
/// over a face to the other.
bool is_between_templates(const Octree& tree, const BandAndInterior& split, const Vec3& place) {
  const OctantId o = tree.find(place);
  if (split.role[o.index()] == OctantRole::kBand) return false;
  const Vec3 off = place - tree.box(o).centre();
  Eigen::Index axis = 0;
  off.cwiseAbs().maxCoeff(&axis);
  const std::optional<OctantId> other = tree.across(o, static_cast<int>(axis), off[axis] > 0.0);
  return other && split.role[other->index()] != OctantRole::kBand;
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
  for (const SharedFace& face : shared_faces(tree, split, OctantRole::kNear)) {
    extra.tets.resize(extra.tets.size() + 4);
    add_tets(vertices, face, number_of, &extra.tets[extra.tets.size() - 4]);
    extra.region.insert(extra.region.end(), 4, labels.region[face.lower]);
  }
  for (const std::uint32_t v :
       deep_vertices(tree, vertices, split, shared_faces(tree, split, OctantRole::kDeep)).shared)
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
  for (const SharedFace& face : shared_faces(tree, split, OctantRole::kDeep)) {
    const double length = tree.length(tree[OctantId(face.lower)].level);
    volume[labels.region[face.lower]] += length * length * length / 3.0;
  }
  return volume;
}

std::size_t append_deep(const Octree& tree, const OctreeVertices& vertices, const OctreeLabels& labels,
                        const BandAndInterior& split, Mesh& mesh) {
  const std::vector<SharedFace> faces = shared_faces(tree, split, OctantRole::kDeep);
  const DeepVertices deep = deep_vertices(tree, vertices, split, faces);
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
