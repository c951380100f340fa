// SPDX-License-Identifier: BSD-3-Clause
// One tree and all that was made on it up to the classified band; a finer tree is a new attempt.
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/attribute_points.h"
#include "app/interior.h"
#include "classify/band.h"
#include "delaunay/triangulation.h"
#include "octree/seeds.h"

namespace octet {

/// Stays where it is made: `band` asks it for regions.
struct Attempt {
  explicit Attempt(Octree t) : tree(std::move(t)) {}
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;

  Octree tree;
  OctreeVertices vertices;
  std::vector<OctantEdge> edges;    ///< of boundary octants; until points are placed, like
  std::vector<OctantEdgeCut> cuts;  ///< these
  OctreeLabels labels;              ///< of octants once the tree is cut, of vertices once points are placed
  std::size_t seed_points = 0;      ///< how many points were placed, those of template octants included
  std::size_t surface_points = 0;   ///< how many of them on the boundary
  std::vector<EdgePiece> pieces;    ///< as the seeds have them
  Tips tips;
  BandAndInterior split;
  Triangulation triangulation;
  std::vector<ModelRef> on;  ///< per vertex of the triangulation
  std::unique_ptr<EdgeChains> chains;
  std::unique_ptr<Band> band;
  AttributeResult closed;

  /// Exact region of a point: the octant's label where it has one.
  [[nodiscard]] int region_of(const Model& model, const Vec3& p) const;

  /// Frees what only the band needed, once its mesh has been extracted.
  void forget_band();
};

/// The steps, in this order. `cancelled` is as in cut_octant_edges().
void cut_tree(Attempt& attempt, const Model& model, const std::function<bool()>& cancelled = {});
void place_points(Attempt& attempt, const Model& model, const SeedOptions& options);
void triangulate(Attempt& attempt, const Model& model, const std::function<bool()>& cancelled = {});
void classify(Attempt& attempt);
/// Attribute points until no hole is left or a limit is met; again with other limits, it goes on from there.
void close_holes(Attempt& attempt, const Model& model, double size, AttributeLimits limits,
                 Observer& observer);

/// The vertices of the triangulation, where they are: it is made of rounded places, and a vertex whose own
/// place would turn a tetrahedron inside out stays where it was rounded to.
[[nodiscard]] std::vector<Vec3> points_of(const Attempt& attempt);

/// Gaps of a boundary that crosses itself beyond which nothing more is tried: smaller octants cure none of
/// its crossings, and where these leave few gaps the rest may still close.
inline constexpr std::size_t kHopelessGaps = 1000;

/// Whether a boundary that is known to cross itself does so all over: by the gaps, or because octant edges
/// whose ends and cuts disagree are more than a twentieth of the points on the boundary (a dome of 0.02 mm
/// whose walls cross left one gap, at which octants were subdivided for many minutes, before a look at the
/// faces found them everywhere).
[[nodiscard]] bool crosses_all_over(const Attempt& attempt);

/// How many holes an attempt left. Facets are not looked at while edges lack pieces, so that says the most.
struct Openness {
  bool lacks_pieces = false;
  std::size_t gaps = 0;
  auto operator<=>(const Openness&) const = default;
};
[[nodiscard]] Openness openness(const std::vector<Gap>& gaps);
/// By more than a tenth, which chance does not leave.
[[nodiscard]] bool clearly_less(const Openness& a, const Openness& b);

/// Looks at facets, too, where edges lack pieces: all gaps, in place of the pieces alone.
void find_all_gaps(Attempt& attempt);

/// The tree with the octants around the gaps that are left, and those whose gaps took many points, refined
/// once [Schroeder & Shephard 1990, "Octant subdivision"], and those across thin walls from them
/// (octree/even_walls); octants no longer than `finest` stay. None when none can be refined.
[[nodiscard]] std::optional<Octree> subdivide_at_gaps(const Attempt& attempt, const Model& model,
                                                      double finest);
/// The same for octants around places where a mesh is at fault.
[[nodiscard]] std::optional<Octree> subdivide_at(const Octree& tree, const Model& model,
                                                 const std::vector<Vec3>& places, double finest);

}  // namespace octet
