// SPDX-License-Identifier: BSD-3-Clause
// The laws of the predicates, judged by big integers and Leibniz' formula.
#include "base/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "base/vertex_order.h"
#include "tests/support/big_integer.h"

namespace octet {
namespace {

using testing::BigInteger;
using Five = std::array<Vec3, 5>;
using Ranks = std::array<std::uint64_t, 5>;

int lowest_bit(const Five& p, int count) {
  int lowest = 2000;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (p[i][k] == 0) continue;
      int e = 0;
      double m = std::frexp(p[i][k], &e);
      while (m != std::floor(m)) {
        m *= 2;
        --e;
      }
      lowest = std::min(lowest, e);
    }
  }
  return lowest == 2000 ? 0 : lowest;
}

// Sign of the determinant by Leibniz' formula over all permutations.
int determinant_sign(const std::vector<std::vector<BigInteger>>& m) {
  std::vector<int> column(m.size());
  std::iota(column.begin(), column.end(), 0);
  BigInteger total;
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < column.size(); ++i) {
      for (std::size_t j = i + 1; j < column.size(); ++j) inversions += column[i] > column[j] ? 1 : 0;
    }
    BigInteger product = m[0][column[0]];
    for (std::size_t i = 1; i < m.size(); ++i) product = product * m[i][column[i]];
    total = total + (inversions % 2 == 0 ? product : -product);
  } while (std::next_permutation(column.begin(), column.end()));
  return total.sign();
}

// The determinants of the raw coordinates, without differences: rows (1, x, y, z) and (x, y, z, |p|^2, 1).
int judge_orient3d(const Five& p) {
  const int low = lowest_bit(p, 4);
  std::vector<std::vector<BigInteger>> m;
  for (int i = 0; i < 4; ++i) {
    m.push_back({BigInteger::scaled(1, 0), BigInteger::scaled(p[i].x(), low),
                 BigInteger::scaled(p[i].y(), low), BigInteger::scaled(p[i].z(), low)});
  }
  return determinant_sign(m);
}

int judge_insphere(const Five& p) {
  const int low = lowest_bit(p, 5);
  std::vector<std::vector<BigInteger>> m;
  for (const Vec3& q : p) {
    const BigInteger x = BigInteger::scaled(q.x(), low), y = BigInteger::scaled(q.y(), low),
                     z = BigInteger::scaled(q.z(), low);
    m.push_back({x, y, z, x * x + y * y + z * z, BigInteger::scaled(1, 0)});
  }
  return -determinant_sign(m);
}

int orient(const Five& p) { return orient3d(p[0], p[1], p[2], p[3]); }
int sphere(const Five& p) { return insphere(p[0], p[1], p[2], p[3], p[4]); }
int ranked(const Five& p, const Ranks& r) { return insphere_ranked(p[0], p[1], p[2], p[3], p[4], r.data()); }

void expect_exact(const Five& p) {
  ASSERT_EQ(orient(p), judge_orient3d(p));
  ASSERT_EQ(sphere(p), judge_insphere(p));
}

double ulps(double x, int n) {
  for (; n > 0; --n) x = std::nextafter(x, 1e300);
  for (; n < 0; ++n) x = std::nextafter(x, -1e300);
  return x;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double real() { return static_cast<double>(engine_()) / 4294967296.0; }
  int integer(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  Five points(double scale, double offset) {
    Five p;
    for (Vec3& q : p) q = {offset + scale * real(), offset + scale * real(), offset + scale * real()};
    return p;
  }
  Five lattice(int n, double unit) {
    Five p;
    for (Vec3& q : p) q = {unit * integer(n), unit * integer(n), unit * integer(n)};
    return p;
  }

 private:
  std::mt19937 engine_;
};

TEST(Predicates, SignsOfAKnownTetrahedron) {
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(orient3d(o, x, y, z), 1);
  EXPECT_EQ(orient3d(o, y, x, z), -1);
  EXPECT_EQ(orient3d(o, x, y, Vec3(3, 4, 0)), 0);
  EXPECT_EQ(insphere(o, x, y, z, Vec3(0.25, 0.25, 0.25)), 1);
  EXPECT_EQ(insphere(o, x, y, z, Vec3(1, 1, 1)), 0);
  EXPECT_EQ(insphere(o, x, y, z, Vec3(1, 1, 1.5)), -1);
}

TEST(Predicates, AgreeWithBigIntegersOnRandomPoints) {
  Random random(1);
  for (int n = 0; n < 100; ++n) expect_exact(random.points(1.0, 0.0));
  for (int n = 0; n < 100; ++n) expect_exact(random.points(1e-6, 1e3));
}

TEST(Predicates, AgreeWithBigIntegersOnLattices) {
  Random random(2);
  for (int n = 0; n < 600; ++n) expect_exact(random.lattice(3, 0.1));
  for (int n = 0; n < 200; ++n) expect_exact(random.lattice(5, 0x1p-20));
}

TEST(Predicates, AgreeWithBigIntegersOneUlpFromDegeneracy) {
  Random random(3);
  int nonzero = 0;
  for (int n = 0; n < 600; ++n) {
    Five p = random.lattice(3, 0.7);
    for (Vec3& q : p) q += Vec3(0.1, 10.3, 1000.7);
    Vec3& moved = p[random.integer(5)];
    double& x = moved[random.integer(3)];
    x = ulps(x, random.integer(2) == 0 ? 1 : -1);
    expect_exact(p);
    nonzero += sphere(p) != 0 ? 1 : 0;
  }
  EXPECT_GT(nonzero, 100);
}

TEST(Predicates, AgreeWithBigIntegersOverTheRangeOfModels) {
  Random random(4);
  for (int n = 0; n < 60; ++n) {
    Five p = random.points(1e-12, 0.0);
    expect_exact(p);
    for (Vec3& q : p) q += Vec3::Constant(1e6 * random.real());
    expect_exact(p);
    p[0] = {1e6, -1e6, 1e6};
    p[1] = {1e-17, 0.0, -3e-17};
    expect_exact(p);
  }
}

TEST(Predicates, AgreeWithBigIntegersBeyondTheRangeOfTheFilter) {
  Random random(5);
  for (int n = 0; n < 4; ++n) {
    expect_exact(random.points(1e-300, 0.0));
    expect_exact(random.points(5e-321, 0.0));
    expect_exact(random.points(1e300, -5e299));
    Five p = random.points(1e-200, 0.0);
    p[3] *= 1e250;
    expect_exact(p);
  }
  const double big = 1e308;
  EXPECT_EQ(orient3d({-big, -big, -big}, {big, 0, 0}, {0, big, 0}, {0, 0, big}), 1);
}

TEST(Predicates, Orient3dChangesSignUnderEveryExchange) {
  Random random(6);
  for (int n = 0; n < 300; ++n) {
    Five p = n % 2 == 0 ? random.lattice(3, 0.3) : random.points(1.0, 5.0);
    const int sign = orient(p);
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        Five q = p;
        std::swap(q[i], q[j]);
        ASSERT_EQ(orient(q), -sign);
      }
    }
  }
}

// Distinct points, not coplanar in the first four, with distinct ranks.
bool usable(const Five& p) { return orient(p) != 0; }

// A random order of ranks in one, two or three classes.
Ranks random_ranks(Random& random) {
  Ranks rank{1, 2, 3, 4, 5};
  for (int i = 4; i > 0; --i) std::swap(rank[i], rank[random.integer(i + 1)]);
  const int classes = 1 + random.integer(3);
  for (auto& r : rank) r |= static_cast<std::uint64_t>(random.integer(classes)) << kRankClassShift;
  return rank;
}

TEST(Predicates, RankedEqualsInsphereWhereThatIsNotZero) {
  Random random(7);
  Ranks rank{5, 3, 9, 1, 7};
  for (int n = 0; n < 500; ++n) {
    const Five p = random.lattice(4, 1.0);
    if (!usable(p) || sphere(p) == 0) continue;
    ASSERT_EQ(ranked(p, rank), sphere(p));
  }
}

TEST(Predicates, RankedIsNeverZeroAndChangesSignUnderEveryExchange) {
  Random random(8);
  int ties = 0;
  for (int n = 0; n < 3000; ++n) {
    const Five p = random.lattice(3, 0.1);
    if (!usable(p)) continue;
    ties += sphere(p) == 0 ? 1 : 0;
    const Ranks rank = random_ranks(random);
    const int sign = ranked(p, rank);
    ASSERT_NE(sign, 0);
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        Five q = p;
        Ranks r = rank;
        std::swap(q[i], q[j]);
        std::swap(r[i], r[j]);
        ASSERT_EQ(ranked(q, r), -sign);
      }
    }
    // With the fifth point too, wherever the law applies: its partner's tetrahedron is not flat.
    for (int i = 0; i < 4; ++i) {
      Five q = p;
      Ranks r = rank;
      std::swap(q[i], q[4]);
      std::swap(r[i], r[4]);
      if (usable(q)) {
        ASSERT_EQ(ranked(q, r), -sign);
      }
    }
  }
  EXPECT_GT(ties, 300);
}

TEST(Predicates, TheStepsOfRankedTellWhatItTells) {
  Random random(9);
  int sure = 0, left = 0;
  for (int n = 0; n < 3000; ++n) {
    const Five p = random.lattice(4, n % 2 == 0 ? 0.1 : 1.0);
    if (!usable(p)) continue;
    const Ranks rank = random_ranks(random);
    const int sign = ranked(p, rank), filtered = insphere_filtered(p[0], p[1], p[2], p[3], p[4]);
    ASSERT_EQ(insphere_ranked_exactly(p[0], p[1], p[2], p[3], p[4], rank.data()), sign);
    (filtered != 0 ? sure : left) += 1;
    if (filtered != 0) {
      ASSERT_EQ(filtered, sign);
    }
  }
  EXPECT_GT(sure, 1000);
  EXPECT_GT(left, 100);
}

TEST(Predicates, OnLatticeAgreesWithRankedForOctreeVertices) {
  Random random(77);
  int told = 0, ties = 0;
  for (int n = 0; n < 200000; ++n) {
    // Corners of octants near to each other, at any place of the root, some with wide gaps.
    const int level = random.integer(6), spread = n % 10 == 0 ? 3000 : 1 + random.integer(4);
    std::array<std::array<std::uint32_t, 3>, 5> at;
    const int room = (1 << (kLatticeLevels - level)) - spread;
    const std::array<int, 3> corner{random.integer(room), random.integer(room), random.integer(room)};
    Five p;
    Ranks rank;
    for (int k = 0; k < 5; ++k) {
      for (int axis = 0; axis < 3; ++axis)
        at[k][axis] = static_cast<std::uint32_t>(corner[axis] + random.integer(spread + 1)) << level;
      p[k] = Vec3(at[k][0], at[k][1], at[k][2]) * 0x1p-10 + Vec3(3.25, -7.5, 11.0);
      rank[k] = octree_vertex_rank(at[k][0], at[k][1], at[k][2]);
      EXPECT_EQ(octree_vertex_lattice(rank[k]), at[k]);
    }
    std::set<std::uint64_t> distinct(rank.begin(), rank.end());
    if (distinct.size() < 5 || orient3d(p[0], p[1], p[2], p[3]) == 0) continue;
    const int sign = insphere_on_lattice(rank.data());
    if (sign == 0) continue;
    ++told;
    ties += sphere(p) == 0 ? 1 : 0;
    ASSERT_EQ(sign, ranked(p, rank));
  }
  EXPECT_GT(told, 50000);
  EXPECT_GT(ties, 3000);
}

TEST(Predicates, OnLatticeLeavesOtherPointsAndFarOnesToOthers) {
  Ranks rank{octree_vertex_rank(0, 0, 0), octree_vertex_rank(1, 0, 0), octree_vertex_rank(0, 1, 0),
             octree_vertex_rank(0, 0, 1), octree_vertex_rank(1, 1, 1)};
  EXPECT_NE(insphere_on_lattice(rank.data()), 0);
  rank[2] = free_point_rank(7);
  EXPECT_EQ(insphere_on_lattice(rank.data()), 0);
  rank[2] = octree_vertex_rank(0, 1u << 13, 0);
  EXPECT_EQ(insphere_on_lattice(rank.data()), 0);
}

int heavier(const Ranks& rank, std::uint64_t than) {
  return static_cast<int>(std::count_if(rank.begin(), rank.end(), [&](std::uint64_t r) { return r > than; }));
}

// The sign with real weights instead of vanishing ones: 2^-(20 + 40 n) for a class that n points outweigh,
// 2^-(220 + 40 n) for an octree vertex that n points outrank, the form times 2^-420 for other points, and
// 2^-(460 + 40 n) for one of these. Exact in big integers.
int judge_weighted(const Five& p, const Ranks& rank) {
  const int low = -700;
  Ranks classes{};
  for (int i = 0; i < 5; ++i) classes[i] = rank[i] >> kRankClassShift;
  const auto integer = [](double v) { return BigInteger::scaled(v, 0); };
  std::vector<std::vector<BigInteger>> m;
  for (int i = 0; i < 5; ++i) {
    const bool octree = rank[i] >> 63 != 0;
    const double common = std::ldexp(1.0, -20 - 40 * heavier(classes, classes[i]));
    const double own = std::ldexp(1.0, (octree ? -220 : -460) - 40 * heavier(rank, rank[i]));
    const Vec3& q = p[i];
    const double form =
        q.x() * q.y() + 2 * q.y() * q.z() + 3 * q.z() * q.x() + 2 * q.x() * q.x() + q.y() * q.y();
    // In units of 2^low for the lifted column only: a column's factor does not change the sign.
    const BigInteger lift = BigInteger::scaled(q.squaredNorm(), low) + -BigInteger::scaled(common, low) +
                            -BigInteger::scaled(own, low) +
                            BigInteger::scaled(octree ? 0.0 : std::ldexp(form, -420), low);
    m.push_back({integer(q.x()), integer(q.y()), integer(q.z()), lift, integer(1)});
  }
  return -determinant_sign(m);
}

TEST(Predicates, RankedIsTheLimitOfVanishingWeights) {
  Random random(9);
  int ties = 0;
  for (int n = 0; n < 6000; ++n) {
    const Five p = random.lattice(n % 2 == 0 ? 3 : 2, 1.0);
    if (!usable(p) || sphere(p) != 0) continue;
    bool distinct = true;
    for (int i = 0; i < 4; ++i) distinct = distinct && p[i] != p[4];
    if (!distinct) continue;
    ++ties;
    Ranks rank = random_ranks(random);
    ASSERT_EQ(ranked(p, rank), judge_weighted(p, rank));
    for (auto& r : rank) r |= static_cast<std::uint64_t>(random.integer(2)) << 63;  // some octree vertices
    ASSERT_EQ(ranked(p, rank), judge_weighted(p, rank));
  }
  EXPECT_GT(ties, 500);
}

}  // namespace
}  // namespace octet
