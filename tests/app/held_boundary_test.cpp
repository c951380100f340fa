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
#include <string_view>
#include <vector>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

TopoDS_Shape pin(double radius) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 6, 1), gp::DZ()), radius, 5.0).Shape();
}

/// A block, 12 by 12 by 3, with a round slit about its middle.
TopoDS_Shape slitted_block(double slit) {
  const TopoDS_Shape whole = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(12, 12, 3)).Shape();
  return BRepAlgoAPI_Cut(whole, BRepAlgoAPI_Cut(pin(4.0 + slit), pin(4.0)).Shape()).Shape();
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

  const Model model_ = model_from_shape(slitted_block(0.05));
  const Mesh mesh_ = mesh_part(model_, options()).mesh;
  const std::array<Vec3, 1> left_{Vec3(2, 6, 3)}, right_{Vec3(10, 6, 3)}, corner_{Vec3(0, 0, 0)};
  const Octree tree_ = build_octree(model_, {.size = 1.0 / kSpacingPerOctant}, {});
  HeldBoundary held_{model_};
};

TEST_F(Held, GrowsFromTryToTryToTheWholeBoundary) {
  EXPECT_FALSE(held_.holds_any());
  std::vector<std::size_t> counts;
  ASSERT_TRUE(held_.is_hopeful());
  EXPECT_EQ(held_.rooms(), nullptr);
  held_.hold_more(left_, true);
  EXPECT_TRUE(held_.find(mesh_, tree_));
  ASSERT_NE(held_.rooms(), nullptr);
  EXPECT_LT(held_.rooms()->at({10.0, 6.0, 2.0}), 0.05);
  EXPECT_TRUE(held_.vertices().empty()) << "the boundary keeps to its faces first";
  for (const auto& places : {left_, right_, corner_, corner_}) {
    ASSERT_TRUE(held_.is_hopeful());
    held_.hold_more(places, true);
    held_.find(mesh_, tree_);
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
  EXPECT_TRUE(held_.find(mesh_, tree_));
  EXPECT_TRUE(held_.is_last_resort());
  const auto holds = [&](const Vec3& place) {
    return std::any_of(held_.vertices().begin(), held_.vertices().end(),
                       [&](Mesh::Index v) { return (mesh_.points[v] - place).norm() < 1e-9; });
  };
  EXPECT_TRUE(holds(corner_[0])) << "near no gap, but at a fault";
  EXPECT_FALSE(holds(Vec3(12, 12, 0)));
  EXPECT_LT(held_.vertices().size(), boundary());

  ASSERT_TRUE(held_.hold_at_last(corner_));
  EXPECT_TRUE(held_.find(mesh_, tree_));
  EXPECT_EQ(held_.vertices().size(), boundary());
  EXPECT_FALSE(held_.hold_at_last(corner_));
}

/// Notes that name what is held.
struct Listener : Observer {
  void note(std::string_view text) override {
    if (text.find("will be held") != std::string_view::npos) ++held;
    if (text.find("will keep to its faces") != std::string_view::npos) ++kept_near;
  }
  int held = 0, kept_near = 0;
};

// A slit far narrower than what chords of the size leave the cylinders by: the boundary keeps to what is free
// there. It had crossed itself in all tries but the last, with vertices held in four.
TEST(FinalizedSlit, DoesNotCrossItselfThoughNothingIsHeld) {
  for (const double slit : {0.01, 0.02}) {
    MeshOptions options;
    options.size = 1.0;
    options.gap_elements = 0.0;
    Listener listener;
    const MeshResult result = mesh_part(model_from_shape(slitted_block(slit)), options, listener);
    EXPECT_EQ(result.report.status, MeshStatus::kComplete);
    EXPECT_EQ(listener.kept_near, 1);
    EXPECT_EQ(listener.held, 0);
    EXPECT_LT(result.report.tets, 8000u) << "17 000 where octants are subdivided at the faults";
  }
}

TEST_F(Held, VerticesAtOnceWhereTheBoundaryDoesNotCrossItself) {
  held_.hold_more(left_, false);
  EXPECT_TRUE(held_.find(mesh_, tree_));
  EXPECT_GT(held_.vertices().size(), 5u);
  EXPECT_NE(held_.rooms(), nullptr);
}

TEST_F(Held, WhatHeldTheSameInANewMeshIsSpent) {
  held_.hold_more(left_, true);
  held_.find(mesh_, tree_);
  held_.find_anew(mesh_, tree_);
  EXPECT_TRUE(held_.is_hopeful()) << "rooms are of the mesh";
  held_.hold_more(left_, true);
  held_.find(mesh_, tree_);
  ASSERT_TRUE(held_.is_hopeful());
  held_.find_anew(mesh_, tree_);
  EXPECT_FALSE(held_.is_hopeful());
}

}  // namespace
}  // namespace octet
