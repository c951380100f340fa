// SPDX-License-Identifier: BSD-3-Clause
// The tries one by one.
#include "app/held_boundary.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace octet {

const char* HeldBoundary::words() const {
  if (tries_ == kRooms) return "the boundary near to itself will keep to its faces";
  if (tries_ <= kAroundFaults) return "the boundary near to itself around them will be held";
  if (tries_ == kEverywhere) return "the boundary near to itself will be held";
  return tries_ == kAllAroundFaults ? "the boundary around them will be held"
                                    : "the whole boundary will be held";
}

void HeldBoundary::hold_more(std::span<const Vec3> places, bool crosses) {
  places_.insert(places_.end(), places.begin(), places.end());
  if (tries_ == kNone && !crosses) tries_ = kRooms;
  ++tries_;
}

bool HeldBoundary::hold_at_last(std::span<const Vec3> places) {
  if (tries_ == kAll) return false;
  places_.insert(places_.end(), places.begin(), places.end());
  tries_ = tries_ == kAllAroundFaults ? kAll : kAllAroundFaults;
  return true;
}

bool HeldBoundary::find(const Mesh& mesh, const Octree& tree) {
  if (!rooms_) rooms_.emplace(mesh, model_, tree);
  if (tries_ == kRooms) {
    if (!rooms_->empty()) return true;
    ++tries_;
  }
  const auto size_at = [&](const Vec3& p) { return tree.spacing_at(p); };
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

void HeldBoundary::find_anew(const Mesh& mesh, const Octree& tree) {
  rooms_.reset();
  spent_ = !find(mesh, tree);
}

}  // namespace octet
