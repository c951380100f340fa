// SPDX-License-Identifier: BSD-3-Clause
// Blades whose trailing edges are strips narrower than facets deviate: what is beside them is known exactly.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geom/model.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

constexpr double kChord = 16.0, kSpan = 50.0, kEnd = 0.03;

/// How far a blade is bowed aside at z: an arc has parabolas beside it that leave their chords.
double bow(double z) { return 5.0 * z * (kSpan - z) / (kSpan * kSpan / 4.0); }

/// The section at z from the upper end of the strip x = kChord around the nose to the lower one, and the
/// strip.
TopoDS_Wire section(double z) {
  constexpr int kHalf = 12;
  TColgp_Array1OfPnt points(1, 2 * kHalf + 1);
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double s = static_cast<double>(i) / kHalf, x = kChord * s * s;
    const double y = 1.2 * s * (1.0 - s * s) + 0.5 * kEnd * s;
    points.SetValue(kHalf + 1 - i, gp_Pnt(x, y + bow(z), z));
  }
  const Handle(Geom_BSplineCurve) around = GeomAPI_PointsToBSpline(points).Curve();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(around),
                                 BRepBuilderAPI_MakeEdge(points.Last(), points.First()));
}

Model blade() {
  BRepOffsetAPI_ThruSections loft(true);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) loft.AddWire(section(share * kSpan));
  loft.Build();
  ReadOptions coarse;
  coarse.facet_deflection = 0.1;
  return model_from_shape(loft.Shape(), coarse);
}

TEST(ThinEnds, WhatLiesBesideTheStripOfABladeIsInItsRegion) {
  const Model model = blade();
  double widest = 0.0;
  for (const double deviation : model.facets().edge_deviation) widest = std::max(widest, deviation);
  ASSERT_GT(widest, kEnd) << "else the edges' polylines tell";
  for (int i = 1; i < 200; ++i) {
    const double z = kSpan * i / 200.0;
    // On the strip, in its middle: the loft runs through the sections, and near the bow between them.
    const Foot strip = *model.closest({kChord + 0.01, bow(z), z}, 1.0);
    for (const double far : {0.02, 0.05, 0.1, 0.2, 0.5, 1.3})
      for (const double angle : {-1.4, -1.1, -0.6, 0.0, 0.6, 1.1, 1.4}) {
        const Vec3 p = strip.point + far * Vec3(std::cos(angle), std::sin(angle), 0.0);
        EXPECT_EQ(model.region_at(p), 0) << p.transpose();
      }
    EXPECT_EQ(model.region_at(strip.point - Vec3(0.02, 0.0, 0.0)), 1) << z;
  }
}

TEST(ThinEnds, NormalsOnEitherEdgeOfTheStripAreThoseOfTheirOwnSide) {
  const Model model = blade();
  std::size_t asked = 0;
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.length < 0.9 * kSpan) continue;
    for (const double share : {0.1, 0.23, 0.37, 0.5, 0.61, 0.78, 0.9}) {
      const Vec3 p = model.edge_point(e, edge.t0 + share * (edge.t1 - edge.t0));
      const double side = p.y() > bow(p.z()) ? 1.0 : -1.0;
      for (const int face : edge.faces) {
        const Vec3 normal = model.face_closest(face, p).normal;
        if (std::abs(normal.x()) > 0.9) continue;  // the strip's
        ++asked;
        EXPECT_GT(side * normal.y(), 0.5) << "Edge " << e << " at " << p.transpose();
      }
    }
  }
  EXPECT_EQ(asked, 14u);
}

TEST(ThinEnds, PlacesOnEitherSideOfABladeAreFoundThere) {
  const Model model = blade();
  const Facets& facets = model.facets();
  std::size_t asked = 0;
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (const double share : {0.02, 0.2, 0.7, 0.98}) {
      const auto& uv = facets.uv[t];
      const Vec2 at = share * uv[0] + (1.0 - share) * 0.5 * (uv[1] + uv[2]);
      const int face = facets.face[t];
      const Vec3 p = model.face_jet(face, at, 0).p, normal = model.face_normal(face, at);
      if (p.x() < 0.9 * kChord || std::abs(normal.x()) > 0.9) continue;
      ++asked;
      const FaceFoot foot = model.face_project(face, p);
      EXPECT_LT((foot.point - p).norm(), 1e-9) << p.transpose();
      EXPECT_GT(foot.normal.dot(normal), 0.99) << p.transpose();
      // Beside the face the foot is as far as the place was moved; a little more where that is past an edge.
      for (const double off : {0.004, 0.02}) {
        const Foot near = *model.closest(p + off * normal, 1.0);
        EXPECT_LT(near.distance, 1.001 * off) << p.transpose();
        EXPECT_EQ(model.region_at(p + off * normal), 0) << p.transpose();
      }
    }
  EXPECT_GT(asked, 100u);
}

TEST(ThinEnds, SegmentsBesideTheStripMeetTheBoundaryWhereTheirEndsAreInTwoRegions) {
  const Model model = blade();
  std::mt19937 random(7);
  const auto share = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
  std::size_t through = 0;
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.length < 0.9 * kSpan) continue;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 middle = model.edge_point(e, edge.t0 + share() * (edge.t1 - edge.t0));
      const auto near = [&] {
        return Vec3(middle + 0.1 * (Vec3(share(), share(), share()) - Vec3::Constant(0.5)));
      };
      const Vec3 p = near(), q = near();
      std::vector<Hit> hits;
      model.intersect(p, q, hits);
      const bool two = model.region_at(p) != model.region_at(q);
      EXPECT_EQ(hits.size() % 2 != 0, two) << p.transpose() << " to " << q.transpose();
      through += two ? 1 : 0;
    }
  }
  EXPECT_GT(through, 500u);
}

}  // namespace
}  // namespace octet
