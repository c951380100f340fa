// SPDX-License-Identifier: BSD-3-Clause
// Lengths, areas, volumes and tolerances of the entities, as they are and not as the file states them.
#include "geom/occt/measure.h"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "base/error.h"
#include "geom/occt/canonical.h"
#include "geom/occt/integrals.h"

namespace octet {
namespace {

constexpr int kGapSamples = 24;       // of closed forms
constexpr int kFreeGapSamples = 100;  // where the gap may swing with the knots
/// Measured gaps are maxima over samples; the true one is a little larger.
constexpr double kGapShare = 1.2;
/// Of the part's diagonal: an edge that is farther off its faces or vertices, and farther than half its
/// length (a circle whose two curves start at opposite places is off by a third), is misplaced.
constexpr double kMisplacedShare = 0.05;

/// Where coordinates are no finer than 1e-4 mm no part can be told from its neighbourhood.
constexpr double kFarthest = 1e12;  // mm

void refuse_far(const Vec3& point, ModelRef entity, const char* kind) {
  if ((point.array().abs() < kFarthest).all()) return;
  throw ModelError(
      fmt::format("{} {} lies at ({:.6g}, {:.6g}, {:.6g}) mm, where coordinates hold no lengths of "
                  "a part any more",
                  kind, entity.tag, point.x(), point.y(), point.z()),
      entity);
}

/// Of the vertices and edges; fails where one lies beyond kFarthest or nowhere.
double diagonal_of_parts(const ModelParts& parts) {
  Box3 box;
  const auto add = [&box](const Vec3& point, ModelRef entity, const char* kind) {
    refuse_far(point, entity, kind);
    box.add(point);
  };
  for (std::size_t v = 1; v < parts.vertices.size(); ++v)
    add(parts.vertices[v].point, model_vertex(static_cast<int>(v)), "Vertex");
  for (std::size_t e = 1; e < parts.edges.size(); ++e)
    for (const Vec3& point : edge_samples(parts, e)) add(point, model_edge(static_cast<int>(e)), "Edge");
  return box.diagonal();
}

/// Largest distance, at equal parameter, of the curve and the boundary of `face` along one pcurve of `edge`.
double gap_on_face(const TopoDS_Edge& edge, const TopoDS_Face& face, const Surface& surface,
                   const Curve& curve, const ModelEdge& range) {
  double a = 0.0, b = 0.0;
  const auto pcurve = BRep_Tool::CurveOnSurface(edge, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), a, b);
  if (pcurve.IsNull()) return 0.0;
  const bool closed_form =
      std::string_view(surface.kind()) == "plane" && std::string_view(curve.kind()) == "line";
  const int samples = closed_form ? kGapSamples : kFreeGapSamples;
  const auto to_ours = from_occt_uv(surface);
  double gap = 0.0;
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const gp_Pnt2d uv = pcurve->Value(a + share * (b - a));
    const Vec3 on_face = surface.evaluate(to_ours({uv.X(), uv.Y()}), 0).p;
    gap = std::max(gap, (on_face - curve.point(range.t0 + share * (range.t1 - range.t0))).norm());
  }
  return gap;
}

double edge_gap(const Numbering& numbering, int tag, std::span<const int> faces, const ModelParts& parts) {
  const ModelEdge& edge = parts.edges[tag];
  double gap = 0.0;
  const auto gap_along = [&](int face, TopAbs_Orientation way) {
    return gap_on_face(TopoDS::Edge(numbering.edge(tag).Oriented(way)), numbering.face(face),
                       *parts.surfaces[face], *parts.curves[tag], edge);
  };
  for (const int face : faces) {
    gap = std::max(gap, gap_along(face, TopAbs_FORWARD));
    // Where the face does not close on itself there both ways have the same curve.
    if (BRep_Tool::IsClosed(numbering.edge(tag), numbering.face(face)))
      gap = std::max(gap, gap_along(face, TopAbs_REVERSED));
  }
  return gap;
}

void measure_edges(const Numbering& numbering, double floor, ModelParts& parts) {
  int worse = 0, first = 0;
  for (int tag = 1; tag <= numbering.count(1); ++tag) {
    ModelEdge& edge = parts.edges[tag];
    edge.tolerance = floor;
    if (edge.use == EdgeUse::kDegenerate) continue;
    const double gap = edge_gap(numbering, tag, edge.faces, parts);
    edge.tolerance = std::max(floor, kGapShare * gap);
    BRepAdaptor_Curve adaptor(numbering.edge(tag));
    edge.length = GCPnts_AbscissaPoint::Length(adaptor, edge.t0, edge.t1, 1e-9 * (1.0 + floor));
    if (gap > 1.01 * BRep_Tool::Tolerance(numbering.edge(tag)) && gap > floor && worse++ == 0) first = tag;
  }
  if (worse > 0)
    parts.notes.push_back(
        fmt::format("{} edge(s) lie farther from their faces than the file's tolerance says, the first is "
                    "Edge {} ({:.3g} mm)",
                    worse, first, parts.edges[first].tolerance / kGapShare));
}

/// An edge elsewhere than its faces say leaves no boundary to mesh.
void refuse_misplaced(const Numbering& numbering, int tag, double diagonal, const ModelParts& parts) {
  const ModelEdge& edge = parts.edges[tag];
  const double gap = edge.tolerance / kGapShare;
  if (edge.use == EdgeUse::kDegenerate || gap <= std::max(0.5 * edge.length, kMisplacedShare * diagonal))
    return;
  int worst = edge.faces.front();
  double widest = 0.0;
  for (const int face : edge.faces) {
    const double here = edge_gap(numbering, tag, {&face, 1}, parts);
    if (here <= widest) continue;
    widest = here;
    worst = face;
  }
  throw ModelError(fmt::format("Edge {} lies up to {:.3g} mm off Face {} and is {:.3g} mm long: its curve in "
                               "space and that on the face are of different places",
                               tag, gap, worst, edge.length),
                   model_edge(tag));
}

/// Loops are open where an edge ends far from its vertex.
void refuse_open_end(std::size_t tag, int vertex, const Vec3& end, double gap, double diagonal,
                     const ModelEdge& edge) {
  if (edge.use == EdgeUse::kDegenerate || gap <= std::max(0.5 * edge.length, kMisplacedShare * diagonal))
    return;
  throw ModelError(
      fmt::format("Edge {} ends at ({:.6g}, {:.6g}, {:.6g}), {:.3g} mm off Vertex {}, and is {:.3g} mm long: "
                  "the loops that it is in are open there",
                  tag, end.x(), end.y(), end.z(), gap, vertex, edge.length),
      model_edge(static_cast<int>(tag)));
}

void measure_vertices(double floor, double diagonal, ModelParts& parts) {
  for (std::size_t v = 1; v < parts.vertices.size(); ++v) parts.vertices[v].tolerance = floor;
  for (std::size_t e = 1; e < parts.edges.size(); ++e) {
    const ModelEdge& edge = parts.edges[e];
    if (!parts.curves[e]) continue;
    for (int end = 0; end < 2; ++end) {
      ModelVertex& vertex = parts.vertices[edge.vertex[end]];
      const Vec3 point = parts.curves[e]->point(end == 0 ? edge.t0 : edge.t1);
      const double gap = (point - vertex.point).norm();
      refuse_open_end(e, edge.vertex[end], point, gap, diagonal, edge);
      vertex.tolerance = std::max(vertex.tolerance, kGapShare * gap);
    }
  }
}

/// Areas, and volumes of the solids by the divergence theorem.
void integrate(const Numbering& numbering, ModelParts& parts) {
  Box3 box;
  for (const Vec3& node : parts.facets.nodes) box.add(node);
  std::vector<FaceIntegrals> integrals(parts.faces.size());
  for (int tag = 1; tag <= numbering.count(2); ++tag) {
    integrals[tag] = integrate_face(numbering.face(tag), *parts.surfaces[tag]);
    parts.faces[tag].area = integrals[tag].area;
    parts.faces[tag].tolerance = 16e-12 * box.diagonal();
  }
  for (int tag = 1; tag <= numbering.count(3); ++tag) {
    ModelRegion& region = parts.regions[tag];
    Vec3 middle = Vec3::Zero();
    for (const int face : region.faces)
      middle += integrals[face].origin / static_cast<double>(region.faces.size());
    for (const int face : region.faces) {
      if (parts.faces[face].region[0] == tag) region.volume += integrals[face].volume(middle);
      if (parts.faces[face].region[1] == tag) region.volume -= integrals[face].volume(middle);
    }
    if (!(region.volume > 0.0))
      throw ModelError(
          fmt::format("Solid {} has volume {:.6g}: its faces are turned inside out", tag, region.volume),
          model_region(tag));
  }
}

}  // namespace

void measure_gaps(const Numbering& numbering, ModelParts& parts) {
  const double diagonal = diagonal_of_parts(parts);
  // OCCT's own floor, but no more than rounding allows on a small part.
  const double floor = std::min(1e-7, 1e-8 * diagonal);
  measure_edges(numbering, floor, parts);
  for (int tag = 1; tag <= numbering.count(1); ++tag) refuse_misplaced(numbering, tag, diagonal, parts);
  measure_vertices(floor, diagonal, parts);
}

std::vector<Vec3> edge_samples(const ModelParts& parts, std::size_t edge) {
  std::vector<Vec3> samples;
  if (!parts.curves[edge]) return samples;
  const ModelEdge& e = parts.edges[edge];
  for (int i = 1; i < 8; ++i) samples.push_back(parts.curves[edge]->point(e.t0 + i / 8.0 * (e.t1 - e.t0)));
  return samples;
}

void measure_volumes(const Numbering& numbering, ModelParts& parts) { integrate(numbering, parts); }

}  // namespace octet
