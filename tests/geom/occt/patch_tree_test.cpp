// SPDX-License-Identifier: BSD-3-Clause
// Starts for foot points, against points all over the surface.
#include "geom/occt/patch_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace octet {
namespace {

constexpr double kCoil = 10.0, kTube = 1.0, kPitch = 0.8;

/// A tube along a helix: many patches, turns beside each other.
SurfaceJet coil(const Vec2& uv, int) {
  const double cu = std::cos(uv.x()), su = std::sin(uv.x()), cv = std::cos(uv.y()), sv = std::sin(uv.y());
  const double r = kCoil + kTube * cv;
  SurfaceJet jet;
  jet.p = Vec3(r * cu, r * su, kPitch * uv.x() + kTube * sv);
  jet.du = Vec3(-r * su, r * cu, kPitch);
  jet.dv = Vec3(-kTube * sv * cu, -kTube * sv * su, kTube * cv);
  jet.duu = Vec3(-r * cu, -r * su, 0.0);
  jet.duv = Vec3(kTube * sv * su, -kTube * sv * cu, 0.0);
  jet.dvv = Vec3(-kTube * cv * cu, -kTube * cv * su, -kTube * sv);
  return jet;
}

TEST(PatchTree, TheNearestPatchIsNearTheNearestPoint) {
  constexpr double kTurns = 6.0 * std::numbers::pi, kAround = 2.0 * std::numbers::pi;
  const PatchTree tree(coil, {0.0, 0.5 * kTurns, kTurns}, {0.0, 0.5 * kAround, kAround});
  EXPECT_GT(tree.leaf_count(), 1000u);
  std::vector<Vec3> all;
  constexpr int kAlong = 800, kAcross = 40;
  for (int i = 0; i <= kAlong; ++i)
    for (int j = 0; j <= kAcross; ++j) all.push_back(coil({kTurns * i / kAlong, kAround * j / kAcross}, 0).p);
  std::mt19937 random(7);
  const Box3 box = tree.box().grown(2.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p = box.lo + Vec3(share(random), share(random), share(random)).cwiseProduct(box.size());
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& q : all) nearest = std::min(nearest, (q - p).norm());
    // No patch is as long as half the tube is wide.
    EXPECT_LT((coil(tree.near(p), 0).p - p).norm(), nearest + 0.5 * kTube) << p.transpose();
  }
}

}  // namespace
}  // namespace octet
