// SPDX-License-Identifier: BSD-3-Clause
// Large meshes in blocks: cut, put together, and finalized as the whole is.
#include "finalize/in_blocks.h"
#include "base/constants.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <numeric>
#include <set>
#include <string>
#include <thread>

#include "base/error.h"
#include "finalize/measure_account.h"
#include "finalize/mesh_blocks.h"
#include "mesh/quality.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

std::vector<Mesh::Index> all_tets(const Mesh& mesh) {
  std::vector<Mesh::Index> tets(mesh.tets.size());
  std::iota(tets.begin(), tets.end(), 0);
  return tets;
}

/// Elements by their corners' places and their entity, in any order.
template <class Elements>
auto by_places(const Mesh& mesh, const Elements& elements, const std::vector<std::int32_t>& on) {
  constexpr std::size_t kCorners = std::tuple_size_v<typename Elements::value_type>;
  std::multiset<std::pair<std::int32_t, std::array<std::array<double, 3>, kCorners>>> found;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    std::array<std::array<double, 3>, kCorners> places;
    for (std::size_t k = 0; k < kCorners; ++k) {
      const Vec3& p = mesh.points[elements[i][k]];
      places[k] = {p.x(), p.y(), p.z()};
    }
    found.insert({on[i], places});
  }
  return found;
}

/// Notes of a run.
struct Listener : Observer {
  void note(std::string_view text) override { notes.emplace_back(text); }
  std::vector<std::string> notes;
};

/// A long bar, jittered: blocks of it have few tetrahedra about their seams.
Part jittered_bar() { return testing::jittered(testing::box_part({40, 1, 1}, 120, 3, 3, true), 0.08, 7); }

TEST(MeshBlocks, PutTogetherUnchangedAreTheMesh) {
  const Part part = testing::two_boxes_part(6);
  const Mesh& mesh = part.mesh;
  const MeshBlocks blocks(mesh, 0, {}, all_tets(mesh), 400);
  ASSERT_EQ(blocks.size(), (mesh.tets.size() + 399) / 400);
  std::vector<MeshBlock> cut;
  std::size_t tets = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    cut.push_back(blocks.cut_out(b));
    EXPECT_LE(cut[b].mesh.tets.size(), 400u);
    EXPECT_GT(cut[b].fixed, 0u);
    tets += cut[b].mesh.tets.size();
  }
  EXPECT_EQ(tets, mesh.tets.size());
  const Mesh whole = blocks.put_together(cut).mesh;
  EXPECT_EQ(faults_of(whole, part.model, testing::face_euler(mesh, part.model.count(2))), "");
  EXPECT_EQ(by_places(whole, whole.tets, whole.tet_in), by_places(mesh, mesh.tets, mesh.tet_in));
  EXPECT_EQ(by_places(whole, whole.edges, whole.edge_on), by_places(mesh, mesh.edges, mesh.edge_on));
  EXPECT_EQ(by_places(whole, whole.triangles, whole.triangle_on),
            by_places(mesh, mesh.triangles, mesh.triangle_on));
}

/// As meshes with gaps have them, and those of other programs.
TEST(MeshBlocks, EdgesAndTrianglesOfNoTetrahedronAreNoneOfABlock) {
  const Part part = testing::two_boxes_part(6);
  Mesh mesh = part.mesh;
  const std::size_t edges = mesh.edges.size(), triangles = mesh.triangles.size();
  const auto last = static_cast<Mesh::Index>(mesh.points.size());
  mesh.points.emplace_back(9.0, 9.0, 9.0);  // of nothing else
  mesh.point_on.push_back(model_edge(1));
  const std::array<Mesh::Index, 2> loose[2] = {{0, last}, {0, last - 1}};
  for (const auto& edge : loose) {
    mesh.edges.push_back(edge);
    mesh.edge_on.push_back(1);
  }
  mesh.triangles.push_back({0, last / 2, last - 1});
  mesh.triangle_on.push_back(1);
  const auto expect_in_range = [](const Mesh& of) {
    const auto all = [&](const auto& elements) {
      for (const auto& element : elements)
        for (const Mesh::Index v : element) EXPECT_LT(v, of.points.size());
    };
    all(of.edges);
    all(of.triangles);
  };
  const MeshBlocks blocks(mesh, 0, {}, all_tets(mesh), 400);
  std::vector<MeshBlock> cut;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    cut.push_back(blocks.cut_out(b));
    expect_in_range(cut[b].mesh);
  }
  const Mesh whole = blocks.put_together(cut).mesh;
  expect_in_range(whole);
  EXPECT_EQ(whole.edges.size(), edges);
  EXPECT_EQ(whole.triangles.size(), triangles);
}

/// Cut where two regions meet: their interface belongs to both blocks, and is there once in the end.
TEST(MeshBlocks, BothHaveTheTrianglesAndEdgesBetweenThem) {
  const Part part = testing::two_boxes_part(4);
  const Mesh& mesh = part.mesh;
  const MeshBlocks blocks(mesh, 0, {}, all_tets(mesh), mesh.tets.size() / 2);
  ASSERT_EQ(blocks.size(), 2u);
  const auto on_interface = [&](const Mesh& of) {
    std::size_t count = 0;
    for (const int face : of.triangle_on) {
      const auto& region = part.model.face(face).region;
      count += region[0] > 0 && region[1] > 0;
    }
    return count;
  };
  ASSERT_EQ(on_interface(mesh), 32u);
  EXPECT_EQ(on_interface(blocks.cut_out(0).mesh), 32u);
  EXPECT_EQ(on_interface(blocks.cut_out(1).mesh), 32u);
  EXPECT_EQ(blocks.seam().size(), 25u);
  EXPECT_EQ(on_interface(blocks.put_together({blocks.cut_out(0), blocks.cut_out(1)}).mesh), 32u);
}

TEST(MeshBlocks, OfSomeTetrahedraLeaveTheOthersAndTellTheRim) {
  const Part part = testing::box_part({1, 1, 1}, 4, 4, 4);
  const Mesh& mesh = part.mesh;
  const std::vector<Mesh::Index> some = tets_near(mesh, {0}, 2);
  ASSERT_LT(some.size(), mesh.tets.size());
  const MeshBlocks blocks(mesh, 0, {}, some, mesh.tets.size());
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_TRUE(blocks.seam().empty());
  std::set<Mesh::Index> inside, beyond, both;
  for (Mesh::Index t = 0; t < mesh.tets.size(); ++t) {
    const bool chosen = std::binary_search(some.begin(), some.end(), t);
    for (const Mesh::Index v : mesh.tets[t]) (chosen ? inside : beyond).insert(v);
  }
  std::set_intersection(inside.begin(), inside.end(), beyond.begin(), beyond.end(),
                        std::inserter(both, both.end()));
  EXPECT_EQ(std::set<Mesh::Index>(blocks.rim().begin(), blocks.rim().end()), both);
  const MeshBlock block = blocks.cut_out(0);
  EXPECT_EQ(block.fixed, both.size());
  EXPECT_EQ(block.mesh.tets.size(), some.size());
  const Mesh whole = blocks.put_together({block}).mesh;
  EXPECT_EQ(faults_of(whole, part.model, testing::face_euler(mesh, part.model.count(2))), "");
}

TEST(TetsNear, GrowByLayers) {
  const Part part = testing::box_part({1, 1, 1}, 6, 6, 6);
  std::size_t before = 0;
  for (const int layers : {1, 2, 3}) {
    const std::vector<Mesh::Index> near = tets_near(part.mesh, {0}, layers);
    EXPECT_GT(near.size(), before);
    before = near.size();
    double farthest = 0.0;
    for (const Mesh::Index t : near)
      for (const Mesh::Index v : part.mesh.tets[t])
        farthest = std::max(farthest, (part.mesh.points[v] - part.mesh.points[0]).cwiseAbs().maxCoeff());
    EXPECT_NEAR(farthest, layers / 6.0, 1e-12);
  }
  EXPECT_TRUE(tets_near(part.mesh, {}, 3).empty());
}

/// What blocks are to have in all is what the part is to have, and so is what they may err by.
TEST(MeasureAccount, SharesAddUp) {
  const Part part = testing::cylinder_part(8);
  const Mesh& mesh = part.mesh;
  const std::vector<double> beyond{0.0, 0.125};
  const MeasureAccount account(mesh, part.model, beyond);
  const MeshBlocks blocks(mesh, 0, {}, all_tets(mesh), 500);
  ASSERT_GT(blocks.size(), 4u);
  MeasureGoals sum{{0.0, 0.0}, {0.0, 0.0}, std::vector<double>(4, 0.0), 0.0};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const MeasureGoals goals = account.goals_of(measures_of(blocks.cut_out(b).mesh, part.model));
    sum.volume[1] += goals.volume[1];
    sum.volume_error[1] += goals.volume_error[1];
    for (std::size_t f = 1; f < sum.area.size(); ++f) sum.area[f] += goals.area[f];
    sum.area_error += goals.area_error;
  }
  Measures whole = measures_of(mesh, part.model);
  whole.volume[1] += beyond[1];
  const MeasureGoals goals = goals_of_model(part.model, whole);
  EXPECT_EQ(goals.volume[1], part.model.region(1).volume);
  EXPECT_NEAR(sum.volume[1], goals.volume[1] - beyond[1], 1e-12);
  EXPECT_NEAR(sum.volume_error[1], goals.volume_error[1], 1e-12);
  for (std::size_t f = 1; f < sum.area.size(); ++f) {
    EXPECT_EQ(goals.area[f], part.model.face(static_cast<int>(f)).area);
    EXPECT_NEAR(sum.area[f], goals.area[f], 1e-12);
  }
  EXPECT_NEAR(sum.area_error, goals.area_error, 1e-12);
}

/// A ten-thousandth, or a tenth more than the error there is.
TEST(MeasureAccount, GoalsOfTheModelAllowATenthMore) {
  const Part part = testing::cylinder_part(8);
  const Measures now = measures_of(part.mesh, part.model);
  const MeasureGoals goals = goals_of_model(part.model, now);
  const double off = std::abs(now.volume[1] - part.model.region(1).volume);
  ASSERT_GT(off, 1e-3 * part.model.region(1).volume);
  EXPECT_NEAR(goals.volume_error[1], 1.1 * off, 1e-12);
  Measures exact = now;
  exact.volume[1] = part.model.region(1).volume;
  EXPECT_NEAR(goals_of_model(part.model, exact).volume_error[1], 1e-4 * exact.volume[1], 1e-12);
}

/// Finalized in blocks and as a whole: both keep what finalize() promises, and blocks do no worse.
void expect_no_worse_in_blocks(const Part& part, double size, std::size_t block_tets) {
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  FinalizeOptions options = testing::options_of_size(size);
  Mesh whole = part.mesh, blocks = part.mesh;
  Listener listener;
  const FinalizeReport of_whole = finalize(whole, part.model, options, listener);
  EXPECT_TRUE(listener.notes.empty());
  options.block_tets = block_tets;
  const FinalizeReport of_blocks = finalize(blocks, part.model, options, listener);
  ASSERT_GT(listener.notes.size(), 1u) << "blocks, and what lies about their seams";
  EXPECT_EQ(faults_of(blocks, part.model, euler), "");
  const QualitySummary a = quality_summary(whole), b = quality_summary(blocks);
  EXPECT_NEAR(b.min_dihedral, of_blocks.min_dihedral_after, 1e-12);
  EXPECT_NEAR(b.max_dihedral, of_blocks.max_dihedral_after, 1e-12);
  EXPECT_EQ(of_blocks.min_dihedral_before, of_whole.min_dihedral_before);
  EXPECT_EQ(of_blocks.below_target, 0u);
  EXPECT_GT(of_blocks.min_dihedral_after,
            std::min(of_whole.min_dihedral_after, 30.0 * kDegree) - 2.0 * kDegree);
  EXPECT_NEAR(b.mean_mean_ratio, a.mean_mean_ratio, 0.01);
  const double exact = part.model.region(1).volume, off = std::abs(testing::total_volume(part.mesh) - exact);
  if (part.model.count(3) == 1) {
    EXPECT_LE(std::abs(testing::total_volume(blocks) - exact), std::max(1.1 * off, 1e-4 * exact));
  }
}

TEST(FinalizeInBlocks, DoesAsWellAsAsAWholeOnABar) { expect_no_worse_in_blocks(jittered_bar(), 0.33, 1800); }

TEST(FinalizeInBlocks, DoesAsWellAsAsAWholeOnARoundShell) {
  Part part = testing::jittered(testing::shell_part(16, 0.85), 0.02, 3);
  expect_no_worse_in_blocks(part, 0.13, part.mesh.tets.size() / 2);
}

TEST(FinalizeInBlocks, DoesAsWellAsAsAWholeWhereRegionsMeetAtASeam) {
  Part part = testing::jittered(testing::two_boxes_part(12), 0.02, 4);
  expect_no_worse_in_blocks(part, 1.0 / 12.0, part.mesh.tets.size() / 2);
}

TEST(FinalizeInBlocks, ManyThreadsGiveTheBytesOfOne) {
  const Part part = jittered_bar();
  FinalizeOptions options = testing::options_of_size(0.33);
  options.block_tets = 1800;
  std::vector<Mesh> meshes;
  for (const int threads : {1, 2}) {
    meshes.push_back(part.mesh);
    Observer observer;
    tbb::task_arena(threads).execute([&] { finalize(meshes.back(), part.model, options, observer); });
  }
  EXPECT_EQ(meshes[0].points, meshes[1].points);
  EXPECT_EQ(meshes[0].tets, meshes[1].tets);
  EXPECT_EQ(meshes[0].triangles, meshes[1].triangles);
  EXPECT_EQ(meshes[0].edges, meshes[1].edges);
}

TEST(FinalizeInBlocks, FixedVerticesKeepTheirNumbersAndHeldOnesTheirPlaces) {
  const Part part = jittered_bar();
  FinalizeOptions options = testing::options_of_size(0.33);
  options.block_tets = 1800;
  options.fixed_vertices = 40;
  std::set<std::array<double, 3>> held;
  for (Mesh::Index v = 100; v < part.mesh.points.size(); v += 3) {
    if (part.mesh.point_on[v].dim != 2) continue;
    options.held.push_back(v);
    const Vec3& p = part.mesh.points[v];
    held.insert({p.x(), p.y(), p.z()});
  }
  ASSERT_GT(held.size(), 100u);
  Mesh mesh = part.mesh;
  Listener listener;
  finalize(mesh, part.model, options, listener);
  ASSERT_GT(listener.notes.size(), 1u);
  for (std::size_t v = 0; v < options.fixed_vertices; ++v) EXPECT_EQ(mesh.points[v], part.mesh.points[v]);
  for (const Vec3& p : mesh.points) held.erase({p.x(), p.y(), p.z()});
  EXPECT_TRUE(held.empty()) << held.size() << " have moved";
}

TEST(FinalizeInBlocks, SmoothingKeepsNumbersAndTetrahedra) {
  const Part part = jittered_bar();
  FinalizeOptions options = testing::options_of_size(0.33);
  options.block_tets = 1800;
  options.scope = FinalizeScope::kSmoothing;
  Mesh mesh = part.mesh;
  Observer observer;
  const FinalizeReport report = finalize(mesh, part.model, options, observer);
  EXPECT_EQ(mesh.tets, part.mesh.tets);
  EXPECT_GT(report.smoothed, 100u);
  EXPECT_GT(report.min_dihedral_after, report.min_dihedral_before);
}

TEST(FinalizeInBlocks, LeavesMeshesWholeOfWhichAnyTwoBlocksAreMuchSeam) {
  Part part = testing::box_part({1, 1, 1}, 8, 8, 8);
  FinalizeOptions options = testing::options_of_size(0.125);
  options.block_tets = 400;
  Observer observer;
  EXPECT_FALSE(finalize_in_blocks(part.mesh, part.model, options, observer).has_value());
}

/// In blocks of 200 all of the bar would lie about seams.
TEST(FinalizeInBlocks, BlocksGetLargerUntilLittleLiesAboutTheirSeams) {
  Part part = jittered_bar();
  FinalizeOptions options = testing::options_of_size(0.33);
  options.block_tets = 200;
  Listener listener;
  ASSERT_TRUE(finalize_in_blocks(part.mesh, part.model, options, listener).has_value());
  ASSERT_FALSE(listener.notes.empty());
  std::size_t tets = 0, blocks = 0;
  ASSERT_EQ(
      std::sscanf(listener.notes[0].c_str(), "finalization: %zu tetrahedra in %zu blocks", &tets, &blocks),
      2);
  EXPECT_GE(blocks, 2u);
  EXPECT_LE(blocks, 8u);
}

/// Cancels when it is asked for the n-th time, and notes whether another thread than its own has asked.
struct Canceller : Observer {
  explicit Canceller(int n) : left(n) {}
  [[nodiscard]] bool cancelled() const override {
    foreign = foreign || std::this_thread::get_id() != own;
    return --left <= 0;
  }
  mutable std::atomic<int> left;
  mutable std::atomic<bool> foreign = false;
  std::thread::id own = std::this_thread::get_id();
};

/// Before the blocks, and within one.
TEST(FinalizeInBlocks, CanBeCancelledByTheCallersThread) {
  FinalizeOptions options = testing::options_of_size(0.33);
  options.block_tets = 1800;
  for (const int asked : {1, 4}) {
    Part part = jittered_bar();
    Canceller canceller(asked);
    EXPECT_THROW(finalize(part.mesh, part.model, options, canceller), Cancelled);
    EXPECT_FALSE(canceller.foreign);
    EXPECT_EQ(part.mesh.tets, jittered_bar().mesh.tets) << "the mesh given is there still";
  }
}

}  // namespace
}  // namespace octet
