// SPDX-License-Identifier: BSD-3-Clause
// Curvature beside poles and apices, where the derivatives of a surface vanish: sizes follow the radius
// there, and no seam is finer than what lies beside it.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Trsf.hxx>

#include "geom/occt/from_shape.h"
#include "geom/sizing.h"

namespace octet::test {
namespace {

TopoDS_Shape as_splines(const TopoDS_Shape& shape) {
  return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
}

TopoDS_Shape turned(const TopoDS_Shape& shape) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0.3, 0.5, -0.8)), 0.7);
  return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}

SizingOptions curvature_alone() {
  SizingOptions options;
  options.size = 100.0;
  options.min_size = 1e-6;
  options.edge_share = 0.0;
  options.edge_gap_elements = 0.0;
  options.curvature_angle = 0.5;
  return options;
}

TEST(PoleSizes, AConesFollowItsRadius) {
  constexpr double kRadius = 10.0, kHeight = 20.0, kTop = 0.6 * kHeight;
  constexpr int kBands = 4, kSectors = 12;
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(kRadius, 0.0, kHeight).Shape();
  const double slope = std::cos(std::atan2(kRadius, kHeight));
  const auto wish_at = [&](double z) { return 0.5 * kRadius * (1.0 - z / kHeight) / slope; };
  for (const TopoDS_Shape& shape : {cone, as_splines(cone)}) {
    std::array<std::array<double, kSectors>, kBands> least;
    for (auto& band : least) band.fill(1e9);
    for (const SizeSample& sample : feature_sizes(model_from_shape(shape), curvature_alone())) {
      const Vec3& p = sample.place;
      if (sample.on.dim != 2 || p.z() >= kTop) continue;
      // A facet's wish is that of its smallest radius.
      ASSERT_GT(sample.size, 0.2 * wish_at(p.z())) << p.transpose();
      const double turn = std::atan2(p.y(), p.x()) / (2.0 * M_PI) + 0.5;
      double& here = least[static_cast<int>(p.z() / kTop * kBands)]
                          [std::min(kSectors - 1, static_cast<int>(turn * kSectors))];
      here = std::min(here, sample.size);
    }
    for (int band = 0; band < kBands; ++band)
      for (const double size : least[band]) EXPECT_LT(size, 1.1 * wish_at(kTop * band / kBands));
  }
}

TEST(PoleSizes, ABallsAreItsRadius) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(3.0).Shape();
  for (const TopoDS_Shape& shape : {ball, as_splines(ball), as_splines(turned(ball))}) {
    const auto samples = feature_sizes(model_from_shape(shape), curvature_alone());
    EXPECT_GT(samples.size(), 50u);
    for (const SizeSample& sample : samples) ASSERT_NEAR(sample.size, 1.5, 0.05) << sample.place.transpose();
  }
}

}  // namespace
}  // namespace octet::test
