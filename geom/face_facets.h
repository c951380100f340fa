// SPDX-License-Identifier: BSD-3-Clause
// Facets of one face between given points on its boundary.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geom/surface.h"

namespace octet {

/// Point and derivatives at (u,v), as Surface::evaluate().
using SurfaceJets = std::function<SurfaceJet(const Vec2& uv, int derivatives)>;

struct FacetLimits {
  double deflection = 0.0;          ///< length: how far the surface may be from a facet
  double angle = 0.6;               ///< radians between the normals at the ends of a side
  std::size_t max_points = 200000;  ///< inside one face; where it is reached the facets stay coarser
};

/// Boundary points in (u,v), and loops of indices into them with the face on the left.
struct FaceLoops {
  std::vector<Vec2> uv;
  std::vector<std::vector<std::uint32_t>> loops;
};

struct FaceFacets {
  std::vector<Vec2> uv;     ///< the boundary points as given, then those inside
  std::vector<Vec3> inner;  ///< points of the surface for uv[boundary size + i]
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Where max_points was reached: how far the surface is at most from the middle of a facet; else 0.
  double off = 0.0;
};

/// Every side of every loop is a side of one facet, in the loop's direction, and all others join two facets:
/// so facets of neighbouring faces close, also where loops cross themselves. Deviations are aimed at from
/// samples and not guaranteed. No triangles: no loop has the face on its left.
[[nodiscard]] FaceFacets facet_face(const SurfaceJets& surface, bool planar, const FaceLoops& loops,
                                    const FacetLimits& limits);

/// Pairs of sides (loop, index of the side's first corner) that cross in (u,v) and share no corner.
struct LoopCrossing {
  std::array<std::uint32_t, 2> loop, side;
};
[[nodiscard]] std::vector<LoopCrossing> loop_crossings(const FaceLoops& loops);

}  // namespace octet
