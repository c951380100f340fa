// SPDX-License-Identifier: BSD-3-Clause
// The largest angles fall, and nothing gets worse than what they were of.
#include "finalize/improve.h"

#include <gtest/gtest.h>

#include <numbers>

#include "finalize/relax.h"
#include "finalize/shape.h"
#include "mesh/quality.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

TEST(Improve, ObtuseAnglesAreOpened) {
  Part part = testing::cylinder_part(8);
  testing::Dice dice(3);
  testing::jitter(part.mesh, part.model, 0.05, dice);
  const std::vector<int> euler = testing::face_euler(part.mesh, part.model.count(2));
  const FinalizeOptions options = testing::options_of_size(0.25);
  Workshop shop(to_work_mesh(part.mesh), part.model, options);
  Observer observer;
  improve_worst_first(shop, shape_of_angle(0.5), observer);
  const QualitySummary before = quality_summary(to_mesh(shop.mesh));
  const double limit = before.max_dihedral - 0.1;
  ASSERT_GT(limit, std::numbers::pi / 2) << "none is obtuse";
  forget_failures(shop);
  EXPECT_GT(improve_obtuse(shop, limit, observer), 0u);
  EXPECT_EQ(check_work_mesh(shop.mesh), "");
  const Mesh mesh = to_mesh(shop.mesh);
  EXPECT_EQ(faults_of(mesh, part.model, euler), "");
  const QualitySummary after = quality_summary(mesh);
  EXPECT_LT(after.max_dihedral, before.max_dihedral);
  EXPECT_GE(after.min_dihedral, std::min(before.min_dihedral, std::numbers::pi - before.max_dihedral));
  EXPECT_EQ(improve_obtuse(shop, std::numbers::pi, observer), 0u) << "none is beyond";
}

}  // namespace
}  // namespace octet
