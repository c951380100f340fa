// SPDX-License-Identifier: BSD-3-Clause
// The claim that the CAD surface is nowhere far from the mesh, tested at places spread over the surface.
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

  struct Worst {
    double share = 0.0;
    Farthest farthest;
  };

  /// Tells the claim what is too far.
  Worst run(ClaimBuilder& claim) {
    const Facets& facets = in_.model.facets();
    std::vector<std::vector<std::uint32_t>> on(in_.triangles_on.size());
    for (std::uint32_t f = 0; f < facets.triangles.size(); ++f) on[facets.face[f]].push_back(f);
    Worst worst;
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
        worst.share = std::max(worst.share, found.share);
        if (found.farthest.distance > worst.farthest.distance)
          worst.farthest = {model_face(static_cast<int>(face)), found.farthest.place,
                            found.farthest.distance};
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
    double share = 0.0;  ///< the largest
    FarPlace farthest;
    std::vector<FarPlace> far;
  };

  /// Samples on the exact surface, in rows along the facet's longest side: slim facets, of which planes are
  /// full, need one row. A facet no larger than the step has one sample, its centroid.
  void sample_facet(int face, std::uint32_t f, const Density& density, Found& found) const {
    const std::array<Vec3, 3> corner = facet_corners(in_.model.facets(), f);
    const auto side = [&](int k) { return (corner[(k + 2) % 3] - corner[(k + 1) % 3]).norm(); };
    int apex = 0;
    for (int k = 1; k < 3; ++k)
      if (side(k) > side(apex)) apex = k;
    const double longest = side(apex);
    const double area = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
    const double height = longest > 0.0 ? area / longest : 0.0;
    const auto steps = [&](double length) {
      return std::clamp(static_cast<int>(std::ceil(length / density.step)), 1, kMostSteps);
    };
    const auto& uv = in_.model.facets().uv[f];
    const int rows = steps(height);
    for (int j = 0; j < rows; ++j) {
      const double up = (j + 1.0 / 3.0) / rows;
      const int columns = steps((1.0 - up) * longest);
      for (int i = 0; i < columns; ++i) {
        const double along = (i + 0.5) / columns;
        const Vec2 foot = (1.0 - along) * uv[(apex + 1) % 3] + along * uv[(apex + 2) % 3];
        check(face, in_.model.face_jet(face, up * uv[apex] + (1.0 - up) * foot, 0).p, found);
      }
    }
  }

  void check(int face, const Vec3& p, Found& found) const {
    FarPlace far = distance_at(face, p);
    // Where a border bends the facets go beyond the face; on a strip, by more than its elements.
    if (far.share > found.share || far.distance > found.farthest.distance)
      far = distance_at(face, in_.model.face_closest(face, p).point);
    found.share = std::max(found.share, far.share);
    if (far.distance > found.farthest.distance) found.farthest = far;
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
  const SurfaceSampler::Worst worst = SurfaceSampler(in).run(claim);
  Claim measured = claim.measured(worst.share, kShare);
  if (worst.farthest.entity.valid()) measured.farthest = worst.farthest;
  return measured;
}

}  // namespace octet
