// SPDX-License-Identifier: BSD-3-Clause
// The list of claims, in the order in which a reader wants to know.
#include "classify/acceptance.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "classify/claims.h"

namespace octet {

std::vector<Fault> faults_of(const std::vector<Claim>& claims) {
  std::vector<Fault> faults;
  for (const Claim& claim : claims)
    if (!claim.holds) faults.insert(faults.end(), claim.faults.begin(), claim.faults.end());
  return faults;
}

bool Acceptance::holds() const {
  return !claims.empty() && std::all_of(claims.begin(), claims.end(), [](const Claim& c) { return c.holds; });
}

bool Acceptance::holds(std::string_view name) const {
  return std::all_of(claims.begin(), claims.end(), [&](const Claim& c) { return c.name != name || c.holds; });
}

std::optional<Farthest> Acceptance::farthest() const {
  std::optional<Farthest> all;
  for (const Claim& claim : claims)
    if (claim.farthest && (!all || claim.farthest->distance > all->distance)) all = claim.farthest;
  return all;
}

Acceptance accept_mesh(const Mesh& mesh, const Model& model, const AcceptanceOptions& options) {
  Acceptance result;
  result.claims.push_back(claim_numbers(mesh, model));
  if (!result.claims[0].holds) return result;  // nothing else can be asked
  const ClaimInput in(mesh, model);
  result.filled = in.sweep.filled;
  std::vector<Claim (*)(const ClaimInput&)> asked{
      claim_positive_volume,   claim_conforming,       claim_boundary_classified, claim_interfaces_classified,
      claim_regions_connected, claim_orphan_nodes,     claim_duplicate_nodes,     claim_closure,
      claim_upward_counts,     claim_model_vertices,   claim_edge_chains,         claim_face_euler,
      claim_face_borders,      claim_face_orientation, claim_nodes_on_entity,     claim_edge_length,
      claim_face_area,         claim_region_volume,    claim_volumes_add_up};
  if (options.overlap) asked.push_back(claim_no_overlap);
  if (options.sample_surface) asked.push_back(claim_surface_distance);
  result.claims.resize(1 + asked.size());
  tbb::parallel_for(std::size_t{0}, asked.size(),
                    [&](std::size_t i) { result.claims[i + 1] = asked[i](in); });
  for (Claim& claim : accept_second_order(mesh, model)) result.claims.push_back(std::move(claim));
  return result;
}

std::vector<Claim> accept_second_order(const Mesh& mesh, const Model& model) {
  if (mesh.mid.empty()) return {};
  std::vector<Claim> claims;
  claims.push_back(claim_mid_nodes(mesh, model));
  if (claims.back().holds) claims.push_back(claim_curved_elements(mesh));
  return claims;
}

}  // namespace octet
