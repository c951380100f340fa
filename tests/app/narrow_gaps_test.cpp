// SPDX-License-Identifier: BSD-3-Clause
// Boundary vertices at a slit are told from those at a wall as thin.
#include "app/narrow_gaps.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "app/mesh_part.h"
#include "geom/occt/from_shape.h"
#include "octree/octree.h"

namespace octet {
namespace {

TopoDS_Shape ring(double inner, double outer) {
  const gp_Ax2 axis(gp_Pnt(3, 3, 1), gp::DZ());
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(axis, outer, 5.0).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, inner, 5.0).Shape())
      .Shape();
}

/// A block with a round slit from radius 1 to 1 + `slit`, above z = 1, and a wall as thin around it, up to
/// 1 + 2 slit, where a wide pocket begins.
TopoDS_Shape block(double slit) {
  const TopoDS_Shape whole = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(6, 6, 3)).Shape();
  const TopoDS_Shape slitted = BRepAlgoAPI_Cut(whole, ring(1.0, 1.0 + slit)).Shape();
  return BRepAlgoAPI_Cut(slitted, ring(1.0 + 2.0 * slit, 2.5)).Shape();
}

MeshOptions as_begun() {
  MeshOptions options;
  options.size = 1.0;
  options.gap_elements = 0.0;
  options.finalize = false;
  return options;
}

std::vector<Vec3> found_in(double slit, std::span<const Vec3> around = {}) {
  const Model model = model_from_shape(block(slit));
  const Mesh mesh = mesh_part(model, as_begun()).mesh;
  std::vector<Vec3> places;
  for (const Mesh::Index v : vertices_at_gaps(
           mesh, model, [](const Vec3&) { return 1.0; }, around))
    places.push_back(mesh.points[v]);
  return places;
}

TEST(NarrowGaps, VerticesOfASlitAndNotOfAWall) {
  constexpr double kSlit = 0.05;
  const std::vector<Vec3> places = found_in(kSlit);
  const auto count_at = [&](double radius) {
    return std::count_if(places.begin(), places.end(), [&](const Vec3& p) {
      return std::abs(std::hypot(p.x() - 3.0, p.y() - 3.0) - radius) < 1e-6;
    });
  };
  EXPECT_GT(count_at(1.0), 10);
  EXPECT_GT(count_at(1.0 + kSlit), 10);
  EXPECT_EQ(count_at(1.0 + 2.0 * kSlit), 0) << "the pocket's side of the wall";
  EXPECT_EQ(count_at(1.0) + count_at(1.0 + kSlit), static_cast<std::ptrdiff_t>(places.size()));
}

TEST(NarrowGaps, OnlyAroundThePlacesGiven) {
  const std::vector<Vec3> all = found_in(0.05), around{Vec3(3, 0, 3)}, some = found_in(0.05, around);
  EXPECT_GT(some.size(), 5u);
  EXPECT_LT(some.size(), all.size());
  for (const Vec3& p : some) EXPECT_LE((p - around[0]).norm(), 3.0);
}

TEST(NarrowGaps, NoneInASlitAsWideAsAThirdOfTheSize) { EXPECT_TRUE(found_in(0.33).empty()); }

TEST(NarrowGaps, NoneBetweenPlanes) {
  const TopoDS_Shape whole = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(6, 4, 4)).Shape();
  const TopoDS_Shape slit = BRepPrimAPI_MakeBox(gp_Pnt(2, -1, 1), gp_Pnt(2.05, 5, 5)).Shape();
  const Model model = model_from_shape(BRepAlgoAPI_Cut(whole, slit).Shape());
  const Mesh mesh = mesh_part(model, as_begun()).mesh;
  for (const Mesh::Index v : vertices_at_gaps(mesh, model, [](const Vec3&) { return 1.0; }))
    EXPECT_LT(mesh.point_on[v].dim, 2) << "edges alone";
}

TEST(GapRooms, AreLessThanTheSlitOnBothItsSidesAndEndlessElsewhere) {
  constexpr double kSlit = 0.05;
  const Model model = model_from_shape(block(kSlit));
  const Octree tree = build_octree(model, {.size = 1.0}, {});
  const GapRooms rooms(mesh_part(model, as_begun()).mesh, model, tree);
  for (const double radius : {1.0, 1.0 + kSlit})
    for (const double angle : {0.1, 1.3, 2.9, 4.4}) {
      const double room = rooms.at({3.0 + radius * std::cos(angle), 3.0 + radius * std::sin(angle), 2.0});
      EXPECT_NEAR(room, 0.8 * kSlit, 1e-6);
    }
  EXPECT_EQ(rooms.at({0, 0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(rooms.at({5.9, 5.9, 3.0}), std::numeric_limits<double>::infinity());
}

TEST(GapRooms, NoneInASlitAsWideAsAThirdOfTheSize) {
  const Model model = model_from_shape(block(0.33));
  const Octree tree = build_octree(model, {.size = 1.0}, {});
  EXPECT_TRUE(GapRooms(mesh_part(model, as_begun()).mesh, model, tree).empty());
}

}  // namespace
}  // namespace octet
