// SPDX-License-Identifier: BSD-3-Clause
// What loose closed shells bound: solids, and voids in them.
#include "geom/occt/shell_solids.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/gathered.h"
#include "geom/occt/read_part.h"
#include "geom/occt/shape_measures.h"
#include "tests/support/loose_iges.h"
#include "tests/support/notes.h"
#include "tests/support/with_void.h"

namespace octet {
namespace {

/// A cube about the origin.
TopoDS_Shape cube(double side) {
  return BRepPrimAPI_MakeBox(gp_Pnt(-0.5 * side, -0.5 * side, -0.5 * side), side, side, side).Solid();
}

TopoDS_Shape shell_in(const TopoDS_Shape& solid) { return TopExp_Explorer(solid, TopAbs_SHELL).Current(); }

TopoDS_Shape face_in(const TopoDS_Shape& solid) { return TopExp_Explorer(solid, TopAbs_FACE).Current(); }

double ball_volume(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

std::vector<double> volumes(const std::vector<TopoDS_Shape>& shells) {
  std::vector<double> result;
  for (const TopoDS_Shape& solid : solids_from_shells(compound_of(shells)))
    result.push_back(volume_of(solid));
  std::sort(result.begin(), result.end());
  return result;
}

TEST(ShellSolids, AFaceThatClosesByItselfIsASolid) {
  const TopoDS_Shape ball = face_in(BRepPrimAPI_MakeSphere(2.0).Solid());
  for (const TopoDS_Shape& face : {ball, TopoDS_Shape(ball.Reversed())}) {
    const std::vector<double> found = volumes({face});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0], ball_volume(2.0), 1e-9);
  }
  EXPECT_TRUE(volumes({face_in(cube(2.0))}).empty());
}

TEST(ShellSolids, AShellTurnedTheOtherWayWithinAnotherIsAVoid) {
  const TopoDS_Shape outer = shell_in(cube(4.0)), inner = shell_in(cube(2.0));
  const TopoDS_Shape ball = face_in(BRepPrimAPI_MakeSphere(0.5).Solid());
  for (const bool inside_out : {false, true}) {
    const auto turned = [&](const TopoDS_Shape& shape, bool inwards) {
      return TopoDS_Shape(inwards != inside_out ? shape.Reversed() : shape);
    };
    const std::vector<double> one = volumes({turned(inner, true), turned(outer, false)});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_NEAR(one[0], 64.0 - 8.0, 1e-9);
    const std::vector<double> with_ball = volumes({turned(outer, false), turned(ball, true)});
    ASSERT_EQ(with_ball.size(), 1u);
    EXPECT_NEAR(with_ball[0], 64.0 - ball_volume(0.5), 1e-9);
  }
  EXPECT_EQ(count_voids(solids_from_shells(compound_of({outer, TopoDS_Shape(inner.Reversed())}))), 1u);
}

TEST(ShellSolids, AShellTurnedTheSameWayIsASolidOfItsOwn) {
  const std::vector<double> found = volumes({shell_in(cube(4.0)), shell_in(cube(2.0))});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 8.0, 1e-9);
  EXPECT_NEAR(found[1], 64.0, 1e-9);
}

TEST(ShellSolids, SolidsStandInTheOrderOfTheirShells) {
  const auto solids = solids_from_shells(
      compound_of({shell_in(cube(2.0)), TopoDS_Shape(shell_in(cube(3.0)).Reversed()), shell_in(cube(4.0))}));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_NEAR(volume_of(solids[0]), 8.0, 1e-9);
  EXPECT_NEAR(volume_of(solids[1]), 64.0 - 27.0, 1e-9);
}

TEST(ShellSolids, ABodyInAVoidMayHaveAVoidItself) {
  const std::vector<double> found = volumes({shell_in(cube(1.0)).Reversed(), shell_in(cube(4.0)),
                                             shell_in(cube(2.0)), shell_in(cube(3.0)).Reversed()});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 8.0 - 1.0, 1e-9);
  EXPECT_NEAR(found[1], 64.0 - 27.0, 1e-9);
}

TEST(ShellSolids, LooseFacesOfIgesFilesKeepTheirVoids) {
  const auto path = std::filesystem::temp_directory_path() / "octet_ShellSolids.iges";
  for (const TopoDS_Shape& inner : {cube(2.0), TopoDS_Shape(BRepPrimAPI_MakeSphere(1.0).Solid())}) {
    const TopoDS_Shape hollow = test::with_void(cube(4.0), inner);
    ASSERT_TRUE(test::write_loose_iges(hollow, path));
    const Model model = read_part(path);
    EXPECT_EQ(model.count(3), 1);
    EXPECT_NEAR(model.region(1).volume, volume_of(hollow), 1e-6);
    EXPECT_TRUE(model.parts().faults.empty());
  }
  std::filesystem::remove(path);
}

/// One solid of cubes of these sides, each within the one before; below 0: turned inwards.
TopoDS_Shape nested_cubes(const std::vector<double>& sides) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (const double side : sides) {
    const TopoDS_Shape shell = shell_in(cube(std::abs(side)));
    builder.Add(solid, side < 0.0 ? shell.Reversed() : shell);
  }
  return solid;
}

TEST(ShellSolids, ShellsOfOneSolidWithinAnotherAreTurnedSoThatTheyBoundWhatIsBetween) {
  const auto volume_of_turned = [](const std::vector<double>& sides, std::size_t turned) {
    const TurnedShells result = turn_nested_shells(nested_cubes(sides));
    EXPECT_EQ(result.turned, turned);
    return volume_of(result.solid);
  };
  EXPECT_NEAR(volume_of_turned({4.0}, 0), 64.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({4.0, -2.0}, 0), 64.0 - 8.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({4.0, 2.0}, 1), 64.0 - 8.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({2.0, 4.0}, 1), 64.0 - 8.0, 1e-9) << "in any order";
  EXPECT_NEAR(volume_of_turned({4.0, -3.0, 2.0}, 0), 64.0 - 27.0 + 8.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({4.0, 3.0, 2.0}, 1), 64.0 - 27.0 + 8.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({4.0, -3.0, -2.0}, 1), 64.0 - 27.0 + 8.0, 1e-9);
  EXPECT_NEAR(volume_of_turned({-4.0, 2.0}, 0), 8.0 - 64.0, 1e-9) << "inside out as a whole";
  const TurnedShells of_reversed = turn_nested_shells(nested_cubes({-4.0, -2.0}).Reversed());
  EXPECT_EQ(of_reversed.turned, 1u);
  EXPECT_NEAR(volume_of(of_reversed.solid), 64.0 - 8.0, 1e-9)
      << "a solid may be turned as well as its shells";
}

TEST(ShellSolids, AnOpenShellWithinASolidIsNotTurned) {
  const BRep_Builder builder;
  TopoDS_Shape solid = nested_cubes({4.0});
  builder.Add(solid, shell_of<TopoDS_Shape>({face_in(cube(2.0))}));
  EXPECT_EQ(turn_nested_shells(solid).turned, 0u);
}

TEST(ShellSolids, AVoidThatASolidHasTurnedOutwardsIsAVoid) {
  const Model model = model_from_shape(nested_cubes({4.0, 2.0}));
  ASSERT_EQ(model.count(3), 1);
  EXPECT_NEAR(model.region(1).volume, 64.0 - 8.0, 1e-9);
  EXPECT_TRUE(test::has_note(model, "a shell within another is a void"));
  EXPECT_EQ(check_model(model), "");
  EXPECT_FALSE(test::has_note(model_from_shape(nested_cubes({4.0, -2.0})), "shell"));
}

}  // namespace
}  // namespace octet
