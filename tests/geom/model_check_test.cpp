// SPDX-License-Identifier: BSD-3-Clause
// The model's invariants, and that a broken one is told.
#include "geom/model_check.h"

#include <gtest/gtest.h>

#include "geom/conics.h"
#include "geom/parts_builder.h"
#include "geom/quadrics.h"
#include "geom/uv_trims.h"
#include "tests/geom/sample_models.h"

namespace octet {
namespace {

/// A triangular pyramid of unit legs whose parts may be spoilt before they become a model.
ModelParts pyramid() {
  PartsBuilder builder;
  builder.add_region(1.0 / 6.0);
  const std::array<Vec3, 4> p{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  std::array<int, 4> v{};
  for (int i = 0; i < 4; ++i) v[i] = builder.add_vertex(p[i]);
  int edge[4][4] = {};
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      edge[i][j] = builder.add_edge(make_line(p[i], p[j] - p[i], 0.0, 1.0), {v[i], v[j]}, 0.0, 1.0, 1);
  const int corners[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& c : corners) {
    Axes3 axes;
    axes.origin = p[c[0]];
    axes.x = (p[c[1]] - p[c[0]]).normalized();
    axes.z = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).normalized();
    axes.y = axes.z.cross(axes.x);
    ModelFace face;
    face.region = {1, 0};
    std::vector<Vec2> uv;
    for (int k = 0; k < 3; ++k) {
      const int a = c[k], b = c[(k + 1) % 3];
      face.boundary.push_back({edge[std::min(a, b)][std::max(a, b)], a < b ? 1 : -1});
      uv.push_back(axes.to_local(p[a]).head<2>());
    }
    const int tag = builder.add_face(make_plane(axes), make_polygon_trim(uv, 1e-12), face);
    builder.add_triangle(
        tag, {builder.vertex_node(v[c[0]]), builder.vertex_node(v[c[1]]), builder.vertex_node(v[c[2]])},
        {uv[0], uv[1], uv[2]});
  }
  return builder.finish();
}

TEST(ModelCheck, AnalyticModelsHoldTheirInvariants) {
  for (const Frame& frame : {Frame{}, test::tilted_frame()}) {
    for (const auto& s : test::all_samples(frame)) EXPECT_EQ(check_model(s.model), "") << s.name;
    EXPECT_EQ(check_model(analytic_two_boxes(Vec3(1, 2, 3), {frame, 1e-2})), "");
  }
  EXPECT_EQ(check_model(Model(pyramid())), "");
}

TEST(ModelCheck, FacesWithoutFacetsAreTold) {
  ModelParts parts = pyramid();
  parts.facets.triangles.clear();
  parts.facets.uv.clear();
  parts.facets.face.clear();
  EXPECT_NE(check_model(Model(std::move(parts))).find("it has no facets"), std::string::npos);
}

TEST(ModelCheck, OpenFacetsAreTold) {
  ModelParts parts = pyramid();
  Facets& facets = parts.facets;
  // Two of three pieces of the last facet.
  const auto [a, b, c] = facets.triangles.back();
  const std::array<Vec2, 3> uv = facets.uv.back();
  const Vec2 middle = (uv[0] + uv[1] + uv[2]) / 3.0;
  const auto m = static_cast<std::uint32_t>(facets.nodes.size());
  facets.nodes.push_back((facets.nodes[a] + facets.nodes[b] + facets.nodes[c]) / 3.0);
  facets.triangles.back() = {a, b, m};
  facets.uv.back() = {uv[0], uv[1], middle};
  facets.triangles.push_back({b, c, m});
  facets.uv.push_back({uv[1], uv[2], middle});
  facets.face.push_back(facets.face.back());
  EXPECT_EQ(check_model(Model(std::move(parts))), "Region 1: its facets are not closed");
}

TEST(ModelCheck, TurnedFacetsAreTold) {
  ModelParts parts = pyramid();
  std::swap(parts.facets.triangles[2][0], parts.facets.triangles[2][1]);
  EXPECT_EQ(check_model(Model(std::move(parts))), "Face 3: a facet is turned against the face");
}

TEST(ModelCheck, VerticesOffTheirEdgesAreTold) {
  ModelParts parts = pyramid();
  parts.vertices[2].point.x() += 0.1;
  EXPECT_EQ(check_model(Model(std::move(parts))), "Vertex 2 is off the end of Edge 1");
}

TEST(ModelCheck, OneSidedAdjacencyIsTold) {
  ModelParts parts = pyramid();
  parts.edges[1].faces.pop_back();
  EXPECT_NE(check_model(Model(std::move(parts))), "");
}

}  // namespace
}  // namespace octet
