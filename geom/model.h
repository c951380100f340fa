// SPDX-License-Identifier: BSD-3-Clause
// The part: a non-manifold boundary representation with exact queries.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/fault.h"
#include "base/model_ref.h"
#include "base/vec.h"
#include "geom/facets.h"
#include "geom/provenance.h"
#include "geom/surface.h"

namespace octet {

/// What an edge is to the mesh.
enum class EdgeUse {
  kReal,        ///< covered by a chain of mesh edges
  kSeam,        ///< closes a periodic face: no mesh edges asked
  kDegenerate,  ///< no length (pole, apex): no mesh edges asked
};

struct ModelVertex {
  Vec3 point = Vec3::Zero();
  std::vector<int> edges;  ///< all edges that end here, ascending, once each
  double tolerance = 0.0;
  std::string name;
};

struct ModelEdge {
  std::array<int, 2> vertex{0, 0};  ///< start, end; equal for a closed edge
  double t0 = 0.0, t1 = 0.0;        ///< parameter range of the curve, t0 < t1
  EdgeUse use = EdgeUse::kReal;
  std::vector<int> faces;  ///< faces that it bounds, ascending, once each
  double length = 0.0;
  double tolerance = 0.0;  ///< measured gap between the 3D curve and the faces' boundaries
  std::string name;
  std::string colour, layer;  ///< as for faces
};

struct FaceBoundary {
  int edge = 0;
  int sense = 1;  ///< +1: the face lies to the left of the edge seen against the face normal
};

struct ModelFace {
  std::vector<FaceBoundary> boundary;  ///< seams appear twice, with both senses
  std::vector<int> vertices;           ///< all vertices in the closure, ascending
  std::array<int, 2> region{0, 0};     ///< [0] behind the normal, [1] in front of it; 0 = outside
  bool reversed = false;               ///< face normal = -(du x dv)
  int euler = 1;                       ///< Euler characteristic of the closed face as a point set
  double area = 0.0;
  double tolerance = 0.0;
  std::string name;
  std::string colour;  ///< "#rrggbb" or empty
  std::string layer;   ///< several are separated by ", "
};

struct ModelRegion {
  std::vector<int> faces;  ///< ascending, once each
  double volume = 0.0;     ///< by adaptive integration of the exact boundary
  std::string name;
  std::string colour, layer, material;
  double density = 0.0;  ///< of the material, g/cm^3; 0: not given
};

enum class HitKind { kTransversal, kTangent, kCoincident };

/// One event of a segment with the model's boundary: one per edge or vertex, however many faces meet there.
struct Hit {
  double t = 0.0;              ///< 0..1 along the segment
  Vec3 point = Vec3::Zero();   ///< exact point
  ModelRef on;                 ///< face; or the edge or vertex within whose tolerance it lies
  int face = 0;                ///< a face that reports it
  Vec2 uv = Vec2::Zero();      ///< on `face`
  Vec3 normal = Vec3::Zero();  ///< of `face`, unit, pointing to region[1]
  HitKind kind = HitKind::kTransversal;
  bool end_point = false;  ///< within tolerance of an end of the segment
};

/// A nearest point on the model's boundary.
struct Foot {
  Vec3 point = Vec3::Zero();
  double distance = 0.0;
  ModelRef on;                 ///< face, edge or vertex
  int face = 0;                ///< a face that holds it
  Vec2 uv = Vec2::Zero();      ///< on `face`
  Vec3 normal = Vec3::Zero();  ///< of `face` there, unit, pointing to region[1]
};

/// A foot on one face's surface, for moving a mesh vertex that is classified on the face.
struct FaceFoot {
  Vec3 point = Vec3::Zero();
  Vec2 uv = Vec2::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, pointing to region[1]
  bool converged = false;
};

struct EdgeFoot {
  double t = 0.0;
  Vec3 point = Vec3::Zero();
  double distance = 0.0;
};

/// All that makes a model; filled by geom/occt or by geom/analytic. Arrays are indexed by tag, [0] unused.
struct ModelParts {
  std::vector<ModelVertex> vertices;
  std::vector<ModelEdge> edges;
  std::vector<ModelFace> faces;
  std::vector<ModelRegion> regions;
  std::vector<std::shared_ptr<const Curve>> curves;      ///< per edge; null for degenerate edges
  std::vector<std::shared_ptr<const Surface>> surfaces;  ///< per face
  std::vector<std::shared_ptr<const Trim>> trims;        ///< per face
  Facets facets;
  std::string unit = "millimetre";  ///< of the file; coordinates here are millimetre
  double accuracy = 0.0;    ///< what the file states: places nearer than this are one (mm); 0: nothing
  double taken_away = 0.0;  ///< features no larger went at load (ReadOptions::smallest_feature); 0: none
  bool apart = false;       ///< bodies (geom/bodies.h) may touch or overlap though they share nothing
  std::vector<std::string> notes;  ///< what was healed, fused or found odd at load
  std::vector<Fault> faults;       ///< what of the file the model is not: solids left out or not joined
  Provenance provenance;           ///< empty for a model that no file made
  /// By dimension and tag: the number by which the user knows an entity of a body that was taken out of a
  /// whole ([0] unused). Empty: the tag.
  std::array<std::vector<int>, 4> whole_tag;
};

class FacetBvh;
struct FaceCrossing;  ///< geom/face_crossings.h

/// The part. Immutable after construction; every member may be called from several threads at once.
///
/// Invariants (`check_model` in geom/model_check.h): adjacency agrees in both directions; vertices of edges
/// lie on the curves' ends, curves on the faces, within the stated tolerances; facets of every region are
/// closed.
class Model {
 public:
  explicit Model(ModelParts parts);
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;
  /// The part in another place: `parts` are those of this one, turned or moved. Lengths along the edges and
  /// which facet sides lie on them are as here, and are not found again.
  [[nodiscard]] Model moved(ModelParts parts) const;

  // --- topology -------------------------------------------------------------------------------------------
  [[nodiscard]] int count(int dim) const;  ///< entities of dimension 0..3; tags run from 1 to this
  [[nodiscard]] const ModelVertex& vertex(int tag) const;
  [[nodiscard]] const ModelEdge& edge(int tag) const;
  [[nodiscard]] const ModelFace& face(int tag) const;
  [[nodiscard]] const ModelRegion& region(int tag) const;
  [[nodiscard]] const std::string& unit() const;
  [[nodiscard]] const std::vector<std::string>& notes() const;
  [[nodiscard]] const Provenance& provenance() const;
  [[nodiscard]] const ModelParts& parts() const;  ///< what it was made of
  /// Whether `part` is `whole` or lies in its closure (an edge in the closure of a face, ...).
  [[nodiscard]] bool in_closure(ModelRef part, ModelRef whole) const;
  /// Whether the face lies within a region, the same on both of its sides (a baffle, a crack).
  [[nodiscard]] bool is_embedded(int face_tag) const;
  /// Whether it lies outside of all regions, and so is no part of a mesh.
  [[nodiscard]] bool is_outside(int face_tag) const;
  /// `Face 12 "bore"`: the entity as the user knows it.
  [[nodiscard]] std::string describe(ModelRef entity) const;

  // --- size -----------------------------------------------------------------------------------------------
  [[nodiscard]] const Box3& box() const;  ///< tight, of the facets grown by their deviation
  [[nodiscard]] double diagonal() const;
  [[nodiscard]] double tolerance() const;  ///< tauM: the arithmetic floor, 16e-12 of the diagonal
  /// How well the CAD knows an entity's place: its own tolerance; 0 for a region.
  [[nodiscard]] double tolerance_of(ModelRef entity) const;

  // --- edges ----------------------------------------------------------------------------------------------
  [[nodiscard]] Vec3 edge_point(int tag, double t) const;
  [[nodiscard]] Vec3 edge_derivative(int tag, double t) const;
  /// Arc length from t_from to t_to (negative when t_to < t_from).
  [[nodiscard]] double edge_length(int tag, double t_from, double t_to) const;
  /// Parameter at arc length s from `t_from`, clamped to the range.
  [[nodiscard]] double edge_parameter(int tag, double t_from, double s) const;
  [[nodiscard]] EdgeFoot edge_project(int tag, const Vec3& p, double hint) const;  ///< near the hint
  [[nodiscard]] EdgeFoot edge_closest(int tag, const Vec3& p) const;               ///< global, ends included

  // --- faces ----------------------------------------------------------------------------------------------
  [[nodiscard]] SurfaceJet face_jet(int tag, const Vec2& uv, int derivatives) const;
  [[nodiscard]] Vec3 face_normal(int tag, const Vec2& uv) const;  ///< unit, pointing to region[1]
  /// Foot of p on the untrimmed surface, started at the nearest facet of the face.
  [[nodiscard]] FaceFoot face_project(int tag, const Vec3& p) const;
  /// The same, started at a known (u,v) nearby: the fast one.
  [[nodiscard]] FaceFoot face_project(int tag, const Vec3& p, const Vec2& seed) const;
  [[nodiscard]] TrimSide face_side(int tag, const Vec2& uv) const;
  /// Nearest point of the trimmed face, its boundary included.
  [[nodiscard]] Foot face_closest(int tag, const Vec3& p) const;
  /// Largest absolute principal curvature (1/length) at (u,v).
  [[nodiscard]] double face_curvature(int tag, const Vec2& uv) const;

  // --- the whole boundary ---------------------------------------------------------------------------------
  /// Appends all events of the segment p..q with all faces, sorted by t.
  void intersect(const Vec3& p, const Vec3& q, std::vector<Hit>& hits) const;
  /// Whether any face's facets, grown by their deviation, may meet the box (cheap, may say yes in vain).
  [[nodiscard]] bool near_boundary(const Box3& box) const;
  /// Nearest boundary point, none when farther than `max_distance`.
  [[nodiscard]] std::optional<Foot> closest(const Vec3& p, double max_distance) const;
  /// Tag of the region that holds p, 0 outside. On the boundary: either side.
  [[nodiscard]] int region_at(const Vec3& p) const;
  [[nodiscard]] const Facets& facets() const;
  [[nodiscard]] const FacetBvh& bvh() const;
  [[nodiscard]] const Surface& surface(int face_tag) const;
  [[nodiscard]] bool is_plane(int face_tag) const;
  [[nodiscard]] const Curve& curve(int edge_tag) const;

  // --- itself ---------------------------------------------------------------------------------------------
  /// All pairs of faces whose facets cross and whose surfaces then prove to: a point on both surfaces, inside
  /// both loops, farther from the edges than these are off, the surfaces at an angle of 0.02 and more.
  /// Crossings within the facets' deviation may be missed; none is told in error. Ascending by faces.
  /// Looked for when they are first asked for, and kept.
  [[nodiscard]] const std::vector<FaceCrossing>& crossings() const;

  struct Data;  ///< opaque: geom/model_data.h, for geom/*.cpp

 private:
  Model(ModelParts parts, const Model* twin);
  void make_grid_once() const;
  /// region_at() without the grid.
  [[nodiscard]] int exact_region_at(const Vec3& p) const;

  std::unique_ptr<const Data> data_;
};

}  // namespace octet
