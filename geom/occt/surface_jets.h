// SPDX-License-Identifier: BSD-3-Clause
// Points and derivatives of a surface that is no quadric or torus.
#pragma once

#include <Geom_OffsetSurface.hxx>
#include <Geom_Surface.hxx>
#include <array>
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
  /// How far the surface goes on beyond an end (0, 1) of its own bounds along an axis (0: u) as it is within
  /// them: a share of the last polynomial's span, the less the higher its degree; 0 for all but splines.
  [[nodiscard]] double runs_on(int axis, int end) const { return runs_on_[axis][end]; }
  [[nodiscard]] const Handle(Geom_Surface) & surface() const { return surface_; }
  [[nodiscard]] const char* kind() const;

 private:
  void set_offset(const Geom_OffsetSurface& offset);
  void set_runs_on();

  Handle(Geom_Surface) surface_;
  /// With `derivatives` 3, the third ones go to the place given; surfaces of OCCT's do not give them.
  std::function<SurfaceJet(const Vec2&, int, SurfaceThirds*)> evaluate_;
  bool has_thirds_ = false;
  std::vector<double> u_knots_, v_knots_;  ///< unordered, over one period
  std::array<std::array<double, 2>, 2> runs_on_{};
};

}  // namespace octet
