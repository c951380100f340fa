// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a surface that is no quadric or torus.
#pragma once

#include <Geom_OffsetSurface.hxx>
#include <Geom_Surface.hxx>
#include <functional>
#include <vector>

#include "geom/occt/patch_tree.h"
#include "geom/occt/spline_spans.h"
#include "geom/surface.h"

namespace octet {

/// Splines as one polynomial per span, extrusions and revolutions by their curve, offsets of these by their
/// basis, others (and an offset where its basis has no normal) through the Geom handle, which OCCT lets
/// threads share (adaptors are not). Immutable, thread-safe, shares its coefficients when copied.
class SurfaceJets {
 public:
  explicit SurfaceJets(const Handle(Geom_Surface) & surface);

  /// `derivatives` is 0, 1 or 2; what is above it is left zero.
  [[nodiscard]] SurfaceJet evaluate(const Vec2& uv, int derivatives) const {
    return evaluate_(uv, derivatives, nullptr);
  }
  /// Per direction: ends of the range and all parameters between at which the surface may bend abruptly.
  [[nodiscard]] std::vector<double> u_breaks(const UvCell& range) const;
  [[nodiscard]] std::vector<double> v_breaks(const UvCell& range) const;
  /// Whether the surface goes on beyond its own bounds as it is within them.
  [[nodiscard]] bool runs_on() const { return runs_on_; }
  [[nodiscard]] const Handle(Geom_Surface) & surface() const { return surface_; }
  [[nodiscard]] const char* kind() const;

 private:
  void set_offset(const Geom_OffsetSurface& offset);

  Handle(Geom_Surface) surface_;
  /// With `derivatives` 3, the third ones go to the place given; surfaces of OCCT's do not give them.
  std::function<SurfaceJet(const Vec2&, int, SurfaceThirds*)> evaluate_;
  bool has_thirds_ = false;
  std::vector<double> u_knots_, v_knots_;  ///< unordered, over one period
  bool runs_on_ = false;
};

}  // namespace octet
