// SPDX-License-Identifier: BSD-3-Clause
// Sizes that follow from numbers of elements, and the sizes that parts get unasked.
#include "app/scaled_sizes.h"

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <functional>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "app/element_estimate.h"
#include "app/target_elements.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"

namespace octet {
namespace {

double estimate(const Model& model, const MeshOptions& options) {
  return estimated_elements(model, plan_sizes(model, options));
}

TopoDS_Shape rounded_box_shape(double radius) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer e(box, TopAbs_EDGE); e.More(); e.Next()) fillet.Add(radius, TopoDS::Edge(e.Current()));
  return fillet.Shape();
}

Model rounded_box(double radius) { return model_from_shape(rounded_box_shape(radius)); }

TEST(ScaledSizes, PartsGetThousandsOfElementsUnasked) {
  for (const Model& model : {analytic_torus(1.2, 0.4, {{}, 1e-3}), analytic_ball(1.0, {{}, 1e-3}),
                             analytic_box(Vec3(1.0, 1.0, 1.0)), analytic_box(Vec3(40.0, 30.0, 2.0))}) {
    const MeshResult result = mesh_part(model);
    EXPECT_EQ(result.report.status, MeshStatus::kComplete);
    EXPECT_GT(result.report.tets, 2'000u);
    EXPECT_LT(result.report.tets, 500'000u);
  }
}

TEST(ScaledSizes, PartsOfManySmallFeaturesGetFewEnoughElements) {
  MeshOptions many;
  many.curvature_angle = 0.02;
  const Model model = analytic_hollow_ball(1.0, 0.85, {{}, 1e-3});
  MeshOptions as_first_guessed = many;
  as_first_guessed.size = global_size(model, many);
  EXPECT_GT(estimate(model, as_first_guessed), 450'000.0);
  const double elements = estimate(model, with_default_size(model, many));
  EXPECT_LT(elements, 450'000.0);
  EXPECT_GT(elements, 200'000.0);
}

/// Rounded boxes side by side, 26 faces each.
Model rounded_boxes(int count, double radius) {
  const BRep_Builder builder;
  TopoDS_Compound boxes;
  builder.MakeCompound(boxes);
  const TopoDS_Shape box = rounded_box_shape(radius);
  for (int i = 0; i < count; ++i) {
    gp_Trsf way;
    way.SetTranslation(gp_Vec(50.0 * (i % 10), 50.0 * (i / 10), 0.0));
    builder.Add(boxes, box.Moved(way));
  }
  return model_from_shape(boxes);
}

/// How many times larger than it would be by itself the default size is.
double growth(const Model& model) { return with_default_size(model, {}).size / global_size(model, {}); }

TEST(ScaledSizes, ThreeHundredThousandByEstimateUnlessFacesAreMany) {
  const Model few = rounded_boxes(30, 0.5);
  EXPECT_EQ(few.count(2), 30 * 26);
  EXPECT_EQ(most_by_default(few), 500'000.0);
  EXPECT_LT(estimate(few, with_default_size(few, {})), 330'000.0);
}

TEST(ScaledSizes, OfManyFacesSizesGrowNoFartherThanIsGoodForSmallFeatures) {
  const Model many = rounded_boxes(60, 3.0);
  EXPECT_EQ(most_by_default(many), 780'000.0);
  const double elements = estimate(many, with_default_size(many, {}));
  EXPECT_GT(elements, 330'000.0) << "as many as others may have make sizes larger";
  EXPECT_LT(elements, 0.58 * 780'000.0);
  EXPECT_NEAR(growth(many), 1.6, 0.1);
}

TEST(ScaledSizes, OfManyFacesThereAreNoMoreElementsThanSoManyAFace) {
  const Model many = rounded_boxes(60, 0.25);
  EXPECT_NEAR(estimate(many, with_default_size(many, {})), 0.58 * 780'000.0, 0.12 * 0.58 * 780'000.0);
  EXPECT_GT(growth(many), 1.7);
}

/// Region 1 is a box of 4, 3 and 2 times `scale`, region 2 a ball of radius 1 beside it.
Model box_and_unit_ball(double scale) {
  const BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(4.0 * scale, 3.0 * scale, 2.0 * scale).Shape());
  builder.Add(both, BRepPrimAPI_MakeSphere(gp_Pnt(5.0 * scale, 0.0, 0.0), 1.0).Shape());
  return model_from_shape(both);
}

TEST(ScaledSizes, SmallRegionsHaveASizeOfTheirOwnUnlessOneIsAskedFor) {
  const Model model = box_and_unit_ball(10.0);
  const MeshOptions unasked = with_default_size(model, {});
  const SizePlan plan = plan_sizes(model, unasked);
  EXPECT_EQ(plan.region_size[1], kNoSize);
  EXPECT_NEAR(plan.region_size[2], unasked.region_scale * std::sqrt(12.0) / 12.0, 0.02);
  EXPECT_LT(plan.region_size[2], 0.2 * plan.asked);
  EXPECT_EQ(scaled_sizes(model, unasked, 0.5).region_scale, 0.5 * unasked.region_scale);
  MeshOptions uniform;
  uniform.small_regions = false;
  EXPECT_EQ(with_default_size(model, uniform).region_scale, 0.0);
}

TEST(ScaledSizes, ARegionAThousandTimesSmallerThanThePartHasASizeOfItsOwn) {
  const Model model = box_and_unit_ball(1000.0);
  const MeshOptions unasked = with_default_size(model, {});
  const SizePlan plan = plan_sizes(model, unasked);
  EXPECT_NEAR(plan.region_size[2], unasked.region_scale * std::sqrt(12.0) / 12.0, 0.02);
  EXPECT_GT(plan.min_size, 5.0 * plan.region_size[2]);
}

TEST(ScaledSizes, SmallMeshesFollowCurvedFacesMoreClosely) {
  const double usual = SizeControl().curvature_angle;
  const Model torus = analytic_torus(1.2, 0.4, {{}, 1e-3});
  const MeshOptions unasked = with_default_size(torus, {});
  EXPECT_NEAR(unasked.curvature_angle, 2.0 * M_PI / 20, 1e-12);
  EXPECT_LT(estimate(torus, unasked), 40'000.0);
  const MeshResult result = mesh_part(torus);
  EXPECT_EQ(result.report.status, MeshStatus::kComplete);
  EXPECT_LT(std::abs(result.report.volume / torus.region(1).volume - 1.0), 0.01);

  MeshOptions asked;  // what is asked for is left alone
  asked.curvature_angle = 0.5;
  EXPECT_EQ(with_default_size(torus, asked).curvature_angle, 0.5);
  asked = {};
  asked.size = 0.2;
  EXPECT_EQ(with_default_size(torus, asked).curvature_angle, usual);
  asked = {};
  asked.target_elements = 10'000.0;
  EXPECT_EQ(with_default_size(torus, asked).curvature_angle, usual);

  const Model ring = analytic_torus(1.0, 0.03, {{}, 1e-3});  // curved all over, with no room for more
  EXPECT_EQ(with_default_size(ring, {}).curvature_angle, usual);
  const Model thin = analytic_hollow_ball(1.0, 0.97, {{}, 1e-3});  // most elements are for its wall
  const MeshOptions rounder = with_default_size(thin, {});
  EXPECT_NEAR(rounder.curvature_angle, 2.0 * M_PI / 20, 1e-12);
  MeshOptions as_usual = rounder;
  as_usual.curvature_angle = usual;
  EXPECT_GT(estimate(thin, as_usual), 40'000.0);
  EXPECT_LT(estimate(thin, rounder), 1.25 * estimate(thin, as_usual));
}

TEST(ScaledSizes, ASizeAskedForIsLeftAlone) {
  MeshOptions options;
  options.size = 0.3;
  EXPECT_EQ(with_default_size(analytic_ball(1.0, {{}, 1e-3}), options).region_scale, 0.0);
  EXPECT_EQ(with_default_size(analytic_ball(1.0, {{}, 1e-3}), options).size, 0.3);
  EXPECT_FALSE(with_default_size(analytic_ball(1.0, {{}, 1e-3}), options).suit_curvature);
}

TEST(ScaledSizes, OctantsOfScaledSizesSuitNoRadius) {
  const Model model = rounded_box(2.0);
  const MeshOptions unasked = with_default_size(model, {});
  ASSERT_TRUE(unasked.suit_curvature);
  EXPECT_FALSE(scaled_sizes(model, unasked, 1.1).suit_curvature);
}

TEST(ScaledSizes, OneElementMoreOnACircleIsNoCliff) {
  // Each of the wishes by itself would be met by octants of twice the length up to some number, and by the
  // next smaller ones from there on: four times as many on the fillets.
  const Model model = rounded_box(2.0);
  double last = 0.0;
  for (int n = 8; n <= 20; ++n) {
    MeshOptions options;
    options.curvature_angle = 2.0 * M_PI / n;
    const double count = estimate(model, with_default_size(model, options));
    if (last > 0.0) {
      EXPECT_LT(count / last, 1.8) << n;
      EXPECT_GT(count / last, 0.6) << n;
    }
    last = count;
  }
}

/// A mesher whose counts go with the size as if all of the part were boundary, and who closes no size in a
/// range.
class Pretender {
 public:
  Pretender(double factor, double open_from, double open_to)
      : factor_(factor), open_from_(open_from), open_to_(open_to) {}
  MeshResult operator()(const MeshOptions& options, double most) {
    sizes.push_back(options.size);
    const double count = factor_ / (options.size * options.size);
    const bool open = options.size > open_from_ && options.size < open_to_;
    if (count > 1.2 * most) throw TooManyTets{count, open};
    ++finished;
    MeshResult result;
    result.report.tets = static_cast<std::size_t>(count);
    result.report.status = open ? MeshStatus::kIncomplete : MeshStatus::kComplete;
    return result;
  }
  std::vector<double> sizes;
  int finished = 0;

 private:
  double factor_, open_from_, open_to_;
};

TEST(ScaledSizes, AMeshThatIsLargerThanPromisedIsMadeAgain) {
  const Model box = analytic_box(Vec3(1.0, 1.0, 1.0));
  const double size = with_default_size(box, {}).size;
  const auto by_default = [&](Pretender& mesher, const MeshOptions& options) {
    return mesh_by_default(box, options, std::ref(mesher)).report;
  };
  const double many = 633'000.0 * size * size;
  Pretender small(400'000.0 * size * size, 0.0, 0.0);
  EXPECT_EQ(by_default(small, {}).tets, 400'000u);
  EXPECT_EQ(small.sizes.size(), 1u);
  Pretender large(many, 0.0, 0.0);
  EXPECT_NEAR(static_cast<double>(by_default(large, {}).tets), 400'000.0, 1.0);
  ASSERT_EQ(large.sizes.size(), 2u);
  EXPECT_GT(large.sizes[1], large.sizes[0]);
  EXPECT_EQ(large.finished, 1) << "far too many are seen before the work is done";
  Pretender somewhat_large(560'000.0 * size * size, 0.0, 0.0);
  EXPECT_NEAR(static_cast<double>(by_default(somewhat_large, {}).tets), 560'000.0, 1.0);
  EXPECT_EQ(somewhat_large.sizes.size(), 1u) << "a mesh that is there already costs no second one";
  Pretender somewhat_large_and_open(560'000.0 * size * size, 0.0, 1.01 * size);
  EXPECT_EQ(by_default(somewhat_large_and_open, {}).status, MeshStatus::kComplete);
  EXPECT_EQ(somewhat_large_and_open.sizes.size(), 2u);
  Pretender open_at_both(many, 0.0, 10.0);
  EXPECT_LT(by_default(open_at_both, {}).tets, 500'000u);
  EXPECT_EQ(open_at_both.sizes.size(), 2u) << "what has gaps is not made once more";
  Pretender open_when_coarse(many, 1.01 * size, 10.0);
  EXPECT_EQ(by_default(open_when_coarse, {}).status, MeshStatus::kComplete) << "rather too large than open";
  EXPECT_EQ(open_when_coarse.sizes.size(), 3u);
  EXPECT_EQ(open_when_coarse.sizes[2], open_when_coarse.sizes[0]);
  MeshOptions leaving;
  leaving.large_mesh = LargeMesh::kNever;
  Pretender left(many, 1.01 * size, 10.0);
  const MeshReport small_one = by_default(left, leaving);
  EXPECT_EQ(small_one.status, MeshStatus::kIncomplete);
  EXPECT_NEAR(small_one.left_large, 633'000.0, 1.0);
  EXPECT_EQ(left.sizes.size(), 2u);
  Pretender not_left(many, 0.0, 0.0);
  EXPECT_EQ(by_default(not_left, leaving).left_large, 0.0);
  MeshOptions at_once;
  at_once.large_mesh = LargeMesh::kAtOnce;
  Pretender large_at_once(many, 1.01 * size, 10.0);
  EXPECT_NEAR(static_cast<double>(by_default(large_at_once, at_once).tets), 633'000.0, 1.0);
  EXPECT_EQ(large_at_once.sizes.size(), 1u);
  MeshOptions bounded;
  bounded.min_size = 0.001;
  Pretender asked(many, 0.0, 0.0);
  EXPECT_GT(by_default(asked, bounded).tets, 600'000u) << "the user has asked for something";
  EXPECT_EQ(asked.sizes.size(), 1u);
}

TEST(ScaledSizes, APartWhoseBoundaryHasNoFacesIsMeshedByItsWidth) {
  const Model box = analytic_box(Vec3(1.0, 1.0, 1.0));
  std::vector<double> sizes;
  std::size_t faults_when_fine = 0;
  const auto mesh = [&](const MeshOptions& options, double) {
    sizes.push_back(options.size);
    MeshResult result;
    result.report.size = options.size;
    // As if the part were thinner.
    result.report.cad_volume = 0.06;
    result.report.cad_area = 6.0;
    const bool coarse = sizes.size() == 1;
    if (coarse) result.report.too_coarse = options.size;
    result.report.faults.resize(coarse ? 10 : faults_when_fine);
    result.report.status = result.report.faults.empty() ? MeshStatus::kComplete : MeshStatus::kIncomplete;
    return result;
  };
  const auto by_default = [&](const MeshOptions& options) {
    sizes.clear();
    return mesh_by_default(box, options, mesh).report;
  };
  MeshOptions many;
  many.max_elements = std::numeric_limits<std::size_t>::max();
  MeshReport report = by_default(many);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_DOUBLE_EQ(sizes[1], 0.04);
  EXPECT_EQ(report.status, MeshStatus::kComplete);
  EXPECT_EQ(report.size, sizes[1]);
  EXPECT_EQ(report.too_coarse, sizes[0]);
  faults_when_fine = 3;
  EXPECT_EQ(by_default(many).faults.size(), 3u) << "fewer faults are better";
  faults_when_fine = 10;
  EXPECT_EQ(by_default(many).size, sizes[0]) << "no better: the smaller mesh";
  EXPECT_EQ(sizes.size(), 2u);
  MeshOptions few;
  few.max_elements = 1000;
  EXPECT_EQ(by_default(few).faults.size(), 10u);
  EXPECT_EQ(sizes.size(), 1u) << "more elements than are allowed";
  MeshOptions asked = many;
  asked.size = 0.5;
  EXPECT_EQ(by_default(asked).faults.size(), 10u);
  EXPECT_EQ(sizes.size(), 1u) << "the user's size is the user's";
}

TEST(ScaledSizes, CountsFollowTheScale) {
  const Model model = rounded_box(4.0);
  MeshOptions options;
  options.size = 3.0;
  double last = estimate(model, options);
  for (const double scale : {0.9, 0.8, 0.7, 0.6}) {
    const double count = estimate(model, scaled_sizes(model, options, scale));
    EXPECT_GT(count, last) << scale;
    EXPECT_LT(count, 2.0 * last) << scale;
    last = count;
  }
}

}  // namespace
}  // namespace octet
