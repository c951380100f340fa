// SPDX-License-Identifier: BSD-3-Clause
// The run from model to mesh, as a list of verbs.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "app/attribute_points.h"
#include "app/interior.h"
#include "app/mesh_part.h"
#include "classify/extract.h"
#include "finalize/finalize.h"
#include "geom/sizing.h"
#include "octree/seeds.h"

namespace octet {
namespace {

/// The most levels of local refinement below the size asked for, when no smallest size is given.
constexpr double kFinestShare = 1.0 / 32.0;
/// The same for curvature alone.
constexpr double kFinestCurvedShare = 1.0 / 11.0;

class Run {
 public:
  Run(const Model& model, const MeshOptions& options, Observer& observer)
      : model_(model), options_(options), observer_(observer) {}

  MeshResult run() {
    choose_size();
    build_tree();
    place_points();
    triangulate();
    close_holes();
    extract();
    improve();
    accept();
    summarize();
    return std::move(result_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin(const char* stage, double fraction) {
    if (observer_.cancelled()) throw Cancelled();
    observer_.stage(stage, fraction);
    end();
    result_.report.times.push_back({stage, 0.0});
    started_ = Clock::now();
  }

  void end() {
    auto& times = result_.report.times;
    if (!times.empty())
      times.back().seconds += std::chrono::duration<double>(Clock::now() - started_).count();
    started_ = Clock::now();
  }

  void choose_size() {
    const double h = options_.size;
    if (!std::isfinite(h) || h < 0.0)
      throw InputError(fmt::format("the size must be a positive number, not {}", h));
    size_ = h > 0.0 ? h : default_size(model_);
    result_.report.size = size_;
    double volume = 0.0;
    for (int r = 1; r <= model_.count(3); ++r) volume += model_.region(r).volume;
    const double elements = 5.0 * volume / (size_ * size_ * size_);  // five tetrahedra an octant
    if (elements > static_cast<double>(options_.max_elements))
      throw LimitError(
          fmt::format("size {:.6g} mm needs about {:.2g} elements, more than the limit of {}; "
                      "ask for a larger size or raise --max-elements",
                      size_, elements, options_.max_elements));
  }

  void build_tree() {
    begin("octree", 0.0);
    const std::vector<SizeSample> samples = size_samples();
    OctreeRequest request;
    request.size = size_;
    tree_ = std::make_unique<Octree>(build_octree(model_, request, samples));
    vertices_ = octree_vertices(*tree_);
    observer_.note(fmt::format("octree: {} octants, {} vertices, {} size samples", tree_->size(),
                               vertices_.size(), samples.size()));
    begin("cuts", 0.1);
    const OctantTypes types = octant_types(model_, *tree_);
    cuts_ = cut_octant_edges(model_, *tree_, vertices_, types);
    labels_ = label_vertices(model_, *tree_, vertices_, types, cuts_);
    for (const Fault& fault : labels_.conflicts) observer_.note("parity: " + fault.cause);
  }

  /// The part's own wishes: short edges and gaps are resolved down to the finest size, curvature alone not so
  /// far, since a small fillet is well served by elements of its own width.
  [[nodiscard]] std::vector<SizeSample> size_samples() const {
    SizingOptions gaps;
    gaps.size = size_;
    gaps.min_size = options_.min_size > 0.0 ? options_.min_size : kFinestShare * size_;
    gaps.curvature_angle = 0.0;
    std::vector<SizeSample> samples = feature_sizes(model_, gaps);
    if (options_.curvature_angle > 0.0) {
      SizingOptions curvature = gaps;
      curvature.min_size = std::max(gaps.min_size, kFinestCurvedShare * size_);
      curvature.curvature_angle = options_.curvature_angle;
      curvature.edge_share = std::numeric_limits<double>::infinity();
      curvature.gap_share = 0.0;
      const std::vector<SizeSample> curved = feature_sizes(model_, curvature);
      samples.insert(samples.end(), curved.begin(), curved.end());
    }
    // Octants come in powers of two: a wish is met to the nearest one, not to the next smaller.
    for (SizeSample& sample : samples) sample.size *= M_SQRT2;
    return samples;
  }

  void place_points() {
    begin("points", 0.2);
    seeds_ = seed_points(model_, *tree_, vertices_, labels_, cuts_, size_);
    observer_.note(fmt::format("points: {} on the boundary, {} octree vertices, {} edge pieces",
                               seeds_.surface_points, seeds_.points.size() - seeds_.surface_points,
                               seeds_.pieces.size()));
  }

  void triangulate() {
    begin("triangulation", 0.3);
    split_ = split_interior(model_, *tree_, vertices_, labels_, seeds_);
    observer_.note(fmt::format("interior: {} template octants, {} of {} points in the band",
                               split_.templates.size(), split_.band.size(), seeds_.points.size()));
    triangulation_.insert_all(split_.band.position, split_.band.order);
  }

  /// Exact region of a point: the octant's label where it has one.
  [[nodiscard]] int region_of(const Vec3& p) const {
    const Vec3 x = p - tree_->origin();
    if ((x.array() < 0.0).any() || (x.array() > tree_->root_size()).any()) return 0;
    const OctantId o = tree_->find(p);
    switch (labels_.type[o.index()]) {
      case OctantType::kOut:
        return 0;
      case OctantType::kIn:
        return labels_.region[o.index()];
      default:
        return model_.region_at(p);
    }
  }

  void close_holes() {
    begin("classification", 0.45);
    on_ = split_.band.on;
    chains_ = std::make_unique<EdgeChains>(seeds_.pieces);
    band_ = std::make_unique<Band>(model_, [this](const Vec3& p) { return region_of(p); });
    std::vector<TetId> all;
    for (std::size_t i = 0; i < triangulation_.mesh().tets.size(); ++i)
      if (triangulation_.mesh().alive(TetId(i))) all.emplace_back(i);
    band_->update(triangulation_.mesh(), on_, all);
    AttributeLimits limits;
    limits.points = 4 * seeds_.surface_points + 2000;
    limits.floor = 1e-3 * size_ * kFinestShare;
    const EdgeIndex edges(model_, size_);
    const AttributeResult closed =
        close_gaps(triangulation_, *band_, *chains_, on_, edges, limits, observer_);
    result_.report.attribute_points = closed.points;
    result_.report.rounds = closed.rounds;
    for (const Gap& gap : closed.gaps) result_.report.faults.push_back(describe_gap(model_, gap));
  }

  void extract() {
    begin("extraction", 0.6);
    const TetMesh& band = triangulation_.mesh();
    std::vector<Vec3> points = band.points.values();
    std::vector<ModelRef> on = on_;
    const ExtraTets interior = template_tets(*tree_, vertices_, labels_, split_, points, on);
    result_.report.template_tets = interior.tets.size();
    result_.mesh = extract_mesh(*band_, band, points, on, *chains_, interior);
    if (observer_.wants_dumps()) observer_.dump("classified", result_.mesh);
  }

  void improve() {
    if (!options_.finalize || !result_.report.faults.empty()) return;
    begin("finalization", 0.65);
    FinalizeOptions finalize_options;
    finalize_options.threads = options_.threads;
    finalize_options.size_at = [this](const Vec3& p) { return tree_->size_at(p); };
    const FinalizeReport report = finalize(result_.mesh, model_, finalize_options, observer_);
    observer_.note(fmt::format(
        "finalization: smallest dihedral {:.2f} -> {:.2f} degrees, {} below target ({} by geometry)",
        report.min_dihedral_before * 180.0 / M_PI, report.min_dihedral_after * 180.0 / M_PI,
        report.below_target, report.limited_by_geometry));
    if (observer_.wants_dumps()) observer_.dump("finalized", result_.mesh);
  }

  void accept() {
    begin("acceptance", 0.9);
    MeshReport& report = result_.report;
    report.acceptance = accept_mesh(result_.mesh, model_);
    for (const Claim& claim : report.acceptance.claims)
      if (!claim.holds) report.faults.insert(report.faults.end(), claim.faults.begin(), claim.faults.end());
    report.status =
        report.acceptance.holds() && report.faults.empty() ? MeshStatus::kComplete : MeshStatus::kIncomplete;
    end();
  }

  void summarize() {
    MeshReport& report = result_.report;
    const Mesh& mesh = result_.mesh;
    report.quality = quality_summary(mesh);
    report.nodes = mesh.points.size();
    report.tets = mesh.tets.size();
    report.triangles = mesh.triangles.size();
    for (const auto& t : mesh.tets)
      report.volume +=
          signed_volume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    for (const auto& t : mesh.triangles)
      report.area +=
          0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm();
    for (int r = 1; r <= model_.count(3); ++r) report.cad_volume += model_.region(r).volume;
    for (int f = 1; f <= model_.count(2); ++f) {
      const auto& region = model_.face(f).region;
      if (region[0] != region[1]) report.cad_area += model_.face(f).area;
    }
  }

  const Model& model_;
  const MeshOptions& options_;
  Observer& observer_;
  MeshResult result_;
  Clock::time_point started_ = Clock::now();
  double size_ = 0.0;
  std::unique_ptr<Octree> tree_;
  OctreeVertices vertices_;
  OctreeLabels labels_;
  std::vector<OctantEdgeCut> cuts_;
  Seeds seeds_;
  BandAndInterior split_;
  Triangulation triangulation_;
  std::vector<ModelRef> on_;
  std::unique_ptr<EdgeChains> chains_;
  std::unique_ptr<Band> band_;
};

}  // namespace

MeshResult mesh_part(const Model& model, const MeshOptions& options, Observer& observer) {
  if (options.threads < 1)
    throw InputError(fmt::format("the number of threads must be at least 1, not {}", options.threads));
  MeshResult result;
  tbb::task_arena arena(options.threads);
  arena.execute([&] { result = Run(model, options, observer).run(); });
  return result;
}

MeshResult mesh_part(const Model& model, const MeshOptions& options) {
  Observer silent;
  return mesh_part(model, options, silent);
}

}  // namespace octet
