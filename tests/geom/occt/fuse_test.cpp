// SPDX-License-Identifier: BSD-3-Clause
// Solids that touch are joined where that can be; where it cannot, the others still are, and it is told.
#include "geom/occt/fuse.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <functional>
#include <gp_Trsf.hxx>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "geom/model_check.h"
#include "geom/occt/from_shape.h"
#include "geom/occt/fuse_attempts.h"
#include "geom/occt/fuse_tolerances.h"
#include "geom/occt/gathered.h"
#include "geom/occt/sub_shapes.h"
#include "geom/tiny_features.h"
#include "tests/support/notes.h"

namespace octet::test {
namespace {

TopoDS_Shape box(double x0, double x1) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x0, 0, 0), gp_Pnt(x1, 1, 1)).Shape();
}

/// A box without its last face.
TopoDS_Shape open_box(double x0, double x1) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(box(x0, x1), TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  faces.pop_back();
  return solid_of(faces);
}

void fuse(SolidSet& set, std::vector<KeptApart>& apart) {
  std::vector<DoneFuse> none;
  fuse_touching(set, 0.0, apart, none);
}

SolidSet set_of(const std::vector<TopoDS_Shape>& solids) { return {solids, new BRepTools_History(), {}}; }

int faces_in(const std::vector<TopoDS_Shape>& solids) {
  return ShapeMaps(compound_of(solids)).of[2].Extent();
}

TEST(Fuse, GroupsThatDoNotTouchAreFusedByThemselves) {
  SolidSet set = set_of({box(0, 1), box(5, 6), box(1, 2), box(6, 7)});
  std::vector<KeptApart> apart;
  fuse(set, apart);
  EXPECT_TRUE(apart.empty());
  EXPECT_EQ(set.solids.size(), 4u);
  EXPECT_EQ(faces_in(set.solids), 22);
}

TEST(Fuse, AnOverlapOfLittleMoreThanTolerancesIsFusedWithATolerance) {
  const Model model = model_from_shape(compound_of({box(0, 1), box(1 - 1.5e-6, 2)}));
  EXPECT_TRUE(has_note(model, "were fused with a tolerance of"));
  ASSERT_EQ(model.count(3), 2) << "no region 1.5e-6 thick";
  EXPECT_EQ(model.count(2), 11);
  EXPECT_EQ(check_model(model), "");
  EXPECT_TRUE(model.parts().faults.empty());
}

TEST(Fuse, OneBodyTwiceButForNoiseIsOne) {
  const auto bored = [](double x) {
    const gp_Ax2 axes(gp_Pnt(x + 0.5, 0.5, -1.0), gp::DZ());
    return BRepAlgoAPI_Cut(box(x, x + 2.0), BRepPrimAPI_MakeCylinder(axes, 0.2, 3.0).Shape()).Shape();
  };
  const auto twice = [&](double shift) {
    return model_from_shape(compound_of({box(5, 6), bored(0.0), bored(shift)}));
  };
  const Model noise = twice(1e-6), more = twice(1e-3);
  EXPECT_TRUE(has_note(noise, "were fused with a tolerance of"));
  EXPECT_EQ(noise.count(3), 2);
  EXPECT_FALSE(has_note(more, "were fused with a tolerance of"));
  EXPECT_GT(more.count(3), 3) << "what they share, and what each has beside that";
}

TEST(Fuse, AGapOfNoMoreThanNoiseIsClosedWithATolerance) {
  // The second box does not reach the first, whose face is larger, by a ten-millionth of the diagonal.
  const TopoDS_Shape small = BRepPrimAPI_MakeBox(gp_Pnt(100 + 2e-5, 30, 30), gp_Pnt(150, 60, 60)).Shape();
  const TopoDS_Shape large = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(100, 100, 100)).Shape();
  const Model model = model_from_shape(compound_of({large, small}));
  EXPECT_TRUE(has_note(model, "were fused with a tolerance of"));
  EXPECT_EQ(model.count(2), 12) << "one of them between the two";
  EXPECT_EQ(check_model(model), "");
  const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(small).Shape();
  EXPECT_EQ(model_from_shape(compound_of({large, splines})).count(2), 12) << "planes as splines";
}

TEST(Fuse, TheLargestToleranceThatTheSmallestSolidAllowsIsTried) {
  // An overlap of 1e-4: the share of the diagonal before is less, the next is more than the small one allows.
  const TopoDS_Shape small = BRepPrimAPI_MakeBox(gp_Pnt(1000 - 1e-4, 30, 30), gp_Pnt(1009, 39, 39)).Shape();
  const TopoDS_Shape large = BRepPrimAPI_MakeBox(1000.0, 1000.0, 1000.0).Shape();
  const Model model = model_from_shape(compound_of({large, small}));
  EXPECT_EQ(model.count(3), 2);
  EXPECT_EQ(model.count(2), 12) << "one of them between the two";
}

TEST(Fuse, TolerancesAscendFromNone) {
  const std::vector<double> none = fuse_tolerances({box(0, 1), box(1, 2)}, 0.0);
  EXPECT_EQ(none.front(), 0.0);
  EXPECT_EQ(std::adjacent_find(none.begin(), none.end(), std::greater_equal<>()), none.end());
  EXPECT_LT(none.back(), 1e-4);
  const std::vector<double> more = fuse_tolerances({box(0, 1), box(1, 2)}, 1e-3);
  EXPECT_EQ(more.size(), none.size() + 1);
  EXPECT_EQ(more.back(), 1e-3);
}

/// A row of boxes, the second a little wider than the others: the first and the third leave slivers of its
/// sides.
std::vector<TopoDS_Shape> row_with_slivers(int count) {
  std::vector<TopoDS_Shape> row;
  for (int i = 0; i < count; ++i)
    row.push_back(BRepPrimAPI_MakeBox(gp_Pnt(i, 0, 0), gp_Pnt(i + 1, i == 1 ? 1 + 8e-7 : 1, 1)).Shape());
  return row;
}

TEST(Fuse, OfManySolidsSliversStayForAnotherFuseTakesLong) {
  EXPECT_GT(GroupFuse(row_with_slivers(3), {}, 0.0, 1e-6).slivers(), 0) << "else this test needs others";
  const auto few = best_fuse(row_with_slivers(3), 0.0);
  EXPECT_TRUE(few->clean());
  EXPECT_GT(few->tolerance(), 0.0);
  const auto many = best_fuse(row_with_slivers(12), 0.0);
  EXPECT_TRUE(many->sound());
  EXPECT_GT(many->slivers(), 0);
  EXPECT_EQ(many->tolerance(), 0.0);
}

TEST(Fuse, AGapThatIsMoreThanNoiseStays) {
  const TopoDS_Shape far = BRepPrimAPI_MakeBox(gp_Pnt(100.001, 30, 30), gp_Pnt(150, 60, 60)).Shape();
  const TopoDS_Shape large = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(100, 100, 100)).Shape();
  const Model model = model_from_shape(compound_of({large, far}));
  EXPECT_FALSE(has_note(model, "were fused with a tolerance of"));
  EXPECT_EQ(model.count(2), 12) << "six of either";
}

TEST(Fuse, TheToleranceAskedForJoinsWhatOverlapsOrIsApart) {
  ReadOptions options;
  options.fuse_tolerance = 0.02;
  const auto read = [&](double x) { return model_from_shape(compound_of({box(0, 1), box(x, 2)}), options); };
  for (const double x : {0.99, 1.0, 1.01}) {
    const Model model = read(x);
    EXPECT_EQ(model.count(3), 2) << x;
    EXPECT_EQ(model.count(2), 11) << x;
    EXPECT_EQ(check_model(model), "") << x;
    EXPECT_EQ(has_note(model, "were fused with a tolerance of 0.02 mm"), x != 1.0) << x;
  }
  EXPECT_EQ(read(0.9).count(3), 3) << "an overlap";
  EXPECT_EQ(read(1.1).count(2), 12) << "a gap";
}

TEST(Fuse, AThinOverlapTellsTheToleranceThatTakesItAway) {
  const auto read = [](double overlap, const ReadOptions& options = {}) {
    const TopoDS_Shape low = BRepPrimAPI_MakeBox(100.0, 100.0, 5.0).Shape();
    const TopoDS_Shape high = BRepPrimAPI_MakeBox(gp_Pnt(20, 20, 5 - overlap), gp_Pnt(60, 60, 30)).Shape();
    return model_from_shape(compound_of({low, high}), options);
  };
  const std::string note = note_with(read(2e-3), "Solid 1 and Solid 2 overlap");
  EXPECT_NE(note.find("0.002 mm thick: --fuse-tolerance 0.008"), std::string::npos) << note;
  ReadOptions options;
  options.fuse_tolerance = 0.008;
  EXPECT_EQ(read(2e-3, options).count(3), 2);
  const std::string thick = note_with(read(1.0), "Solid 1 and Solid 2 overlap");
  EXPECT_EQ(thick.find("--fuse-tolerance"), std::string::npos) << thick;
  EXPECT_FALSE(thick.empty());
}

TEST(Fuse, AGapAskedForIsClosedBesideAWiderOne) {
  ReadOptions options;
  options.fuse_tolerance = 0.02;
  const TopoDS_Shape row = compound_of({box(0, 1), box(1.01, 2), box(2.05, 3)});
  EXPECT_EQ(model_from_shape(row, options).count(2), 17) << "one of the two pairs of sides";
  EXPECT_EQ(model_from_shape(row).count(2), 18);
}

TEST(Fuse, AThickerOverlapStaysARegion) {
  const Model model = model_from_shape(compound_of({box(0, 1), box(0.99, 2)}));
  ASSERT_EQ(model.count(3), 3);
  EXPECT_FALSE(has_note(model, "were fused with a tolerance of"));
}

/// Whether an edge of some solid has an end that no other edge has.
bool has_loose_ends(const std::vector<TopoDS_Shape>& solids) {
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndUniqueAncestors(compound_of(solids), TopAbs_VERTEX, TopAbs_EDGE, edges);
  for (int v = 1; v <= edges.Extent(); ++v) {
    const auto& edge = TopoDS::Edge(edges(v).First());
    if (edges(v).Extent() == 1 && !TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge))) return true;
  }
  return false;
}

/// A ring with a groove around it, and balls of the groove's own radius, which touch it along circles.
const gp_Ax2 kGroove(gp_Pnt(-62.3, -42.1, 0), gp_Dir(0, 1, 0), gp_Dir(1, 0, 0));
TopoDS_Shape grooved_ring() {
  const TopoDS_Shape wheel = BRepPrimAPI_MakeCylinder(kGroove.Translated(gp_Vec(0, -3, 0)), 9.6, 6.0).Shape();
  const TopoDS_Shape ring = BRepAlgoAPI_Cut(wheel, BRepPrimAPI_MakeTorus(kGroove, 9.6, 2.0).Shape()).Shape();
  return TopExp_Explorer(ring, TopAbs_SOLID).Current();
}
TopoDS_Shape ball_in_groove(double angle) {
  const gp_Vec out =
      std::cos(angle) * gp_Vec(kGroove.XDirection()) + std::sin(angle) * gp_Vec(kGroove.YDirection());
  return BRepPrimAPI_MakeSphere(kGroove.Location().Translated(9.6 * out), 2.0).Shape();
}

/// Edges that both solids have.
int shared_edges(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  const TopTools_IndexedMapOfShape of_a = sub_shapes(a, TopAbs_EDGE), of_b = sub_shapes(b, TopAbs_EDGE);
  int count = 0;
  for (int i = 1; i <= of_a.Extent(); ++i) count += of_b.Contains(of_a(i)) ? 1 : 0;
  return count;
}

TEST(Fuse, BallsInAGrooveShareTheCircleWithIt) {
  for (int i = 0; i < 6; ++i) {
    SolidSet set = set_of({grooved_ring(), ball_in_groove(0.5 + i)});
    std::vector<KeptApart> apart;
    fuse(set, apart);
    EXPECT_TRUE(apart.empty()) << i;
    ASSERT_EQ(set.solids.size(), 2u);
    EXPECT_FALSE(has_loose_ends(set.solids)) << i;
    EXPECT_GE(shared_edges(set.solids[0], set.solids[1]), 1) << i;
  }
}

TEST(Fuse, SolidsThatTouchAlongALineShareNoPiecesOfIt) {
  // The same as splines: the circles are not known, and the fuse finds them here and there.
  int kept = 0;
  for (int i = 0; i < 6; ++i) {
    SolidSet set = set_of({BRepBuilderAPI_NurbsConvert(grooved_ring()).Shape(), ball_in_groove(0.5 + i)});
    std::vector<KeptApart> apart;
    fuse(set, apart);
    EXPECT_FALSE(has_loose_ends(set.solids)) << i;
    for (const KeptApart& one : apart) kept += one.cause.find("along a line") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(kept, 0);
}

TEST(Fuse, AThirdSolidIsJoinedWhereTwoAreAtOdds) {
  const gp_Pnt hub = kGroove.Location();
  const TopoDS_Shape block =
      BRepPrimAPI_MakeBox(hub.Translated(gp_Vec(-3, 3, -3)), hub.Translated(gp_Vec(3, 5, 3))).Shape();
  const TopoDS_Shape ring = BRepBuilderAPI_NurbsConvert(grooved_ring()).Shape();
  int kept = 0;
  for (int i = 0; i < 6; ++i) {
    SolidSet set = set_of({block, ring, ball_in_groove(0.5 + i)});
    std::vector<KeptApart> apart;
    fuse(set, apart);
    ASSERT_LE(apart.size(), 1u) << i;
    if (apart.empty()) continue;
    ++kept;
    EXPECT_EQ(apart[0].solid, 2u) << "the smaller one";
    EXPECT_EQ(apart[0].other, 1u) << i;
    EXPECT_GE(shared_edges(set.solids[0], set.solids[1]), 4) << i;
  }
  EXPECT_GT(kept, 0);
}

TEST(Fuse, AClosedEdgeWithAVertexToItselfIsNoPieceOfALine) {
  // The cap that they share ends at a circle that the ball's seam does not cross.
  const gp_Ax2 seam_away(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(-1, 0, 0));
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0.8, -2, -2), gp_Pnt(3, 2, 2)).Shape();
  SolidSet set = set_of({block, BRepPrimAPI_MakeSphere(seam_away, 1.0).Shape()});
  std::vector<KeptApart> apart;
  fuse(set, apart);
  EXPECT_TRUE(apart.empty());
  EXPECT_EQ(set.solids.size(), 3u);
}

/// A pin of radius 10 in a bore of a plate 5 thick, of the same radius but `tilt` askew and `off` its axis.
TopoDS_Shape pin_in_bore(double tilt, double off) {
  const gp_Ax2 axis(gp_Pnt(50, 50, 0), gp::DZ());
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100.0, 100.0, 5.0).Shape();
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis.Translated(gp_Vec(0, 0, -1)), 10.0, 10.0).Shape();
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(50, 50, 2.5), gp_Dir(1, 0.3, 0)), tilt);
  shift.SetTranslation(gp_Vec(off, 0, 0));
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(axis, 10.0, 7.0).Shape();
  return compound_of({TopExp_Explorer(BRepAlgoAPI_Cut(plate, drill).Shape(), TopAbs_SOLID).Current(),
                      BRepBuilderAPI_Transform(pin, shift * turn, true).Shape()});
}

TEST(Fuse, APinAskewInItsBoreByRoundingSharesTheWall) {
  // OCCT finds pieces of lines and points where the walls cross, cuts them in part only, or cuts slivers off
  // them and the ends; some tolerance does without, and what is left inside the wall is taken away.
  for (const auto& [tilt, off] :
       {std::pair(3e-7, 1e-6), {1e-6, -1e-6}, {1e-6, 0.0}, {1e-6, 1e-5}, {1e-5, 1e-6}}) {
    const Model model = model_from_shape(pin_in_bore(tilt, off));
    EXPECT_TRUE(model.parts().faults.empty()) << tilt << ' ' << off;
    EXPECT_EQ(check_model(model), "") << tilt << ' ' << off;
    ASSERT_EQ(model.count(3), 2) << tilt << ' ' << off;
    EXPECT_TRUE(tiny_features(model).empty()) << tilt << ' ' << off;
    double wall = 0.0;
    for (int f = 1; f <= model.count(2); ++f)
      wall += model.face(f).region[0] != 0 && model.face(f).region[1] != 0 ? model.face(f).area : 0.0;
    EXPECT_NEAR(wall, 100.0 * std::numbers::pi, 0.01) << tilt << ' ' << off;
    EXPECT_NEAR(model.region(2).volume, 700.0 * std::numbers::pi, 0.01) << tilt << ' ' << off;
  }
}

TEST(Fuse, ASolidKeptApartSharesNothing) {
  SolidSet set = set_of({box(0, 1), box(1, 2), box(2, 3)});
  std::vector<KeptApart> apart{{2, 2, Vec3::Zero(), "test"}};
  fuse(set, apart);
  ASSERT_EQ(set.solids.size(), 3u);
  EXPECT_EQ(faces_in({set.solids[0], set.solids[1]}), 11);
  EXPECT_EQ(faces_in(set.solids), 17);
}

TEST(Fuse, WhatHasBeenFusedIsNotFusedAgain) {
  const std::vector<TopoDS_Shape> solids{box(0, 1), box(1, 2), box(5, 6), box(6, 7), box(7, 8)};
  std::vector<DoneFuse> done;
  std::vector<KeptApart> apart;
  SolidSet first = set_of(solids), again = set_of(solids), without = set_of(solids);
  fuse_touching(first, 0.0, apart, done);
  ASSERT_EQ(done.size(), 2u);
  fuse_touching(again, 0.0, apart, done);
  EXPECT_EQ(done.size(), 2u);
  EXPECT_EQ(faces_in(again.solids), faces_in(first.solids));
  apart.push_back({4, 4, Vec3::Zero(), "test"});
  fuse_touching(without, 0.0, apart, done);
  EXPECT_EQ(done.size(), 3u) << "the group with the last solid only";
  EXPECT_EQ(faces_in(without.solids), faces_in(first.solids) + 1);
}

TEST(Fuse, ASolidThatCannotBeClosedIsLeftOutAndTheOthersAreJoined) {
  const Model model = model_from_shape(compound_of({box(0, 1), open_box(1, 2), box(2, 3), box(-1, 0)}));
  EXPECT_EQ(model.count(3), 3);
  EXPECT_EQ(check_model(model), "");
  ASSERT_EQ(model.parts().faults.size(), 1u);
  const std::string& cause = model.parts().faults[0].cause;
  EXPECT_NE(cause.find("Solid 2 is left out"), std::string::npos) << cause;
  EXPECT_NEAR(model.parts().faults[0].place.x(), 1.5, 1e-6);
  const auto& left_out = model.provenance().left_out;
  ASSERT_FALSE(left_out.empty());
  EXPECT_EQ(left_out.front().entity, model_region(2));
  EXPECT_FALSE(model.parts().apart);
  int shared = 0;
  for (int f = 1; f <= model.count(2); ++f)
    shared += model.face(f).region[0] != 0 && model.face(f).region[1] != 0 ? 1 : 0;
  EXPECT_EQ(shared, 1);
}

// Closed forms may be what does not join: then all is tried with the splines.
TEST(Fuse, SplinesStayAsTheyAreWhereNotAllIsJoinedWithoutThem) {
  const auto told = [](const TopoDS_Shape& solids) {
    const Model model = model_from_shape(BRepBuilderAPI_NurbsConvert(solids, true).Shape());
    EXPECT_EQ(model.count(3), 2);
    return has_note(model, "face(s) whose splines are planes");
  };
  EXPECT_TRUE(told(compound_of({box(0, 1), box(1, 2)})));
  EXPECT_FALSE(told(compound_of({box(0, 1), open_box(2, 3), box(1, 2)})));
}

TEST(Fuse, APartOfOneOpenSolidIsRefused) { EXPECT_THROW((void)model_from_shape(open_box(0, 1)), ModelError); }

}  // namespace
}  // namespace octet::test
