// SPDX-License-Identifier: BSD-3-Clause
// Topological holes: where the mesh does not cover a model edge or face, and the points that may close them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/fault.h"
#include "classify/band.h"
#include "classify/expected_faces.h"

namespace octet {

enum class GapKind {
  kMissingPiece,  ///< no mesh edge joins two consecutive points of a model edge
  kNoFace,        ///< a facet whose vertices, distance or normal fit no model face
  kEdgeFan,       ///< a mesh edge whose facets are not those of its model entity
  kVertexFan,     ///< a vertex whose facets are not one disk (one fan a face corner)
  kBareVertex,    ///< a point on the boundary with no facet at all
  kBareFace,      ///< a model face with no facet at all: it lies between the octants' edges
  kDualCrossing,  ///< a facet whose dual segment crosses its face more than once, or a face far from it
};

/// One hole. `piece` is set for kMissingPiece and for fans of a piece; `tet` and `local` (a facet) for the
/// others but kBareVertex and kBareFace.
struct Gap {
  GapKind kind = GapKind::kNoFace;
  ModelRef entity;
  Vec3 place = Vec3::Zero();
  std::uint32_t piece = UINT32_MAX;
  VertexId vertex;
  TetId tet;
  std::int8_t local = -1;
};

/// What find_gaps() looks at where edges lack pieces.
enum class GapScope {
  kPiecesFirst,  ///< only pieces are reported: the facets around a missing one mean nothing yet
  kAll,          ///< facets, too: to tell which regions are whole, and to close what lies elsewhere
};

/// All holes of the band, edges first. [Schroeder & Shephard 1990, "Classification and compatibility";
/// Handbook 15.5.2.2]
[[nodiscard]] std::vector<Gap> find_gaps(Band& band, const TetMesh& mesh, std::span<const ModelRef> on,
                                         const EdgeChains& chains, GapScope scope = GapScope::kPiecesFirst);

/// What a search for holes has seen, so that the next one looks at what changed alone. For one band, of which
/// no search with another memory, or without one, may be made in between: it would take what changed.
class GapMemory {
 public:
  /// Tells of tetrahedra that came since the last search.
  void add(const TetMesh& mesh, std::span<const TetId> created);
  /// Tells that an edge piece at this vertex has changed.
  void ask_again(VertexId v);

 private:
  friend class GapFinder;
  enum Fan : std::uint8_t { kAsk, kPlain, kWhole };
  std::optional<ExpectedFaces> expected_;  ///< of the band's model, once facets have been looked at
  std::vector<std::uint8_t> touched_;  ///< per vertex: whether a tetrahedron came there; those beyond are new
  std::vector<std::uint8_t> present_;  ///< per piece: whether it was an edge of the mesh
  std::vector<std::uint8_t> fans_;     ///< per vertex: a Fan
};

/// As find_gaps() without a memory: the same gaps.
[[nodiscard]] std::vector<Gap> find_gaps(Band& band, const TetMesh& mesh, std::span<const ModelRef> on,
                                         const EdgeChains& chains, GapMemory& memory,
                                         GapScope scope = GapScope::kPiecesFirst);

/// A point on the boundary that may close a hole.
struct AttributePoint {
  Vec3 point = Vec3::Zero();
  ModelRef on;                 ///< face or edge
  double t = 0.0;              ///< on an edge: its parameter
  Vec3 normal = Vec3::Zero();  ///< on a face
  double clearance = 0.0;      ///< distance to the facet's or piece's vertices
};

/// For a piece: the point that splits it, at a power-of-two distance from an end that is a model vertex
/// (concentric shells), else at half its length.
[[nodiscard]] AttributePoint split_point(const Model& model, const TetMesh& mesh,
                                         std::span<const ModelRef> on, const EdgePiece& piece);

/// For a facet: the crossing of its dual segment with the boundary that is farthest from its vertices; the
/// dual goes on from a circumcentre to the octree vertices of its tetrahedron, which say where that lies.
/// When there is none, the foot of the facet's centroid. None when all are closer than `floor` to a vertex.
[[nodiscard]] std::optional<AttributePoint> facet_point(const Model& model, const TetMesh& mesh,
                                                        std::span<const ModelRef> on, TetId tet, int local,
                                                        double floor);

/// For a tetrahedron that lies where its octree vertices do although its circumcentre lies elsewhere: the
/// crossing between them that is farthest from its other vertices. None when it has no such vertices or
/// crossings, or all are closer than `floor` to a vertex.
[[nodiscard]] std::optional<AttributePoint> reach_point(const Model& model, const TetMesh& mesh,
                                                        std::span<const ModelRef> on, TetId tet,
                                                        double floor);

/// For a face of a tetrahedron whose dual segment crosses the boundary more often than it shows (a facet
/// once, other faces never), at a thin wall or a narrow hole or where misfits were relabelled away: the
/// crossing of a model face that is farthest from its corners.
[[nodiscard]] std::optional<AttributePoint> hidden_sheet_point(const Model& model, const TetMesh& mesh,
                                                               std::span<const ModelRef> on, TetId tet,
                                                               int local, bool is_facet, double floor);

/// Gaps in the user's terms: one fault for those of a kind on an entity, at the first of them.
[[nodiscard]] std::vector<Fault> describe_gaps(const Model& model, std::span<const Gap> gaps);

}  // namespace octet
