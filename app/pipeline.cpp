// SPDX-License-Identifier: BSD-3-Clause
// The run from model to mesh, as a list of verbs.
#include "app/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "app/attempt.h"
#include "app/edge_divisions.h"
#include "app/element_limits.h"
#include "app/geometry_faults.h"
#include "app/held_boundary.h"
#include "app/leave_out.h"
#include "app/measures.h"
#include "app/octant_sizes.h"
#include "app/periodic_mesh.h"
#include "app/size_notes.h"
#include "app/size_shortfall.h"
#include "app/stage_clock.h"
#include "app/suited_octants.h"
#include "app/target_elements.h"
#include "app/watched_observer.h"
#include "classify/extract.h"
#include "finalize/finalize.h"
#include "finalize/surplus.h"
#include "geom/face_crossings.h"
#include "geom/face_touches.h"
#include "geom/size_memo.h"
#include "geom/wide_gaps.h"

namespace octet {
namespace {

/// How often octants are subdivided where gaps survive, and how often in a row without fewer gaps where the
/// tree has more octants than a moment's work; the last few gaps are tried on, for it is chance that leaves
/// one more or less.
constexpr int kSubdivisions = 6, kPatience = 2;
constexpr std::size_t kCheapTree = 20'000, kFewGaps = 10;
/// A mesh with more gaps than points on the boundary is too coarse nearly everywhere, by more than a factor
/// of two: in a large tree smaller octants at all of them, again and again, take hours and as much memory as
/// there is (a heat exchanger of 89 tubes, 1.1 m long, whose bores are a fortieth of the size).
constexpr std::size_t kLargeTree = 50'000;
/// Faces that touch are looked for within this share of the size of a gap.
constexpr double kTouchReach = 0.1;
/// Octants at gaps are subdivided to this share of the finest otherwise where no smallest size was asked for:
/// a bore of 0.005 mm in a part of 46 mm is closed by octants of its own width.
constexpr double kFinestAtGaps = 1.0 / 64.0;
/// What finalization begins with is kept up to so many tetrahedra, for meshes without gaps that fail a claim:
/// they are finalized again with some of the boundary held. Larger ones, which would take its memory in every
/// run for the few that come to this, are made again from the same tree.
constexpr std::size_t kKeptTets = 2'000'000;
/// How often it is then made again with smaller octants at its faults.
constexpr int kSecondTries = 3;
/// In attempts after the first octree vertices keep farther off: middle layers of walls, which the nearer
/// ones are for, are worth less than holes that close and claims that hold.
constexpr double kRoomyClearance = 0.6;
/// Attribute points keep this share of the finest octant off each other, and where no smaller octants close
/// the gaps that are left, these shares: a wall of 0.0008 mm beside a tangent face wants points as near.
constexpr double kFloorShare = 1e-3;
constexpr std::array<double, 6> kLastFloorShares{5e-4, 2.5e-4, 1.25e-4, 6e-5, 3e-5, 1.5e-5};
/// Attribute points for the gaps of one octant. Where gaps close few octants take more than 23, but four
/// narrow holes in one take 400; where they do not, octants take thousands.
constexpr std::size_t kPointsPerOctant = 1000;

/// What finalization begins with.
struct Begun {
  Mesh mesh;
  std::size_t template_tets;  ///< among its tetrahedra
};

class Run {
 public:
  /// `most`: tetrahedra; TooManyTets is thrown where there would be far more.
  /// `memo`: what plans of the frame's model found.
  Run(const OwnFrame& frame, const MeshOptions& options, double most, const PeriodicSeeds* periodic,
      SizeMemo& memo, Observer& observer)
      : frame_(frame),
        part_(frame.part()),
        model_(frame.model()),
        options_(options),
        most_(most),
        memo_(memo),
        observer_(observer) {
    seeds_.periodic = periodic;
  }

  MeshResult run() {
    choose_size();
    std::optional<Octree> tree = build_tree();
    std::optional<MeshResult> best;
    while (tree || again_) {
      if (again_) {
        restore();
      } else {
        try {
          mesh_band(*std::exchange(tree, std::nullopt));
        } catch (const LimitError& limit) {
          if (!best) throw;
          limit_ = limit.what();
          best->report.times = result_.report.times;
          break;
        }
        extract();
        if (held_.holds_any()) held_.find_anew(result_.mesh, band_->tree);
      }
      improve();
      append_interior();
      accept();
      const bool better = !best || fault_count(result_.report) < fault_count(best->report);
      tree = next_tree(better);
      keep_better(best, better);
    }
    result_ = *std::move(best);
    tell_limit();
    summarize();
    return std::move(result_);
  }

 private:
  void begin(const char* stage, double fraction) {
    if (observer_.cancelled()) throw Cancelled();
    observer_.stage(stage, fraction);
    end();
    auto& times = result_.report.times;
    const auto known =
        std::find_if(times.begin(), times.end(), [&](const StageTime& t) { return t.name == stage; });
    stage_ = static_cast<std::size_t>(known - times.begin());
    if (known == times.end()) times.push_back({stage});
  }

  void end() {
    auto& times = result_.report.times;
    const StageTime lap = clock_.lap({});
    if (stage_ >= times.size()) return;
    times[stage_].seconds += lap.seconds;
    times[stage_].cpu_seconds += lap.cpu_seconds;
    times[stage_].peak_bytes = lap.peak_bytes;
  }

  void choose_size() {
    begin("sizes", 0.0);
    check_volume(model_, options_, global_size(model_, options_));
    plan_ = plan_sizes(model_, options_, &memo_);
    if (std::string note = suit_octants(model_, options_, plan_); !note.empty())
      result_.report.notes.push_back(std::move(note));
    result_.report.size = plan_.asked;
    for (const WideGap& gap : wide_gaps(part_, plan_.asked))
      result_.report.warnings.push_back(warning_of(gap, part_));
    if (auto warning = warning_of(plan_.thinnest_wall, options_)) {
      warning->place = frame_.to_part(warning->place);
      result_.report.warnings.push_back(*std::move(warning));
    }
    refuse_crossings();
    octant_ = octant_request(plan_).size;
    seeds_.size = octant_;
    seeds_.divisions = edge_divisions(model_, options_.attributes);
    seeds_.cancelled = options_.cancelled;
  }

  /// A boundary that crosses itself within the size bounds nothing; what the size cannot tell apart is tried.
  void refuse_crossings() {
    constexpr double kSeenShare = 0.5;
    for (const FaceCrossing& crossing : part_.crossings()) {
      if (crossing.depth > kSeenShare * plan_.asked) throw InputError(refusal_of(crossing, part_));
      crossings_.push_back(warning_of(crossing, part_));
      result_.report.warnings.push_back(crossings_.back());
    }
  }

  [[nodiscard]] Octree build_tree() {
    begin("octree", 0.0);
    Octree tree = planned_octree(model_, plan_, options_.shift);
    observer_.note(fmt::format("octree: {} octants, {} size samples", tree.size(), plan_.samples.size()));
    return tree;
  }

  /// Points, triangulation, attribute points; where gaps survive, their octants are subdivided and the band
  /// is made anew. The attempt with the fewest gaps is kept.
  void mesh_band(Octree tree) {
    std::optional<Openness> mark;
    int kept = 0, depth = 0;
    for (int best = 0;; ++depth) {
      std::unique_ptr<Attempt> next;
      try {
        next = attempt(std::move(tree));
      } catch (const LimitError& limit) {
        if (!band_) throw;
        limit_ = limit.what();
        break;
      }
      if (in_vain_) close_below_floor(*next);
      const Openness open = openness(next->closed.gaps);
      const bool better = !band_ || open < openness(band_->closed.gaps);
      if (!mark || clearly_less(open, *mark)) {
        mark = open;
        best = depth;
      }
      std::optional<Octree> finer;
      too_coarse_ = next->closed.gaps.size() > most_gaps(*next);
      hopeless_ = too_coarse_ || (!crossings_.empty() && crosses_all_over(*next));
      if (!next->closed.gaps.empty() && !hopeless_ && depth < kSubdivisions)
        finer = subdivide_at_gaps(*next, model_, finest_at_gaps());
      const bool few = next->closed.gaps.size() <= kFewGaps;
      if (finer && depth - best >= kPatience && finer->size() > kCheapTree && !few) finer.reset();
      if (finer && !wish_) wish_ = next->tree;
      seeds_.octree_clearance = kRoomyClearance;
      if (finer)
        observer_.note(fmt::format("{} gaps left: their octants subdivided, {} octants now",
                                   next->closed.gaps.size(), finer->size()));
      if (better) {
        band_ = std::move(next);
        kept = depth;
      }
      if (!finer) break;
      tree = std::move(*finer);
    }
    close_below_floor(*band_);
    close_elsewhere(*band_);
    gaps_left_ = !band_->closed.gaps.empty();
    // The first attempt is no measure: its octree vertices stand nearer to the boundary.
    in_vain_ = in_vain_ || (kept > 0 && kept < depth && limit_.empty() && !gaps_left_);
    if (gaps_left_) find_all_gaps(*band_);
    broken_ = broken_regions(*band_, model_);
    auto& faults = result_.report.faults;
    faults = describe_left_out(*band_, model_, broken_);
    add_faults(describe_gaps(model_, band_->closed.gaps));
    if (gaps_left_ && !too_coarse_) tell_touches(faults);
    for (Fault& fault : faults) fault.place = frame_.to_part(fault.place);
    if (gaps_left_) faults.insert(faults.begin(), crossings_.begin(), crossings_.end());
    if (!gaps_left_ || !too_coarse_) return;
    result_.report.too_coarse = plan_.asked;
    faults.insert(faults.begin(), fault_of_coarseness(plan_.asked, frame_.to_part(model_.box().centre())));
  }

  /// A mesh that is there is not given up for a finer one that may not be made.
  void tell_limit() {
    if (limit_.empty() || result_.report.status == MeshStatus::kComplete) return;
    auto& faults = result_.report.faults;
    const Vec3 place = faults.empty() ? part_.box().centre() : faults.front().place;
    faults.push_back({{},
                      place,
                      "octants small enough to mend the faults were not made: " + limit_,
                      "raise --max-elements"});
  }

  /// Points nearer to each other than is good for elements, for the gaps that nothing else closes. About a
  /// boundary that is known to cross itself they open the more gaps the nearer they are.
  void close_below_floor(Attempt& attempt) {
    if (hopeless_) return;
    std::size_t most = kHopelessGaps;
    for (const double share : kLastFloorShares) {
      const std::size_t gaps = attempt.closed.gaps.size();
      if (gaps == 0 || gaps > most) return;
      if (!crossings_.empty()) most = std::min(most, 2 * gaps);
      observer_.note(fmt::format("{} gaps left: points may be nearer to each other", gaps));
      close_attempt(attempt, share);
    }
  }

  /// A piece of an edge that cannot be had, at a defect of the part, is no reason to leave holes in faces
  /// elsewhere.
  void close_elsewhere(Attempt& attempt) {
    const std::vector<Gap>& gaps = attempt.closed.gaps;
    if (hopeless_ || gaps.size() > kHopelessGaps || !openness(gaps).lacks_pieces) return;
    observer_.note(fmt::format("{} pieces of edges are left: what lies elsewhere is closed", gaps.size()));
    close_attempt(attempt, kFloorShare, GapScope::kAll);
  }

  /// The loop of attribute points, from where the attempt is.
  void close_attempt(Attempt& attempt, double floor_share, GapScope scope = GapScope::kPiecesFirst) {
    AttributeLimits limits;
    limits.scope = scope;
    limits.points = 4 * attempt.surface_points + 2000;
    limits.per_cell = kPointsPerOctant;
    limits.gaps = most_gaps(attempt);
    limits.floor = floor_share * finest_octant();
    limits.images = image_points(seeds_.periodic, model_);
    close_holes(attempt, model_, octant_, limits, observer_);
    result_.report.attribute_points += attempt.closed.points;
    result_.report.rounds += attempt.closed.rounds;
  }

  /// Of the mesh. Where there are gaps, no other advice is any good to faces that cross.
  void add_faults(std::vector<Fault> faults) {
    for (Fault& fault : faults)
      if (gaps_left_ && deepest_crossing_at(fault, part_) > 0.0) fault.advice = kMendCrossings;
    result_.report.faults.insert(result_.report.faults.end(), faults.begin(), faults.end());
  }

  /// Faces that touch are what most holes are about that no octants close: they are told first.
  void tell_touches(std::vector<Fault>& faults) const {
    std::vector<PlaceOnFace> places;
    for (const Gap& gap : band_->closed.gaps)
      if (gap.entity.dim == 2) places.push_back({gap.entity.tag, gap.place});
    std::vector<Fault> touches;
    for (const FaceTouch& touch :
         face_touches(model_, places, kTouchReach * plan_.asked, kTouchShare * model_.diagonal()))
      touches.push_back(fault_of(touch, part_));
    faults.insert(faults.begin(), touches.begin(), touches.end());
  }

  [[nodiscard]] static std::size_t most_gaps(const Attempt& attempt) {
    return attempt.tree.size() > kLargeTree ? attempt.surface_points
                                            : std::numeric_limits<std::size_t>::max();
  }

  [[nodiscard]] double finest_octant() const { return plan_.min_size / kEdgePerOctant; }

  /// Without a smallest size asked for, octants at holes in the mesh get as small as it takes.
  [[nodiscard]] double finest_at_gaps() const {
    return options_.min_size > 0.0 ? 0.5 * finest_octant() : kFinestAtGaps * finest_octant();
  }

  [[nodiscard]] std::unique_ptr<Attempt> attempt(Octree tree) {
    auto next = std::make_unique<Attempt>(std::move(tree));
    begin("cuts", 0.1);
    cut_tree(*next, model_, options_.cancelled);
    check_limit(*next);
    begin("points", 0.2);
    place_points(*next, model_, seeds_);
    tell_conflicts(next->labels.conflicts);
    observer_.note(fmt::format("points: {} on the boundary, {} in all, {} triangulated; {} template octants",
                               next->surface_points, next->seed_points, next->split.band.size(),
                               next->split.templates));
    begin("triangulation", 0.3);
    triangulate(*next, model_, options_.cancelled);
    begin("classification", 0.45);
    classify(*next);
    close_attempt(*next, kFloorShare);
    return next;
  }

  void tell_conflicts(const std::vector<Fault>& conflicts) {
    constexpr std::size_t kTold = 3;
    for (std::size_t i = 0; i < conflicts.size() && i < kTold; ++i)
      observer_.note("parity: " + conflicts[i].cause);
    if (conflicts.size() > kTold)
      observer_.note(fmt::format("parity: and {} more octant edges", conflicts.size() - kTold));
  }

  /// A boundary octant gives about as many tetrahedra as one inside.
  void check_limit(const Attempt& attempt) const {
    check_octants(plan_, static_cast<std::size_t>(
                             std::count_if(attempt.labels.type.begin(), attempt.labels.type.end(),
                                           [](OctantType type) { return type != OctantType::kOut; })));
  }

  void extract() {
    begin("extraction", 0.6);
    if (!broken_.empty()) leave_out_octants(*band_, broken_);
    const TetMesh& tets = band_->triangulation.mesh();
    std::vector<Vec3> points = points_of(*band_);
    std::vector<ModelRef> on = band_->on;
    const ExtraTets near = near_tets(band_->tree, band_->vertices, band_->labels, band_->split, points, on);
    result_.report.template_tets = near.tets.size();
    fixed_vertices_ = near.first.size();
    result_.mesh = extract_mesh(*band_->band, tets, points, on, *band_->chains, near);
    refuse_too_many();
    band_->forget_band();
    if (!broken_.empty()) leave_out(result_.mesh, model_, broken_);
    if (!seeds_.divisions.empty() && options_.finalize && !gaps_left_)
      draw_in(result_.mesh, model_, finalize_options(),
              surplus_vertices(result_.mesh, model_, seeds_.divisions));
    dump("classified");
  }

  /// A little more than asked for is kept.
  void refuse_too_many() const {
    constexpr double kFarMore = 1.2;
    auto count = static_cast<double>(result_.mesh.tets.size());
    if (count <= most_) return;
    Mesh interior;
    count +=
        static_cast<double>(append_deep(band_->tree, band_->vertices, band_->labels, band_->split, interior));
    if (count > kFarMore * most_) throw TooManyTets{count, gaps_left_};
  }

  /// Goes back to what finalization began with.
  void restore() {
    again_ = false;
    result_.mesh = begun_->mesh;
    result_.report.template_tets = begun_->template_tets;
  }

  /// The mesh so far together with what will be appended to it.
  void dump(const char* stage) {
    if (!observer_.wants_dumps()) return;
    Mesh whole = result_.mesh;
    append_deep(band_->tree, band_->vertices, band_->labels, band_->split, whole);
    frame_.to_part(whole.points);
    observer_.dump(stage, whole);
  }

  [[nodiscard]] FinalizeOptions finalize_options() const {
    FinalizeOptions given;
    given.scope = options_.scope;
    given.fixed_vertices = fixed_vertices_;
    given.volume_beyond = deep_volumes(band_->tree, band_->labels, band_->split, model_.count(3));
    given.size_at = [this](const Vec3& p) { return band_->tree.spacing_at(p); };
    return given;
  }

  /// Deep octants have good shapes already, and are appended only after the others have been worked on.
  void improve() {
    if (!options_.finalize || (!result_.report.faults.empty() && broken_.empty())) return;
    begin("finalization", 0.65);
    if (!gaps_left_ && !begun_ && result_.mesh.tets.size() <= kKeptTets)
      begun_ = Begun{result_.mesh, result_.report.template_tets};
    FinalizeOptions given = finalize_options();
    given.held = with_periodic(with_divided(held_.vertices(), result_.mesh, seeds_.divisions), result_.mesh,
                               seeds_.periodic);
    if (const GapRooms* rooms = held_.rooms())
      given.room_at = [rooms](const Vec3& p) { return rooms->at(p); };
    if (wish_) given.coarse_size_at = [this](const Vec3& p) { return wish_->spacing_at(p); };
    const FinalizeReport report = finalize(result_.mesh, model_, given, observer_);
    observer_.note(describe(report));
    dump("finalized");
  }

  void append_interior() {
    begin("interior", 0.85);
    result_.report.template_tets +=
        append_deep(band_->tree, band_->vertices, band_->labels, band_->split, result_.mesh);
    frame_.to_part(result_.mesh.points);
    if (begun_) return;
    tree_ = std::move(band_->tree);
    band_.reset();
  }

  /// That of the mesh.
  [[nodiscard]] const Octree& tree() const { return band_ ? band_->tree : *tree_; }

  /// The tree for another try; none where there is no fault, where gaps have had their tries already, where
  /// what is kept will do, and where smaller octants have not helped a tree that is large.
  [[nodiscard]] std::optional<Octree> next_tree(bool better) {
    const std::size_t faults = result_.report.faults.size();
    if (faults == 0 || gaps_left_) return std::nullopt;
    if (options_.finalize && held_.is_hopeful()) {
      const std::vector<Vec3> places = places_at_fault();
      held_.hold_more(places, !result_.report.acceptance.holds("no-overlap"));
      again_ = begun_ && held_.find(begun_->mesh, tree());
      note_held(places.size());
      return again_ ? std::nullopt : std::optional(tree());
    }
    const bool hopeful = better || second_tries_ == 0 || tree().size() <= kCheapTree;
    std::optional<Octree> finer;
    if (hopeful && !held_.is_last_resort() && second_tries_++ < kSecondTries) finer = finer_at_faults();
    if (!finer) again_ = hold_at_last();
    return finer;
  }

  /// Nothing else has helped. False: nor will this.
  [[nodiscard]] bool hold_at_last() {
    const std::vector<Vec3> places = places_at_fault();
    while (begun_ && held_.hold_at_last(places)) {
      note_held(places.size());
      if (held_.find(begun_->mesh, tree())) return true;
    }
    return false;
  }

  void note_held(std::size_t faults) {
    std::vector<std::string> failed;
    for (const Claim& claim : result_.report.acceptance.claims)
      if (!claim.holds) failed.push_back(claim.name);
    observer_.note(
        fmt::format("faults at {} places ({}): {}", faults, fmt::join(failed, ", "), held_.words()));
  }

  [[nodiscard]] std::vector<Vec3> places_at_fault() const {
    return octet::places_at_fault(result_.report.acceptance, frame_);
  }

  /// What a user would do who is told to ask for a smaller size at a fault: the tree with octants subdivided
  /// there.
  [[nodiscard]] std::optional<Octree> finer_at_faults() {
    const std::vector<Vec3> places = places_at_fault();
    std::optional<Octree> finer = subdivide_at(tree(), model_, places, 0.5 * finest_octant());
    if (finer && !wish_) wish_ = tree();
    if (finer)
      observer_.note(fmt::format("faults at {} places: their octants subdivided, {} octants now",
                                 places.size(), finer->size()));
    return finer;
  }

  /// Puts the result by where it is better, with the account of all the work so far, and clears it for
  /// another.
  void keep_better(std::optional<MeshResult>& best, bool better) {
    MeshReport account = result_.report;
    if (better) {
      best = std::move(result_);
    } else {
      best->report.times = account.times;
      best->report.attribute_points = account.attribute_points;
      best->report.rounds = account.rounds;
    }
    account.faults.clear();
    account.acceptance = {};
    account.template_tets = 0;
    result_ = MeshResult{};
    result_.report = std::move(account);
    broken_.clear();
    if (again_) return;
    tree_.reset();
    band_.reset();
    begun_.reset();
  }

  void accept() {
    begin("acceptance", 0.9);
    MeshReport& report = result_.report;
    report.acceptance = accept_mesh(result_.mesh, part_);
    add_faults(faults_of(report.acceptance.claims));
    report.shortfall = shortfall();
    report.status =
        report.acceptance.holds() && report.faults.empty() ? MeshStatus::kComplete : MeshStatus::kIncomplete;
  }

  [[nodiscard]] SizeShortfall shortfall() const {
    const Octree& asked = wish_ ? *wish_ : tree();
    return size_shortfall(result_.mesh, [&](const Vec3& p) { return asked.spacing_at(frame_.to_model(p)); });
  }

  void summarize() {
    begin("summary", 0.98);
    measure_mesh(result_.mesh, part_, result_.report);
    if (auto note = note_of_divisions(result_.mesh, seeds_.divisions))
      result_.report.notes.push_back(*std::move(note));
    end();
  }

  const OwnFrame& frame_;
  const Model& part_;   ///< as the user has it: what is told and accepted
  const Model& model_;  ///< in its own axes: what is meshed
  const MeshOptions& options_;
  double most_;
  SizeMemo& memo_;
  Observer& observer_;
  MeshResult result_;
  StageClock clock_;
  SizePlan plan_;
  double octant_ = 0.0;             ///< length of the coarsest octants of the part
  std::size_t fixed_vertices_ = 0;  ///< the first vertices of the mesh, which the deep interior shares
  std::size_t stage_ = std::numeric_limits<std::size_t>::max();  ///< index of the running stage's time
  std::unique_ptr<Attempt> band_;
  std::vector<int> broken_;  ///< regions left out
  SeedOptions seeds_;
  bool gaps_left_ = false;
  bool too_coarse_ = false;  ///< nearly everywhere, which smaller octants at gaps do not cure
  bool hopeless_ = false;    ///< that, or a boundary that crosses itself all over
  std::vector<Fault>
      crossings_;               ///< of faces, too shallow for the size to tell: why gaps are left, if any are
  std::optional<Octree> wish_;  ///< octants of the sizes asked for, where some were subdivided
  HeldBoundary held_{model_};   ///< in finalization
  int second_tries_ = 0;        ///< with smaller octants at faults
  std::string limit_;           ///< that another try would have passed
  std::optional<Octree> tree_;  ///< that of the mesh, when the band has gone
  std::optional<Begun> begun_;  ///< where it is kept; then the band stays
  bool again_ = false;          ///< the next try is from there
  bool in_vain_ = false;        ///< smaller octants left no fewer gaps, which nearer points then closed
};

}  // namespace

MeshResult run_pipeline(const OwnFrame& frame, const MeshOptions& options, double most,
                        const PeriodicSeeds* periodic, SizeMemo& memo, Observer& observer) {
  return Run(frame, options, most, periodic, memo, observer).run();
}

}  // namespace octet
