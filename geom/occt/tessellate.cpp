// SPDX-License-Identifier: BSD-3-Clause
// A welded triangulation of the boundary.
#include "geom/occt/tessellate.h"

#include <fmt/format.h>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <map>
#include <optional>

#include "base/error.h"
#include "geom/occt/canonical.h"
#include "geom/occt/deviation.h"
#include "geom/occt/extents.h"
#include "geom/occt/measure.h"
#include "geom/occt/triangulate_boundary.h"

namespace octet {
namespace {

constexpr double kOwnDeflectionShare = 1.0 / 50.0;  // of the diagonal of the solids at the face
constexpr double kFacetTurn = 0.3;                  // radians between neighbouring facets
constexpr auto kNone = static_cast<std::uint32_t>(-1);

/// One face's OCCT triangulation, and its nodes' numbers in the welded set.
struct FaceMesh {
  Handle(Poly_Triangulation) triangulation;
  TopLoc_Location place;
  std::vector<std::uint32_t> node;  ///< by OCCT's node number, [0] unused

  [[nodiscard]] Vec3 point(int i) const { return to_vec(triangulation->Node(i).Transformed(place)); }
};

/// The solids without triangulations.
TopoDS_Compound clean(const Numbering& numbering) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (int tag = 1; tag <= numbering.count(3); ++tag) builder.Add(all, numbering.solid(tag));
  BRepTools::Clean(all);
  return all;
}

void run_mesher(const Numbering& numbering, double deflection) {
  const TopoDS_Compound all = clean(numbering);
  const BRepMesh_IncrementalMesh mesher(all, deflection, false, kFacetTurn, false);
}

class Welder {
 public:
  Welder(const Numbering& numbering, ModelParts& parts) : numbering_(numbering), parts_(parts) {
    Facets& facets = parts_.facets;
    for (std::size_t v = 1; v < parts.vertices.size(); ++v) facets.nodes.push_back(parts.vertices[v].point);
    chains_.resize(parts.edges.size());
    facets.deviation.assign(parts.faces.size(), 0.0);
    facets.edge_deviation.assign(parts.edges.size(), 0.0);
  }

  void add_face(int tag) {
    FaceMesh mesh;
    mesh.triangulation = BRep_Tool::Triangulation(numbering_.face(tag), mesh.place);
    if (mesh.triangulation.IsNull() || mesh.triangulation->NbTriangles() == 0 ||
        !mesh.triangulation->HasUVNodes())
      throw ModelError(fmt::format("Face {} cannot be triangulated: its loops are damaged", tag),
                       model_face(tag));
    mesh.node.assign(static_cast<std::size_t>(mesh.triangulation->NbNodes()) + 1, kNone);
    for (TopExp_Explorer it(numbering_.face(tag), TopAbs_EDGE); it.More(); it.Next())
      weld_edge(TopoDS::Edge(it.Current()), tag, mesh);
    for (std::size_t i = 1; i < mesh.node.size(); ++i)
      if (mesh.node[i] == kNone) mesh.node[i] = add_node(mesh.point(static_cast<int>(i)));
    add_triangles(tag, mesh);
  }

  [[nodiscard]] const std::vector<std::vector<double>>& chain_parameters() const { return parameters_; }

 private:
  std::uint32_t add_node(const Vec3& p) {
    parts_.facets.nodes.push_back(p);
    return static_cast<std::uint32_t>(parts_.facets.nodes.size() - 1);
  }

  void weld_edge(const TopoDS_Edge& edge, int face, FaceMesh& mesh) {
    const int tag = numbering_.tag(1, edge);
    // The two sides of a seam or a slit have a polygon each.
    for (const TopAbs_Orientation way : {TopAbs_FORWARD, TopAbs_REVERSED}) {
      const auto polygon =
          BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(edge.Oriented(way)), mesh.triangulation, mesh.place);
      if (polygon.IsNull())
        throw ModelError(fmt::format("Edge {} has no polygon on Face {}", tag, face), model_edge(tag));
      const int n = polygon->NbNodes();
      std::vector<std::uint32_t>& chain = chains_[tag];
      if (chain.empty()) make_chain(tag, *polygon, mesh, chain);
      if (static_cast<int>(chain.size()) != n)
        throw ModelError(
            fmt::format("Edge {} is divided differently on Face {} and its neighbour", tag, face),
            model_edge(tag));
      for (int k = 0; k < n; ++k) mesh.node[static_cast<std::size_t>(polygon->Node(k + 1))] = chain[k];
    }
  }

  /// End nodes are the vertices' own; those between lie on the 3D curve.
  void make_chain(int tag, const Poly_PolygonOnTriangulation& polygon, const FaceMesh& mesh,
                  std::vector<std::uint32_t>& chain) {
    const ModelEdge& edge = parts_.edges[tag];
    const int n = polygon.NbNodes();
    chain.push_back(static_cast<std::uint32_t>(edge.vertex[0] - 1));
    if (edge.use == EdgeUse::kDegenerate) {
      chain.resize(static_cast<std::size_t>(n), chain.front());
      return;
    }
    const bool has_parameters = polygon.HasParameters();
    std::vector<double>& parameters = parameters_of(tag);
    for (int k = 2; k < n; ++k) {
      const double t = has_parameters ? polygon.Parameter(k)
                                      : parts_.curves[tag]->project(mesh.point(polygon.Node(k)), edge.t0);
      parameters.push_back(t);
      chain.push_back(add_node(parts_.curves[tag]->point(t)));
    }
    chain.push_back(static_cast<std::uint32_t>(edge.vertex[1] - 1));
  }

  std::vector<double>& parameters_of(int tag) {
    if (parameters_.size() < parts_.edges.size()) parameters_.resize(parts_.edges.size());
    return parameters_[tag];
  }

  void add_triangles(int tag, const FaceMesh& mesh) {
    Facets& facets = parts_.facets;
    const bool reversed = parts_.faces[tag].reversed;
    const auto to_ours = from_occt_uv(*parts_.surfaces[tag]);
    for (int i = 1; i <= mesh.triangulation->NbTriangles(); ++i) {
      int corner[3];
      mesh.triangulation->Triangle(i).Get(corner[0], corner[1], corner[2]);
      if (reversed) std::swap(corner[1], corner[2]);
      std::array<std::uint32_t, 3> nodes;
      std::array<Vec2, 3> uv;
      for (int k = 0; k < 3; ++k) {
        nodes[k] = mesh.node[static_cast<std::size_t>(corner[k])];
        const gp_Pnt2d at = mesh.triangulation->UVNode(corner[k]);
        uv[k] = to_ours({at.X(), at.Y()});
      }
      // The edge along a pole has no length: its triangles are welded to nothing.
      if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) continue;
      facets.triangles.push_back(nodes);
      facets.uv.push_back(uv);
      facets.face.push_back(tag);
    }
  }

  const Numbering& numbering_;
  ModelParts& parts_;
  std::vector<std::vector<std::uint32_t>> chains_;
  std::vector<std::vector<double>> parameters_;
};

/// The facets of a closed region use each of their edges as often in one direction as in the other.
void require_closed(int region, const ModelParts& parts) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;  // signed count, a face
  const Facets& facets = parts.facets;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const ModelFace& face = parts.faces[facets.face[i]];
    const int sign = (face.region[0] == region ? 1 : 0) - (face.region[1] == region ? 1 : 0);
    if (sign == 0) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = facets.triangles[i][k], b = facets.triangles[i][(k + 1) % 3];
      auto& use = uses[std::minmax(a, b)];
      use.first += a < b ? sign : -sign;
      use.second = facets.face[i];
    }
  }
  for (const auto& [edge, use] : uses) {
    if (use.first == 0) continue;
    const Vec3 at = 0.5 * (facets.nodes[edge.first] + facets.nodes[edge.second]);
    throw ModelError(
        fmt::format(
            "the boundary of Solid {} is not closed: Face {} has a free side at ({:.6g}, {:.6g}, {:.6g})",
            region, use.second, at.x(), at.y(), at.z()),
        model_face(use.second));
  }
}

/// Welds the triangulations of the faces; throws where they leave a hole.
void weld(const Numbering& numbering, ModelParts& parts) {
  parts.facets = {};
  Welder welder(numbering, parts);
  for (int tag = 1; tag <= numbering.count(2); ++tag) welder.add_face(tag);
  for (int region = 1; region <= numbering.count(3); ++region) require_closed(region, parts);
  measure_deviation(welder.chain_parameters(), parts);
}

/// By face tag. What suits an assembly may be larger than a screw in it, whose holes would vanish; what is
/// asked for, larger than a ball, of which no facet would be left.
std::vector<double> deflections_of(const ModelParts& parts, const Extents& extents, double asked) {
  std::vector<double> deflections(parts.faces.size(),
                                  asked > 0.0 ? asked : kDeflectionShare * extents.diagonal());
  for (const ModelRegion& region : parts.regions) {
    const double own = extents.diagonal_of(region);
    if (!(own > 0.0)) continue;
    for (const int face : region.faces)
      deflections[face] = std::min(deflections[face], kOwnDeflectionShare * own);
  }
  return deflections;
}

/// No triangles come near a face whose edges lie elsewhere. All that is asked of such facets would be
/// answered by each of them, and wrongly.
void refuse_far_facets(const ModelParts& parts, const std::vector<double>& deflections, double diagonal) {
  constexpr double kFar = 0.05;     // of the part's diagonal
  constexpr double kBeyond = 20.0;  // times what was asked for
  const double far = kFar * diagonal;
  for (std::size_t f = 1; f < parts.faces.size(); ++f) {
    const double deviation = parts.facets.deviation[f];
    if (deviation <= std::max(far, kBeyond * deflections[f])) continue;
    throw ModelError(
        fmt::format("Face {} lies up to {:.3g} mm off all triangles between its edges: its edges in "
                    "space and those on it are of different places, or its loops are open",
                    f, deviation),
        model_face(static_cast<int>(f)));
  }
}

}  // namespace

void tessellate(const Numbering& numbering, double deflection, const StageLog& log, ModelParts& parts) {
  const Extents extents(parts);
  const std::vector<double> deflections = deflections_of(parts, extents, deflection);
  const double coarsest = *std::max_element(deflections.begin(), deflections.end());
  std::optional<ModelError> first;
  bool closes = false;
  const auto succeeds = [&](const auto& triangulate) {
    try {
      closes = false;
      triangulate();
      weld(numbering, parts);
      closes = true;
      refuse_far_facets(parts, deflections, extents.diagonal());
      return true;
    } catch (const ModelError& error) {
      if (!first) first = error;
      return false;
    }
  };
  const auto own = [&] {
    (void)clean(numbering);
    triangulate_boundary(numbering, parts, deflections, log);
  };
  if (succeeds(own)) return;
  // OCCT's mesher takes loops that are not closed; it now and then loses a face or a piece of one where loops
  // nearly touch, and another spacing of the nodes along the edges then often succeeds. It does not where
  // facets are closed and far off, and takes long.
  log(fmt::format("triangulating the faces with OCCT's mesher, since {},", first->what()));
  const std::vector<double> shares = closes ? std::vector{1.0} : std::vector{1.0, 0.4, 0.15, 2.3};
  for (const double share : shares)
    if (succeeds([&] { run_mesher(numbering, share * coarsest); })) return;
  throw ModelError(*first);
}

}  // namespace octet
