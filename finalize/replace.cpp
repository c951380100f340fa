// SPDX-License-Identifier: BSD-3-Clause
// The door that operators use: `replace_cavity`, unless more flat tetrahedra would be left than may be.
#include "finalize/replace.h"

#include <algorithm>

#include "finalize/shape.h"

namespace octet {
namespace {

int more_flat(const WorkMesh& mesh, const CavityChange& change) {
  const auto added = std::count_if(change.added.begin(), change.added.end(), [&](const NewTet& tet) {
    const auto& v = tet.vertices;
    return FlatGuard::is_flat(
        shape(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]));
  });
  return static_cast<int>(added) - FlatGuard::count_flat(mesh, change.removed);
}

}  // namespace

bool replace(Workshop& shop, const CavityChange& change) {
  const int more = shop.flats.awake() ? more_flat(shop.mesh, change) : 0;
  if (!shop.flats.admits(more, shop.mesh.tets.size()) || !replace_cavity(shop.mesh, change, shop.made))
    return false;
  shop.flats.take(more);
  return true;
}

}  // namespace octet
