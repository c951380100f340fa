// SPDX-License-Identifier: BSD-3-Clause
// The claim that the CAD surface is nowhere far from the mesh, tested at places spread over the surface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/blocks.h"
#include "classify/claims.h"

namespace octet {
namespace {

constexpr double kShare = 0.5;  // of the local mesh edge
// Facets much finer than the mesh tell nothing new: then only every so many are asked.
constexpr double kSamplesPerTriangle = 4.0;
constexpr int kMostSteps = 64;
/// Facets a task; few, for each may hold thousands of samples.
constexpr std::size_t kFacets = 16;

/// A sampling of one face: how many facets are passed over, and how finely the others are divided.
struct Density {
  std::size_t stride = 1;
  double step = 0.0;  ///< wanted distance of samples
};

double mean_side(const ClaimInput& in, const std::vector<std::uint32_t>& triangles) {
  double sum = 0.0;
  for (const std::uint32_t t : triangles) sum += in.longest_side(in.mesh.triangles[t]);
  return triangles.empty() ? 0.0 : sum / static_cast<double>(triangles.size());
}

class SurfaceSampler {
 public:
  explicit SurfaceSampler(const ClaimInput& in) : in_(in) {}

  /// Tells the claim what is too far; returns the worst share.
  double run(ClaimBuilder& claim) {
    const Facets& facets = in_.model.facets();
    std::vector<std::vector<std::uint32_t>> on(in_.triangles_on.size());
    for (std::uint32_t f = 0; f < facets.triangles.size(); ++f) on[facets.face[f]].push_back(f);
    double worst = 0.0;
    for (std::size_t face = 1; face < on.size(); ++face) {
      const auto& triangles = in_.triangles_on[face];
      if (triangles.empty()) continue;  // the claim face-euler tells
      const double asked = std::max(64.0, kSamplesPerTriangle * static_cast<double>(triangles.size()));
      const Density density{1 + static_cast<std::size_t>(static_cast<double>(on[face].size()) / asked),
                            0.7 * mean_side(in_, triangles)};
      const std::size_t asked_facets = (on[face].size() + density.stride - 1) / density.stride;
      const auto sample = [&](std::size_t first, std::size_t last) {
        Found found;
        for (std::size_t i = first; i < last; ++i)
          sample_facet(static_cast<int>(face), on[face][i * density.stride], density, found);
        return found;
      };
      for (const Found& found : map_blocks<Found>(asked_facets, kFacets, sample)) {
        worst = std::max(worst, found.worst);
        for (const FarPlace& far : found.far)
          claim.fault(far.share, model_face(static_cast<int>(face)), far.place,
                      fmt::format("the mesh is {:.3g} away from the face, {:.2g} of its edges there",
                                  far.distance, far.share),
                      kFiner);
      }
    }
    return worst;
  }

 private:
  struct FarPlace {
    double share = 0.0, distance = 0.0;
    Vec3 place;
  };
  struct Found {
    double worst = 0.0;
    std::vector<FarPlace> far;
  };

  /// Samples at the centroids of the facet's n x n division, on the exact surface and within the face.
  void sample_facet(int face, std::uint32_t f, const Density& density, Found& found) const {
    const Facets& facets = in_.model.facets();
    const auto& v = facets.triangles[f];
    const double longest = std::max({(facets.nodes[v[0]] - facets.nodes[v[1]]).norm(),
                                     (facets.nodes[v[1]] - facets.nodes[v[2]]).norm(),
                                     (facets.nodes[v[2]] - facets.nodes[v[0]]).norm()});
    const int n = std::clamp(static_cast<int>(std::ceil(longest / density.step)), 1, kMostSteps);
    const auto& uv = facets.uv[f];
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const double s = (i + 1.0 / 3.0) / n, t = (j + 1.0 / 3.0) / n;
        const Vec2 at = (1.0 - s - t) * uv[0] + s * uv[1] + t * uv[2];
        check(face, in_.model.face_jet(face, at, 0).p, found);
      }
  }

  void check(int face, const Vec3& p, Found& found) const {
    FarPlace far = distance_at(face, p);
    // Where a border bends the facets go beyond the face; on a strip, by more than its elements.
    if (far.share > kShare) far = distance_at(face, in_.model.face_closest(face, p).point);
    found.worst = std::max(found.worst, far.share);
    if (far.share > kShare) found.far.push_back(far);
  }

  [[nodiscard]] FarPlace distance_at(int face, const Vec3& p) const {
    const auto near = in_.surface.nearest(p, std::numeric_limits<double>::infinity(), face);
    if (!near) return {0.0, 0.0, p};
    return {near->distance / in_.longest_side(in_.mesh.triangles[near->triangle]), near->distance, p};
  }

  const ClaimInput& in_;
};

}  // namespace

Claim claim_surface_distance(const ClaimInput& in) {
  ClaimBuilder claim(
      "surface-distance",
      "No place of a CAD face is farther from its triangles than half their edges; worst: share.");
  const double worst = SurfaceSampler(in).run(claim);
  return claim.measured(worst, kShare);
}

}  // namespace octet
