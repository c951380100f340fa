// SPDX-License-Identifier: BSD-3-Clause
// Finalization of large meshes in blocks, side by side.
#include "finalize/in_blocks.h"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <thread>

#include "base/error.h"
#include "finalize/measure_account.h"
#include "finalize/mesh_blocks.h"
#include "finalize/schedule.h"
#include "mesh/quality.h"

namespace octet {
namespace {

using MeshVertices = std::vector<Mesh::Index>;
using Tets = std::vector<Mesh::Index>;

/// So many layers of tetrahedra about seams are worked on again.
constexpr int kSeamLayers = 3;
/// The largest share of a mesh about its seams that is worth while: it is worked on twice.
constexpr double kMostAtSeams = 0.3;

/// For blocks on other threads: asks the caller's observer on the caller's thread alone, as it is promised.
class Watch : public Observer {
 public:
  explicit Watch(const Observer& caller) : caller_(caller) {}
  [[nodiscard]] bool cancelled() const override {
    if (std::this_thread::get_id() == thread_ && caller_.cancelled()) cancelled_ = true;
    return cancelled_;
  }

 private:
  const Observer& caller_;
  std::thread::id thread_ = std::this_thread::get_id();
  mutable std::atomic<bool> cancelled_ = false;
};

void add_to(FinalizeReport& sum, const FinalizeReport& block) {
  sum.min_dihedral_before = std::min(sum.min_dihedral_before, block.min_dihedral_before);
  sum.smoothed += block.smoothed;
  sum.edge_removals += block.edge_removals;
  sum.face_swaps += block.face_swaps;
  sum.collapses += block.collapses;
  sum.splits += block.splits;
  sum.budget_spent = sum.budget_spent || block.budget_spent;
}

/// One call of `work` for each of the numbers. A thread that waits for others within one begins no other.
template <class Work>
void for_each_block(std::size_t count, const Work& work) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const auto& range) {
        for (std::size_t b = range.begin(); b < range.end(); ++b)
          tbb::this_task_arena::isolate([&] { work(b); });
      },
      tbb::simple_partitioner());
}

/// A block being worked on. Not to be moved: the shop refers to the options.
struct Task {
  MeshBlock block;
  Measures before, after;
  FinalizeOptions options;
  std::unique_ptr<Workshop> shop;
  FinalizeReport report;

  void begin(const MeshBlocks& blocks, std::size_t b, const Model& model, const FinalizeOptions& of_all) {
    block = blocks.cut_out(b);
    options = of_all;
    options.volume_beyond.clear();  // the account has it
    options.fixed_vertices = block.fixed;
    options.alone.clear();
    options.held.resize(block.held);
    std::iota(options.held.begin(), options.held.end(), static_cast<Mesh::Index>(block.fixed));
    shop = std::make_unique<Workshop>(block.mesh, model, options);
    before = shop->guard.measures();
    block.mesh = {};  // the shop has it, and the whole mesh has it as it was
  }

  void work(const MeshBlocks& blocks, std::size_t b, Chosen chosen, const Model& model, Observer& observer) {
    Scheduled result = run_schedule(*shop, chosen, observer);
    shop.reset();
    report = result.report;
    block.mesh = result.better ? *std::move(result.better) : blocks.cut_out(b).mesh;
    after = measures_of(block.mesh, model);
  }
};

std::array<Vec3, 4> corners(const Mesh& mesh, std::size_t tet) {
  const auto& t = mesh.tets[tet];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]};
}

/// Those of the vertices that stayed, as they are numbered now.
void renumber(MeshVertices& vertices, const MeshVertices& number) {
  for (Mesh::Index& v : vertices) v = number[v];
  std::erase(vertices, MeshBlocks::kGone);
}

/// A mesh on its way through blocks.
class Passage {
 public:
  Passage(Mesh& mesh, const Model& model, const FinalizeOptions& options, Observer& observer)
      : mesh_(mesh),
        model_(model),
        options_(options),
        observer_(observer),
        account_(mesh, model, options.volume_beyond) {
    report_.min_dihedral_before = std::numbers::pi / 2;
  }

  [[nodiscard]] MeshBlocks cut(const Tets& tets, std::size_t most) const {
    return {mesh_, options_.fixed_vertices, options_.held, tets, most};
  }

  [[nodiscard]] double share_at_seams(const MeshBlocks& blocks) const {
    return static_cast<double>(tets_near(mesh_, blocks.seam(), kSeamLayers).size()) /
           static_cast<double>(mesh_.tets.size());
  }

  /// Works on the blocks, which are used up by it; the tetrahedra about their seams.
  Tets work_on(const MeshBlocks& blocks, Chosen chosen) {
    if (observer_.cancelled()) throw Cancelled();
    std::vector<Task> tasks(blocks.size());
    run(blocks, chosen, tasks);
    std::vector<MeshBlock> done;
    for (Task& task : tasks) done.push_back(std::move(task.block));
    MeshVertices seam = blocks.seam();
    rims_.insert(rims_.end(), blocks.rim().begin(), blocks.rim().end());
    if (options_.scope == FinalizeScope::kSmoothing) {
      MeshBlocks::move_to(done, mesh_.points);
    } else {
      MeshBlocks::Whole whole = blocks.put_together(done);
      renumber(seam, whole.number);
      renumber(rims_, whole.number);
      options_.held = std::move(whole.held);
      mesh_ = std::move(whole.mesh);
    }
    return tets_near(mesh_, seam, kSeamLayers);
  }

  /// Tetrahedra about those at the rims of blocks about seams whose shapes fall short: there what was made
  /// could not be worked on.
  [[nodiscard]] Tets short_at_rims() const {
    const double of_chase = squared_cotangent(kChaseAngle), of_obtuse = squared_cotangent(kObtuse);
    MeshVertices vertices;
    for (const Mesh::Index t : tets_near(mesh_, rims_, 1)) {
      const std::array<Vec3, 4> p = corners(mesh_, t);
      const DihedralCotangents range = dihedral_cotangents(p[0], p[1], p[2], p[3]);
      if (range.smallest > of_chase || range.largest < of_obtuse)
        vertices.insert(vertices.end(), mesh_.tets[t].begin(), mesh_.tets[t].end());
    }
    return tets_near(mesh_, vertices, kSeamLayers);
  }

  [[nodiscard]] FinalizeReport finish() {
    sort_boundary(mesh_);
    const DihedralExtremes after = dihedral_extremes(mesh_, options_.target_dihedral);
    report_.min_dihedral_after = after.range.smallest;
    report_.max_dihedral_after = after.range.largest;
    report_.below_target = after.below;
    return report_;
  }

 private:
  void run(const MeshBlocks& blocks, Chosen chosen, std::vector<Task>& tasks) {
    for_each_block(tasks.size(), [&](std::size_t b) { tasks[b].begin(blocks, b, model_, options_); });
    for (const Task& task : tasks) task.shop->started = started_;
    if (!at_first_) {
      at_first_.emplace();
      for (const Task& task : tasks) at_first_->add(task.shop->guard.at_first());
    }
    Watch watch(observer_);
    for_each_block(tasks.size(), [&](std::size_t b) {
      Task& task = tasks[b];
      task.shop->guard.aim_at(account_.goals_of(task.before), *at_first_);
      task.work(blocks, b, chosen, model_, watch);
    });
    std::size_t count = 0;
    for (const Task& task : tasks) {
      account_.add(task.before, task.after);
      add_to(report_, task.report);
      count += task.block.mesh.tets.size();
    }
    observer_.note(fmt::format("finalization: {} tetrahedra in {} blocks", count, tasks.size()));
  }

  Mesh& mesh_;
  const Model& model_;
  FinalizeOptions options_;  ///< what is held is numbered as the mesh is now
  Observer& observer_;
  MeasureAccount account_;
  FinalizeReport report_;
  std::optional<WorstFits> at_first_;  ///< of the whole
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  MeshVertices rims_;  ///< of blocks about seams
};

}  // namespace

std::optional<FinalizeReport> finalize_in_blocks(Mesh& mesh, const Model& model,
                                                 const FinalizeOptions& options, Observer& observer) {
  if (mesh.tets.size() < 2 * options.block_tets) return std::nullopt;
  Passage passage(mesh, model, options, observer);
  Tets tets(mesh.tets.size());
  std::iota(tets.begin(), tets.end(), 0);
  std::size_t most = options.block_tets;
  auto blocks = std::make_optional(passage.cut(tets, most));
  while (passage.share_at_seams(*blocks) > kMostAtSeams) {
    most *= 2;
    if (tets.size() < 2 * most) return std::nullopt;
    blocks.emplace(passage.cut(tets, most));
  }
  while (blocks) {
    Tets rest = passage.work_on(*blocks, Chosen::kByScope);
    if (2 * rest.size() > tets.size()) most = rest.size();  // what does not get less is taken as one
    tets = std::move(rest);
    blocks.reset();
    if (!tets.empty()) blocks.emplace(passage.cut(tets, most));
  }
  if (options.scope == FinalizeScope::kFast || options.scope == FinalizeScope::kAll) {
    tets = passage.short_at_rims();
    if (!tets.empty()) passage.work_on(passage.cut(tets, options.block_tets), Chosen::kWorst);
  }
  return passage.finish();
}

}  // namespace octet
