// SPDX-License-Identifier: BSD-3-Clause
// The tries one by one.
#include "app/held_boundary.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/narrow_gaps.h"

namespace octet {

const char* HeldBoundary::words() const {
  if (tries_ <= kAroundFaults) return "the boundary near to itself around them";
  if (tries_ == kEverywhere) return "the boundary near to itself";
  return tries_ == kAllAroundFaults ? "the boundary around them" : "the whole boundary";
}

void HeldBoundary::hold_more(std::span<const Vec3> places) {
  places_.insert(places_.end(), places.begin(), places.end());
  ++tries_;
}

bool HeldBoundary::hold_at_last(std::span<const Vec3> places) {
  if (tries_ == kAll) return false;
  places_.insert(places_.end(), places.begin(), places.end());
  tries_ = tries_ == kAllAroundFaults ? kAll : kAllAroundFaults;
  return true;
}

bool HeldBoundary::find(const Mesh& mesh, const SizeAt& size_at) {
  std::vector<Mesh::Index> found;
  if (tries_ == kAll) {
    found = boundary_vertices(mesh);
  } else {
    const bool everywhere = tries_ > kAroundFaults;
    found = vertices_at_gaps(mesh, model_, size_at,
                             everywhere ? std::span<const Vec3>{} : std::span<const Vec3>(places_));
  }
  if (tries_ == kAllAroundFaults) {
    const std::vector<Mesh::Index> near = boundary_vertices(mesh, size_at, places_);
    std::vector<Mesh::Index> both;
    std::set_union(found.begin(), found.end(), near.begin(), near.end(), std::back_inserter(both));
    found = std::move(both);
  }
  found.swap(vertices_);
  return found != vertices_;
}

}  // namespace octet
