// SPDX-License-Identifier: BSD-3-Clause
// A run takes no more threads than the machine has.
#include "app/usable_threads.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/exit_code.h"
#include "app/mesh_part.h"
#include "geom/analytic.h"
#include "tests/app/program.h"

namespace octet {
namespace {

TEST(UsableThreads, NoMoreRunThanTheMachineHas) {
  EXPECT_EQ(usable_threads(1), 1);
  EXPECT_LE(usable_threads(2147483647), std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  const TemporaryDirectory out;
  const std::string box = model_file("box.step");
  EXPECT_EQ(
      run_octet({"mesh", box, "-o", out.file("a.msh"), "--size", "9", "--threads", "2147483647"}).exit_code,
      kExitComplete);
  EXPECT_EQ(run_octet({"improve", out.file("a.msh"), box, "-o", out.file("b.msh"), "--threads", "2147483647"})
                .exit_code,
            kExitComplete);
  MeshOptions options;
  options.size = 1.0;
  options.threads = 2147483647;
  EXPECT_EQ(mesh_part(analytic_box(Vec3(1, 2, 3)), options).report.status, MeshStatus::kComplete);
}

}  // namespace
}  // namespace octet
