// SPDX-License-Identifier: BSD-3-Clause
// More of a slit's boundary is held from try to try, and all of it at last.
#include "app/held_boundary.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <array>
#include <vector>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

double unit(const Vec3&) { return 1.0; }

TopoDS_Shape pin(double radius) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 6, 1), gp::DZ()), radius, 5.0).Shape();
}

/// A block, 12 by 12 by 3, with a round slit about its middle.
TopoDS_Shape slitted_block() {
  const TopoDS_Shape whole = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(12, 12, 3)).Shape();
  return BRepAlgoAPI_Cut(whole, BRepAlgoAPI_Cut(pin(4.05), pin(4.0)).Shape()).Shape();
}

class Held : public testing::Test {
 protected:
  static MeshOptions options() {
    MeshOptions options;
    options.size = 1.0;
    options.finalize = false;
    return options;
  }
  [[nodiscard]] std::size_t boundary() const {
    return static_cast<std::size_t>(std::count_if(mesh_.point_on.begin(), mesh_.point_on.end(),
                                                  [](const ModelRef& on) { return on.dim < 3; }));
  }

  const Model model_ = model_from_shape(slitted_block());
  const Mesh mesh_ = mesh_part(model_, options()).mesh;
  const std::array<Vec3, 1> left_{Vec3(2, 6, 3)}, right_{Vec3(10, 6, 3)}, corner_{Vec3(0, 0, 0)};
  HeldBoundary held_{model_};
};

TEST_F(Held, GrowsFromTryToTryToTheWholeBoundary) {
  EXPECT_FALSE(held_.holds_any());
  std::vector<std::size_t> counts;
  for (const auto& places : {left_, right_, corner_, corner_}) {
    ASSERT_TRUE(held_.is_hopeful());
    held_.hold_more(places);
    held_.find(mesh_, unit);
    EXPECT_FALSE(held_.is_last_resort());
    EXPECT_TRUE(std::is_sorted(held_.vertices().begin(), held_.vertices().end()));
    counts.push_back(held_.vertices().size());
  }
  EXPECT_FALSE(held_.is_hopeful());
  EXPECT_GT(counts[0], 5u);
  EXPECT_GT(counts[1], counts[0]) << "around both places";
  EXPECT_EQ(counts[2], counts[1]) << "no gap is at the corner";
  EXPECT_GT(counts[3], counts[2]) << "all gaps";

  ASSERT_TRUE(held_.hold_at_last(corner_));
  EXPECT_TRUE(held_.find(mesh_, unit));
  EXPECT_TRUE(held_.is_last_resort());
  const auto holds = [&](const Vec3& place) {
    return std::any_of(held_.vertices().begin(), held_.vertices().end(),
                       [&](Mesh::Index v) { return (mesh_.points[v] - place).norm() < 1e-9; });
  };
  EXPECT_TRUE(holds(corner_[0])) << "near no gap, but at a fault";
  EXPECT_FALSE(holds(Vec3(12, 12, 0)));
  EXPECT_LT(held_.vertices().size(), boundary());

  ASSERT_TRUE(held_.hold_at_last(corner_));
  EXPECT_TRUE(held_.find(mesh_, unit));
  EXPECT_EQ(held_.vertices().size(), boundary());
  EXPECT_FALSE(held_.hold_at_last(corner_));
}

TEST_F(Held, WhatHeldTheSameInANewMeshIsSpent) {
  held_.hold_more(left_);
  held_.find(mesh_, unit);
  ASSERT_TRUE(held_.is_hopeful());
  held_.find_anew(mesh_, unit);
  EXPECT_FALSE(held_.is_hopeful());
}

}  // namespace
}  // namespace octet
