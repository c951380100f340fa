// SPDX-License-Identifier: BSD-3-Clause
// The loop between classification and triangulation: holes are found where they are, and closed.
#include "app/attribute_points.h"
#include "app/attempt.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "base/vertex_order.h"
#include "geom/analytic.h"
#include "geom/occt/from_shape.h"
#include "octree/seeds.h"
#include "tests/support/seed_points.h"

namespace octet {
namespace {

/// A band triangulated from seeds of which the test may drop some.
class Bench {
 public:
  Bench(const Model& model, double size)
      : band_(model, [&](const Vec3& p) { return model.region_at(p); }), edges_(model, size) {
    OctreeRequest request;
    request.size = size;
    seeds_ = test::seed_points(model, build_octree(model, request, {}), size);
  }

  /// Keeps the points for which keep(position, on) holds; edge points are always kept.
  template <class Keep>
  void triangulate(const Keep& keep) {
    SeedPoints kept;
    const SeedPoints& all = seeds_.points;
    std::vector<std::uint32_t> number(all.size(), UINT32_MAX);
    for (std::uint32_t n = 0; n < all.size(); ++n)
      if (all.on[n].dim < 2 || keep(all.position[n], all.on[n]))
        number[n] =
            static_cast<std::uint32_t>(kept.add(all.position[n], all.on[n], all.order[n], all.spacing[n]));
    std::vector<EdgePiece> pieces = seeds_.pieces;
    for (EdgePiece& piece : pieces) {
      piece.a = number[piece.a];
      piece.b = number[piece.b];
    }
    chains_ = std::make_unique<EdgeChains>(std::move(pieces));
    on_ = kept.on;
    triangulation_.insert_all(kept.position, kept.order);
    std::vector<TetId> tets;
    for (std::size_t i = 0; i < triangulation_.mesh().tets.size(); ++i)
      if (triangulation_.mesh().alive(TetId(i))) tets.emplace_back(i);
    band_.update(triangulation_.mesh(), on_, tets);
  }

  /// Adds a free point before triangulate().
  void add(const Vec3& p, ModelRef on) {
    seeds_.points.add(p, on, free_point_rank(1'000'000 + seeds_.points.size()), 1.0);
  }
  const std::vector<EdgePiece>& pieces() const { return seeds_.pieces; }

  std::vector<Gap> gaps(GapScope scope = GapScope::kPiecesFirst) {
    return find_gaps(band_, triangulation_.mesh(), on_, *chains_, scope);
  }

  std::vector<Gap> gaps(GapMemory& memory) {
    return find_gaps(band_, triangulation_.mesh(), on_, *chains_, memory);
  }

  /// A point more, of which the memory is told.
  VertexId insert(const Vec3& p, ModelRef on, GapMemory& memory) {
    std::vector<TetId> created;
    const VertexId v = triangulation_.insert(p, free_point_rank(on_.size()), TetId(), created);
    if (v.index() < on_.size()) return v;
    on_.push_back(on);
    band_.update(mesh(), on_, created);
    memory.add(mesh(), created);
    return v;
  }
  /// Splits an edge piece in the middle of its parameters.
  void split(std::uint32_t n, GapMemory& memory) {
    const EdgePiece piece = (*chains_)[n];
    const double t = 0.5 * (piece.ta + piece.tb);
    const VertexId v = insert(band_.model().edge_point(piece.edge, t), model_edge(piece.edge), memory);
    chains_->split(n, v, t);
    memory.ask_again(VertexId(piece.a));
    memory.ask_again(VertexId(piece.b));
  }

  AttributeResult close(std::size_t points) {
    AttributeLimits limits;
    limits.points = points;
    return close(limits);
  }
  AttributeResult close(AttributeLimits limits) {
    limits.floor = 1e-5;
    Observer silent;
    return close_gaps(triangulation_, band_, *chains_, on_, edges_, limits, silent);
  }

  const std::vector<ModelRef>& on() const { return on_; }
  const TetMesh& mesh() const { return triangulation_.mesh(); }

 private:
  Seeds seeds_;
  Triangulation triangulation_;
  Band band_;
  std::unique_ptr<EdgeChains> chains_;
  std::vector<ModelRef> on_;
  EdgeIndex edges_;
};

TEST(AttributePoints, CloseTheHoleWhereABallWasNotSampled) {
  const Model model = analytic_ball(1.0, {});
  Bench bench(model, 0.3);
  // No point on a cap: the facets that span it are too far from the ball.
  bench.triangulate([](const Vec3& p, ModelRef on) { return on.dim == 3 || p.z() < 0.5; });
  const std::vector<Gap> gaps = bench.gaps();
  EXPECT_TRUE(std::any_of(gaps.begin(), gaps.end(), [](const Gap& gap) { return gap.place.z() > 0.3; }));
  const std::size_t before = bench.on().size();
  const AttributeResult result = bench.close(2000);
  EXPECT_TRUE(result.gaps.empty());
  EXPECT_EQ(bench.on().size(), before + result.points);
  EXPECT_GT(result.points, 0u);
  for (std::size_t n = before; n < bench.on().size(); ++n) {
    EXPECT_EQ(bench.on()[n], model_face(1));
    EXPECT_NEAR(bench.mesh().points[VertexId(n)].norm(), 1.0, 1e-9);
  }
  EXPECT_TRUE(bench.gaps().empty());
}

TEST(AttributePoints, CloseAHollowWhosePointsAreAllInTheMiddle) {
  // A quarter of a cylinder's hollow along an edge of a block. Facets from its points to its borders are too
  // far from it, and the chord from border to border asks for a point in the middle, where there are some.
  const Model model = model_from_shape(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(6, 8, 6).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, -1, 0), gp::DY()), 1.6, 10).Shape())
          .Shape());
  int hollow = 0;
  for (int f = 1; f <= model.count(2); ++f)
    if (!model.is_plane(f)) hollow = f;
  for (int step = 0; step < 24; ++step) {
    const double size = 1.0 + 0.05 * step;
    Bench bench(model, size);
    for (double y = 0.2; y < 7.9; y += 0.15)
      bench.add(1.6 * Vec3(std::sqrt(0.5), 0.0, std::sqrt(0.5)) + Vec3(0.0, y, 0.0), model_face(hollow));
    bench.triangulate([&](const Vec3& p, ModelRef on) {
      return on != model_face(hollow) || std::abs(p.x() - p.z()) < 1e-9;
    });
    EXPECT_FALSE(bench.gaps().empty());
    const AttributeResult result = bench.close(2000);
    EXPECT_TRUE(result.gaps.empty()) << size;
    EXPECT_LT(result.points, 100u) << size;
  }
}

TEST(AttributePoints, MoreGapsThanAllowedEndTheLoopBeforeAnyPoint) {
  const Model model = analytic_ball(1.0, {});
  Bench bench(model, 0.3);
  bench.triangulate([](const Vec3& p, ModelRef on) { return on.dim == 3 || p.z() < 0.5; });
  AttributeLimits limits;
  limits.points = 2000;
  limits.gaps = bench.gaps().size() - 1;
  const AttributeResult ended = bench.close(limits);
  EXPECT_EQ(ended.points, 0u);
  EXPECT_EQ(ended.gaps.size(), limits.gaps + 1);
  ++limits.gaps;
  EXPECT_TRUE(bench.close(limits).gaps.empty());
}

TEST(AttributePoints, WhatTheLimitLeavesOpenIsReported) {
  const Model model = analytic_ball(1.0, {});
  Bench bench(model, 0.3);
  bench.triangulate([](const Vec3& p, ModelRef on) { return on.dim == 3 || p.z() < 0.0; });
  const AttributeResult result = bench.close(1);
  EXPECT_GT(result.gaps.size(), 1u);
  const std::vector<Fault> faults = describe_gaps(model, result.gaps);
  EXPECT_NE(faults.front().cause.find("Face 1"), std::string::npos);
  EXPECT_LE(faults.size(), 6u);  // one a kind
  EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
    return fault.cause.find("more places") != std::string::npos;
  }));
}

TEST(AttributePoints, ACellThatHasSpentItsPointsStaysOpenAndTheOthersClose) {
  const Model model = analytic_ball(1.0, {});
  Bench bench(model, 0.3);
  bench.triangulate([](const Vec3& p, ModelRef on) { return on.dim == 3 || std::abs(p.z()) < 0.4; });
  const std::size_t before = bench.on().size();
  std::size_t other = 0;
  AttributeLimits limits;
  limits.points = 2000;
  limits.per_cell = 3;
  limits.cell_at = [&](const Vec3& p) { return p.z() > 0.0 ? 0 : ++other; };
  const AttributeResult result = bench.close(limits);
  EXPECT_FALSE(result.gaps.empty());
  for (const Gap& gap : result.gaps) EXPECT_GT(gap.place.z(), 0.0);
  int north = 0;
  for (std::size_t n = before; n < bench.on().size(); ++n)
    north += bench.mesh().points[VertexId(n)].z() > 0.4;
  EXPECT_GT(north, 0);
  EXPECT_LE(north, 4);
}

TEST(AttributePoints, AMissingEdgePieceIsFoundAndSplit) {
  const Model model = analytic_box(Vec3(1, 1, 1), {});
  Bench bench(model, 0.5);
  // Points just inside and just outside of the middle of an edge piece break it.
  const EdgePiece first = bench.pieces().front();
  const Vec3 middle = model.edge_point(first.edge, 0.5 * (first.ta + first.tb));
  const Vec3 inwards = 0.05 * (Vec3(0.5, 0.5, 0.5) - middle);
  bench.add(middle + inwards, model_region(1));
  bench.add(middle - inwards, model_region(0));
  bench.triangulate([](const Vec3&, ModelRef) { return true; });
  const std::vector<Gap> gaps = bench.gaps();
  ASSERT_FALSE(gaps.empty());
  EXPECT_EQ(gaps.front().kind, GapKind::kMissingPiece);
  EXPECT_EQ(gaps.front().entity, model_edge(first.edge));
  const std::vector<Gap> all = bench.gaps(GapScope::kAll);
  const auto pieces = std::count_if(all.begin(), all.end(),
                                    [](const Gap& gap) { return gap.kind == GapKind::kMissingPiece; });
  EXPECT_EQ(static_cast<std::size_t>(pieces), gaps.size());
  EXPECT_GT(all.size(), gaps.size()) << "facets, too";
  EXPECT_TRUE(bench.close(500).gaps.empty());
}

TEST(AttributePoints, WhatLiesElsewhereIsClosedWhereAPieceCannotBeHad) {
  const Model model = analytic_box_minus_ball(2.0, 0.6);
  const Vec3 centre = model.box().centre();
  const auto at_hollow = [&](const Vec3& p) { return (p - centre).norm() < 0.7; };
  for (const GapScope scope : {GapScope::kPiecesFirst, GapScope::kAll}) {
    Bench bench(model, 0.3);
    for (std::size_t n = 0; n < 4; ++n) {
      const EdgePiece& piece = bench.pieces()[n];
      const Vec3 middle = model.edge_point(piece.edge, 0.5 * (piece.ta + piece.tb));
      const Vec3 inwards = 0.02 * (centre - middle);
      bench.add(middle + inwards, model_region(1));
      bench.add(middle - inwards, model_region(0));
    }
    bench.triangulate(
        [&](const Vec3& p, ModelRef on) { return on.dim == 3 || !at_hollow(p) || p.z() < centre.z(); });
    // One point for all of the pieces, as many as it takes for the hollow.
    std::size_t cells = 0;
    AttributeLimits limits;
    limits.points = 2000;
    limits.scope = scope;
    limits.per_cell = 1;
    limits.cell_at = [&](const Vec3& p) { return at_hollow(p) ? ++cells : 0; };
    const AttributeResult result = bench.close(limits);
    EXPECT_TRUE(openness(result.gaps).lacks_pieces);
    const std::vector<Gap> all = bench.gaps(GapScope::kAll);
    const bool open =
        std::any_of(all.begin(), all.end(), [&](const Gap& gap) { return at_hollow(gap.place); });
    EXPECT_EQ(open, scope == GapScope::kPiecesFirst);
  }
}

/// Points at random about a cylinder, some where they say they are and some not, and splits of edge pieces,
/// by turns: a search that remembers finds after each what one that does not finds.
TEST(AttributePoints, ASearchThatRemembersFindsTheSameGaps) {
  const Model model = analytic_cylinder(1.0, 1.0, {});
  Bench bench(model, 0.4);
  bench.triangulate([](const Vec3&, ModelRef) { return true; });
  GapMemory memory;
  std::map<GapKind, int> seen;
  const auto compare = [&] {
    const std::vector<Gap> found = bench.gaps(memory), fresh = bench.gaps();
    EXPECT_EQ(found.size(), fresh.size());
    for (std::size_t i = 0; i < std::min(found.size(), fresh.size()); ++i) {
      EXPECT_TRUE(found[i].kind == fresh[i].kind && found[i].entity == fresh[i].entity &&
                  found[i].piece == fresh[i].piece && found[i].vertex == fresh[i].vertex &&
                  found[i].tet == fresh[i].tet && found[i].local == fresh[i].local);
      ++seen[found[i].kind];
    }
    return fresh;
  };
  compare();
  std::minstd_rand random(7);
  const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  for (int step = 0; step < 200; ++step) {
    const Vec3 p(2.4 * share() - 1.2, 2.4 * share() - 1.2, 1.4 * share() - 0.2);
    const auto foot = model.closest(p, 3.0);
    ASSERT_TRUE(foot);
    switch (step % 4) {
      case 0:
      case 1:
        if (foot->on.dim == 2) bench.insert(foot->point, foot->on, memory);
        break;
      case 2:
        bench.insert(foot->point + 0.1 * (p - foot->point), model_region(share() < 0.5 ? 0 : 1), memory);
        break;
      default:
        bench.insert(foot->point, model_face(1 + static_cast<int>(3.0 * share())), memory);
    }
    // What broke is split, as the loop does it, so that facets are looked at again.
    for (int tries = 0; tries < 4; ++tries)
      for (const Gap& gap : compare())
        if (gap.kind == GapKind::kMissingPiece) bench.split(gap.piece, memory);
  }
  for (const GapKind kind :
       {GapKind::kMissingPiece, GapKind::kNoFace, GapKind::kEdgeFan, GapKind::kVertexFan})
    EXPECT_GT(seen[kind], 0) << static_cast<int>(kind);
}

TEST(SplitPoint, IsOnAPowerOfTwoShellAroundAModelVertex) {
  const Model model = analytic_box(Vec3(1, 1, 1), {});
  const ModelEdge& edge = model.edge(1);
  TetMesh mesh;
  mesh.points.push_back(model.vertex(edge.vertex[0]).point);
  mesh.points.push_back(model.edge_point(1, edge.t0 + 0.3 * (edge.t1 - edge.t0)));
  const std::vector<ModelRef> on{model_vertex(edge.vertex[0]), model_edge(1)};
  const EdgePiece piece{0, 1, edge.t0, edge.t0 + 0.3 * (edge.t1 - edge.t0), 1};
  const AttributePoint p = split_point(model, mesh, on, piece);
  const double radius = (p.point - mesh.points[VertexId(0)]).norm();
  EXPECT_NEAR(std::log2(radius), std::round(std::log2(radius)), 1e-9);
  EXPECT_GT(radius, 0.3 * 0.3);
  EXPECT_LT(radius, 0.3 * 0.75);
}

}  // namespace
}  // namespace octet
