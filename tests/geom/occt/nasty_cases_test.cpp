// SPDX-License-Identifier: BSD-3-Clause
// Poles, apices, seams, tangencies, coincidences, cusps, thin walls: what a hit is, not only how many.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <gp_Circ.hxx>

#include "base/constants.h"
#include "base/error.h"
#include "geom/occt/gathered.h"
#include "geom/opposite.h"
#include "variants.h"

namespace octet::test {
namespace {

TopoDS_Shape moved(const TopoDS_Shape& shape, double x, double y, double z) {
  gp_Trsf place;
  place.SetTranslation(gp_Vec(x, y, z));
  return BRepBuilderAPI_Transform(shape, place, true).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Dir& axis, double angle) {
  gp_Trsf place;
  place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), axis), angle);
  return BRepBuilderAPI_Transform(shape, place, true).Shape();
}

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }
TopoDS_Shape cylinder(double r, double h) { return BRepPrimAPI_MakeCylinder(r, h).Shape(); }
TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }

/// The circle (or segment of one) about (major, 0, 0) in the plane y = 0, turned about z.
TopoDS_Shape turned_arc(double major, double minor, double from, double to) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(major, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), minor);
  BRepBuilderAPI_MakeEdge arc(circle, from, to);
  BRepBuilderAPI_MakeWire wire(arc.Edge());
  if (to - from < 2.0 * kPi) wire.Add(BRepBuilderAPI_MakeEdge(arc.Vertex2(), arc.Vertex1()));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                               gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
      .Shape();
}

TEST(NastyCases, SphereAtPolesAndSeam) {
  in_all_variants(BRepPrimAPI_MakeSphere(1).Shape(), [](const Asked& sphere) {
    sphere.expect_segment({0, 0, 0.5}, {0, 0, 1.5}, "v+");
    sphere.expect_line({0, 0, -2}, {0, 0, 2}, "v+ v+");
    sphere.expect_line({-2, 0, 1}, {2, 0, 1}, "v~");
    sphere.expect_line({-2, 0, 1 - 1e-6}, {2, 0, 1 - 1e-6}, "f+ f+");
    sphere.expect_line({-2, 0, 1 + 1e-6}, {2, 0, 1 + 1e-6}, "");
    sphere.expect_segment({0, 0, 0.3}, {2, 0, 0.3}, "f+");
    sphere.expect_line({-2, 0, 0}, {2, 0, 0}, "f+ f+");
    sphere.expect_segment({0.2, 0.1, 0}, {1, 0, 0}, "f+.");
    sphere.expect_segment({0, 0, 0}, {0.6, 0.8, 0}, "f+.");
    sphere.expect_segment({0.6, 0.8, 0}, {3, 4, 0}, "f+.");
    sphere.expect_region({0, 0, 1 - 1e-7}, 1);
    sphere.expect_region({0, 0, 1 + 1e-7}, 0);
  });
}

TEST(NastyCases, BoxInItsPlanesAndAlongItsEdges) {
  in_all_variants(box(1, 1, 1), [](const Asked& box) {
    box.expect_line({-1, 0.5, 1}, {2, 0.5, 1}, "e= e=");
    box.expect_line({-1, 0.5, 1 - 1e-6}, {2, 0.5, 1 - 1e-6}, "f+ f+");
    box.expect_line({-1, 0.5, 1 + 1e-6}, {2, 0.5, 1 + 1e-6}, "");
    box.expect_line({-1, 0, 1}, {2, 0, 1}, "v= v=");
    box.expect_segment({0.2, 0.5, 1}, {0.7, 0.5, 1}, "f=. f=.");
    box.expect_segment({2, 0.5, 1}, {3, 0.5, 1}, "");
    box.expect_line({-1, -1, 1}, {2, 2, 1}, "v= v=");
    box.expect_segment({0.5, 0.5, -1}, {0.5, 0.5, 1}, "f+ f+.");
    box.expect_segment({0.5, 0.5, 1}, {0.5, 0.5, 3}, "f+.");
    box.expect_region({2, 0.5, 1}, 0);
    box.expect_region({0.5, 0.5, 1 - 1e-6}, 1);
    box.expect_region({0.5, 0.5, 1 + 1e-6}, 0);
  });
}

TEST(NastyCases, AnEdgeOrCornerIsOneEventHoweverManyFacesMeet) {
  in_all_variants(box(1, 1, 1), [](const Asked& box) {
    box.expect_line({-1, -1, -1}, {2, 2, 2}, "v+ v+");
    box.expect_line({-1, -1, 0.5}, {2, 2, 0.5}, "e+ e+");
    box.expect_line({-1, 1, 0.5}, {1, -1, 0.5}, "e~");
    box.expect_line({-1, 1, 0}, {1, -1, 0}, "v~");
  });
  in_all_variants(turned(box(1, 1, 1), gp_Dir(1, 0, 0), kPi / 4), [](const Asked& box) {
    box.expect_line({0.5, 0, -1}, {0.5, 0, 3}, "e+ e+");
    box.expect_line({0.5, -1, 0}, {0.5, 1, 0}, "e~");
    box.expect_line({-1, 0, 0}, {2, 0, 0}, "v= v=");
    box.expect_region({0.5, 0, 1e-6}, 1);
    box.expect_region({0.5, 0, -1e-6}, 0);
  });
}

TEST(NastyCases, ConeAtItsApex) {
  in_all_variants(BRepPrimAPI_MakeCone(1, 0, 1).Shape(), [](const Asked& cone) {
    cone.expect_line({0, 0, -0.5}, {0, 0, 1.5}, "f+ v+");
    cone.expect_segment({0, 0, 0.5}, {0, 0, 1}, "v+.");
    cone.expect_line({-1, 0, 1}, {1, 0, 1}, "v~");
    cone.expect_line({-1, 0, 1 - 1e-6}, {1, 0, 1 - 1e-6}, "f+ f+");
    cone.expect_line({-2, 0, 1.5}, {2, 0, 1.5}, "");
    cone.expect_line({1.5, 0, -0.5}, {-0.5, 0, 1.5}, "v= v=");
    for (const double depth : {1.0 / 32, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
      cone.expect_region({0, 0, 1 - depth}, 1);
    cone.expect_region({0, 0, 1 + 1e-6}, 0);
    cone.expect_region({0, 0, 1.5}, 0);
  });
}

TEST(NastyCases, LinesNearlyTangentToACylinder) {
  in_all_variants(cylinder(1, 2), [](const Asked& cylinder) {
    for (const double depth : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
      const double y = 1.0 - depth;
      if (depth > 1e3 * cylinder.variant().rounding)
        cylinder.expect_line({-2, y, 0.7}, {2, y, 0.7}, "f+ f+");
      else if (depth > 5.0 * cylinder.variant().rounding)
        cylinder.expect_segment({-2, y, 0.7}, {2, y, 0.7}, "f+ f+");
      else
        EXPECT_NE(cylinder.hits({-2, y, 0.7}, {2, y, 0.7}), "f+") << cylinder.variant().name << depth;
    }
    cylinder.expect_line({-2, 1, 0.7}, {2, 1, 0.7}, "f~");
    cylinder.expect_line({-2, 1 + 1e-8, 0.7}, {2, 1 + 1e-8, 0.7}, "");
    cylinder.expect_line({0.6, 0.8, -1}, {0.6, 0.8, 3}, "e= e=");
    cylinder.expect_segment({0.6, 0.8, 0.5}, {0.6, 0.8, 1.5}, "f=. f=.");
    cylinder.expect_segment({0.6, 0.8, 1}, {0.6, 0.8, 2}, "f=. e=.");
    cylinder.expect_line({-2, 0.3, 2}, {2, 0.3, 2}, "e= e=");
    cylinder.expect_segment({0.2, 0.1, 1}, {1, 0, 2}, "v+.");
    cylinder.expect_region({0, 1 - 1e-7, 1}, 1);
    cylinder.expect_region({0, 1 + 1e-7, 1}, 0);
  });
}

TEST(NastyCases, FilletsMeetTheirPlanesInOneEvent) {
  const TopoDS_Shape sharp = box(1, 1, 1);
  BRepFilletAPI_MakeFillet fillet(sharp);
  for (TopExp_Explorer it(sharp, TopAbs_EDGE); it.More(); it.Next())
    fillet.Add(0.2, TopoDS::Edge(it.Current()));
  in_all_variants(fillet.Shape(), [](const Asked& part) {
    part.expect_segment({0.8, 0.5, 0.5}, {0.8, 0.5, 1.5}, "e+");
    part.expect_segment({0.8, 0.8, 0.5}, {0.8, 0.8, 1.5}, "v+");
    part.expect_line({1 - 1e-6, 0.5, -1}, {1 - 1e-6, 0.5, 2}, "f+ f+");
    part.expect_line({1, 0.5, -1}, {1, 0.5, 2}, "e= e=");
    part.expect_region({0.99, 0.99, 0.99}, 0);
    part.expect_region({0.9, 0.9, 0.9}, 1);
  });
}

TEST(NastyCases, TorusTouchedFromAllSides) {
  in_all_variants(BRepPrimAPI_MakeTorus(2, 0.5).Shape(), [](const Asked& torus) {
    torus.expect_line({-3, 2, 0.5}, {3, 2, 0.5}, "f~");
    torus.expect_line({-3, 0, 0.5 - 1e-6}, {3, 0, 0.5 - 1e-6}, "f+ f+ f+ f+");
    torus.expect_line({-3, 0, 0.5}, {3, 0, 0.5}, "f~ f~");
    torus.expect_line({-3, 1.5, 0}, {3, 1.5, 0}, "f+ f~ f+");
    torus.expect_segment({2, 0, 0}, {3, 0, 0}, "v+");
    torus.expect_region({0, 0, 0}, 0);
    torus.expect_region({2.5 - 1e-7, 0, 0}, 1);
  });
}

TEST(NastyCases, HornAndSpindleTori) {
  in_all_variants(turned_arc(1, 1, 0, 2 * kPi), [](const Asked& horn) {
    horn.expect_line({0, 0, -2}, {0, 0, 2}, "f~");
    horn.expect_line({-3, 0, 0}, {3, 0, 0}, "f+ f~ v+");
    horn.expect_line({0.5, 0.3, -2}, {0.5, 0.3, 2}, "f+ f+");
    horn.expect_region({0.01, 0, 0}, 1);
    horn.expect_region({0, 0, 1e-3}, 0);
  });
  in_all_variants(turned_arc(0.5, 1, -2 * kPi / 3, 2 * kPi / 3), [](const Asked& apple) {
    apple.expect_line({0, 0, -2}, {0, 0, 2}, "v+ v+");
    apple.expect_line({-3, 0, 0}, {3, 0, 0}, "f+ f+");
    apple.expect_region({0, 0, 0.8}, 1);
    apple.expect_region({0, 0, 0.9}, 0);
  });
}

TEST(NastyCases, ALoftThatEndsInAPoint) {
  const auto circle = [](double z, double r) {
    const gp_Circ c(gp_Ax2(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), r);
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(c).Edge()).Wire();
  };
  BRepOffsetAPI_ThruSections loft(true, false);
  loft.AddWire(circle(0, 1));
  loft.AddWire(circle(1, 0.8));
  loft.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 2)).Vertex());
  loft.Build();
  in_all_variants(loft.Shape(), [](const Asked& part) {
    part.expect_segment({0, 0, 1}, {0, 0, 3}, "v+");
    part.expect_line({-2, 0, 2}, {2, 0, 2}, "v~");
    part.expect_segment({-2, 0, 2 - 1e-6}, {2, 0, 2 - 1e-6}, "f+ f+");
    part.expect_region({0, 0, 2 - 1e-6}, 1);
    part.expect_region({0, 0, 2 + 1e-6}, 0);
  });
}

TEST(NastyCases, ThinPlatesHaveTwoSides) {
  in_all_variants(box(1, 1, 1e-3), [](const Asked& plate) {
    plate.expect_line({0.5, 0.4, -1}, {0.5, 0.4, 1}, "f+ f+");
    plate.expect_line({-1, 0.4, 5e-4}, {2, 0.4, 5e-4}, "f+ f+");
    plate.expect_region({0.5, 0.5, 5e-4}, 1);
    plate.expect_region({0.5, 0.5, 1.1e-3}, 0);
  });
  // As thin as OCCT's own precision.
  gp_Trsf small;
  small.SetScale(gp_Pnt(0, 0, 0), 1e-3);
  const Model model = model_from_shape(BRepBuilderAPI_Transform(box(1, 1, 1e-4), small, true).Shape());
  EXPECT_NEAR(model.region(1).volume, 1e-13, 1e-19);
  EXPECT_EQ(model.region_at({5e-4, 5e-4, 5e-8}), 1);
  EXPECT_EQ(model.region_at({5e-4, 5e-4, 2e-7}), 0);
  EXPECT_EQ(model.region_at({5e-4, 5e-4, -1e-7}), 0);
}

TEST(NastyCases, AWallThatThinsOutToAKnife) {
  in_all_variants(cut(cylinder(2, 1), moved(cylinder(1, 1), 1 - 1e-3, 0, 0)), [](const Asked& part) {
    part.expect_line({-3, 0, 0.5}, {3, 0, 0.5}, "f+ f+ f+ f+");
    part.expect_segment({1.5, 0, 0.5}, {3, 0, 0.5}, "f+ f+");
    part.expect_region({1.9995, 0, 0.5}, 1);
    part.expect_region({1.99, 0, 0.5}, 0);
    part.expect_region({2.0001, 0, 0.5}, 0);
  });
}

TEST(NastyCases, ACylinderThatRestsOnAPlaneTouchesItInAnEdge) {
  const TopoDS_Shape roll = moved(turned(cylinder(0.5, 1), gp_Dir(0, 1, 0), kPi / 2), 0, 0.5, 1.5);
  in_all_variants(BRepAlgoAPI_Fuse(box(1, 1, 1), roll).Shape(), [](const Asked& part) {
    part.expect_line({0.5, 0.5, -1}, {0.5, 0.5, 3}, "f+ e+ f+");
    part.expect_line({0.5, 0.4, -1}, {0.5, 0.4, 3}, "f+ f+ f+ f+");
    part.expect_line({-1, 0.5, 1}, {2, 0.5, 1}, "v= v=");
    part.expect_region({0.5, 0.45, 1.0005}, 0);
    part.expect_region({0.5, 0.5, 1.5}, 2);
    part.expect_region({0.5, 0.5, 0.5}, 1);
  });
}

TEST(NastyCases, AnEdgeOverAFaceIsThePartnerNotTheFacesItBounds) {
  // A lid over a step, its rim 0.05 above the step: straight below the rim, the ball touches the rim itself.
  TopoDS_Shape clamp = BRepAlgoAPI_Fuse(box(10, 4, 1), moved(box(8, 4, 1), 2, 0, 1.05)).Shape();
  clamp = BRepAlgoAPI_Fuse(clamp, moved(box(1, 4, 1.05), 9, 0, 0)).Shape();
  const Model model = model_from_shape(turned(clamp, gp_Dir(1, 2, 3), 0.7));
  gp_Trsf place;
  place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 2, 3)), 0.7);
  for (double y = 0.3; y < 4.0; y += 0.21) {
    const gp_Pnt foot = gp_Pnt(2, y, 1).Transformed(place), rim = gp_Pnt(2, y, 1.05).Transformed(place);
    const auto a = model.closest({foot.X(), foot.Y(), foot.Z()}, 1e-6);
    ASSERT_TRUE(a.has_value());
    const auto b = opposite_point(model, a->point, a->face, a->normal, 1, 0.5);
    ASSERT_TRUE(b.has_value()) << y;
    EXPECT_EQ(b->on.dim, 1) << y;
    EXPECT_LT((b->point - Vec3(rim.X(), rim.Y(), rim.Z())).norm(), 1e-9) << y;
  }
}

TEST(NastyCases, AVoidIsOutside) {
  const TopoDS_Shape block = moved(box(2, 2, 2), -1, -1, -1);
  in_all_variants(cut(block, BRepPrimAPI_MakeSphere(0.5).Shape()), [](const Asked& part) {
    part.expect_line({-2, 0.1, 0.05}, {2, 0.1, 0.05}, "f+ f+ f+ f+");
    part.expect_line({0, 0, -2}, {0, 0, 2}, "f+ v+ v+ f+");
    part.expect_region({0, 0, 0}, 0);
    part.expect_region({0.7, 0, 0}, 1);
  });
}

TEST(NastyCases, ASolidTurnedInsideOutIsTurnedBack) {
  in_all_variants(box(1, 1, 1).Reversed(), [](const Asked& part) {
    part.expect_line({-1, 0.4, 0.3}, {2, 0.4, 0.3}, "f+ f+");
    part.expect_region({0.5, 0.5, 0.5}, 1);
    part.expect_region({1.5, 0.5, 0.5}, 0);
  });
}

TEST(NastyCases, SolidsThatShareAFaceAreCrossedOnce) {
  in_all_variants(compound_of({box(1, 1, 1), moved(box(1, 1, 1), 1, 0, 0)}), [](const Asked& pair) {
    pair.expect_line({-1, 0.4, 0.3}, {3, 0.4, 0.3}, "f+ f+ f+");
    pair.expect_line({1, 0.4, -1}, {1, 0.4, 2}, "e= e=");
    pair.expect_line({-1, 1, 0.5}, {3, 1, 0.5}, "e= e= e=");
    pair.expect_segment({0.5, 1.5, 0.5}, {1.5, 0.5, 0.5}, "e+");
    pair.expect_region({1 - 1e-6, 0.5, 0.5}, 1);
    pair.expect_region({1 + 1e-6, 0.5, 0.5}, 2);
  });
}

TEST(NastyCases, AWindowAcrossTheSeam) {
  const TopoDS_Shape tube = cut(cylinder(1, 3), cylinder(0.8, 3));
  in_all_variants(cut(tube, moved(box(1, 1, 1), 0.5, -0.5, 1)), [](const Asked& part) {
    part.expect_segment({0, 0, 1.5}, {2, 0, 1.5}, "");
    part.expect_segment({0, 0, 0.5}, {2, 0, 0.5}, "f+ f+");
    part.expect_segment({0, 0.6, 1.5}, {2, 0.6, 1.5}, "f+ f+");
    part.expect_region({0.9, 0, 1.5}, 0);
    part.expect_region({0.9, 0, 0.5}, 1);
    part.expect_region({-0.9, 0, 1.5}, 1);
  });
}

TEST(NastyCases, HalvesOfACylinderShareItsSurface) {
  const TopoDS_Shape whole = cylinder(1, 2),
                     side = BRepPrimAPI_MakeBox(gp_Pnt(-2, 0, -1), gp_Pnt(2, 2, 3)).Shape();
  in_all_variants(compound_of({cut(whole, side), BRepAlgoAPI_Common(whole, side).Shape()}),
                  [](const Asked& part) {
                    part.expect_line({0.3, -2, 1}, {0.3, 2, 1}, "f+ f+ f+");
                    part.expect_line({-2, 0, 1}, {2, 0, 1}, "e= e=");
                    part.expect_line({-2, 0.3, 1}, {2, 0.3, 1}, "f+ f+");
                    part.expect_region({0, 0.5, 1}, 2);
                    part.expect_region({0, -0.5, 1}, 1);
                    part.expect_region({0, 1.5, 1}, 0);
                  });
}

TEST(NastyCases, LinesThatGrazeHolesAndFallBetweenChordAndArc) {
  TopoDS_Shape plate = box(10, 10, 1);
  for (int i = 0; i < 3; ++i) plate = cut(plate, moved(cylinder(1, 3), 2 + 3 * i, 5, -1));
  in_all_variants(plate, [](const Asked& part) {
    part.expect_line({1 - 1e-5, 5, -1}, {1 - 1e-5, 5, 2}, "f+ f+");
    part.expect_line({1 + 1e-5, 5, -1}, {1 + 1e-5, 5, 2}, "");
    part.expect_line({1, 5, -1}, {1, 5, 2}, "e= e=");
    part.expect_line({-1, 4 + 1e-5, 0.5}, {11, 4 + 1e-5, 0.5}, "f+ f+ f+ f+ f+ f+ f+ f+");
    part.expect_line({-1, 4, 0.5}, {11, 4, 0.5}, "f+ f~ f~ f~ f+");
    part.expect_line({-1, 4 - 1e-5, 0.5}, {11, 4 - 1e-5, 0.5}, "f+ f+");
    // At places all around a hole, just within its arc and just beyond.
    for (int i = 0; i < 40; ++i) {
      const double x = 2 + std::cos(0.11 + 0.157 * i), y = 5 + std::sin(0.11 + 0.157 * i);
      const Vec3 out(x - 2, y - 5, 0);
      for (const double depth : {1e-6, 1e-4, 5e-4}) {
        const Vec3 in_hole = Vec3(x, y, 0) - depth * out, in_plate = Vec3(x, y, 0) + depth * out, up(0, 0, 1);
        part.expect_segment(in_hole - up, in_hole + 2 * up, "");
        part.expect_segment(in_plate - up, in_plate + 2 * up, "f+ f+");
      }
    }
    part.expect_region({1 - 1e-5, 5, 0.5}, 1);
    part.expect_region({1 + 1e-5, 5, 0.5}, 0);
  });
}

/// The area under a curve from (0,0) to (4,0), 1 deep below y = 0, raised by 1.
TopoDS_Shape raised_under(const Handle(Geom_Curve) & curve) {
  BRepBuilderAPI_MakeEdge top(curve);
  BRepBuilderAPI_MakeEdge right(top.Vertex2(), BRepBuilderAPI_MakeVertex(gp_Pnt(4, -1, 0)).Vertex());
  BRepBuilderAPI_MakeEdge bottom(right.Vertex2(), BRepBuilderAPI_MakeVertex(gp_Pnt(0, -1, 0)).Vertex());
  BRepBuilderAPI_MakeWire wire(top.Edge(), right.Edge(), bottom.Edge(),
                               BRepBuilderAPI_MakeEdge(bottom.Vertex2(), top.Vertex1()).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire()).Face(), gp_Vec(0, 0, 1)).Shape();
}

TEST(NastyCases, ASplineWithACrease) {
  TColgp_Array1OfPnt poles(1, 5);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(1, 1, 0);
  poles(3) = gp_Pnt(2, 0, 0);
  poles(4) = gp_Pnt(3, 1.5, 0);
  poles(5) = gp_Pnt(4, 0, 0);
  TColStd_Array1OfReal knots(1, 3);
  TColStd_Array1OfInteger times(1, 3);
  for (int i = 1; i <= 3; ++i) {
    knots(i) = i - 1;
    times(i) = i == 2 ? 2 : 3;
  }
  in_all_variants(raised_under(new Geom_BSplineCurve(poles, knots, times, 2)), [](const Asked& part) {
    part.expect_line({2, -2, 0.5}, {2, 2, 0.5}, "f+ f+");
    part.expect_line({-1, 0, 0.5}, {5, 0, 0.5}, "e+ f~ e+");
    part.expect_line({-1, 1e-6, 0.5}, {5, 1e-6, 0.5}, "f+ f+ f+ f+");
    part.expect_line({-1, -1e-6, 0.5}, {5, -1e-6, 0.5}, "f+ f+");
    part.expect_line({-1, 0.5, 0.5}, {5, 0.5, 0.5}, "f~ f+ f+");
    part.expect_line({-1, 0.5 - 1e-6, 0.5}, {5, 0.5 - 1e-6, 0.5}, "f+ f+ f+ f+");
    part.expect_region({2, -1e-3, 0.5}, 1);
    part.expect_region({2, 1e-3, 0.5}, 0);
    part.expect_region({1, 0.499, 0.5}, 1);
    part.expect_region({1, 0.501, 0.5}, 0);
  });
}

TEST(NastyCases, ACurveOfHighDegree) {
  TColgp_Array1OfPnt poles(1, 13);
  for (int i = 1; i <= 13; ++i)
    poles(i) = gp_Pnt((i - 1) / 3.0, i == 1 || i == 13 ? 0.0 : (i % 2 == 0 ? 2.0 : -1.0), 0);
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles);
  in_all_variants(raised_under(curve), [&](const Asked& part) {
    for (int i = 1; i < 60; ++i) {
      const gp_Pnt p = curve->Value(i / 60.0);
      part.expect_segment({p.X(), p.Y() - 0.1, 0.5}, {p.X(), p.Y() + 3, 0.5}, "f+");
      part.expect_region({p.X(), p.Y() - 1e-5, 0.5}, 1);
      part.expect_region({p.X(), p.Y() + 1e-5, 0.5}, 0);
    }
  });
}

TEST(NastyCases, ACrackBetweenFacesIsPartOfItsEdge) {
  // One edge of the box runs away from its faces' corner, by too little to be drawn anew.
  constexpr double kCrack = 8e-4;
  const TopoDS_Shape shape = box(1, 1, 1);
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    double a = 0.0, b = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, a, b);
    const gp_Pnt middle = curve->Value(0.5 * (a + b));
    if (middle.Distance(gp_Pnt(1, 0.5, 1)) > 1e-9) continue;
    const Handle(Geom_Curve) away =
        Handle(Geom_Curve)::DownCast(curve->Translated(gp_Vec(kCrack, 0, kCrack)));
    BRep_Builder().UpdateEdge(edge, away, 2.0 * kCrack);
  }
  const Model model = model_from_shape(shape);
  const auto hits = [&](const Vec3& p, const Vec3& q) {
    std::vector<Hit> found;
    model.intersect(p, q, found);
    return found;
  };
  // Through the corner, through the curve, between the two, and along either side within the gap.
  for (const double off : {-0.01, 0.01, 0.5, 1.0}) {
    const double x = 1.0 + off * kCrack;
    const auto found = hits({x, 0.4, 2}, {x, 0.4, 0.9});
    ASSERT_EQ(found.size(), 1u) << x;
    EXPECT_EQ(found[0].on.dim, 1) << x;
  }
  for (const double off : {-0.5, -1.0, -100.0}) {
    const double x = 1.0 + off * kCrack;
    const auto found = hits({x, 0.4, 2}, {x, 0.4, 0.9});
    ASSERT_EQ(found.size(), 1u) << x;
    EXPECT_EQ(found[0].on.dim, 2) << x;
  }
}

TEST(NastyCases, AnOpenShellIsRefusedByPlace) {
  TopoDS_Compound faces;
  BRep_Builder builder;
  builder.MakeCompound(faces);
  int count = 0;
  for (TopExp_Explorer it(box(1, 1, 1), TopAbs_FACE); it.More(); it.Next())
    if (++count > 1) builder.Add(faces, it.Current());
  EXPECT_ANY_THROW((void)model_from_shape(faces));
}

TEST(NastyCases, PlanesCutEdgesWhereTheyCross) {
  // The rims of a cylinder and their cuts by planes x = c: two, one touching, none; both ends of generatrix.
  in_all_variants(cylinder(1, 2), [](const Asked& cylinder) {
    if (cylinder.variant().name == "turned") return;  // its planes are not those of the axes
    const Model& model = cylinder.model();
    const double unit = cylinder.variant().name == "small" ? 1e-3 : 1.0;
    const Vec3 origin = cylinder.variant()(Vec3::Zero());
    for (int tag = 1; tag <= model.count(1); ++tag) {
      if (model.edge(tag).length < 3.0 * unit) continue;  // the seam
      const auto cuts = [&](double y) {
        std::vector<double> at;
        model.curve(tag).cut(Vec3::UnitY(), origin.y() + y * unit, at);
        for (const double t : at)
          EXPECT_NEAR(model.edge_point(tag, t).y(), origin.y() + y * unit, 1e-9 * unit + 1e-10);
        return at.size();
      };
      EXPECT_EQ(cuts(0.3), 2u);
      EXPECT_EQ(cuts(1.0 - 1e-6), 2u);
      EXPECT_EQ(cuts(1.0 + 1e-6), 0u);
    }
  });
}

}  // namespace
}  // namespace octet::test
