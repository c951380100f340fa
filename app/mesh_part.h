// SPDX-License-Identifier: BSD-3-Clause
// The library's front door: a model in, a classified mesh and a report out.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/size_shortfall.h"
#include "base/error.h"
#include "base/fault.h"
#include "base/observer.h"
#include "classify/acceptance.h"
#include "finalize/curve.h"
#include "finalize/finalize.h"
#include "finalize/layers.h"
#include "geom/model.h"
#include "geom/size_attributes.h"
#include "geom/size_plan.h"
#include "mesh/mesh.h"
#include "mesh/periodic_link.h"
#include "mesh/quality.h"
#include "octree/root.h"

namespace octet {

/// When a mesh of more elements than there may be where no size is asked for (most_by_default()) is made.
enum class LargeMesh {
  kLast,    ///< where one of larger elements has faults
  kNever,   ///< that one is the result, with MeshReport::left_large
  kAtOnce,  ///< before one of larger elements
};

/// Faces whose meshes are to be images of each other (app/periodic_words.h).
struct PeriodicWish {
  std::string text;  ///< as the user wrote it, for messages
  int axis = -1;     ///< 0..2: the faces in the least plane across this axis, and those in the greatest
  std::vector<SizeAttribute> faces, images;  ///< else
};

/// Layers of elements on faces (app/layer_mesh.h).
struct LayerRequest {
  std::string text;  ///< as the user wrote it, for messages
  std::vector<SizeAttribute> places;
  double first = 0.0;  ///< height of the first (model units)
  int count = 0;
  double growth = 1.2;  ///< of each to the one before
};

/// Sizes (geom/size_plan.h), and what else a run may be told.
struct MeshOptions : SizeControl {
  double target_elements = 0.0;  ///< sizes are scaled to get about so many tetrahedra; 0: as they are
  int threads = 1;               ///< at most; no more run than the machine has; same bytes for any number
  bool finalize = true;
  std::array<double, 3> shift = kRootShift;   ///< of the part in the lattice: octree/root.h
  FinalizeScope scope = FinalizeScope::kAll;  ///< of finalization
  LargeMesh large_mesh = LargeMesh::kLast;
  std::vector<PeriodicWish> periodic;
  std::vector<LayerRequest> layers;
  int order = 1;  ///< of the elements: 2 gives each edge a node in its middle, on the curved faces
};

/// What a run came to.
enum class MeshStatus {
  kComplete,    ///< a mesh, and every claim of the acceptance holds
  kIncomplete,  ///< a mesh, and a list of faults
};

struct StageTime {
  std::string name;
  double seconds = 0.0;
  double cpu_seconds = 0.0;  ///< of all threads together; unlike `seconds` hardly moved by what else runs
  double peak_bytes = 0.0;   ///< most memory the process has held up to the end of the stage
};

struct MeshReport {
  MeshStatus status = MeshStatus::kIncomplete;
  double size = 0.0;             ///< the size used
  double target_elements = 0.0;  ///< asked for; 0: none
  /// A size at which most of the boundary had no mesh faces: the one used, or a larger one that was tried
  /// before; 0: none.
  double too_coarse = 0.0;
  double left_large = 0.0;  ///< elements of the mesh that was not made for LargeMesh::kNever; 0: none
  std::vector<Fault> faults;
  /// What is a danger at this size though the mesh may be complete: wide gaps, faces that cross; and walls
  /// that get fewer elements across than asked for.
  std::vector<Fault> warnings;
  std::vector<std::string> notes;   ///< wishes without effect, or not met, and why
  std::vector<PeriodicLink> links;  ///< of what is periodic and fits, for writers (ModelOutline)
  SizeShortfall shortfall;          ///< where the part is finer than the size asked for
  QualitySummary quality;
  Acceptance acceptance;
  double volume = 0.0, cad_volume = 0.0;
  double area = 0.0, cad_area = 0.0;
  double area_off = 0.0;  ///< sum of the faces' |area - CAD's area|
  std::size_t nodes = 0, tets = 0, triangles = 0;
  std::size_t attribute_points = 0, rounds = 0;
  std::size_t template_tets = 0;  ///< of the tetrahedra: emitted from octant templates
  /// Of a mesh with layers; `quality` is that of all other elements then.
  std::optional<LayerReport> layers;
  std::optional<CurveReport> curve;  ///< of a mesh of second order, whose volume and area are the curved ones
  std::vector<StageTime> times;
};

struct MeshResult {
  Mesh mesh;
  MeshReport report;
};

/// Meshes the model. Prints nothing, keeps no state, may run in several threads at once.
/// Throws InputError, ModelError, LimitError, Cancelled, Bug; a goal not met is a fault in the report.
[[nodiscard]] MeshResult mesh_part(const Model& model, const MeshOptions& options, Observer& observer);
[[nodiscard]] MeshResult mesh_part(const Model& model, const MeshOptions& options = {});

}  // namespace octet
