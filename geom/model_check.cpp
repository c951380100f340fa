// SPDX-License-Identifier: BSD-3-Clause
// Tests the invariants that a Model states.
#include "geom/model_check.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace octet {
namespace {

bool holds(const std::vector<int>& tags, int tag) {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

bool ascending(const std::vector<int>& tags) {
  return std::adjacent_find(tags.begin(), tags.end(), [](int a, int b) { return a >= b; }) == tags.end();
}

std::string pair_text(const Model& model, ModelRef a, const char* relation, ModelRef b) {
  return model.describe(a) + " " + relation + " " + model.describe(b);
}

std::string check_vertices(const Model& model) {
  for (int v = 1; v <= model.count(0); ++v) {
    const ModelVertex& vertex = model.vertex(v);
    if (!ascending(vertex.edges)) return model.describe(model_vertex(v)) + ": edges are not ascending";
    for (const int e : vertex.edges)
      if (!model.in_closure(model_vertex(v), model_edge(e)))
        return pair_text(model, model_vertex(v), "lists but does not end", model_edge(e));
  }
  return {};
}

std::string check_edge_ends(const Model& model, int e) {
  const ModelEdge& edge = model.edge(e);
  for (int k = 0; k < 2; ++k) {
    const int v = edge.vertex[k];
    // A pole's own edge need not be listed by its vertex: nothing is meshed along it.
    if (edge.use != EdgeUse::kDegenerate && !holds(model.vertex(v).edges, e))
      return pair_text(model, model_edge(e), "is not listed by", model_vertex(v));
    const double gap = (model.edge_point(e, k == 0 ? edge.t0 : edge.t1) - model.vertex(v).point).norm();
    if (gap > model.vertex(v).tolerance + edge.tolerance + model.tolerance())
      return pair_text(model, model_vertex(v), "is off the end of", model_edge(e));
  }
  return {};
}

std::string check_edges(const Model& model) {
  for (int e = 1; e <= model.count(1); ++e) {
    const ModelEdge& edge = model.edge(e);
    if (!ascending(edge.faces)) return model.describe(model_edge(e)) + ": faces are not ascending";
    if (std::string fault = check_edge_ends(model, e); !fault.empty()) return fault;
    for (const int f : edge.faces) {
      const auto& boundary = model.face(f).boundary;
      if (std::none_of(boundary.begin(), boundary.end(), [&](const FaceBoundary& b) { return b.edge == e; }))
        return pair_text(model, model_edge(e), "is not in the boundary of", model_face(f));
      if (edge.use == EdgeUse::kDegenerate) continue;
      constexpr int kSamples = 5;
      for (int i = 0; i < kSamples; ++i) {
        const Vec3 p = model.edge_point(e, edge.t0 + (edge.t1 - edge.t0) * (i + 0.5) / kSamples);
        const double gap = (model.face_project(f, p).point - p).norm();
        // The stated tolerance was measured at samples too: half as much again lies between them.
        if (gap > 1.5 * edge.tolerance + model.face(f).tolerance + 4.0 * model.tolerance())
          return pair_text(model, model_edge(e), "is off", model_face(f));
      }
    }
  }
  return {};
}

std::string check_faces(const Model& model) {
  for (int f = 1; f <= model.count(2); ++f) {
    const ModelFace& face = model.face(f);
    if (!ascending(face.vertices)) return model.describe(model_face(f)) + ": vertices are not ascending";
    for (const FaceBoundary& b : face.boundary) {
      if (!holds(model.edge(b.edge).faces, f))
        return pair_text(model, model_face(f), "is not listed by", model_edge(b.edge));
      for (const int v : model.edge(b.edge).vertex)
        if (!holds(face.vertices, v))
          return pair_text(model, model_face(f), "does not list", model_vertex(v));
    }
    for (const int r : face.region)
      if (r > 0 && !holds(model.region(r).faces, f))
        return pair_text(model, model_face(f), "is not listed by", model_region(r));
  }
  for (int r = 1; r <= model.count(3); ++r)
    for (const int f : model.region(r).faces)
      if (!model.in_closure(model_face(f), model_region(r)))
        return pair_text(model, model_region(r), "lists but is not bounded by", model_face(f));
  return {};
}

/// A facet whose middle's normal turns more than 90 degrees from the face is turned the wrong way round;
/// slivers have no direction worth asking.
std::string check_facets(const Model& model) {
  const Facets& facets = model.facets();
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const auto& t = facets.triangles[i];
    const int f = facets.face[i];
    const Vec3 &a = facets.nodes[t[0]], &b = facets.nodes[t[1]], &c = facets.nodes[t[2]];
    const Vec2 seed = (facets.uv[i][0] + facets.uv[i][1] + facets.uv[i][2]) / 3.0;
    const Vec3 middle = (a + b + c) / 3.0;
    const FaceFoot foot = model.face_project(f, middle, seed);
    const double reach = facets.deviation[f] + model.face(f).tolerance + 4.0 * model.tolerance();
    if ((foot.point - middle).norm() > reach)
      return model.describe(model_face(f)) + ": a facet is farther from the face than its deviation";
    const Vec3 normal = (b - a).cross(c - a);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const bool sliver = normal.norm() < longest * (10.0 * reach);
    if (!sliver && normal.dot(foot.normal) < 0.0)
      return model.describe(model_face(f)) + ": a facet is turned against the face";
  }
  return {};
}

std::string check_no_face_is_bare(const Model& model) {
  std::vector<bool> has_facets(static_cast<std::size_t>(model.count(2)) + 1, false);
  for (const int f : model.facets().face) has_facets[static_cast<std::size_t>(f)] = true;
  for (int f = 1; f <= model.count(2); ++f)
    if (!has_facets[static_cast<std::size_t>(f)]) return model.describe(model_face(f)) + ": it has no facets";
  return {};
}

std::string check_closed(const Model& model) {
  struct Side {
    std::uint32_t a, b;
    int way;
  };
  const Facets& facets = model.facets();
  for (int r = 1; r <= model.count(3); ++r) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
      const auto& region = model.face(facets.face[i]).region;
      const int sign = (region[0] == r) - (region[1] == r);
      if (sign == 0) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = facets.triangles[i][k], b = facets.triangles[i][(k + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), a < b ? sign : -sign});
      }
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    for (std::size_t i = 0; i < sides.size();) {
      int sum = 0;
      const Side first = sides[i];
      for (; i < sides.size() && sides[i].a == first.a && sides[i].b == first.b; ++i) sum += sides[i].way;
      if (sum != 0) return model.describe(model_region(r)) + ": its facets are not closed";
    }
  }
  return {};
}

}  // namespace

std::string check_model(const Model& model) {
  for (const auto check :
       {check_vertices, check_edges, check_faces, check_facets, check_no_face_is_bare, check_closed})
    if (std::string fault = check(model); !fault.empty()) return fault;
  return {};
}

}  // namespace octet
