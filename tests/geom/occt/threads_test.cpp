// SPDX-License-Identifier: BSD-3-Clause
// Four threads give the bits of one, with every query at once.
#include <gtest/gtest.h>

#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <bit>
#include <thread>
#include <tuple>

#include "geom/occt/occt_surface.h"
#include "geom/opposite.h"
#include "lattice_segments.h"
#include "sample_parts.h"

namespace octet::test {
namespace {

/// All answers as bits.
using Bits = std::vector<std::uint64_t>;

void note(Bits& bits, double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); }
void note(Bits& bits, const Vec3& p) {
  for (int k = 0; k < 3; ++k) note(bits, p[k]);
}

struct Question {
  Vec3 p, q;
  int face = 0, edge = 0, axis = 0;
  Vec2 seed = Vec2::Zero();
};

std::vector<Question> questions(const Model& model, int count) {
  LatticeSegments random(model);
  std::vector<Question> all;
  while (static_cast<int>(all.size()) < count) {
    Question question;
    std::tie(question.p, question.q) = random.next();
    const auto triangle =
        static_cast<std::size_t>(random.unit() * static_cast<double>(model.facets().triangles.size()));
    question.face = model.facets().face[triangle];
    question.seed = model.facets().uv[triangle][0];
    question.edge = 1 + static_cast<int>(random.unit() * model.count(1));
    question.axis = static_cast<int>(all.size() % 3);
    if (model.edge(question.edge).use != EdgeUse::kDegenerate) all.push_back(question);
  }
  return all;
}

Bits answer(const Model& model, const Question& ask) {
  Bits bits;
  const Vec3 x = 0.5 * (ask.p + ask.q);
  std::vector<Hit> hits;
  model.intersect(ask.p, ask.q, hits);
  for (const Hit& hit : hits) {
    note(bits, hit.t);
    note(bits, hit.normal);
    bits.push_back(static_cast<std::uint64_t>(hit.on.tag) << 8 | static_cast<std::uint64_t>(hit.kind));
  }
  bits.push_back(static_cast<std::uint64_t>(model.region_at(x)));
  if (const auto foot = model.closest(x, model.diagonal())) note(bits, foot->point);
  const FaceFoot foot = model.face_project(ask.face, x, ask.seed);
  note(bits, foot.point);
  note(bits, foot.normal);
  note(bits, model.face_curvature(ask.face, ask.seed));
  bits.push_back(static_cast<std::uint64_t>(model.face_side(ask.face, ask.seed)));
  note(bits, model.edge_closest(ask.edge, x).t);
  std::vector<double> cuts;
  model.curve(ask.edge).cut(Vec3::Unit(ask.axis), x[ask.axis], cuts);
  for (const double t : cuts) note(bits, t);
  const double thin = 0.05 * model.diagonal();
  if (const auto b = opposite_point(model, foot.point, ask.face, foot.normal, -1, thin)) note(bits, b->point);
  return bits;
}

void expect_same_from_four_threads(const Model& model) {
  const std::vector<Question> all = questions(model, 400);
  std::vector<Bits> alone(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) alone[i] = answer(model, all[i]);
  constexpr std::size_t kThreads = 4;
  std::vector<std::vector<Bits>> together(kThreads, std::vector<Bits>(all.size()));
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < kThreads; ++k)
    threads.emplace_back([&, k] {
      // Every thread asks everything, each from another question on.
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t j = (i + k * all.size() / kThreads) % all.size();
        together[k][j] = answer(model, all[j]);
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < kThreads; ++k) EXPECT_EQ(together[k], alone);
}

class Threads : public ::testing::TestWithParam<const char*> {};

TEST_P(Threads, FourGiveTheBitsOfOne) { expect_same_from_four_threads(sample(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Samples, Threads,
                         ::testing::Values("blade", "box_minus_ball", "bracket", "cone", "torus",
                                           "two_boxes"),
                         [](const auto& sample) { return std::string(sample.param); });

TEST(Threads, ShareASurfaceThatOcctEvaluates) {
  // Poles that swing leave the basis, and so the offset, to OCCT.
  TColgp_Array2OfPnt poles(1, 26, 1, 4);
  for (int i = 1; i <= 26; ++i)
    for (int j = 1; j <= 4; ++j)
      poles(i, j) =
          gp_Pnt(1.0 + (i - 1) / 8.0, j, 0.02 * (i - 13.5) * (j - 2.5) + (i / 2 % 2 == 0 ? 0.2 : -0.2));
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(new Geom_BezierSurface(poles), 0.3);
  const auto surface = make_free_form(SurfaceJets(offset), {Vec2(0, 0), Vec2(1, 1)});
  const auto sweep = [&] {
    Bits bits;
    for (int i = 0; i < 500; ++i) {
      const Vec3 p(1.0 + 0.0059 * i, 4.0 - 0.0059 * i, 3.0);
      const SurfaceFoot foot = surface->project(p, {0.5, 0.5});
      note(bits, foot.point);
      std::vector<SurfaceRoot> roots;
      surface->intersect(p, p - Vec3(0, 0, 6), roots);
      for (const SurfaceRoot& root : roots) note(bits, root.t);
    }
    return bits;
  };
  const Bits alone = sweep();
  EXPECT_GT(alone.size(), 1800u);
  std::vector<Bits> together(4);
  std::vector<std::thread> threads;
  for (Bits& bits : together) threads.emplace_back([&] { bits = sweep(); });
  for (std::thread& thread : threads) thread.join();
  for (const Bits& bits : together) EXPECT_EQ(bits, alone);
}

}  // namespace
}  // namespace octet::test
