// SPDX-License-Identifier: BSD-3-Clause
// Entities and their adjacency, from the B-rep.
#include "geom/occt/topology.h"

#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <numeric>
#include <set>

#include "base/error.h"
#include "base/sort_unique.h"
#include "geom/occt/canonical.h"
#include "geom/occt/face_trim.h"

namespace octet {
namespace {

/// Normals across a seam differ by more than this: a crease the mesh must follow (10 degrees).
constexpr double kCreaseCosine = 0.985;

void fill_vertices(const Numbering& numbering, ModelParts& parts) {
  for (int tag = 1; tag <= numbering.count(0); ++tag)
    parts.vertices[tag].point = to_vec(BRep_Tool::Pnt(numbering.vertex(tag)));
}

void fill_edges(const Numbering& numbering, ModelParts& parts) {
  for (int tag = 1; tag <= numbering.count(1); ++tag) {
    const TopoDS_Edge edge = TopoDS::Edge(numbering.edge(tag).Oriented(TopAbs_FORWARD));
    ModelEdge& out = parts.edges[tag];
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge, first, last);
    if (first.IsNull() || last.IsNull())
      throw ModelError(fmt::format("Edge {} has no end vertex", tag), model_edge(tag));
    out.vertex = {numbering.tag(0, first), numbering.tag(0, last)};
    BRep_Tool::Range(edge, out.t0, out.t1);
    if (BRep_Tool::Degenerated(edge)) {
      out.use = EdgeUse::kDegenerate;
      continue;
    }
    double t0 = 0.0, t1 = 0.0;
    if (BRep_Tool::Curve(edge, t0, t1).IsNull())
      throw ModelError(fmt::format("Edge {} has no curve", tag), model_edge(tag));
    if (!(t0 < t1))
      throw ModelError(fmt::format("Edge {} has an empty parameter range", tag), model_edge(tag));
    out.t0 = t0;
    out.t1 = t1;
    for (const int v : out.vertex) parts.vertices[v].edges.push_back(tag);
  }
  for (ModelVertex& vertex : parts.vertices) {
    sort_unique(vertex.edges);
  }
}

/// Whether the surface bends sharply where the face closes on itself along `edge`.
bool is_crease(const TopoDS_Edge& edge, const TopoDS_Face& face, const Surface& surface) {
  double a0 = 0.0, a1 = 0.0, b0 = 0.0, b1 = 0.0;
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  const auto left = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), forward, a0, a1);
  const auto right = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Oriented(TopAbs_REVERSED)), forward, b0, b1);
  if (left.IsNull() || right.IsNull()) return false;
  const auto to_ours = from_occt_uv(surface);
  // A little inside of the face: on a periodic spline a curve that runs a rounding beyond the period is at
  // its begin, where the normal is that of the other side.
  constexpr double kInside = 1e-6;
  for (const double share : {0.11, 0.37, 0.5, 0.71, 0.93}) {
    const gp_Pnt2d l = left->Value(a0 + share * (a1 - a0)), r = right->Value(b0 + share * (b1 - b0));
    const Vec2 a(l.X(), l.Y()), b(r.X(), r.Y()), in = kInside * (b - a);
    const Vec3 n = surface.normal(to_ours(a + in)), m = surface.normal(to_ours(b - in));
    if (n.norm() > 0.5 && m.norm() > 0.5 && n.dot(m) < kCreaseCosine) return true;
  }
  return false;
}

/// Connected pieces of a face's boundary: wires, joined where they share a vertex.
class BoundaryPieces {
 public:
  void add_wire(const std::vector<int>& vertices) {
    std::set<int> piece(vertices.begin(), vertices.end());
    for (auto it = pieces_.begin(); it != pieces_.end();) {
      const bool joined =
          std::any_of(vertices.begin(), vertices.end(), [&](int v) { return it->count(v) > 0; });
      if (!joined) {
        ++it;
        continue;
      }
      piece.insert(it->begin(), it->end());
      it = pieces_.erase(it);
    }
    pieces_.push_back(std::move(piece));
  }
  [[nodiscard]] int count() const { return static_cast<int>(pieces_.size()); }

 private:
  std::vector<std::set<int>> pieces_;
};

void add_boundary(const TopoDS_Edge& edge, int tag, ModelFace& out) {
  const TopAbs_Orientation way = edge.Orientation();
  if (way != TopAbs_REVERSED) out.boundary.push_back({tag, +1});
  if (way != TopAbs_FORWARD) out.boundary.push_back({tag, -1});
}

/// Cells of the closed face: vertices - edges + (1 - further boundary pieces), the face cut open along its
/// seams being a disc with holes. Edges without length are not counted: their vertex is.
int euler_characteristic(const ModelFace& face, const ModelParts& parts, int pieces) {
  std::set<int> edges;
  for (const FaceBoundary& side : face.boundary)
    if (parts.edges[side.edge].use != EdgeUse::kDegenerate) edges.insert(side.edge);
  return static_cast<int>(face.vertices.size()) - static_cast<int>(edges.size()) + 2 - pieces;
}

void fill_face(const Numbering& numbering, int tag, ModelParts& parts) {
  const TopoDS_Face& face = numbering.face(tag);
  ModelFace& out = parts.faces[tag];
  out.reversed = face.Orientation() == TopAbs_REVERSED;
  std::set<int> vertices;
  BoundaryPieces pieces;
  for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) {
    std::vector<int> on_wire;
    for (TopExp_Explorer it(wire.Current(), TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = numbering.tag(1, it.Current());
      add_boundary(TopoDS::Edge(it.Current()), edge, out);
      for (const int v : parts.edges[edge].vertex) on_wire.push_back(v);
    }
    if (on_wire.empty()) continue;
    vertices.insert(on_wire.begin(), on_wire.end());
    pieces.add_wire(on_wire);
  }
  for (TopoDS_Iterator it(face); it.More(); it.Next()) {
    if (it.Value().ShapeType() != TopAbs_VERTEX) continue;
    const int v = numbering.tag(0, it.Value());
    if (vertices.insert(v).second) pieces.add_wire({v});
  }
  if (vertices.empty()) throw ModelError(fmt::format("Face {} has no boundary edges", tag), model_face(tag));
  out.vertices.assign(vertices.begin(), vertices.end());
  out.euler = euler_characteristic(out, parts, pieces.count());
  std::set<int> edges;
  for (const FaceBoundary& side : out.boundary) edges.insert(side.edge);
  for (const int edge : edges) parts.edges[edge].faces.push_back(tag);
}

/// An edge that one face uses in both directions, and no other face, closes that face.
void mark_seams(const Numbering& numbering, ModelParts& parts) {
  for (int tag = 1; tag <= numbering.count(1); ++tag) {
    ModelEdge& edge = parts.edges[tag];
    if (edge.use == EdgeUse::kDegenerate || edge.faces.size() != 1) continue;
    const int face = edge.faces.front();
    if (!BRep_Tool::IsClosed(numbering.edge(tag), numbering.face(face))) continue;
    const auto& sides = parts.faces[face].boundary;
    const auto uses =
        std::count_if(sides.begin(), sides.end(), [&](const FaceBoundary& b) { return b.edge == tag; });
    if (uses < 2) continue;
    if (is_crease(numbering.edge(tag), numbering.face(face), *parts.surfaces[face])) continue;
    edge.use = EdgeUse::kSeam;
  }
}

void set_region(int tag, int side, int region, ModelFace& face) {
  int& old = face.region[static_cast<std::size_t>(side)];
  if (old != 0 && old != region)
    throw ModelError(
        fmt::format("Face {} bounds Solid {} and Solid {} on the same side: the solids overlap in a way that "
                    "fusing cannot part; --no-fuse meshes each by itself",
                    tag, old, region),
        model_face(tag));
  old = region;
}

void add_face_to_region(const Numbering& numbering, const TopoDS_Shape& face, int region, ModelParts& parts) {
  const int tag = numbering.tag(2, face);
  ModelFace& out = parts.faces[tag];
  const TopAbs_Orientation way = face.Orientation();
  const bool outward = way == numbering.face(tag).Orientation();
  const bool inside = way == TopAbs_INTERNAL || way == TopAbs_EXTERNAL;
  if (inside || outward) set_region(tag, 0, region, out);
  if (inside || !outward) set_region(tag, 1, region, out);
  parts.regions[region].faces.push_back(tag);
}

void fill_regions(const Numbering& numbering, ModelParts& parts) {
  for (int region = 1; region <= numbering.count(3); ++region) {
    for (TopExp_Explorer it(numbering.solid(region), TopAbs_FACE); it.More(); it.Next())
      add_face_to_region(numbering, it.Current(), region, parts);
    auto& faces = parts.regions[region].faces;
    sort_unique(faces);
  }
}

/// Whether the surface spans an area somewhere within the face's bounds.
bool has_extent(const TopoDS_Face& face, const Surface& surface) {
  constexpr int kPlaces = 3;
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const auto to_ours = from_occt_uv(surface);
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kPlaces; ++j) {
      const Vec2 uv = to_ours({u0 + (u1 - u0) * (i + 0.5) / kPlaces, v0 + (v1 - v0) * (j + 0.5) / kPlaces});
      const SurfaceJet jet = surface.evaluate(uv, 1);
      if (jet.du.cross(jet.dv).norm() > 0.0) return true;
    }
  return false;
}

/// The least weight of a rational surface over its largest; 1 for others.
double least_weight_share(const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Geom_BSplineSurface) spline =
      Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, place));
  if (spline.IsNull() || !(spline->IsURational() || spline->IsVRational())) return 1.0;
  const TColStd_Array2OfReal& weights = *spline->Weights();
  double least = weights(1, 1), largest = least;
  for (int i = weights.LowerRow(); i <= weights.UpperRow(); ++i)
    for (int j = weights.LowerCol(); j <= weights.UpperCol(); ++j) {
      least = std::min(least, weights(i, j));
      largest = std::max(largest, weights(i, j));
    }
  return least / largest;
}

}  // namespace

void make_geometry(const Numbering& numbering, ModelParts& parts) {
  parts.curves.resize(parts.edges.size());
  parts.surfaces.resize(parts.faces.size());
  parts.trims.resize(parts.faces.size());
  for (int tag = 1; tag <= numbering.count(1); ++tag)
    if (parts.edges[tag].use != EdgeUse::kDegenerate) parts.curves[tag] = make_curve(numbering.edge(tag));
  for (int tag = 1; tag <= numbering.count(2); ++tag) {
    parts.surfaces[tag] = make_surface(numbering.face(tag), tag);
    if (!has_extent(numbering.face(tag), *parts.surfaces[tag]))
      throw ModelError(
          fmt::format("Face {} has a surface without extent: a radius of it is zero, or no number", tag),
          model_face(tag));
    // Such a pole is met nowhere but at a point, where the surface is infinitely fast.
    constexpr double kLeastWeightShare = 1e-9;
    if (const double share = least_weight_share(numbering.face(tag)); share < kLeastWeightShare)
      throw ModelError(fmt::format("Face {} has a spline surface whose weights differ by a factor of {:.1g}: "
                                   "questions about it have no end",
                                   tag, 1.0 / share),
                       model_face(tag));
    parts.trims[tag] = make_trim(numbering.face(tag), *parts.surfaces[tag]);
  }
}

void fill_topology(const Numbering& numbering, ModelParts& parts) {
  const auto size = [&](int dim) { return static_cast<std::size_t>(numbering.count(dim)) + 1; };
  parts.vertices.resize(size(0));
  parts.edges.resize(size(1));
  parts.faces.resize(size(2));
  parts.regions.resize(size(3));
  fill_vertices(numbering, parts);
  fill_edges(numbering, parts);
  make_geometry(numbering, parts);
  for (int tag = 1; tag <= numbering.count(2); ++tag) fill_face(numbering, tag, parts);
  mark_seams(numbering, parts);
  fill_regions(numbering, parts);
}

}  // namespace octet
