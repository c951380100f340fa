// SPDX-License-Identifier: BSD-3-Clause
// Solids whose boundary touches itself where the file has no edge get one there.
#include "geom/occt/imprint.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <gp_Ax1.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

#include "geom/face_touches.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "tests/support/hook.h"

namespace octet {
namespace {

TopoDS_Shape prism(double tip) {
  return BRepPrimAPI_MakePrism(test::hook(0.0, tip, true), gp_Vec(0, 3, 0)).Shape();
}
TopoDS_Shape turned(double tip, bool round) {
  return BRepPrimAPI_MakeRevol(test::hook(3.0, tip, round), gp_Ax1(gp_Pnt(0, 0, 0), gp::DZ())).Shape();
}

bool has_note(const Model& model, std::string_view words) {
  return std::any_of(model.notes().begin(), model.notes().end(),
                     [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// Real edges with more uses by faces than two.
int pinched_edges(const Model& model) {
  int count = 0;
  for (int e = 1; e <= model.count(1); ++e) count += model.edge(e).faces.size() > 2 ? 1 : 0;
  return count;
}

TEST(Imprint, ARoundTipThatTouchesAWallAlongALine) {
  const Model model = model_from_shape(prism(1.5));
  EXPECT_TRUE(has_note(model, "1 pair(s) were imprinted")) << "one cylinder, one plane";
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty())
      << "they have the line in common now";
  EXPECT_EQ(pinched_edges(model), 1);
  EXPECT_TRUE(check_model(model).empty());
  const double area = 6.0 * 1.0 + 1.5 * 3.5 + 1.0 * 3.0 + 3.0 * 1.0 + std::numbers::pi / 8.0;
  EXPECT_NEAR(model.region(1).volume, 3.0 * area, 1e-9);
}

TEST(Imprint, ATipBesideTheWallStaysAsItIs) {
  for (const double gap : {1e-4, 0.05}) {
    const Model model = model_from_shape(prism(1.5 + gap));
    EXPECT_FALSE(has_note(model, "touch")) << gap;
    EXPECT_EQ(pinched_edges(model), 0);
  }
}

TEST(Imprint, ATorusThatTouchesACylinderAlongACircle) {
  const Model model = model_from_shape(turned(1.5, true));
  EXPECT_TRUE(has_note(model, "were imprinted on each other"));
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty());
  EXPECT_GE(pinched_edges(model), 1);
  EXPECT_TRUE(check_model(model).empty());
}

TEST(Imprint, FacesThatLieOnOneAnotherAreTakenAway) {
  const Model model = model_from_shape(turned(1.5, false));
  EXPECT_TRUE(has_note(model, "lay on one another"));
  EXPECT_TRUE(touching_faces(model, kTouchShare * model.diagonal()).empty());
  EXPECT_EQ(pinched_edges(model), 0) << "the finger and the wall are one body there";
  EXPECT_TRUE(check_model(model).empty());
  double area = 0.0, before = 0.0;
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  const Model apart = model_from_shape(turned(1.5 + 1e-5, false));
  for (int f = 1; f <= apart.count(2); ++f) before += apart.face(f).area;
  const double tip = 2.0 * std::numbers::pi * 4.5;  // a cylinder of radius 4.5, 1 high
  EXPECT_NEAR(area, before - 2.0 * tip, 0.01);
}

TEST(Imprint, NumbersOfOtherFacesStay) {
  const Model apart = model_from_shape(prism(1.55)), touching = model_from_shape(prism(1.5));
  int kept = 0;
  for (int f = 1; f <= apart.count(2); ++f)
    kept += apart.face(f).boundary.size() == touching.face(f).boundary.size() &&
                    std::string_view(apart.surface(f).kind()) == touching.surface(f).kind()
                ? 1
                : 0;
  EXPECT_GE(kept, apart.count(2) - 4) << "the wall, the tip and the two sides have other edges";
}

}  // namespace
}  // namespace octet
