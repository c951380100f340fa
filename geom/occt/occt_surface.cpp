// SPDX-License-Identifier: BSD-3-Clause
// A surface without closed form: B-spline, Bezier, extrusion, revolution, offset.
#include "geom/occt/occt_surface.h"

#include <Precision.hxx>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

namespace octet {
namespace {

class OcctSurface final : public Surface {
 public:
  OcctSurface(SurfaceJets jets, const UvCell& face_cell) : jets_(std::move(jets)) { set_range(face_cell); }

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    return jets_.evaluate(uv, derivatives);
  }

  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    tree().intersect(p, q, roots);
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override;
  Vec3 normal(const Vec2& uv) const override;
  const char* kind() const override { return jets_.kind(); }

 private:
  /// Made when it is first asked for: the process that reads a part asks for none.
  [[nodiscard]] const PatchTree& tree() const {
    const PatchTree* made = made_.load(std::memory_order_acquire);
    return made != nullptr ? *made : make_tree();
  }
  [[nodiscard]] const PatchTree& make_tree() const;
  void set_range(const UvCell& face_cell);
  [[nodiscard]] bool is_collapsed(int axis, double value) const;
  [[nodiscard]] Vec2 into_range(Vec2 uv) const;
  [[nodiscard]] bool is_foot(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double small) const;
  [[nodiscard]] SurfaceFoot descend(const Vec3& p, const Vec2& start, double small) const;
  [[nodiscard]] Vec2 newton_step(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double damping) const;

  SurfaceJets jets_;
  UvCell range_;
  bool closed_[2] = {false, false};  ///< the range is one whole turn
  mutable std::unique_ptr<const PatchTree> tree_;
  mutable std::once_flag tree_begun_;
  mutable std::atomic<const PatchTree*> made_{nullptr};  ///< the tree, once it is whole
};

const PatchTree& OcctSurface::make_tree() const {
  std::call_once(tree_begun_, [this] {
    tree_ = std::make_unique<const PatchTree>([this](const Vec2& uv, int n) { return evaluate(uv, n); },
                                              jets_.u_breaks(range_), jets_.v_breaks(range_));
    made_.store(tree_.get(), std::memory_order_release);
  });
  return *tree_;
}

/// The face's box, somewhat grown so that hits just across an edge are seen, within the surface's own bounds.
void OcctSurface::set_range(const UvCell& face_cell) {
  constexpr double kMargin = 1e-3;
  double lo[2], hi[2];
  const Geom_Surface& surface = *jets_.surface();
  surface.Bounds(lo[0], hi[0], lo[1], hi[1]);
  const bool periodic[2] = {surface.IsUPeriodic() != 0, surface.IsVPeriodic() != 0};
  const bool closed[2] = {surface.IsUClosed() != 0, surface.IsVClosed() != 0};
  range_ = face_cell;
  for (int i = 0; i < 2; ++i) {
    const double own = hi[i] - lo[i], asked = face_cell.hi[i] - face_cell.lo[i];
    closed_[i] = closed[i] && asked > own * (1.0 - 1e-6);
    if (closed_[i]) continue;
    range_.lo[i] -= kMargin * asked;
    range_.hi[i] += kMargin * asked;
    if (periodic[i]) continue;
    // Loops may run somewhat beyond a spline's own bounds: its polynomials go on there, but not for long, and
    // not across a pole. What has no bounds, as a hyperbola drawn out, cannot be asked there.
    const auto beyond = [&](int side, double bound) {
      return Precision::IsInfinite(bound) || is_collapsed(i, bound) ? 0.0 : jets_.runs_on(i, side);
    };
    range_.lo[i] = std::max(range_.lo[i], std::min(lo[i] - beyond(0, lo[i]), face_cell.lo[i]));
    range_.hi[i] = std::min(range_.hi[i], std::max(hi[i] + beyond(1, hi[i]), face_cell.hi[i]));
  }
}

/// Whether the border at this value of one parameter is a single point.
bool OcctSurface::is_collapsed(int axis, double value) const {
  Box3 border, inside;
  for (int k = 0; k <= 4; ++k) {
    Vec2 uv = range_.lo + 0.25 * k * range_.size();
    uv[axis] = value;
    border.add(evaluate(uv, 0).p);
    uv[axis] = range_.centre()[axis];
    inside.add(evaluate(uv, 0).p);
  }
  return border.diagonal() < 1e-3 * inside.diagonal();
}

Vec2 OcctSurface::into_range(Vec2 uv) const {
  for (int i = 0; i < 2; ++i) {
    const double lo = range_.lo[i], hi = range_.hi[i];
    if (closed_[i] && (uv[i] < lo || uv[i] > hi)) uv[i] -= (hi - lo) * std::floor((uv[i] - lo) / (hi - lo));
    uv[i] = std::clamp(uv[i], lo, hi);
  }
  return uv;
}

/// Full Newton where the Hessian is positive, Gauss-Newton elsewhere; variables held at a bound stay there.
Vec2 OcctSurface::newton_step(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double damping) const {
  const Vec2 g(r.dot(jet.du), r.dot(jet.dv));
  double a = jet.du.squaredNorm(), b = jet.du.dot(jet.dv), c = jet.dv.squaredNorm();
  const double fa = a + r.dot(jet.duu), fb = b + r.dot(jet.duv), fc = c + r.dot(jet.dvv);
  if (fa > 0.1 * a && fc > 0.1 * c && fa * fc - fb * fb > 0.05 * a * c) {
    a = fa;
    b = fb;
    c = fc;
  }
  a += damping * jet.du.squaredNorm();
  c += damping * jet.dv.squaredNorm();
  const auto held = [&](int i) {
    return !closed_[i] && ((uv[i] <= range_.lo[i] && g[i] > 0.0) || (uv[i] >= range_.hi[i] && g[i] < 0.0));
  };
  Vec2 step = Vec2::Zero();
  if (held(0) && held(1)) return step;
  if (held(0)) {
    if (c > 0.0) step.y() = -g.y() / c;
    return step;
  }
  if (held(1)) {
    if (a > 0.0) step.x() = -g.x() / a;
    return step;
  }
  const double det = a * c - b * b;
  if (det <= 1e-14 * a * c) return {a > 0.0 ? -g.x() / a : 0.0, c > 0.0 ? -g.y() / c : 0.0};
  return {(-g.x() * c + g.y() * b) / det, (-g.y() * a + g.x() * b) / det};
}

/// Whether no direction within the range leads nearer.
bool OcctSurface::is_foot(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double small) const {
  const double allowed = 1e-7 * r.norm() + 64.0 * small;
  const auto idle = [&](int i, const Vec3& along) {
    const double g = r.dot(along), length = along.norm();
    if (length == 0.0 || std::abs(g) <= allowed * length) return true;
    return !closed_[i] && ((uv[i] <= range_.lo[i] && g > 0.0) || (uv[i] >= range_.hi[i] && g < 0.0));
  };
  return idle(0, jet.du) && idle(1, jet.dv);
}

SurfaceFoot OcctSurface::descend(const Vec3& p, const Vec2& start, double small) const {
  Vec2 uv = into_range(start);
  SurfaceJet jet = evaluate(uv, 2);
  // Parameters far from zero are known no better than their last digits.
  constexpr double kLastDigit = std::numeric_limits<double>::epsilon();
  small = std::max(small, kLastDigit * (std::abs(uv.x()) * jet.du.norm() + std::abs(uv.y()) * jet.dv.norm()));
  double value = (jet.p - p).squaredNorm();
  double damping = 0.0;
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Vec3 r = jet.p - p;
    const Vec2 next = into_range(uv + newton_step(jet, r, uv, damping));
    const SurfaceJet there = evaluate(next, 2);
    const double value_there = (there.p - p).squaredNorm();
    const double moved = (there.p - jet.p).norm();
    // A step that no longer gains because of rounding is the end, not a failure.
    const double noise = 4.0 * small * (std::sqrt(value) + small);
    if (value_there > value + noise) {
      if (moved <= 16.0 * small || damping > 1e8) break;
      damping = damping == 0.0 ? 0.5 : 4.0 * damping;
      continue;
    }
    damping = damping < 0.1 ? 0.0 : 0.2 * damping;
    uv = next;
    jet = there;
    value = value_there;
    if (moved <= 16.0 * small && damping <= 1.0) break;
  }
  return {uv, jet.p, is_foot(jet, jet.p - p, uv, small)};
}

SurfaceFoot OcctSurface::project(const Vec3& p, const Vec2& seed) const {
  const double small = 1e-14 * (tree().box().diagonal() + p.cwiseAbs().maxCoeff());
  const SurfaceFoot foot = descend(p, seed, small);
  if (foot.converged) return foot;
  // Stuck at a crease or a pole: once more from the nearest patch.
  const SurfaceFoot other = descend(p, tree().near(p), small);
  const bool nearer = (other.point - p).squaredNorm() < (foot.point - p).squaredNorm();
  return nearer ? other : foot;
}

Vec3 OcctSurface::normal(const Vec2& uv) const {
  SurfaceJet jet = evaluate(uv, 1);
  Vec3 n = jet.du.cross(jet.dv);
  const double size = tree().box().diagonal();
  const Vec2 span = range_.size();
  const double u_length = jet.du.norm() * span.x(), v_length = jet.dv.norm() * span.y();
  if (n.norm() * span.x() * span.y() > 1e-9 * size * std::max(u_length, v_length)) return n.normalized();
  // A collapsed side: look a little inwards along the direction that is alive.
  Vec2 inwards = range_.centre() - uv;
  if (u_length < 1e-6 * v_length) inwards.x() = 0.0;
  if (v_length < 1e-6 * u_length) inwards.y() = 0.0;
  jet = evaluate(uv + 1e-5 * inwards, 1);
  n = jet.du.cross(jet.dv);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

}  // namespace

std::shared_ptr<const Surface> make_free_form(SurfaceJets jets, const UvCell& cell) {
  return std::make_shared<OcctSurface>(std::move(jets), cell);
}

}  // namespace octet
