// SPDX-License-Identifier: BSD-3-Clause
// How often a mesh is made, and at which sizes.
#include "app/mesh_part.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <limits>

#include "app/apart.h"
#include "app/layer_mesh.h"
#include "app/option_check.h"
#include "app/own_frame.h"
#include "app/periodic_mesh.h"
#include "app/periodic_words.h"
#include "app/pipeline.h"
#include "app/second_order.h"
#include "app/size_notes.h"
#include "app/stage_clock.h"
#include "app/stage_times.h"
#include "app/target_elements.h"
#include "app/usable_threads.h"
#include "app/watched_observer.h"
#include "classify/periodic.h"

namespace octet {

namespace {

/// With the nodes in the middles of edges.
void match_again(MeshResult& result, const Model& model, const Periodicity& periodicity) {
  MeshReport& report = result.report;
  const bool fitted = report.acceptance.holds(kPeriodicClaim);
  std::erase_if(report.acceptance.claims, [](const Claim& claim) { return claim.name == kPeriodicClaim; });
  const std::size_t faults = report.faults.size();
  take_match(result, model, periodicity);
  if (!fitted) report.faults.resize(faults);  // they are told already
}

}  // namespace

MeshResult mesh_part(const Model& model, const MeshOptions& options, Observer& own_observer) {
  check_options(options);
  const bool apart = is_meshed_apart(model);
  if (apart && !options.periodic.empty())
    throw InputError("--periodic is for parts whose solids share the faces where they touch");
  if (!options.layers.empty() && (apart || options.order == 2 || !options.periodic.empty()))
    throw InputError(fmt::format("--layers is not for {}", apart                ? "solids that are kept apart"
                                                           : options.order == 2 ? "elements of second order"
                                                                                : "what is periodic"));
  const std::vector<LayerWish> layers = layer_wishes(model, options.layers);
  const Periodicity periodicity(model, periodic_faces(model, options.periodic));
  MeshResult result;
  int makings = 0;
  StageClock clock;
  tbb::task_arena arena(usable_threads(options.threads));
  WatchedObserver observer(own_observer, options.cancelled);
  MeshOptions watched = options;
  watched.cancelled = [&observer] { return observer.cancelled(); };
  arena.execute([&] {
    observer.stage("sizes", 0.0);
    const OwnFrame frame(model, watched);
    SizeMemo memo;
    const auto mesh = [&](const MeshOptions& with, double most) {
      const auto make = [&](const MeshOptions& now, const PeriodicSeeds* seeds, Observer& follower) {
        ++makings;
        return run_pipeline(frame, now, most, seeds, memo, follower);
      };
      if (!periodicity.empty()) return mesh_periodic(frame, with, periodicity, make, observer);
      if (!apart) return make(with, nullptr, observer);
      ++makings;
      return mesh_apart(model, with, observer);
    };
    const auto mesh_all = [&](const MeshOptions& with) {
      MeshResult made = mesh(with, std::numeric_limits<double>::infinity());
      observer.note(fmt::format("size {:.6g} gives {} tetrahedra", with.size, made.report.tets));
      return made;
    };
    result = options.target_elements > 0.0 ? mesh_to_target(frame.model(), frame.options(), mesh_all, &memo)
                                           : mesh_by_default(frame.model(), frame.options(), mesh, &memo);
  });
  if (!layers.empty())
    arena.execute(
        [&] { grow_layers(result, model, layers, options.max_elements, watched.cancelled, observer); });
  if (options.order == 2) {
    arena.execute([&] { raise_order(result, model, observer); });
    if (!periodicity.empty()) match_again(result, model, periodicity);
  }
  MeshReport& report = result.report;
  add_size_notes(model, options, observer, report);
  add_rest(beside_stages(clock.lap({}), report.times), makings, report.times);
  const std::vector<Fault> of_part = faults_of_part(model);
  report.faults.insert(report.faults.begin(), of_part.begin(), of_part.end());
  if (!report.faults.empty()) report.status = MeshStatus::kIncomplete;
  return result;
}

MeshResult mesh_part(const Model& model, const MeshOptions& options) {
  Observer silent;
  return mesh_part(model, options, silent);
}

}  // namespace octet
