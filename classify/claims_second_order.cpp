// SPDX-License-Identifier: BSD-3-Clause
// Claims about elements of second order. What is asked of a node does not follow how it was put there.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "base/blocks.h"
#include "base/check.h"
#include "classify/claims.h"
#include "mesh/edges.h"
#include "mesh/quadratic.h"

namespace octet {
namespace {

using Index = Mesh::Index;

/// Nodes asked of the CAD by one task.
constexpr std::size_t kNodes = 256;
/// Of the largest value: what the bound of a determinant may be below its least value.
constexpr double kBoundShare = 1e-3;
/// Rounding of a distance.
constexpr double kRounding = 1e-9;

/// Whether elements and nodes agree on which is between which.
class Betweenness {
 public:
  Betweenness(const Mesh& mesh, ClaimBuilder& claim)
      : mesh_(mesh), claim_(claim), expected_(mesh.mid.points.size()) {}

  void ask() {
    const MidNodes& mid = mesh_.mid;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      for (std::size_t e = 0; e < 6; ++e)
        use(mid.of_tets[t][e], tet_edge(mesh_, t, e), model_region(mesh_.tet_in[t]));
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        use(mid.of_triangles[t][k], edge_ends(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]),
            model_face(mesh_.triangle_on[t]));
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e)
      use(mid.of_edges[e], edge_ends(mesh_.edges[e][0], mesh_.edges[e][1]), model_edge(mesh_.edge_on[e]));
    for (Index m = 0; m < expected_.size(); ++m) {
      if (!expected_[m].valid())
        tell(m, "is in no element");
      else if (expected_[m] != mid.on[m])
        tell(m, "is not on the model entity that holds its edge");
    }
    ask_for_twins();
  }

 private:
  /// Elements of less dimension come later, so the last one's entity stays.
  void use(Index m, const EdgeEnds& ends, ModelRef on) {
    if (m >= expected_.size()) {
      claim_.fault(2.0, on, middle_of(mesh_, ends), "an edge has no node in its middle", kBadMesh);
      return;
    }
    if (mesh_.mid.between[m] != ends) tell(m, "is in the middle of two edges");
    expected_[m] = on;
  }
  void ask_for_twins() {
    std::vector<Index> order(mesh_.mid.between.size());
    std::iota(order.begin(), order.end(), Index{0});
    const auto& between = mesh_.mid.between;
    if (!std::is_sorted(between.begin(), between.end()))
      std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return between[a] < between[b]; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (between[order[i]] == between[order[i - 1]])
        tell(order[i], "is the second in the middle of its edge");
  }
  void tell(Index m, const char* what) {
    claim_.fault(1.0, mesh_.mid.on[m], mesh_.mid.points[m],
                 fmt::format("node {} {}", mesh_.points.size() + m + 1, what), kBadMesh);
  }

  const Mesh& mesh_;
  ClaimBuilder& claim_;
  std::vector<ModelRef> expected_;
};

double distance_from(const Model& model, ModelRef on, const Vec3& p) {
  if (on.dim == 1) {
    const bool has_length = model.edge(on.tag).use != EdgeUse::kDegenerate;
    return has_length ? model.edge_closest(on.tag, p).distance : 0.0;
  }
  const FaceFoot foot = model.face_project(on.tag, p);
  return foot.converged ? (foot.point - p).norm() : model.face_closest(on.tag, p).distance;
}

struct NodeOff {
  Index node = 0;
  double distance = 0.0, straight = 0.0;  ///< of the node, and of the middle of the straight edge
};

/// Nodes that are farther from their entity than the straight edge's middle is.
std::vector<NodeOff> nodes_off(const Mesh& mesh, const Model& model) {
  const MidNodes& mid = mesh.mid;
  return collect<NodeOff>(
      mid.points.size(),
      [&](std::size_t m, std::vector<NodeOff>& off) {
        const ModelRef on = mid.on[m];
        if (on.dim != 1 && on.dim != 2) return;
        const double distance = distance_from(model, on, mid.points[m]);
        if (distance <= allowed_distance(model, on)) return;
        const double straight = distance_from(model, on, middle_of(mesh, mid.between[m]));
        if (distance > straight * (1.0 + kRounding))
          off.push_back({static_cast<Index>(m), distance, straight});
      },
      kNodes);
}

/// Tells the first element of a kind that has no nodes in the middles of its edges; false where there is one.
template <class Elements, class Mids>
bool all_have(ClaimBuilder& claim, const Mesh& mesh, const Elements& elements,
              const std::vector<std::int32_t>& on, int dim, const Mids& mids) {
  if (mids.size() == elements.size()) return true;
  const std::size_t first = mids.size();
  OCTET_CHECK(first < elements.size());
  claim.fault(
      2.0, {dim, on[first]}, mesh.points[elements[first][0]],
      fmt::format("of {} elements of dimension {} {} are of second order", elements.size(), dim, first),
      kBadMesh);
  return false;
}

bool numbers_hold(ClaimBuilder& claim, const Mesh& mesh) {
  const MidNodes& mid = mesh.mid;
  OCTET_CHECK(mid.on.size() == mid.points.size() && mid.between.size() == mid.points.size());
  const bool edges = all_have(claim, mesh, mesh.edges, mesh.edge_on, 1, mid.of_edges);
  const bool triangles = all_have(claim, mesh, mesh.triangles, mesh.triangle_on, 2, mid.of_triangles);
  const bool tets = all_have(claim, mesh, mesh.tets, mesh.tet_in, 3, mid.of_tets);
  return edges && triangles && tets;
}

}  // namespace

Claim claim_mid_nodes(const Mesh& mesh, const Model& model) {
  ClaimBuilder claim("mid-nodes",
                     "Every edge has one node of second order in its middle, on the edge's model entity or "
                     "between that and the straight edge.");
  if (!numbers_hold(claim, mesh)) return claim.counted();
  Betweenness(mesh, claim).ask();
  if (claim.count() > 0) return claim.counted();
  for (const NodeOff& off : nodes_off(mesh, model))
    claim.fault(off.distance, mesh.mid.on[off.node], mesh.mid.points[off.node],
                fmt::format("the node in the middle of an edge is {:.3g} mm off, that of the straight edge "
                            "would be {:.3g} mm off",
                            off.distance, off.straight),
                kBadMesh);
  return claim.counted();
}

Claim claim_curved_elements(const Mesh& mesh) {
  ClaimBuilder claim(
      "curved-elements",
      "No element of second order is turned over anywhere: the determinant of its Jacobian has "
      "a bound above nought.");
  struct TurnedOver {
    Index tet = 0;
    double share = 0.0;
  };
  const auto over = collect<TurnedOver>(
      mesh.tets.size(),
      [&](std::size_t t, std::vector<TurnedOver>& list) {
        if (has_straight_edges(mesh, t)) return;  // as good as its corners, of which other claims speak
        const JacobianForm form = jacobian_form(quadratic_tet(mesh, t));
        if (form.least() > 0.0) return;
        const double largest = form.largest();
        const double least = largest > 0.0 ? least_jacobian(form, kBoundShare * largest) : form.least();
        if (!(least > 0.0)) list.push_back({static_cast<Index>(t), largest > 0.0 ? least / largest : -1.0});
      },
      kNodes);
  for (const TurnedOver& element : over) {
    const auto& tet = mesh.tets[element.tet];
    const Vec3 place =
        0.25 * (mesh.points[tet[0]] + mesh.points[tet[1]] + mesh.points[tet[2]] + mesh.points[tet[3]]);
    claim.fault(-element.share, model_region(mesh.tet_in[element.tet]), place,
                fmt::format("element {} is turned over: its determinant falls to {:.3g} of its largest",
                            element.tet + 1, element.share),
                kFiner);
  }
  return claim.counted();
}

}  // namespace octet
