// SPDX-License-Identifier: BSD-3-Clause
// Bounds by the mesh's own edges: a chord cuts no more off an arc of 180 degrees than half its length.
#include "app/same_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/words.h"
#include "base/error.h"

namespace octet {
namespace {

struct Extent {
  Box3 box;
  double volume = 0.0, longest_edge = 0.0, mean_edge = 0.0;
};

Extent extent_of(const Mesh& mesh) {
  Extent extent;
  for (const auto& tet : mesh.tets) {
    const auto p = [&](int i) -> const Vec3& { return mesh.points[tet[static_cast<std::size_t>(i)]]; };
    extent.volume += (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6.0;
    for (int i = 0; i < 4; ++i) {
      extent.box.add(p(i));
      for (int j = 0; j < i; ++j) {
        const double length = (p(i) - p(j)).norm();
        extent.longest_edge = std::max(extent.longest_edge, length);
        extent.mean_edge += length;
      }
    }
  }
  extent.mean_edge /= 6.0 * static_cast<double>(std::max<std::size_t>(mesh.tets.size(), 1));
  return extent;
}

}  // namespace

void require_mesh_of(const Mesh& mesh, const Model& model) {
  constexpr double kShare = 0.01;  // of the diagonal, and of the volume: what facets and healing may change
  const Extent extent = extent_of(mesh);
  const Box3& box = model.box();
  double volume = 0.0, area = 0.0;
  for (int r = 1; r <= model.count(3); ++r) volume += std::abs(model.region(r).volume);
  for (int f = 1; f <= model.count(2); ++f) area += model.face(f).area;
  const double off = std::max((extent.box.lo - box.lo).cwiseAbs().maxCoeff(),
                              (extent.box.hi - box.hi).cwiseAbs().maxCoeff());
  if (!(off <= kShare * model.diagonal() + 0.5 * extent.longest_edge))
    throw InputError(fmt::format(
        "the mesh is none of this part: it lies between {} and {}, the part between {} and {} mm; "
        "is the unit right?",
        place_text(extent.box.lo), place_text(extent.box.hi), place_text(box.lo), place_text(box.hi)));
  if (!(std::abs(extent.volume - volume) <= kShare * volume + 0.5 * extent.mean_edge * area))
    throw InputError(
        fmt::format("the mesh is none of this part: its volume is {:.6g} mm^3, that of the part {:.6g}",
                    extent.volume, volume));
}

}  // namespace octet
