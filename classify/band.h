// SPDX-License-Identifier: BSD-3-Clause
// The band of tetrahedra around the boundary as classification sees it, kept up to date as points are
// inserted.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/seed_points.h"
#include "geom/model.h"
#include "mesh/tet_mesh.h"

namespace octet {

/// Region tag of the model that holds a point, 0 outside; must be exact and callable from several threads.
using RegionOf = std::function<int(const Vec3&)>;

/// A face between two tetrahedra of different regions, or of one region on either side of a face embedded in
/// it.
struct BoundaryFacet {
  TetId tet;                  ///< the side with the larger region tag; at an embedded face the one behind it
  std::int8_t local = 0;      ///< face of `tet`
  std::int32_t face = 0;      ///< model face it is classified on, 0: none fits (a gap)
  std::array<VertexId, 3> v;  ///< counter-clockwise seen from outside `tet`
};

/// The chains of mesh vertices on the real model edges, as pieces found by their two ends.
class EdgeChains {
 public:
  explicit EdgeChains(std::vector<EdgePiece> pieces);

  [[nodiscard]] const std::vector<EdgePiece>& pieces() const { return pieces_; }
  [[nodiscard]] const EdgePiece& operator[](std::uint32_t n) const { return pieces_[n]; }
  /// Number of the piece that joins two points, or UINT32_MAX.
  [[nodiscard]] std::uint32_t find(VertexId a, VertexId b) const;
  /// Number of the piece of `edge` that holds parameter t.
  [[nodiscard]] std::uint32_t piece_at(int edge, double t) const;
  /// Replaces piece n by two that meet in `point`; the first keeps the number.
  void split(std::uint32_t n, VertexId point, double t);

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return a < b ? (std::uint64_t{a} << 32 | b) : (std::uint64_t{b} << 32 | a);
  }
  std::vector<EdgePiece> pieces_;
  std::unordered_map<std::uint64_t, std::uint32_t> by_ends_;
  std::vector<std::vector<std::uint32_t>> by_edge_;  ///< per model edge, piece numbers in order of t
};

/// Regions of the tetrahedra and model faces of the facets.
///
/// Invariant: `region` is that of the octree vertices of a live tetrahedron seen by update(), of its
/// circumcentre where it has none, 0 for ghosts, until repair() moves it. Where all are the circumcentre's
/// the facets between different regions are the restricted Delaunay triangulation of the boundary.
/// [docs/classification.md]
///
/// A face embedded in a region parts no regions: there a facet is a face whose two tetrahedra have their
/// places on either side of it. The places around an edge of the mesh make a closed polygon, which goes
/// through the embedded face an even number of times unless it winds about the face's border; so these facets
/// make a surface that ends at the border, as those between regions make one that ends nowhere.
class Band {
 public:
  Band(const Model& model, RegionOf region_of);

  /// Labels the given tetrahedra anew. `on` gives the classification of every vertex of the mesh.
  void update(const TetMesh& mesh, std::span<const ModelRef> on, std::span<const TetId> created);

  /// Moves tetrahedra of boundary points alone to the region across a facet that fits no model face, where
  /// that leaves fewer such facets around them: at cusps and creases a circumcentre may fall just beyond the
  /// boundary. Returns how many moved.
  std::size_t repair(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains);

  /// Labels the tetrahedra around the given pieces, whose fans lack facets, anew: beside an edge of the model
  /// it is known where a region begins, while a circumcentre may lie far beyond a thin gap there. Returns how
  /// many moved.
  std::size_t repair_beside(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                            std::span<const std::uint32_t> pieces);

  [[nodiscard]] int region(TetId t) const { return region_[t]; }
  /// Region that the tetrahedron has by itself, before any repair; none where it is flat.
  [[nodiscard]] std::optional<int> own_region(const TetMesh& mesh, std::span<const ModelRef> on,
                                              TetId t) const;
  /// Whether face f of t is a facet, of t or of its neighbour.
  [[nodiscard]] bool is_facet(const TetMesh& mesh, TetId t, std::int8_t f) const;
  /// Region of the model that holds p, 0 outside.
  [[nodiscard]] int region_of(const Vec3& p) const { return region_of_(p); }
  /// All facets, ascending by tetrahedron; those of the last call that did not
  /// change keep their classification without new queries.
  [[nodiscard]] const std::vector<BoundaryFacet>& facets(const TetMesh& mesh, std::span<const ModelRef> on);
  /// Corners of facets that came or went since this was asked last, in any order, some more than once. Those
  /// that came with the first list are not among them.
  [[nodiscard]] std::vector<VertexId> take_changed() { return std::exchange(changed_, {}); }

  [[nodiscard]] const Model& model() const { return *model_; }

 private:
  std::size_t repair_singly(const TetMesh& mesh, std::span<const ModelRef> on);
  std::size_t repair_in_groups(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains);
  /// Tetrahedra around a misfit, which are parted into two regions anew.
  struct Group {
    int first, second;
    std::vector<TetId> tets;
  };
  /// No tetrahedron is in two.
  struct Groups {
    explicit Groups(std::size_t tets) : of_tet(tets, UINT32_MAX) {}
    [[nodiscard]] bool has(TetId t) const { return of_tet[t.index()] != UINT32_MAX; }
    std::vector<Group> all;
    std::vector<std::uint32_t> of_tet;  ///< number of its group, or UINT32_MAX
  };
  void add_group(const TetMesh& mesh, std::span<const ModelRef> on, TetId a, TetId b, Group group,
                 Groups& groups) const;
  std::size_t relabel(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                      const Groups& groups);
  [[nodiscard]] std::vector<std::uint8_t> labels_of(const TetMesh& mesh, std::span<const ModelRef> on,
                                                    const EdgeChains& chains, const Group& group) const;
  /// What a tetrahedron of a group says of its region: at its circumcentre (kNowhere where that is not
  /// reliable), and beside those of its edges that are pieces of model edges (kNowhere beside others).
  struct Voice {
    std::int32_t circumcentre;
    std::array<std::int32_t, 6> beside;
  };
  static constexpr std::int32_t kNowhere = -1;
  [[nodiscard]] Voice voice_of(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
                               TetId t) const;
  void hear(const TetMesh& mesh, std::span<const ModelRef> on, const EdgeChains& chains,
            const std::vector<Group>& groups);
  [[nodiscard]] int region_beside(const TetMesh& mesh, TetId t, const EdgePiece& piece) const;
  [[nodiscard]] bool misfit(const TetMesh& mesh, std::span<const ModelRef> on, TetId t, std::int8_t f,
                            int behind, int front) const;
  [[nodiscard]] bool movable(const TetMesh& mesh, std::span<const ModelRef> on, TetId t) const;
  [[nodiscard]] int misfits(const TetMesh& mesh, std::span<const ModelRef> on, TetId t, int region) const;
  void move(const TetMesh& mesh, TetId t, int region);
  void forget_facets(const TetMesh& mesh, TetId t);
  void forget_faces_of(const TetMesh& mesh, TetId t);
  void list_facets(const TetMesh& mesh, TetId t, std::uint8_t faces, std::vector<BoundaryFacet>& found) const;
  void list_stale_facets(const TetMesh& mesh);
  /// Whether the way from the place of one tetrahedron to that of its neighbour, in one region, goes through
  /// faces embedded in that an odd number of times: 1 where the first is met along its normal, -1 where
  /// against it, else 0.
  [[nodiscard]] int passage(const TetMesh& mesh, TetId from, TetId to) const;
  [[nodiscard]] Vec3 side_place(const TetMesh& mesh, TetId t, int steps) const;
  [[nodiscard]] bool is_through_embedded(const Hit& hit) const;
  void label_flat(const TetMesh& mesh, const std::vector<TetId>& flat);
  [[nodiscard]] int classify_facet(const TetMesh& mesh, std::span<const ModelRef> on,
                                   const BoundaryFacet& facet, int region_behind, int region_front) const;
  [[nodiscard]] double slack_of(std::span<const ModelRef> on, const BoundaryFacet& facet) const;
  /// `foot`: of the facet's centroid on the face's surface; `slack`: slack_of().
  [[nodiscard]] bool fits(const TetMesh& mesh, const BoundaryFacet& facet, int face, const FaceFoot& foot,
                          double slack, int region_front) const;
  [[nodiscard]] const std::vector<int>& faces_of(ModelRef on) const;
  [[nodiscard]] bool share_a_face(ModelRef a, ModelRef b) const;
  [[nodiscard]] Vec3 place_of(const TetMesh& mesh, std::span<const ModelRef> on, TetId t,
                              const Vec3& centre) const;

  const Model* model_;
  RegionOf region_of_;
  IdVector<TetId, std::int32_t> region_;
  std::unordered_map<std::uint32_t, Voice> voice_;  ///< per tetrahedron of a group, until it is gone
  std::vector<BoundaryFacet> facets_;
  bool facets_are_current_ = false;
  /// Faces of a tetrahedron, a bit each, that are no longer what they were when facets_ were listed.
  struct Stale {
    TetId tet;
    std::uint8_t faces;
  };
  std::vector<Stale> stale_;
  std::vector<VertexId> changed_;
  std::vector<std::vector<int>> vertex_faces_;  ///< per model vertex tag: faces whose closure holds it
  std::vector<std::vector<int>> face_itself_;   ///< per face tag: {tag}
  std::vector<std::vector<Box3>> embedded_;     ///< per region tag: boxes of the faces embedded in it
  bool has_embedded_ = false;
};

}  // namespace octet
