// SPDX-License-Identifier: BSD-3-Clause
// Nodes are found at the images of others; then edges and triangles are compared by their nodes.
#include "classify/periodic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/sort_unique.h"

namespace octet {
namespace {

using Index = Mesh::Index;

/// The mesh of one entity's closure.
struct Patch {
  std::vector<Index> vertices;                 ///< ascending
  std::vector<std::array<Index, 3>> elements;  ///< a face's triangles, vertices ascending; an edge's pieces
};

/// A mesh edge in the place of a triangle.
std::array<Index, 3> piece(Index a, Index b) { return {std::min(a, b), std::max(a, b), std::max(a, b)}; }

void close(Patch& patch) {
  for (auto& element : patch.elements) {
    patch.vertices.insert(patch.vertices.end(), element.begin(), element.end());
    std::sort(element.begin(), element.end());
  }
  sort_unique(patch.vertices);
}

/// The patches of all entities that are in an orbit.
std::map<ModelRef, Patch> patches_of(const Mesh& mesh, const Periodicity& periodicity) {
  std::map<ModelRef, Patch> patches;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (const ModelRef face = model_face(mesh.triangle_on[t]); periodicity.holds(face))
      patches[face].elements.push_back(mesh.triangles[t]);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (const ModelRef edge = model_edge(mesh.edge_on[e]); periodicity.holds(edge))
      patches[edge].elements.push_back(piece(mesh.edges[e][0], mesh.edges[e][1]));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.point_on[v].dim == 0) patches[mesh.point_on[v]].vertices.push_back(static_cast<Index>(v));
  for (auto& [entity, patch] : patches) close(patch);
  return patches;
}

/// Vertices in cells that are longer than what images may be off.
class NearVertices {
 public:
  NearVertices(const Mesh& mesh, const std::vector<Index>& vertices, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), cell_(4.0 * tolerance) {
    for (const Index v : vertices) cells_[key(index(mesh.points[v]))].push_back(v);
  }

  /// The nearest within the tolerance; none: `none`.
  [[nodiscard]] Index at(const Vec3& p, Index none) const {
    Index best = none;
    double least = tolerance_;
    const auto middle = index(p);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto found = cells_.find(key({middle[0] + i, middle[1] + j, middle[2] + k}));
          if (found == cells_.end()) continue;
          for (const Index v : found->second)
            if (const double d = (mesh_.points[v] - p).norm(); d <= least) {
              least = d;
              best = v;
            }
        }
    return best;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  [[nodiscard]] Cell index(const Vec3& p) const {
    return {std::llround(p.x() / cell_), std::llround(p.y() / cell_), std::llround(p.z() / cell_)};
  }
  /// Two cells may have the same: distances decide.
  [[nodiscard]] static std::uint64_t key(const Cell& c) {
    std::uint64_t k = 0;
    for (const std::int64_t x : c) k = (k ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
    return k ^ k >> 29;
  }

  const Mesh& mesh_;
  double tolerance_, cell_;
  std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

/// Nodes in the middles of edges by the edges' ends.
class Middles {
 public:
  Middles(const Mesh& mesh, const std::map<ModelRef, Patch>& patches) : mesh_(mesh) {
    if (mesh.mid.empty()) return;
    std::vector<bool> wanted(mesh.points.size(), false);
    for (const auto& [entity, patch] : patches)
      for (const Index v : patch.vertices) wanted[v] = true;
    for (std::size_t m = 0; m < mesh.mid.between.size(); ++m) {
      const auto& ends = mesh.mid.between[m];
      if (wanted[ends[0]] && wanted[ends[1]]) nodes_[ends] = static_cast<Index>(mesh.points.size() + m);
    }
  }
  [[nodiscard]] bool any() const { return !mesh_.mid.empty(); }
  [[nodiscard]] Index of(Index a, Index b) const { return nodes_.at({std::min(a, b), std::max(a, b)}); }

 private:
  const Mesh& mesh_;
  std::map<std::array<Index, 2>, Index> nodes_;
};

class Matcher {
 public:
  Matcher(const Mesh& mesh, const Model& model, const Periodicity& periodicity)
      : mesh_(mesh),
        model_(model),
        periodicity_(periodicity),
        patches_(patches_of(mesh, periodicity)),
        middles_(mesh, patches_) {
    match_.claim.name = kPeriodicClaim;
    match_.claim.statement = "Faces that are each other's images have meshes that are so, too.";
    match_.claim.limit = periodicity.tolerance();
  }

  PeriodicMatch run() {
    match_all(0, periodicity_.vertices());
    for (const std::vector<PieceMember>& orbit : periodicity_.pieces())
      if (periodicity_.is_whole(orbit))
        for (std::size_t i = 1; i < orbit.size(); ++i)
          match(model_edge(orbit.front().edge), model_edge(orbit[i].edge), orbit[i].motion);
    match_all(2, periodicity_.faces());
    match_.claim.holds = match_.claim.places.empty();
    return std::move(match_);
  }

 private:
  static constexpr std::size_t kTold = 10;
  static constexpr Index kNone = UINT32_MAX;

  void match_all(int dim, const std::vector<std::vector<OrbitMember>>& orbits) {
    for (const std::vector<OrbitMember>& orbit : orbits)
      for (std::size_t i = 1; i < orbit.size(); ++i)
        match({dim, orbit.front().tag}, {dim, orbit[i].tag}, orbit[i].motion);
  }

  void match(ModelRef source, ModelRef entity, const Motion& motion) {
    const Patch &from = patches_[source], &to = patches_[entity];
    const NearVertices near(mesh_, to.vertices, periodicity_.tolerance());
    std::map<Index, Index> images;
    std::size_t lacking = 0;
    for (const Index v : from.vertices) {
      const Vec3 p = motion(mesh_.points[v]);
      const Index image = near.at(p, kNone);
      if (image == kNone) {
        if (lacking++ == 0) tell(source, entity, p, "a node has no image");
        match_.claim.places.push_back(p);
        continue;
      }
      match_.claim.worst = std::max(match_.claim.worst, (mesh_.points[image] - p).norm());
      images[v] = image;
    }
    if (lacking > 0) return;
    if (from.vertices.size() != to.vertices.size()) {
      lacks(source, entity, surplus(to, images), "a node is no image");
      return;
    }
    std::set<std::array<Index, 3>> elements(to.elements.begin(), to.elements.end());
    std::vector<Vec3> places;
    for (const auto& element : from.elements) {
      std::array<Index, 3> image{images[element[0]], images[element[1]], images[element[2]]};
      std::sort(image.begin(), image.end());
      if (entity.dim == 1) image = piece(image[0], image[2]);
      if (elements.erase(image) == 0)
        places.push_back((mesh_.points[image[0]] + mesh_.points[image[1]] + mesh_.points[image[2]]) / 3.0);
    }
    if (!places.empty() || !elements.empty()) {
      for (const auto& rest : elements)
        if (places.empty()) places.push_back(mesh_.points[rest[0]]);
      lacks(source, entity, places, entity.dim == 2 ? "a triangle has no image" : "a mesh edge has no image");
      return;
    }
    if (middles_.any() && !match_middles(source, entity, motion, from, images)) return;
    link(source, entity, motion, from, images);
  }

  bool match_middles(ModelRef source, ModelRef entity, const Motion& motion, const Patch& from,
                     std::map<Index, Index>& images) {
    std::vector<Vec3> places;
    for_each_side(from, [&](Index a, Index b) {
      const Vec3 p = motion(node(middles_.of(a, b)));
      const double off = (node(middles_.of(images[a], images[b])) - p).norm();
      match_.claim.worst = std::max(match_.claim.worst, off);
      if (off > periodicity_.tolerance()) places.push_back(p);
    });
    if (!places.empty()) lacks(source, entity, places, "a node in the middle of an edge has no image");
    return places.empty();
  }

  [[nodiscard]] const Vec3& node(Index n) const {
    return n < mesh_.points.size() ? mesh_.points[n] : mesh_.mid.points[n - mesh_.points.size()];
  }

  template <class Visit>
  static void for_each_side(const Patch& patch, const Visit& visit) {
    for (const auto& element : patch.elements)
      for (std::size_t i = 0; i < 3; ++i)
        if (element[i] != element[(i + 1) % 3]) visit(element[i], element[(i + 1) % 3]);
  }

  /// Vertices that are no images.
  [[nodiscard]] std::vector<Vec3> surplus(const Patch& patch, const std::map<Index, Index>& images) const {
    std::set<Index> known;
    for (const auto& pair : images) known.insert(pair.second);
    std::vector<Vec3> places;
    for (const Index v : patch.vertices)
      if (known.count(v) == 0) places.push_back(mesh_.points[v]);
    return places;
  }

  void lacks(ModelRef source, ModelRef entity, const std::vector<Vec3>& places, const char* what) {
    tell(source, entity, places.front(), what);
    match_.claim.places.insert(match_.claim.places.end(), places.begin(), places.end());
  }

  void tell(ModelRef source, ModelRef entity, const Vec3& place, const char* what) {
    if (match_.claim.faults.size() >= kTold) return;
    match_.claim.faults.push_back({entity, place,
                                   fmt::format("the mesh of {} is not the image of that of {}: {}",
                                               model_.describe(entity), model_.describe(source), what),
                                   "ask for a smaller size there"});
  }

  void link(ModelRef source, ModelRef entity, const Motion& motion, const Patch& from,
            std::map<Index, Index>& images) {
    PeriodicLink made{entity, source, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        made.motion[4 * i + j] = motion.turn(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      made.motion[4 * i + 3] = motion.shift[static_cast<Eigen::Index>(i)];
    }
    made.motion[15] = 1.0;
    for (const auto& [v, image] : images) made.nodes.push_back({image, v});
    if (middles_.any())
      for_each_side(from, [&](Index a, Index b) {
        made.nodes.push_back({middles_.of(images[a], images[b]), middles_.of(a, b)});
      });
    sort_unique(made.nodes);
    match_.links.push_back(std::move(made));
  }

  const Mesh& mesh_;
  const Model& model_;
  const Periodicity& periodicity_;
  std::map<ModelRef, Patch> patches_;
  Middles middles_;
  PeriodicMatch match_;
};

}  // namespace

PeriodicMatch match_periodic(const Mesh& mesh, const Model& model, const Periodicity& periodicity) {
  return Matcher(mesh, model, periodicity).run();
}

}  // namespace octet
