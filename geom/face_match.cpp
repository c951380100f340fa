// SPDX-License-Identifier: BSD-3-Clause
// Feet of edge points on other faces, slid until the chord makes equal angles with the edge and the face.
#include "geom/face_match.h"

#include <algorithm>
#include <cmath>

#include "base/sort_unique.h"
#include "geom/facet_bvh.h"

namespace octet {
namespace {

/// An edge steeper than this against a face (the sine of 45 degrees) leaves it.
constexpr double kSteep = 0.7;
/// Nearer to a vertex than this share of the reach, partners keep their distance from the vertex.
constexpr double kNearVertex = 1.5;

/// Slides b along the face until (b - a) is perpendicular to the sum of the edge's direction and of that
/// direction's shadow on the face. The step is exact for a line and a plane.
bool mirror(const Model& model, const Vec3& a, const Vec3& along, FacePartner& b, Vec2 uv) {
  constexpr int kSteps = 24;  // linear convergence where the face is curved
  for (int i = 0; i < kSteps; ++i) {
    const double steep = along.dot(b.normal);
    if (std::abs(steep) > kSteep) return false;
    const Vec3 shadow = (along - steep * b.normal).normalized();
    const Vec3 sum = along + shadow;
    const double step = (b.point - a).dot(sum) / shadow.dot(sum);
    if (std::abs(step) < 1e-10 * (b.point - a).norm()) return true;
    const FaceFoot foot = model.face_project(b.face, b.point - step * shadow, uv);
    if (!foot.converged) return false;
    b.point = foot.point;
    b.normal = foot.normal;
    uv = foot.uv;
  }
  return true;
}

/// Slides b along the face to a's distance from a vertex that ends the edge and lies on the face: around a
/// vertex where sheets touch, points on one sphere see their neighbours in the same order on every sheet.
bool onto_shell(const Model& model, const Vec3& vertex, double radius, FacePartner& b, Vec2 uv) {
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 out = b.point - vertex;
    const double off = out.norm() - radius;
    if (std::abs(off) < 1e-12 * radius) return true;
    const FaceFoot foot = model.face_project(b.face, vertex + out * (radius / out.norm()), uv);
    if (!foot.converged) return false;
    b.point = foot.point;
    b.normal = foot.normal;
    uv = foot.uv;
  }
  return true;
}

/// The vertex that ends the edge nearer to a than `distance` and lies in the closure of the face, or 0.
int common_vertex(const Model& model, ModelRef edge, int face, const Vec3& a, double distance) {
  if (edge.dim != 1) return 0;
  for (const int v : model.edge(edge.tag).vertex)
    if ((model.vertex(v).point - a).norm() <= distance && model.in_closure(model_vertex(v), model_face(face)))
      return v;
  return 0;
}

}  // namespace

std::vector<FacePartner> face_partners(const Model& model, ModelRef on, const Vec3& a, const Vec3& tangent,
                                       double max_distance) {
  std::vector<int> faces;
  model.bvh().visit_within(a, max_distance, 0, [&](const FacetFoot& f) {
    const int face = model.facets().face[f.triangle];
    if (!model.in_closure(on, model_face(face))) faces.push_back(face);
  });
  sort_unique(faces);
  std::vector<FacePartner> partners;
  const bool is_edge = tangent.squaredNorm() > 0.0;
  for (const int face : faces) {
    const Foot foot = model.face_closest(face, a);
    if (foot.on.dim != 2 || foot.distance > max_distance || foot.distance <= model.tolerance()) continue;
    FacePartner b{face, foot.point, foot.normal};
    const int vertex = is_edge ? common_vertex(model, on, face, a, kNearVertex * max_distance) : 0;
    const Vec3 from = vertex != 0 ? model.vertex(vertex).point : a;
    const bool slid = !is_edge || (vertex != 0 ? onto_shell(model, from, (a - from).norm(), b, foot.uv)
                                               : mirror(model, a, tangent.normalized(), b, foot.uv));
    if (!slid || (b.point - foot.point).norm() > foot.distance) continue;
    if (model.face_closest(face, b.point).on.dim != 2) continue;
    partners.push_back(b);
  }
  return partners;
}

}  // namespace octet
