// SPDX-License-Identifier: BSD-3-Clause
// Octants on both sides of a thin wall or gap are of one size; elsewhere sizes are what they were.
#include "octree/even_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geom/analytic.h"

namespace octet {
namespace {

constexpr double kOctant = 0.2, kFine = 0.05;

enum class Sheets { kOfAWall, kOfAGap };

/// A plate, or a void of that shape in material all around.
Model plate_of(double thickness, Sheets sheets) {
  ModelParts parts = analytic_box(Vec3(2, 2, thickness), {{}, 1e-3}).parts();
  if (sheets == Sheets::kOfAGap)
    for (ModelFace& face : parts.faces) std::swap(face.region[0], face.region[1]);
  return Model(std::move(parts));
}

/// Of a plate whose upper face wants small octants at its middle.
struct Tree {
  explicit Tree(double thickness, Sheets sheets = Sheets::kOfAWall)
      : model(plate_of(thickness, sheets)), built(build(thickness)), even(with_even_walls(model, built)) {
    EXPECT_EQ(check_octree(even), "");
  }
  [[nodiscard]] Octree build(double thickness) const {
    OctreeRequest request;
    request.size = kOctant;
    std::vector<SizeSample> samples;
    for (double x = 0.6; x < 1.4; x += kFine)
      for (double y = 0.6; y < 1.4; y += kFine) samples.push_back({Vec3(x, y, thickness - 1e-6), kFine});
    return build_octree(model, request, samples);
  }
  Model model;
  Octree built, even;
};

/// The greatest ratio, either way, of lengths of the octants that hold a place of the upper face, where that
/// wants small ones, and the place below it.
double greatest_ratio(const Octree& tree, double thickness) {
  double greatest = 1.0;
  for (double x = 0.65; x < 1.3; x += 0.03)
    for (double y = 0.65; y < 1.3; y += 0.03) {
      const double above = tree.length_at(Vec3(x, y, thickness)), below = tree.length_at(Vec3(x, y, 0));
      EXPECT_LE(above, kFine * 1.001);
      greatest = std::max({greatest, above / below, below / above});
    }
  return greatest;
}

TEST(EvenWalls, ThinOnesAndGapsHaveOctantsOfOneSizeOnBothSides) {
  // The coarser octants beside the fine ones have spacings of 0.075: walls up to 0.0975 are thin to them.
  for (const Sheets sheets : {Sheets::kOfAWall, Sheets::kOfAGap})
    for (const double thickness : {0.06, 0.07, 0.08, 0.09}) {
      const Tree tree(thickness, sheets);
      EXPECT_EQ(greatest_ratio(tree.built, thickness), 2.0) << thickness;
      EXPECT_EQ(greatest_ratio(tree.even, thickness), 1.0) << thickness;
    }
}

TEST(EvenWalls, ThickOnesHaveTheSizesAskedFor) {
  for (const double thickness : {0.25, 0.3, 0.4}) {
    const Tree tree(thickness);
    EXPECT_GE(greatest_ratio(tree.built, thickness), 2.0);
    EXPECT_TRUE(std::equal(tree.built.octants().begin(), tree.built.octants().end(),
                           tree.even.octants().begin(), tree.even.octants().end()));
  }
}

}  // namespace
}  // namespace octet
