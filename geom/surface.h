// SPDX-License-Identifier: BSD-3-Clause
// The untrimmed surface under a model face, and the curve under a model edge.
#pragma once

#include <memory>
#include <vector>

#include "base/vec.h"

namespace octet {

/// Position and derivatives at (u, v).
struct SurfaceJet {
  Vec3 p = Vec3::Zero();
  Vec3 du = Vec3::Zero(), dv = Vec3::Zero();
  Vec3 duu = Vec3::Zero(), duv = Vec3::Zero(), dvv = Vec3::Zero();
};

/// A root of segment and surface.
struct SurfaceRoot {
  double t = 0.0;  ///< parameter on the segment, 0..1
  Vec2 uv = Vec2::Zero();
  bool tangent = false;     ///< an even root: the segment touches and does not cross
  bool coincident = false;  ///< the segment lies in the surface around t
};

/// The nearest point of a surface.
struct SurfaceFoot {
  Vec2 uv = Vec2::Zero();
  Vec3 point = Vec3::Zero();
  bool converged = false;  ///< the gradient vanishes, or the foot lies on the border of the (u,v) box
};

/// A parametric surface. Immutable; all members may be called from several threads at once.
class Surface {
 public:
  virtual ~Surface() = default;
  /// `derivatives` is 0, 1 or 2; what is above it is left zero.
  [[nodiscard]] virtual SurfaceJet evaluate(const Vec2& uv, int derivatives) const = 0;
  /// Appends every root of the segment p..q with the surface over its (u,v) box.
  virtual void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const = 0;
  /// Foot point of p near the seed (closed forms ignore the seed but for periods and ties).
  [[nodiscard]] virtual SurfaceFoot project(const Vec3& p, const Vec2& seed) const = 0;
  /// Unit normal du x dv; at a singular point the limit along the seed's direction, or zero when there is
  /// none.
  [[nodiscard]] virtual Vec3 normal(const Vec2& uv) const = 0;
  /// "plane", "cylinder", "cone", "sphere", "torus", "b-spline", ...
  [[nodiscard]] virtual const char* kind() const = 0;
};

/// A parametric curve over [t0, t1]. Immutable; all members may be called from several threads at once.
class Curve {
 public:
  virtual ~Curve() = default;
  [[nodiscard]] virtual Vec3 point(double t) const = 0;
  [[nodiscard]] virtual Vec3 derivative(double t) const = 0;
  /// Parameter in [t0, t1] of the point nearest to p, near the hint where there are several.
  [[nodiscard]] virtual double project(const Vec3& p, double hint) const = 0;
  /// Appends the parameters in [t0, t1], ascending, at which normal . point = offset (edge and plane). A
  /// curve in the plane has none. Requires a unit normal.
  virtual void cut(const Vec3& normal, double offset, std::vector<double>& parameters) const = 0;
  /// t0, t1 and the parameters between, ascending, at which derivatives may jump; empty for smooth curves.
  [[nodiscard]] virtual std::vector<double> breaks() const { return {}; }
  [[nodiscard]] virtual const char* kind() const = 0;
};

/// Where a point of the (u,v) plane lies with respect to a face's loops.
enum class TrimSide { kOut, kOn, kIn };

/// The loops of a face in (u,v). Immutable; thread-safe.
class Trim {
 public:
  virtual ~Trim() = default;
  [[nodiscard]] virtual TrimSide side(const Vec2& uv) const = 0;
};

}  // namespace octet
