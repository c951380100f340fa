// SPDX-License-Identifier: BSD-3-Clause
// Partners of edge points and vertices on faces that they do not bound.
#include "geom/face_match.h"

#include <gtest/gtest.h>

#include <numbers>

#include "geom/analytic.h"

namespace octet {
namespace {

/// A cube of side 2 around a ball that comes within 0.05 of its faces and 0.46 of its edges.
Model tight_box() { return analytic_box_minus_ball(2.0, 0.95, {{}, 1e-2}); }

int ball_face(const Model& model) {
  for (int f = 1; f <= model.count(2); ++f)
    if (std::string_view(model.surface(f).kind()) == "sphere") return f;
  return 0;
}

TEST(FaceMatch, AnEdgeAlongAFaceHasItsFootThere) {
  const Model model = tight_box();
  const ModelEdge& edge = model.edge(1);
  const double middle = 0.5 * (edge.t0 + edge.t1);
  const Vec3 a = model.edge_point(1, middle);
  const auto partners = face_partners(model, model_edge(1), a, model.edge_derivative(1, middle), 0.5);
  ASSERT_EQ(partners.size(), 1u);
  EXPECT_EQ(partners[0].face, ball_face(model));
  EXPECT_NEAR((partners[0].point - a).norm(), std::numbers::sqrt2 - 0.95, 1e-9);
  EXPECT_NEAR(partners[0].point.norm(), 0.95, 1e-9);
}

TEST(FaceMatch, TheChordMakesEqualAnglesWithTheEdgeAndTheFace) {
  const Model model = tight_box();
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (edge.use != EdgeUse::kReal) continue;
    for (const double share : {0.3, 0.4, 0.6, 0.7}) {
      const double t = edge.t0 + share * (edge.t1 - edge.t0);
      const Vec3 a = model.edge_point(e, t), along = model.edge_derivative(e, t).normalized();
      const auto partners = face_partners(model, model_edge(e), a, along, 0.7);
      ASSERT_EQ(partners.size(), 1u);
      const FacePartner& b = partners[0];
      const Vec3 shadow = (along - along.dot(b.normal) * b.normal).normalized();
      EXPECT_NEAR((b.point - a).dot(along), -(b.point - a).dot(shadow), 1e-9);
    }
  }
}

TEST(FaceMatch, AVertexHasItsFootOnANearFaceOnly) {
  const Model model = tight_box();
  const Vec3 corner = model.vertex(model.edge(1).vertex[0]).point;
  const ModelRef vertex = model_vertex(model.edge(1).vertex[0]);
  EXPECT_TRUE(face_partners(model, vertex, corner, Vec3::Zero(), 0.7).empty());
  const auto partners = face_partners(model, vertex, corner, Vec3::Zero(), 0.8);
  ASSERT_EQ(partners.size(), 1u);
  EXPECT_LT((partners[0].point - 0.95 * corner.normalized()).norm(), 1e-9);
}

TEST(FaceMatch, AnEdgeThatLeavesAFaceSteeplyHasNoPartnerThere) {
  const Model model = analytic_box(Vec3(1, 1, 1));
  for (int e = 1; e <= model.count(1); ++e) {
    const double t = model.edge_parameter(e, model.edge(e).t0, 0.1);
    EXPECT_TRUE(face_partners(model, model_edge(e), model.edge_point(e, t), model.edge_derivative(e, t), 0.3)
                    .empty());
  }
}

}  // namespace
}  // namespace octet
