// SPDX-License-Identifier: BSD-3-Clause
// The table counts each element once and agrees with the summary.
#include "mesh/quality_table.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/error.h"
#include "mesh/local_size.h"
#include "mesh/mid_nodes.h"
#include "tests/support/box_mesh.h"

namespace octet {
namespace {

TEST(QualityTable, CountsEachElementOnceAndAgreesWithTheSummary) {
  Mesh mesh = test::plain_box_mesh(4);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.point_on[v].dim == 3) mesh.points[v].x() += 0.1 * static_cast<double>(v % 3);
  }
  const std::vector<double> size(mesh.points.size(), 0.5);
  const QualityTable table = quality_table(mesh, size, 3);
  const QualitySummary summary = quality_summary(mesh);
  ASSERT_EQ(table.all.size(), 5u);
  for (const Distribution& d : table.all) {
    EXPECT_EQ(d.count, mesh.tets.size());
    EXPECT_EQ(std::accumulate(d.bins.begin(), d.bins.end(), std::size_t{0}), d.count) << d.name;
    EXPECT_LE(d.least, d.p1);
    EXPECT_LE(d.p1, d.median);
    EXPECT_LE(d.median, d.p99);
    EXPECT_LE(d.p99, d.largest);
  }
  EXPECT_EQ(table.all[0].least, summary.min_dihedral);
  EXPECT_EQ(table.all[0].p1, summary.p1_min_dihedral);
  EXPECT_EQ(table.all[1].largest, summary.max_dihedral);
  EXPECT_NEAR(table.all[2].mean, summary.mean_mean_ratio, 1e-12);
  EXPECT_EQ(table.free[0].count + table.limited, table.tets);
  EXPECT_EQ(table.edges.count, element_edges(mesh).size());
}

TEST(QualityTable, TellsTheScaledJacobianOfElementsOfSecondOrder) {
  Mesh mesh = test::plain_box_mesh(2);
  const std::vector<double> size(mesh.points.size(), 1.0);
  mesh.mid = straight_mid_nodes(mesh);
  const QualityTable straight = quality_table(mesh, size, 1);
  ASSERT_EQ(straight.all.size(), 6u);
  EXPECT_EQ(straight.all.back().name, "scaled Jacobian");
  EXPECT_NEAR(straight.all.back().least, 1.0, 1e-12);
  mesh.mid.points[mesh.mid.of_tets[0][2]] += Vec3(0.05, -0.05, 0.02);
  const QualityTable bent = quality_table(mesh, size, 1);
  EXPECT_LT(bent.all.back().least, 0.99);
  EXPECT_GT(bent.all.back().least, 0.0);
  EXPECT_EQ(bent.all.back().count, mesh.tets.size());
}

TEST(QualityTable, SizesThatDoNotFitAreRefused) {
  Mesh mesh = test::plain_box_mesh(4);
  const std::vector<double> size(mesh.points.size(), 0.5);
  EXPECT_THROW((void)quality_table(mesh, {size.data(), 1}, 1), InputError);
  EXPECT_THROW((void)quality_table(mesh, {}, 1), InputError);
  mesh.mid = straight_mid_nodes(mesh);
  mesh.mid.of_tets.pop_back();
  EXPECT_THROW((void)quality_table(mesh, size, 1), InputError);
}

TEST(QualityTable, TheWorstElementIsNamedWithItsEntities) {
  Mesh mesh = test::plain_box_mesh(4);
  // Flatten one element at the boundary.
  std::size_t victim = 0;
  while (mesh.point_on[mesh.tets[victim][3]].dim != 3) ++victim;
  const auto v = mesh.tets[victim];
  const Vec3 middle = (mesh.points[v[0]] + mesh.points[v[1]] + mesh.points[v[2]]) / 3.0;
  mesh.points[v[3]] = middle + 1e-3 * (mesh.points[v[3]] - middle);
  const std::vector<double> size(mesh.points.size(), 0.01);
  const QualityTable table = quality_table(mesh, size, 2);
  ASSERT_EQ(table.worst.size(), 2u);
  const WorstTet& worst = table.worst[0];
  const auto& w = mesh.tets[worst.tet];
  EXPECT_NE(std::find(w.begin(), w.end(), v[3]), w.end());
  EXPECT_FALSE(worst.limited);
  EXPECT_EQ(worst.on.back(), model_region(1));
  for (const Mesh::Index i : w) {
    EXPECT_NE(std::find(worst.on.begin(), worst.on.end(), mesh.point_on[i]), worst.on.end());
  }
}

}  // namespace
}  // namespace octet
