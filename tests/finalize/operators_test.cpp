// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "finalize/collapse.h"
#include "finalize/edge_removal.h"
#include "finalize/face_swap.h"
#include "finalize/shape.h"
#include "finalize/smooth.h"
#include "finalize/split.h"
#include "tests/finalize/parts.h"

namespace octet {
namespace {

using testing::faults_of;
using testing::Part;

struct Bench {
  explicit Bench(Part the_part, double size = 0.5)
      : part(std::move(the_part)),
        euler(testing::face_euler(part.mesh, part.model.count(2))),
        options(testing::options_of_size(size)),
        shop(to_work_mesh(part.mesh), part.model, options) {}

  [[nodiscard]] std::string faults() const {
    if (std::string fault = check_work_mesh(shop.mesh); !fault.empty()) return fault;
    return faults_of(to_mesh(shop.mesh), part.model, euler);
  }
  [[nodiscard]] VertexId at(double x, double y, double z) const {
    return testing::vertex_near(shop.mesh, {x, y, z});
  }
  [[nodiscard]] TetId tet(VertexId a, VertexId b) { return tet_with_edge(shop.mesh, a, b); }
  [[nodiscard]] std::size_t tets() const { return to_mesh(shop.mesh).tets.size(); }

  Part part;
  std::vector<int> euler;
  FinalizeOptions options;
  Workshop shop;
};

TEST(EdgeRemoval, TurnsARingOfFiveIntoSix) {
  Bench bench(testing::spindle_part(5));
  ASSERT_TRUE(remove_edge(bench.shop, TetId(0), VertexId(0), VertexId(1), 0.0));
  EXPECT_EQ(bench.tets(), 6u);
  EXPECT_EQ(bench.faults(), "");
  EXPECT_FALSE(bench.tet(VertexId(0), VertexId(1)).valid());
}

TEST(EdgeRemoval, TurnsThreeTetrahedraIntoTwoAndFaceSwapTurnsThemBack) {
  Bench bench(testing::spindle_part(3));
  ASSERT_TRUE(remove_edge(bench.shop, TetId(0), VertexId(0), VertexId(1), 0.0));
  EXPECT_EQ(bench.tets(), 2u);
  EXPECT_EQ(bench.faults(), "");
  const TetId t = bench.shop.made[0];
  int inner = 0;
  while (!bench.shop.mesh.neighbours[t][inner].valid()) ++inner;
  ASSERT_TRUE(swap_face(bench.shop, t, inner, 0.0));
  EXPECT_EQ(bench.tets(), 3u);
  EXPECT_EQ(bench.faults(), "");
}

TEST(EdgeRemoval, DoesNothingThatIsNotBetterThanTheFloor) {
  Bench bench(testing::spindle_part(5));
  EXPECT_FALSE(remove_edge(bench.shop, TetId(0), VertexId(0), VertexId(1), 0.9));
  EXPECT_EQ(bench.tets(), 5u);
}

TEST(EdgeRemoval, NeverRemovesAPieceOfAModelEdge) {
  Bench bench(testing::box_part({1, 1, 1}, 2, 2, 2));
  const VertexId a = bench.at(0, 0, 0), b = bench.at(0.5, 0, 0);
  EXPECT_FALSE(remove_edge(bench.shop, bench.tet(a, b), a, b, -1.0));
}

TEST(EdgeRemoval, SwapsTheDiagonalOfAPlanarFaceAndKeepsTheVolume) {
  int swaps = 0;
  const Bench model(testing::box_part({1, 1, 1}, 2, 2, 2));
  for (const auto& tet : model.part.mesh.tets) {
    for (const auto& e : kTetEdge) {
      Bench bench(testing::box_part({1, 1, 1}, 2, 2, 2));
      const VertexId a(tet[e[0]]), b(tet[e[1]]);
      if (!remove_edge(bench.shop, bench.tet(a, b), a, b, 0.0)) continue;
      ASSERT_EQ(bench.faults(), "");
      EXPECT_NEAR(testing::total_volume(to_mesh(bench.shop.mesh)), 1.0, 1e-13);
      swaps += bench.shop.mesh.on_boundary(a) && bench.shop.mesh.on_boundary(b);
    }
  }
  EXPECT_GT(swaps, 0);
}

TEST(EdgeRemoval, DropsNoiseFlatTetrahedraFromPlanarFaces) {
  Part part = testing::box_part({1, 1, 1}, 3, 3, 3, true);
  const std::size_t before = part.mesh.tets.size();
  const int glued = testing::glue_flat_tets(part.mesh, part.model);
  ASSERT_GT(glued, 3);
  Bench bench(std::move(part));
  ASSERT_EQ(bench.faults(), "");
  for (std::size_t i = before; i < bench.shop.mesh.tets.size(); ++i) {
    const TetId t(i);
    ASSERT_LT(bench.shop.mesh.quality[t], 1e-20);
    const auto v = bench.shop.mesh.tets[t];
    bool removed = false;
    for (const auto& e : kTetEdge) {
      removed = removed || remove_edge(bench.shop, t, v[e[0]], v[e[1]], kNoise);
      if (removed) break;
    }
    EXPECT_TRUE(removed);
    ASSERT_EQ(bench.faults(), "");
  }
  EXPECT_EQ(bench.tets(), before);
}

/// Every ordered pair of neighbours, each on a fresh mesh: what the model forbids is refused, what is done
/// keeps the mesh right.
TEST(Collapse, KeepsEveryChainAndFaceWhateverPairIsAsked) {
  const Bench model(testing::box_part({1, 1, 1}, 2, 2, 2));
  int done = 0;
  for (const auto& tet : model.part.mesh.tets) {
    for (const auto& e : kTetEdge) {
      for (const bool turned : {false, true}) {
        Bench bench(testing::box_part({1, 1, 1}, 2, 2, 2));
        const VertexId gone(tet[e[turned]]), kept(tet[e[!turned]]);
        const ModelRef from = bench.shop.mesh.on[gone], to = bench.shop.mesh.on[kept];
        const bool collapsed = collapse_edge(bench.shop, gone, kept, 1e-9);
        if (!bench.part.model.in_closure(to, from) && from.dim < 3) {
          EXPECT_FALSE(collapsed);
        }
        if (!collapsed) continue;
        ++done;
        ASSERT_EQ(bench.faults(), "");
        EXPECT_NEAR(testing::total_volume(to_mesh(bench.shop.mesh)), 1.0, 1e-13);
        EXPECT_EQ(to_mesh(bench.shop.mesh).edges.size(), from.dim == 1 ? 23u : 24u);
      }
    }
  }
  EXPECT_GT(done, 50);
}

TEST(Collapse, RefusesAModelVertexAndADepartureFromAFace) {
  Bench bench(testing::box_part({1, 1, 1}, 2, 2, 2));
  EXPECT_FALSE(collapse_edge(bench.shop, bench.at(0, 0, 0), bench.at(0.5, 0, 0), -1.0));
  EXPECT_FALSE(collapse_edge(bench.shop, bench.at(0.5, 0.5, 0), bench.at(0.5, 0.5, 0.5), -1.0));
  EXPECT_FALSE(collapse_edge(bench.shop, bench.at(0.5, 0, 0), bench.at(0.5, 0.5, 0), -1.0));
}

TEST(Collapse, LeavesThreePiecesOnAClosedEdge) {
  Bench bench(testing::cylinder_part(4), 1.0);
  ASSERT_EQ(bench.faults(), "");
  WorkMesh& mesh = bench.shop.mesh;
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const VertexId v(i);
      if (!mesh.alive(v) || mesh.on[v].dim != 1) continue;
      for (std::size_t j = 0; j < mesh.points.size() && mesh.alive(v); ++j) {
        const VertexId w(j);
        if (w == v || !mesh.alive(w) || piece_on(mesh, v, w) == 0) continue;
        if (collapse_edge(bench.shop, v, w, 1e-9)) {
          ASSERT_EQ(check_work_mesh(mesh), "");
        }
      }
    }
  }
  for (int e = 1; e <= bench.part.model.count(1); ++e) {
    if (bench.part.model.edge(e).use == EdgeUse::kReal) {
      EXPECT_GE(mesh.pieces_on_edge[static_cast<std::size_t>(e)], 3);
    }
  }
  EXPECT_EQ(bench.faults(), "");
}

TEST(Split, PutsTheNewVertexOnTheEntityOfTheEdge) {
  Bench bench(testing::cylinder_part(4), 0.5);
  int on[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 40; ++i) {
    const TetId t(i);
    if (!bench.shop.mesh.alive(t)) continue;
    const auto v = bench.shop.mesh.tets[t];
    for (const auto& e : kTetEdge) {
      if (!split_edge(bench.shop, t, v[e[0]], v[e[1]], 1e-6, 2e-6)) continue;
      ++on[bench.shop.mesh.on[VertexId(bench.shop.mesh.points.size() - 1)].dim];
      ASSERT_EQ(bench.faults(), "");
      break;
    }
  }
  EXPECT_EQ(on[0], 0);
  EXPECT_GT(on[1] + on[2] + on[3], 20);
  EXPECT_GT(on[1], 0);
  EXPECT_GT(on[2], 0);
}

TEST(Split, NoPlaceOfTheNewVertexIsBetterThanTheBound) {
  Bench bench(testing::ball_part(4));
  testing::Dice dice(7);
  testing::jitter(bench.part.mesh, bench.part.model, 0.08, dice);
  const WorkMesh mesh = to_work_mesh(bench.part.mesh);
  EdgeRing ring;
  double nearest = 0.0;
  for (std::size_t i = 0; i < mesh.tets.size(); i += 3) {
    const auto v = mesh.tets[TetId(i)];
    for (const auto& e : kTetEdge) {
      edge_ring(mesh, TetId(i), v[e[0]], v[e[1]], ring);
      const double bound = most_of_split(mesh, ring);
      const Vec3 &a = mesh.points[ring.a], &b = mesh.points[ring.b];
      for (int place = 0; place < 40; ++place) {
        const double x = dice.roll(), y = dice.roll(), z = dice.roll();
        const Vec3 off = 0.4 * (Vec3(x, y, z) - Vec3::Constant(0.5));
        const Vec3 m = 0.5 * (a + b) + (b - a).norm() * off;
        double worst = 1.0;
        for (std::size_t k = 0; k < ring.tets.size(); ++k) {
          const Vec3 &c = mesh.points[ring.rim[k]], &d = mesh.points[ring.rim[(k + 1) % ring.rim.size()]];
          worst = std::min({worst, shape(m, b, c, d), shape(a, m, c, d)});
        }
        ASSERT_LE(worst, bound * (1.0 + 1e-9));
        nearest = std::max(nearest, worst / bound);
      }
    }
  }
  EXPECT_GT(nearest, 0.9) << "the bound says nothing";
}

TEST(Split, MakesNoNicks) {
  Bench bench(testing::cylinder_part(4), 10.0);
  const auto v = bench.shop.mesh.tets[TetId(0)];
  EXPECT_FALSE(split_edge(bench.shop, TetId(0), v[0], v[1], -1.0, 0.0));
}

TEST(Split, MakesNoMoreFlatElementsWhereTheyAreMany) {
  const auto splits = [](double thickness) {
    int done = 0;
    const std::size_t tets = Bench(testing::box_part({1, 1, thickness}, 2, 2, 1), 0.3).shop.mesh.tets.size();
    for (std::size_t i = 0; i < tets; ++i) {
      for (const auto& e : kTetEdge) {
        Bench bench(testing::box_part({1, 1, thickness}, 2, 2, 1), 0.3);
        const FlatWatch watch(bench.shop.flats);
        const auto v = bench.shop.mesh.tets[TetId(i)];
        if (!split_edge(bench.shop, TetId(i), v[e[0]], v[e[1]], 1e-9, 1e-8)) continue;
        ++done;
        EXPECT_EQ(bench.faults(), "");
      }
    }
    return done;
  };
  EXPECT_EQ(splits(0.01), 0) << "each tetrahedron is flat, and would be two that are";
  EXPECT_GT(splits(0.3), 20);
}

TEST(Split, MayMakeAThousandthOfAllFlat) {
  Bench bench(testing::box_part({1, 1, 0.0005}, 40, 40, 1), 0.015);
  const FlatWatch watch(bench.shop.flats);
  WorkMesh& mesh = bench.shop.mesh;
  const std::size_t tets = mesh.tets.size();
  for (std::size_t i = 0; i < tets; ++i) {
    const TetId t(i);
    for (const auto& e : kTetEdge) {
      if (!mesh.alive(t)) break;
      const auto v = mesh.tets[t];
      split_edge(bench.shop, t, v[e[0]], v[e[1]], 1e-9, 1e-8);
    }
  }
  EXPECT_GT(bench.shop.flats.made(), 0u);
  EXPECT_LE(static_cast<double>(bench.shop.flats.made()), 0.001 * static_cast<double>(mesh.tets.size()));
  EXPECT_EQ(bench.tets(), tets + bench.shop.flats.made()) << "all are flat here";
}

TEST(Split, LeavesAnEdgeThatTheSolidTouchesItselfAlong) {
  using testing::Cells;
  for (const Cells& without : {Cells{}, Cells{{1, 1}}, Cells{{1, 1}, {-1, -1}}}) {
    const Part part = testing::cells_about_edge(without);
    const FinalizeOptions options = testing::options_of_size(0.5);
    Workshop shop(to_work_mesh(part.mesh), part.model, options);
    const VertexId a = testing::vertex_near(shop.mesh, {0, 0, 1}),
                   b = testing::vertex_near(shop.mesh, {0, 0, 2});
    const TetId t = tet_with_edge(shop.mesh, a, b);
    ASSERT_TRUE(t.valid());
    EXPECT_EQ(split_edge(shop, t, a, b, 1e-6, 2e-6), without.size() < 2) << without.size();
  }
}

TEST(Smooth, NeverLowersTheWorstOfTheStarAndStaysOnTheEntity) {
  Part part = testing::jittered(testing::cylinder_part(5), 0.12, 3);
  Bench bench(std::move(part), 0.4);
  WorkMesh& mesh = bench.shop.mesh;
  std::vector<TetId> tets;
  int moved = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const VertexId v(i);
    star(mesh, v, tets);
    const auto worst = [&] {
      double q = 1.0;
      for (const TetId t : tets) q = std::min(q, mesh.quality[t]);
      return q;
    };
    const double before = worst();
    const bool moved_here = smooth_vertex(bench.shop, v, 1.0);
    EXPECT_EQ(worst() > before, moved_here);
    moved += moved_here;
  }
  EXPECT_GT(moved, 50);
  EXPECT_EQ(bench.faults(), "");
}

}  // namespace
}  // namespace octet
