// SPDX-License-Identifier: BSD-3-Clause
// The part: construction, topology and the queries of one entity.
#include "geom/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>

#include "base/check.h"
#include "base/constants.h"
#include "base/entity_words.h"
#include "geom/facet_trim.h"
#include "geom/model_data.h"

namespace octet {
namespace {

template <class T>
const T& tagged(const std::vector<T>& items, int tag) {
  OCTET_DCHECK(tag > 0 && static_cast<std::size_t>(tag) < items.size());
  return items[tag];
}

void check_parts(const ModelParts& parts) {
  OCTET_CHECK(!parts.vertices.empty() && !parts.edges.empty() && !parts.faces.empty() &&
              !parts.regions.empty());
  OCTET_CHECK(parts.curves.size() == parts.edges.size());
  OCTET_CHECK(parts.surfaces.size() == parts.faces.size() && parts.trims.size() == parts.faces.size());
  OCTET_CHECK(parts.facets.deviation.size() == parts.faces.size());
  OCTET_CHECK(parts.facets.edge_deviation.size() == parts.edges.size());
  OCTET_CHECK(parts.facets.face.size() == parts.facets.triangles.size());
  OCTET_CHECK(parts.facets.uv.size() == parts.facets.triangles.size());
}

/// One for each edge with a curve.
template <class OfCurve>
std::vector<OfCurve> of_curves(const ModelParts& parts) {
  std::vector<OfCurve> all(parts.edges.size());
  for (std::size_t e = 1; e < parts.edges.size(); ++e)
    if (parts.curves[e]) all[e] = OfCurve(*parts.curves[e], parts.edges[e].t0, parts.edges[e].t1);
  return all;
}

bool contains(const std::vector<int>& ascending, int tag) {
  return std::binary_search(ascending.begin(), ascending.end(), tag);
}

}  // namespace

Vec3 Model::Data::facet_normal(std::uint32_t triangle) const {
  const auto& t = parts.facets.triangles[triangle];
  const auto& nodes = parts.facets.nodes;
  const Vec3 n = (nodes[t[1]] - nodes[t[0]]).cross(nodes[t[2]] - nodes[t[0]]);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3::Zero();
}

Vec3 Model::Data::normal(int face, const Vec2& uv, std::uint32_t triangle) const {
  const Vec3 n = normal(face, uv);
  return n.squaredNorm() > 0.5 ? n : facet_normal(triangle);
}

const FacetFoot* Model::Data::nearest_against(std::span<const FacetFoot> near, const Vec3& normal) const {
  const FacetFoot* best = nullptr;
  for (const FacetFoot& f : near) {
    if (facet_normal(f.triangle).dot(normal) >= 0.0) continue;
    if (best == nullptr || std::tie(f.distance, f.triangle) < std::tie(best->distance, best->triangle))
      best = &f;
  }
  return best;
}

Vec2 Model::Data::seed_on_side(std::uint32_t triangle, int corner, const Vec3& x) const {
  const auto& nodes = parts.facets.triangles[triangle];
  const int from = (corner + 1) % 3, to = (corner + 2) % 3;
  const Vec3 &a = parts.facets.nodes[nodes[from]], side = parts.facets.nodes[nodes[to]] - a;
  const double squared = side.squaredNorm();
  Vec3 weights = Vec3::Zero();
  weights[to] = squared > 0.0 ? std::clamp((x - a).dot(side) / squared, 0.0, 1.0) : 0.5;
  weights[from] = 1.0 - weights[to];
  return seed(triangle, weights);
}

Vec3 Model::Data::normal_on_edge(int face, int edge, const Vec3& x) const {
  struct Side {
    double distance = kInfinity;
    std::uint32_t triangle = 0;
    int corner = 0;
  };
  Side best;
  bvh.visit_within(x, parts.facets.edge_deviation[edge] + edge_reach(edge), face, [&](const FacetFoot& f) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::int32_t s = border.of_triangle[f.triangle][corner];
      if (s < 0 || border.sides[s].edge != edge) continue;
      const double distance = chord_distance(*this, border.sides[s], x);
      if (std::tie(distance, f.triangle) < std::tie(best.distance, best.triangle))
        best = {distance, f.triangle, corner};
    }
  });
  Vec2 start;
  if (best.distance < kInfinity) {
    start = seed_on_side(best.triangle, best.corner, x);
  } else {
    const auto near = bvh.nearest(x, kInfinity, face);
    if (!near) return Vec3::Zero();
    best.triangle = near->triangle;
    start = seed(near->triangle, near->weights);
  }
  return normal(face, surface(face).project(x, start).uv, best.triangle);
}

Model::Model(ModelParts parts, const Model* twin) {
  check_parts(parts);
  auto data = std::make_unique<Data>();
  data->parts = std::move(parts);
  const ModelParts& p = data->parts;
  Box3 nodes;
  for (const Vec3& x : p.facets.nodes) nodes.add(x);
  data->tolerance = 16e-12 * nodes.diagonal();
  for (const auto& surface : p.surfaces)
    data->is_plane.push_back(surface && std::string_view(surface->kind()) == "plane");
  data->arcs = twin ? twin->data_->arcs : of_curves<ArcLength>(p);
  data->samples = of_curves<CurveSamples>(p);
  data->border = twin ? twin->data_->border : find_border_sides(p, data->samples, data->tolerance);
  const std::vector<double> grow = facet_growth(p, data->border, data->tolerance);
  data->bvh = FacetBvh(p.facets, grow, static_cast<int>(p.faces.size()) - 1);
  for (std::size_t i = 0; i < p.facets.triangles.size(); ++i) {
    Box3 box;
    for (const auto n : p.facets.triangles[i]) box.add(p.facets.nodes[n]);
    data->box.add(box.grown(p.facets.deviation[p.facets.face[i]]));
  }
  for (std::size_t v = 1; v < p.vertices.size(); ++v) data->box.add(p.vertices[v].point);
  data->diagonal = data->box.diagonal();
  data_ = std::move(data);
}

Model::Model(ModelParts parts) : Model(std::move(parts), nullptr) {}

Model Model::moved(ModelParts parts) const { return Model(std::move(parts), this); }

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

int Model::count(int dim) const {
  const ModelParts& p = data_->parts;
  const std::array<std::size_t, 4> sizes{p.vertices.size(), p.edges.size(), p.faces.size(), p.regions.size()};
  return static_cast<int>(sizes.at(dim)) - 1;
}

const ModelVertex& Model::vertex(int tag) const { return tagged(data_->parts.vertices, tag); }
const ModelEdge& Model::edge(int tag) const { return tagged(data_->parts.edges, tag); }
const ModelFace& Model::face(int tag) const { return tagged(data_->parts.faces, tag); }
const ModelRegion& Model::region(int tag) const { return tagged(data_->parts.regions, tag); }
const std::string& Model::unit() const { return data_->parts.unit; }
const std::vector<std::string>& Model::notes() const { return data_->parts.notes; }
const ModelParts& Model::parts() const { return data_->parts; }
const Provenance& Model::provenance() const { return data_->parts.provenance; }

bool Model::in_closure(ModelRef part, ModelRef whole) const {
  if (part == whole) return true;
  if (!part.valid() || !whole.valid() || part.dim >= whole.dim) return false;
  if (whole.dim == 1) return edge(whole.tag).vertex[0] == part.tag || edge(whole.tag).vertex[1] == part.tag;
  if (whole.dim == 2)
    return part.dim == 0 ? contains(face(whole.tag).vertices, part.tag)
                         : contains(edge(part.tag).faces, whole.tag);
  if (part.dim == 2) return face(part.tag).region[0] == whole.tag || face(part.tag).region[1] == whole.tag;
  if (part.dim == 1) {
    const auto& faces = edge(part.tag).faces;
    return std::any_of(faces.begin(), faces.end(), [&](int f) { return in_closure(model_face(f), whole); });
  }
  const auto& edges = vertex(part.tag).edges;
  if (std::any_of(edges.begin(), edges.end(), [&](int e) { return in_closure(model_edge(e), whole); }))
    return true;
  // A vertex within a face, where another solid touches it at a point, ends no edge of the region's.
  const auto& faces = region(whole.tag).faces;
  return std::any_of(faces.begin(), faces.end(), [&](int f) { return contains(face(f).vertices, part.tag); });
}

std::string Model::describe(ModelRef entity) const {
  if (entity == ModelRef{3, 0}) return "the outside";
  if (!entity.valid() || entity.dim > 3 || entity.tag > count(entity.dim)) return "no model entity";
  const std::array<const std::string*, 4> names{entity.dim == 0 ? &vertex(entity.tag).name : nullptr,
                                                entity.dim == 1 ? &edge(entity.tag).name : nullptr,
                                                entity.dim == 2 ? &face(entity.tag).name : nullptr,
                                                entity.dim == 3 ? &region(entity.tag).name : nullptr};
  const std::vector<int>& whole_tag = parts().whole_tag[static_cast<std::size_t>(entity.dim)];
  const int told = whole_tag.empty() ? entity.tag : whole_tag[static_cast<std::size_t>(entity.tag)];
  std::string text = std::string(entity_word(entity.dim)) + " " + std::to_string(told);
  const std::string& name = *names[entity.dim];
  if (!name.empty()) text += " \"" + name + "\"";
  return text;
}

const Box3& Model::box() const { return data_->box; }
double Model::diagonal() const { return data_->diagonal; }
double Model::tolerance() const { return data_->tolerance; }
bool Model::is_embedded(int face_tag) const {
  const auto& region = face(face_tag).region;
  return region[0] != 0 && region[0] == region[1];
}

bool Model::is_outside(int face_tag) const {
  const auto& region = face(face_tag).region;
  return region[0] == 0 && region[1] == 0;
}

double Model::tolerance_of(ModelRef entity) const {
  switch (entity.dim) {
    case 0:
      return vertex(entity.tag).tolerance;
    case 1:
      return edge(entity.tag).tolerance;
    case 2:
      return face(entity.tag).tolerance;
    default:
      return 0.0;
  }
}
const Facets& Model::facets() const { return data_->parts.facets; }
const FacetBvh& Model::bvh() const { return data_->bvh; }
const Surface& Model::surface(int face_tag) const { return *tagged(data_->parts.surfaces, face_tag); }
bool Model::is_plane(int face_tag) const { return data_->is_plane[static_cast<std::size_t>(face_tag)]; }
const Curve& Model::curve(int edge_tag) const { return *tagged(data_->parts.curves, edge_tag); }

// A degenerate edge has no curve: it is its vertex at every parameter.

Vec3 Model::edge_point(int tag, double t) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  return curve ? curve->point(t) : vertex(edge(tag).vertex[0]).point;
}

Vec3 Model::edge_derivative(int tag, double t) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  return curve ? curve->derivative(t) : Vec3::Zero();
}

double Model::edge_length(int tag, double t_from, double t_to) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  return curve ? data_->arcs[tag].length(*curve, t_from, t_to) : 0.0;
}

double Model::edge_parameter(int tag, double t_from, double s) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  return curve ? data_->arcs[tag].parameter(*curve, t_from, s) : t_from;
}

EdgeFoot Model::edge_project(int tag, const Vec3& p, double hint) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  EdgeFoot foot;
  foot.t = curve ? curve->project(p, hint) : edge(tag).t0;
  foot.point = edge_point(tag, foot.t);
  foot.distance = (p - foot.point).norm();
  return foot;
}

EdgeFoot Model::edge_closest(int tag, const Vec3& p) const {
  const auto& curve = tagged(data_->parts.curves, tag);
  if (!curve) return edge_project(tag, p, edge(tag).t0);
  const CurveFoot foot = data_->samples[tag].nearest(*curve, p);
  return {foot.t, foot.point, foot.distance};
}

SurfaceJet Model::face_jet(int tag, const Vec2& uv, int derivatives) const {
  return surface(tag).evaluate(uv, derivatives);
}

Vec3 Model::face_normal(int tag, const Vec2& uv) const {
  const Vec3 n = data_->normal(tag, uv);
  if (n.squaredNorm() > 0.5) return n;
  const auto near = data_->bvh.nearest(surface(tag).evaluate(uv, 0).p, kInfinity, tag);
  return near ? data_->facet_normal(near->triangle) : Vec3::Zero();
}

FaceFoot Model::face_project(int tag, const Vec3& p) const {
  if (is_plane(tag)) return face_project(tag, p, Vec2(0.0, 0.0));
  const auto near = data_->bvh.nearest(p, kInfinity, tag);
  if (!near) return face_project(tag, p, Vec2(0.0, 0.0));
  const FaceFoot foot = face_project(tag, p, data_->seed(near->triangle, near->weights));
  if ((foot.point - p).norm() <= data_->tolerance) return foot;
  std::vector<FacetFoot> candidates;
  data_->bvh.near(p, kInfinity, tag, candidates);
  const FacetFoot* start = data_->nearest_against(candidates, foot.normal);
  if (start == nullptr) return foot;
  const FaceFoot other = face_project(tag, p, data_->seed(start->triangle, start->weights));
  return other.converged && (other.point - p).squaredNorm() < (foot.point - p).squaredNorm() ? other : foot;
}

FaceFoot Model::face_project(int tag, const Vec3& p, const Vec2& seed) const {
  const SurfaceFoot foot = surface(tag).project(p, seed);
  return {foot.point, foot.uv, face_normal(tag, foot.uv), foot.converged};
}

TrimSide Model::face_side(int tag, const Vec2& uv) const { return tagged(data_->parts.trims, tag)->side(uv); }

double Model::face_curvature(int tag, const Vec2& uv) const {
  const SurfaceJet j = face_jet(tag, uv, 2);
  const Vec3 n = surface(tag).normal(uv);
  const double e = j.du.dot(j.du), f = j.du.dot(j.dv), g = j.dv.dot(j.dv);
  const double l = j.duu.dot(n), m = j.duv.dot(n), k = j.dvv.dot(n);
  if (!(e * g - f * f > 1e-24 * e * g) || e * g == 0.0) return 0.0;
  // The second form in an orthonormal basis of the tangent plane, du first: symmetric, so its larger
  // eigenvalue comes without cancellation.
  const double shear = f / e, height2 = g - f * shear;
  const double a = l / e, b = (m - shear * l) / std::sqrt(e * height2);
  const double c = (k - 2.0 * shear * m + shear * shear * l) / height2;
  const double curvature = 0.5 * std::abs(a + c) + std::hypot(0.5 * (a - c), b);
  // Beside a pole derivatives are so small that the rounding of their products with the normal is all there
  // is.
  constexpr double kRounding = 1e-12;
  const double noise =
      kRounding * (j.duu.norm() / e + j.duv.norm() / std::sqrt(e * height2) + j.dvv.norm() / height2);
  return curvature > noise ? curvature : 0.0;
}

bool Model::near_boundary(const Box3& box) const { return data_->bvh.meets(box); }

}  // namespace octet
