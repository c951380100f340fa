// SPDX-License-Identifier: BSD-3-Clause
// The claim that every real model edge is one chain of mesh edges from end to end.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "classify/claims.h"

namespace octet {
namespace {

using NextPiece = std::map<Mesh::Index, std::vector<std::uint32_t>>;  ///< pieces by their first vertex

Mesh::Index node_of_vertex(const ClaimInput& in, int tag, const std::vector<Mesh::Index>& nodes) {
  return tag > 0 && tag < static_cast<int>(nodes.size()) ? nodes[tag]
                                                         : static_cast<Mesh::Index>(in.mesh.points.size());
}

/// Mesh vertex per model vertex tag; the number of points where there is none.
std::vector<Mesh::Index> vertex_nodes(const ClaimInput& in) {
  std::vector<Mesh::Index> nodes(static_cast<std::size_t>(in.model.count(0)) + 1,
                                 static_cast<Mesh::Index>(in.mesh.points.size()));
  for (Mesh::Index v = 0; v < in.mesh.points.size(); ++v)
    if (in.mesh.point_on[v].dim == 0) nodes[in.mesh.point_on[v].tag] = v;
  return nodes;
}

/// The parameter of the chain's next vertex, behind `previous`. Where the curve meets itself the nearest
/// parameter may be that of the other branch: then the one near the previous is asked for.
double next_parameter(const ClaimInput& in, int tag, Mesh::Index v, double previous, double step) {
  const double t = in.node_foot[v].t;
  const ModelEdge& edge = in.model.edge(tag);
  if (t > previous) return t;
  const EdgeFoot near = in.model.edge_project(tag, in.point(v), std::min(previous + step, edge.t1));
  const bool there = near.distance <= in.allowed_distance(model_edge(tag));
  return there && near.t > previous ? near.t : t;
}

class ChainWalk {
 public:
  ChainWalk(const ClaimInput& in, ClaimBuilder& claim, int tag, const std::vector<Mesh::Index>& nodes)
      : in_(in), claim_(claim), tag_(tag), nodes_(nodes) {}

  void check() {
    const ModelEdge& edge = in_.model.edge(tag_);
    const auto& pieces = in_.pieces_on[tag_];
    // A seam may carry a chain, as other programs' meshes do, but none is asked for.
    if (edge.use == EdgeUse::kSeam && pieces.empty()) return;
    if (edge.use == EdgeUse::kDegenerate) {
      if (!pieces.empty())
        fault(in_.point(in_.mesh.edges[pieces[0]][0]), "an edge without length has mesh edges");
      return;
    }
    if (pieces.empty()) return fault(middle(edge), "no mesh edge lies on the edge");
    NextPiece next;
    for (const std::uint32_t e : pieces) next[in_.mesh.edges[e][0]].push_back(e);
    Mesh::Index start = node_of_vertex(in_, edge.vertex[0], nodes_);
    Mesh::Index end = node_of_vertex(in_, edge.vertex[1], nodes_);
    // A closed edge without a vertex begins anywhere.
    if (edge.vertex[0] == 0) start = end = in_.mesh.edges[pieces[0]][0];
    walk(next, start, end, edge);
  }

 private:
  [[nodiscard]] Vec3 middle(const ModelEdge& edge) const {
    return in_.model.edge_point(tag_, 0.5 * (edge.t0 + edge.t1));
  }
  void fault(const Vec3& place, std::string cause) {
    claim_.fault(1.0, model_edge(tag_), place, std::move(cause), kFiner);
  }
  void walk(const NextPiece& next, Mesh::Index start, Mesh::Index end, const ModelEdge& edge) {
    const std::size_t total = in_.pieces_on[tag_].size();
    if (start >= in_.mesh.points.size()) return fault(middle(edge), "the edge's first vertex is missing");
    const double step = (edge.t1 - edge.t0) / static_cast<double>(total);
    double t = edge.t0;
    Mesh::Index v = start;
    std::size_t walked = 0;
    do {
      const auto at = next.find(v);
      if (at == next.end())
        return fault(in_.point(v), "the chain of mesh edges breaks off or runs backwards");
      if (at->second.size() > 1) return fault(in_.point(v), "the chain of mesh edges forks");
      v = in_.mesh.edges[at->second[0]][1];
      ++walked;
      if (v == end) break;
      if (in_.mesh.point_on[v] != model_edge(tag_) && edge.vertex[0] != 0)
        return fault(in_.point(v), fmt::format("the chain runs through a vertex on {}",
                                               in_.model.describe(in_.mesh.point_on[v])));
      const double ahead = next_parameter(in_, tag_, v, t, step);
      if (edge.vertex[0] != 0 && ahead <= t) return fault(in_.point(v), "the chain of mesh edges turns back");
      t = ahead;
    } while (walked < total);
    if (v != end) return fault(in_.point(v), "the chain of mesh edges does not reach the edge's end");
    if (walked < total)
      fault(in_.point(start),
            fmt::format("{} mesh edges are not in the chain from end to end", total - walked));
  }

  const ClaimInput& in_;
  ClaimBuilder& claim_;
  int tag_;
  const std::vector<Mesh::Index>& nodes_;
};

}  // namespace

Claim claim_edge_chains(const ClaimInput& in) {
  ClaimBuilder claim(
      "edge-chains",
      "Every model edge is one chain of mesh edges along it, from end to end (seams: or none).");
  const auto nodes = vertex_nodes(in);
  for (int tag = 1; tag <= in.model.count(1); ++tag) ChainWalk(in, claim, tag, nodes).check();
  for (std::size_t i = 1; i < in.pieces.size(); ++i)
    if (in.pieces[i].v == in.pieces[i - 1].v)
      claim.fault(1.0, model_edge(in.mesh.edge_on[in.pieces[i].edge]), in.point(in.pieces[i].v[0]),
                  "a mesh edge is given twice", kBadMesh);
  return claim.counted();
}

}  // namespace octet
