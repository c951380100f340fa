// SPDX-License-Identifier: BSD-3-Clause
// The passes for the mean raise it, spare the worst, and do not depend on the number of threads.
#include "finalize/relax.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "finalize/shape.h"
#include "mesh/quality.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

Part jittered_cylinder() { return testing::jittered(testing::cylinder_part(8), 0.08, 3); }

double worst_shape(const WorkMesh& mesh) {
  double worst = 1.0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    if (mesh.alive(TetId(i))) worst = std::min(worst, mesh.quality[TetId(i)]);
  }
  return worst;
}

/// The mesh after the pass, held to what each pass promises.
template <class Pass>
Mesh after(const Pass& pass, int threads, double size = 0.25) {
  const Part part = jittered_cylinder();
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  const FinalizeOptions options = testing::options_of_size(size);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  const double floor = shape_of_angle(0.3), worst = worst_shape(shop.mesh);
  const double mean = quality_summary(part.mesh).mean_mean_ratio;
  tbb::task_arena arena(threads);
  arena.execute([&] { pass(shop, floor); });
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
  EXPECT_GE(worst_shape(shop.mesh), 0.99 * std::min(worst, floor));
  const Mesh mesh = to_mesh(shop.mesh);
  EXPECT_EQ(faults_of(mesh, part.model, euler), "");
  EXPECT_GT(quality_summary(mesh).mean_mean_ratio, mean);
  return mesh;
}

void smooth(Workshop& shop, double floor) { relax_for_mean(shop, floor, 3); }
void swap(Workshop& shop, double floor) { swap_for_mean(shop, floor); }

TEST(Relax, SmoothingRaisesTheMeanAndGivesTheSameMeshFromAnyNumberOfThreads) {
  const Mesh one = after(smooth, 1), two = after(smooth, 2);
  EXPECT_EQ(one.points, two.points);
}

TEST(Relax, SwapsRaiseTheMeanAndGiveTheSameMeshFromAnyNumberOfThreads) {
  const Mesh one = after(swap, 1), two = after(swap, 2);
  EXPECT_EQ(one.tets, two.tets);
  EXPECT_EQ(one.triangles, two.triangles);
}

TEST(Relax, CollapsesRaiseTheMeanAndKeepTheMeshRight) {
  const auto collapse = [](Workshop& shop, double floor) {
    collapse_for_mean(shop, floor);
    EXPECT_GT(shop.report.collapses, 0u);
  };
  after(collapse, 1, 0.5);
}

TEST(Relax, LeavesALatticeThatIsGoodEnoughAlone) {
  // All of the five-tetrahedra lattice's angles are 54.7 degrees or more.
  const Part part = testing::box_part({1, 1, 1}, 4, 4, 4);
  const FinalizeOptions options = testing::options_of_size(0.25);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  for (std::size_t i = 0; i < shop.mesh.quality.size(); ++i) shop.mesh.quality[TetId(i)] = 0.7;
  relax_for_mean(shop, 0.3, 2);
  swap_for_mean(shop, 0.3);
  EXPECT_EQ(to_mesh(shop.mesh).points, to_mesh(to_work_mesh(part.mesh)).points);
  EXPECT_EQ(shop.report.smoothed + shop.report.edge_removals + shop.report.face_swaps, 0u);
}

}  // namespace
}  // namespace octet
