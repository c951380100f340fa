// SPDX-License-Identifier: BSD-3-Clause
// Keeps the boundary of the mesh by the exact geometry while it is changed.
#pragma once

#include <algorithm>
#include <span>
#include <unordered_map>
#include <vector>

#include "finalize/work_mesh.h"
#include "geom/edge_turn.h"
#include "geom/model.h"

namespace octet {

/// A mesh vertex as one model face sees it. The normal is zero where the face has none (an apex).
struct Seat {
  Vec2 uv = Vec2::Zero();
  Vec3 normal = Vec3::Zero();
};

/// How far triangles are from the faces they are classified on.
struct Fit {
  double turn = 0.0;  ///< largest 1 - cos of the angle between a triangle and the face's exact normals at its
                      ///< vertices; 2 for a triangle without area
  double sag = 0.0;   ///< largest estimated distance of an edge's middle or the centroid to the face
  double bend = 0.0;  ///< largest curvature along an edge, 1/length; not a defect, but what sagittae come of
  double turn_at_first = 0.0, sag_at_first = 0.0;  ///< the largest that the model face had in the mesh given

  void add(const Fit& other) {
    turn = std::max(turn, other.turn);
    sag = std::max(sag, other.sag);
    bend = std::max(bend, other.bend);
    turn_at_first = std::max(turn_at_first, other.turn_at_first);
    sag_at_first = std::max(sag_at_first, other.sag_at_first);
  }
};

/// What an operation adds to a region's volume or a face's area; only operations on curved faces add any.
struct MeasureChange {
  ModelRef of;
  double change = 0.0;
};
/// Of a mesh: volumes per region tag, areas per face tag.
struct Measures {
  std::vector<double> volume, area;
};

/// What they are to be, and how far off they may get.
struct MeasureGoals {
  std::vector<double> volume, volume_error;  ///< per region tag
  std::vector<double> area;                  ///< per face tag; 0 of faces that are not in the mesh
  double area_error = 0.0;                   ///< summed over the faces
};
/// The model's, off by a small share of it at most, or by a tenth more than now.
[[nodiscard]] MeasureGoals goals_of_model(const Model& model, const Measures& now);

/// The farthest that faces and edges are from a mesh, by estimated sagittae.
struct WorstFits {
  std::vector<Fit> face;  ///< per face tag
  double sag = 0.0;       ///< of all, and a twentieth more
  void add(const WorstFits& other);
};

/// Adds to what the list has of that entity.
void add_change(std::vector<MeasureChange>& changes, ModelRef of, double change);

/// Seats of vertices on faces, found once (on all cores), and what a change of the boundary may do. What is
/// const may be asked by many threads at once.
///
/// Why: greedy improvement of angles folds thin curved sheets over their own surface. All vertices stay on
/// the exact geometry, so a triangle can leave it by its sagitta only, and that is bounded by the turn of the
/// exact normals over the triangle; both are held to a bound, or to what was there before.
class BoundaryGuard {
 public:
  /// `volume_beyond`: of what is not in the mesh, per region tag; empty: nothing.
  BoundaryGuard(const Model& model, const WorkMesh& mesh, std::span<const double> volume_beyond = {});

  /// For a mesh that is a part of a whole: volumes and areas to be held to in place of the model's, and how
  /// far off the whole was at first.
  void aim_at(const MeasureGoals& goals, const WorstFits& at_first);
  [[nodiscard]] const WorstFits& at_first() const { return at_first_; }

  [[nodiscard]] bool planar(int face) const { return planar_[static_cast<std::size_t>(face)]; }
  /// Seat of a vertex in the closure of the face.
  [[nodiscard]] Seat seat(const WorkMesh& mesh, VertexId v, int face) const;
  /// The vertex moved (or is new): its seat on the face is now this.
  void set_seat(const WorkMesh& mesh, VertexId v, int face, const Seat& seat);

  /// Parameter of a vertex on its model edge.
  [[nodiscard]] double parameter(VertexId v) const { return parameter_[v.index()]; }
  void set_parameter(VertexId v, double t);

  /// Fit of one triangle that is oriented as the face.
  [[nodiscard]] Fit fit(const WorkMesh& mesh, int face, const std::array<VertexId, 3>& triangle) const;
  /// The same for a vertex at another place.
  [[nodiscard]] static Fit fit(const std::array<Vec3, 3>& points, const std::array<Vec3, 3>& normals);

  /// The worst that triangles made from ones of fit `before` may have, where the local size is `size`: as far
  /// from the face as before or a twentieth more, as long as the face had such at first, or as an edge of
  /// that size is at the curvature there.
  /// What was nearer never gets farther than the farthest of the whole part at first, and a twentieth more,
  /// nor than `room`; what was farther than that is to stay (nothing is within the bound).
  [[nodiscard]] Fit bound(const Fit& before, double size, double room) const;
  [[nodiscard]] static bool within(const Fit& fit, const Fit& bound) {
    return fit.turn <= bound.turn && fit.sag <= bound.sag;
  }

  /// A vertex in the closure of a model edge; `last` tells the ends apart.
  [[nodiscard]] OnEdge on_edge(const WorkMesh& mesh, VertexId v, int edge, bool last) const;
  /// Distance of the middle of a piece of a model edge from its chord.
  [[nodiscard]] double piece_sag(int edge, const OnEdge& from, const OnEdge& to) const;
  /// The same in the mesh; `tag` as `piece_on` has it.
  [[nodiscard]] double piece_sag(const WorkMesh& mesh, VertexId a, VertexId b, std::int32_t tag) const;
  /// The same for pieces of a model edge made from ones that were `before` from it.
  [[nodiscard]] double piece_bound(double before, double room) const;

  /// Whether volumes and areas may change so: each region's volume nearer to the exact one, or within a small
  /// share of it, or a tenth beyond the error that was there at first; the same of the sum of the faces'
  /// errors of area while areas are guarded.
  [[nodiscard]] bool admits(std::span<const MeasureChange> changes) const;
  void take(std::span<const MeasureChange> changes);
  /// Volumes and areas as the mesh is now, `volume_beyond` included.
  [[nodiscard]] const Measures& measures() const { return measures_; }
  /// Sum of the faces' errors of area as the mesh is now.
  [[nodiscard]] double area_error() const { return area_error_; }
  /// To be asked for where the worst elements are chased: there collapses would make fillets coarser. Else
  /// guarded areas do harm: a surface that smoothing makes even has less of it than one that was uneven by
  /// chance.
  void guard_areas(bool guarded) { areas_guarded_ = guarded; }

  /// What is set and taken from here on can be taken back, until the journal is closed; vertices from number
  /// `vertices` on are new then.
  void open_journal(std::size_t vertices);
  void close_journal() { journal_.open = false; }
  void take_back();

 private:
  /// What was there before, in the order of the changes.
  struct Journal {
    struct OnRim {
      std::uint64_t key;
      bool known;
      Seat seat;
    };
    bool open = false;
    std::size_t vertices = 0;
    std::vector<std::pair<VertexId, Seat>> on_face;
    std::vector<OnRim> on_rim;
    std::vector<std::pair<VertexId, double>> parameter;
    std::vector<std::pair<ModelRef, double>> measure;
    double area_error = 0.0;
  };

  void seat_all(const WorkMesh& mesh);
  /// visit(face, corners) for each triangle on a face that is no plane, as the face is turned.
  template <class Visit>
  void for_each_curved_triangle(const WorkMesh& mesh, const Visit& visit) const;
  void measure_volumes(const WorkMesh& mesh, std::span<const double> volume_beyond);
  void measure_areas(const WorkMesh& mesh);
  [[nodiscard]] double sum_area_errors() const;
  [[nodiscard]] double& measure(ModelRef of) {
    return (of.dim == 3 ? measures_.volume : measures_.area)[static_cast<std::size_t>(of.tag)];
  }
  void measure_faces(const WorkMesh& mesh);
  void measure_pieces(const WorkMesh& mesh);
  [[nodiscard]] Seat project(const WorkMesh& mesh, VertexId v, int face) const;
  /// What the change adds to the sum of the faces' errors of area.
  [[nodiscard]] double area_error_by(const MeasureChange& change) const;

  const Model* model_;
  std::vector<char> planar_;        ///< per face tag
  std::vector<Vec3> plane_normal_;  ///< per face tag
  WorstFits at_first_;
  std::vector<Seat> on_face_;                       ///< per vertex: of vertices inside a face
  std::vector<char> on_face_known_;                 ///< per vertex
  std::unordered_map<std::uint64_t, Seat> on_rim_;  ///< (vertex, face): of vertices on edges; looked up only
  std::vector<double> parameter_;                   ///< per vertex: of vertices on edges
  Measures measures_;
  MeasureGoals goals_;
  double area_error_ = 0.0;  ///< sum of the faces' errors of area
  bool areas_guarded_ = false;
  Journal journal_;
};

}  // namespace octet
