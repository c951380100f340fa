// SPDX-License-Identifier: BSD-3-Clause
// Triangulations of all faces by our own means, in the place where OCCT's mesher leaves its own.
#include "geom/occt/triangulate_boundary.h"

#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "geom/facet_bvh.h"
#include "geom/occt/canonical.h"
#include "geom/occt/face_loops.h"

namespace octet {
namespace {

constexpr double kEdgeShare = 0.5;     // of the deflection, so that sides athwart are not too coarse either
constexpr double kChordTurn = 0.3;     // radians between the tangents at the ends of a chord
constexpr double kLeastTurning = 0.5;  // of the deflection on edges: shorter chords may turn
constexpr int kHalvings = 12;          // of a piece of an edge
constexpr std::size_t kMostPoints = 5000;    // of an edge
constexpr std::size_t kPolePoints = 17;      // of an edge without length
constexpr int kRounds = 10;                  // of dividing edges where loops cross
constexpr double kShortestChord = 1.0 / 64;  // of the deflection: what crosses below that is left so

class Chain {
 public:
  Chain(const Curve& curve, double deflection) : curve_(curve), deflection_(deflection) {}

  std::vector<double> run(const ModelEdge& edge, bool in_lens) {
    const bool line = std::string_view(curve_.kind()) == "line";
    const int pieces = edge.vertex[0] == edge.vertex[1] ? 4 : in_lens ? 2 : 1;
    parameters_ = {edge.t0};
    for (int i = 0; i < pieces; ++i) {
      const double a = edge.t0 + i * (edge.t1 - edge.t0) / pieces,
                   b = edge.t0 + (i + 1) * (edge.t1 - edge.t0) / pieces;
      if (!line) divide(a, b, kHalvings);
      parameters_.push_back(i + 1 == pieces ? edge.t1 : b);
    }
    return std::move(parameters_);
  }

 private:
  void divide(double a, double b, int depth) {
    if (depth == 0 || parameters_.size() >= kMostPoints || !too_coarse(a, b)) return;
    const double middle = 0.5 * (a + b);
    divide(a, middle, depth - 1);
    parameters_.push_back(middle);
    divide(middle, b, depth - 1);
  }

  [[nodiscard]] bool too_coarse(double a, double b) const {
    const Vec3 p = curve_.point(a), q = curve_.point(b);
    for (const double share : {0.5, 0.25, 0.75})
      if (closest_on_triangle(curve_.point(a + share * (b - a)), p, q, q).distance > deflection_) return true;
    if ((q - p).norm() <= kLeastTurning * deflection_) return false;
    const Vec3 s = curve_.derivative(a), t = curve_.derivative(b);
    return s.dot(t) < std::cos(kChordTurn) * s.norm() * t.norm();
  }

  const Curve& curve_;
  double deflection_;
  std::vector<double> parameters_;
};

std::vector<double> even_steps(double a, double b, std::size_t count) {
  std::vector<double> steps;
  for (std::size_t i = 0; i < count; ++i)
    steps.push_back(a + (b - a) * static_cast<double>(i) / static_cast<double>(count - 1));
  steps.back() = b;
  return steps;
}

/// Edges of faces with no more than two sides: with one chord each nothing would lie between them.
std::vector<bool> edges_of_lenses(const ModelParts& parts) {
  std::vector<bool> in_lens(parts.edges.size(), false);
  for (const ModelFace& face : parts.faces)
    if (face.boundary.size() <= 2)
      for (const FaceBoundary& side : face.boundary) in_lens[side.edge] = true;
  return in_lens;
}

/// The least deflection of an edge's faces.
double edge_deflection(int edge, const std::vector<double>& deflection, const ModelParts& parts) {
  double least = *std::max_element(deflection.begin(), deflection.end());
  for (const int face : parts.edges[edge].faces) least = std::min(least, deflection[face]);
  return least;
}

EdgeChains make_chains(const std::vector<double>& deflection, const ModelParts& parts) {
  EdgeChains chains(parts.edges.size());
  const std::vector<bool> in_lens = edges_of_lenses(parts);
  for (std::size_t e = 1; e < parts.edges.size(); ++e) {
    const double fine = kEdgeShare * edge_deflection(static_cast<int>(e), deflection, parts);
    chains[e] = parts.curves[e] ? Chain(*parts.curves[e], fine).run(parts.edges[e], in_lens[e])
                                : even_steps(parts.edges[e].t0, parts.edges[e].t1, kPolePoints);
  }
  return chains;
}

/// Edges that are instances of one, in several places, hang on one set of points.
void share_chains(const Numbering& numbering, EdgeChains& chains) {
  TopTools_DataMapOfShapeInteger first;
  for (int tag = 1; tag <= numbering.count(1); ++tag) {
    const TopoDS_Shape own = numbering.edge(tag).Located(TopLoc_Location());
    if (first.IsBound(own))
      chains[tag] = chains[first(own)];
    else
      first.Bind(own, tag);
  }
}

/// Divides chords until no two cross on a face and none leaves its edge on the face's surface, or they are as
/// short as tolerances.
class Untangler {
 public:
  Untangler(const Numbering& numbering, const std::vector<double>& deflection, const ModelParts& parts,
            EdgeChains& chains)
      : numbering_(numbering), deflection_(deflection), parts_(parts), chains_(chains) {}

  void run() {
    std::vector<int> faces;
    for (int tag = 1; tag <= numbering_.count(2); ++tag) faces.push_back(tag);
    for (int round = 0; round < kRounds && !faces.empty(); ++round) {
      std::set<std::pair<int, std::size_t>> chords;  // edge, index of the chord's first point
      for (const int face : faces) {
        const FacePolygons polygons = face_polygons(numbering_, face, chains_, parts_);
        find_crossings(polygons, chords);
        find_astray(face, polygons, chords);
      }
      faces = divide(chords);
      share_chains(numbering_, chains_);
    }
  }

 private:
  static void find_crossings(const FacePolygons& polygons, std::set<std::pair<int, std::size_t>>& chords) {
    const std::vector<LoopCrossing> crossings = loop_crossings(polygons.loops);
    if (crossings.empty()) return;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, std::size_t>> chord_of;
    for (const HalfEdgePoints& half : polygons.half_edges)
      for (std::size_t k = 0; k + 1 < half.points.size(); ++k)
        chord_of[std::minmax(half.points[k], half.points[k + 1])] = {half.edge, k};
    for (const LoopCrossing& crossing : crossings)
      for (int k = 0; k < 2; ++k) {
        const auto& loop = polygons.loops.loops[crossing.loop[k]];
        const std::uint32_t a = loop[crossing.side[k]], b = loop[(crossing.side[k] + 1) % loop.size()];
        chords.insert(chord_of.at(std::minmax(a, b)));
      }
  }

  /// A chord may follow its edge in space and yet bulge on the surface, where (u,v) bends it: the facets
  /// would cover what is not of the face, or leave some of it bare.
  void find_astray(int face, const FacePolygons& polygons,
                   std::set<std::pair<int, std::size_t>>& chords) const {
    const Surface& surface = *parts_.surfaces[face];
    if (std::string_view(surface.kind()) == "plane") return;
    const SurfaceJets jets = occt_jets(surface);
    for (const HalfEdgePoints& half : polygons.half_edges)
      for (std::size_t k = 0; k + 1 < half.points.size(); ++k) {
        const Vec2 &a = polygons.loops.uv[half.points[k]], &b = polygons.loops.uv[half.points[k + 1]];
        const Vec3 p = jets(a, 0).p, q = jets(b, 0).p;
        for (const double share : {0.5, 0.25, 0.75}) {
          const Vec3 x = jets((1.0 - share) * a + share * b, 0).p;
          if (closest_on_triangle(x, p, q, q).distance > deflection_[face]) chords.emplace(half.edge, k);
        }
      }
  }

  /// Returns the faces of the edges that were divided.
  std::vector<int> divide(const std::set<std::pair<int, std::size_t>>& chords) {
    std::set<int> faces;
    for (auto it = chords.rbegin(); it != chords.rend(); ++it) {
      const auto& [edge, index] = *it;
      std::vector<double>& chain = chains_[edge];
      const double a = chain[index], b = chain[index + 1];
      if (!parts_.curves[edge] || chain.size() >= kMostPoints) continue;
      const double shortest = kShortestChord * edge_deflection(edge, deflection_, parts_);
      if ((parts_.curves[edge]->point(b) - parts_.curves[edge]->point(a)).norm() < shortest) continue;
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(index) + 1, 0.5 * (a + b));
      faces.insert(parts_.edges[edge].faces.begin(), parts_.edges[edge].faces.end());
    }
    return {faces.begin(), faces.end()};
  }

  const Numbering& numbering_;
  const std::vector<double>& deflection_;
  const ModelParts& parts_;
  EdgeChains& chains_;
};

/// One face's triangulation as OCCT keeps it.
class FaceWriter {
 public:
  FaceWriter(const Numbering& numbering, const ModelParts& parts, int tag)
      : numbering_(numbering),
        parts_(parts),
        tag_(tag),
        face_(numbering.face(tag)),
        place_(face_.Location()) {}

  void write(const FacePolygons& polygons, const FaceFacets& made) {
    const int nodes = static_cast<int>(made.uv.size()), triangles = static_cast<int>(made.triangles.size());
    Handle(Poly_Triangulation) triangulation = new Poly_Triangulation(nodes, triangles, true);
    const SurfaceJets jets = occt_jets(*parts_.surfaces[tag_]);
    const gp_Trsf to_face = place_.Transformation().Inverted();
    const std::size_t given = polygons.loops.uv.size();
    for (std::size_t i = 0; i < made.uv.size(); ++i) {
      const Vec3 p = i < given ? jets(made.uv[i], 0).p : made.inner[i - given];
      const int number = static_cast<int>(i) + 1;
      triangulation->SetNode(number, gp_Pnt(p.x(), p.y(), p.z()).Transformed(to_face));
      triangulation->SetUVNode(number, gp_Pnt2d(made.uv[i].x(), made.uv[i].y()));
    }
    for (int i = 0; i < triangles; ++i) {
      const auto& [a, b, c] = made.triangles[static_cast<std::size_t>(i)];
      triangulation->SetTriangle(
          i + 1, Poly_Triangle(static_cast<int>(a) + 1, static_cast<int>(b) + 1, static_cast<int>(c) + 1));
    }
    const BRep_Builder builder;
    builder.UpdateFace(face_, triangulation);
    write_polygons(polygons, triangulation);
  }

 private:
  void write_polygons(const FacePolygons& polygons, const Handle(Poly_Triangulation) & triangulation) const {
    const BRep_Builder builder;
    std::map<int, std::vector<const HalfEdgePoints*>> of_edge;
    for (const HalfEdgePoints& half : polygons.half_edges) of_edge[half.edge].push_back(&half);
    for (const auto& [edge, halves] : of_edge) {
      const TopoDS_Edge shape = TopoDS::Edge(numbering_.edge(edge).Oriented(TopAbs_FORWARD));
      const auto forward = polygon(*halves.front());
      if (halves.size() == 1) {
        builder.UpdateEdge(shape, forward, triangulation, place_);
      } else {
        const bool in_order = halves[0]->forward;
        const auto other = polygon(*halves[1]);
        builder.UpdateEdge(shape, in_order ? forward : other, in_order ? other : forward, triangulation,
                           place_);
      }
    }
  }

  static Handle(Poly_PolygonOnTriangulation) polygon(const HalfEdgePoints& half) {
    const int n = static_cast<int>(half.points.size());
    TColStd_Array1OfInteger nodes(1, n);
    TColStd_Array1OfReal parameters(1, n);
    for (int k = 0; k < n; ++k) {
      nodes(k + 1) = static_cast<int>(half.points[static_cast<std::size_t>(k)]) + 1;
      parameters(k + 1) = half.parameters[static_cast<std::size_t>(k)];
    }
    return new Poly_PolygonOnTriangulation(nodes, parameters);
  }

  const Numbering& numbering_;
  const ModelParts& parts_;
  int tag_;
  TopoDS_Face face_;
  TopLoc_Location place_;
};

}  // namespace

void triangulate_boundary(const Numbering& numbering, const ModelParts& parts,
                          const std::vector<double>& deflection, const StageLog& log) {
  EdgeChains chains = make_chains(deflection, parts);
  share_chains(numbering, chains);
  Untangler(numbering, deflection, parts, chains).run();
  FacetLimits limits;
  TopTools_MapOfShape done;
  for (int tag = 1; tag <= numbering.count(2); ++tag) {
    // Instances of one face hang on one triangulation.
    if (!done.Add(numbering.face(tag).Located(TopLoc_Location()).Oriented(TopAbs_FORWARD))) continue;
    log(fmt::format("triangulating Face {}", tag));
    limits.deflection = deflection[tag];
    const FacePolygons polygons = face_polygons(numbering, tag, chains, parts);
    const Surface& surface = *parts.surfaces[tag];
    const FaceFacets made =
        facet_face(occt_jets(surface), std::string_view(surface.kind()) == "plane", polygons.loops, limits);
    const auto place = [&] {
      const Vec3 p = surface.evaluate(polygons.loops.uv.front(), 0).p;
      return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
    };
    if (made.triangles.empty())
      throw ModelError(
          fmt::format("Face {} at {} cannot be triangulated: nothing is inside its loops", tag, place()),
          model_face(tag));
    // Where the triangles fold, no number of points brings them near.
    constexpr double kMuch = 4.0;
    if (made.off > kMuch * limits.deflection)
      throw ModelError(
          fmt::format("Face {} at {} lies up to {:.3g} mm off its triangles, with {} points inside it", tag,
                      place(), made.off, made.inner.size()),
          model_face(tag));
    FaceWriter(numbering, parts, tag).write(polygons, made);
  }
}

}  // namespace octet
