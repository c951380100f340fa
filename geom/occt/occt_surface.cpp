// SPDX-License-Identifier: BSD-3-Clause
// A surface without closed form: B-spline, Bezier, extrusion, revolution, offset.
#include "geom/occt/occt_surface.h"

#include <GeomAbs_Shape.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/occt/canonical.h"
#include "geom/occt/spline_spans.h"

namespace octet {
namespace {

SurfaceJet jet_of(const Geom_Surface& surface, const Vec2& uv, int derivatives) {
  SurfaceJet jet;
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  if (derivatives == 0) {
    surface.D0(uv.x(), uv.y(), p);
  } else if (derivatives == 1) {
    surface.D1(uv.x(), uv.y(), p, du, dv);
  } else {
    surface.D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
    jet.duu = to_vec(duu);
    jet.duv = to_vec(duv);
    jet.dvv = to_vec(dvv);
  }
  jet.p = to_vec(p);
  jet.du = to_vec(du);
  jet.dv = to_vec(dv);
  return jet;
}

/// Parameters at which a surface may bend abruptly, unordered, over one period.
struct Knots {
  std::vector<double> u, v;
};

void add_curve_knots(Handle(Geom_Curve) curve, std::vector<double>& knots) {
  if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve); !trimmed.IsNull())
    curve = trimmed->BasisCurve();
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return;
  for (int i = 1; i <= spline->NbKnots(); ++i) knots.push_back(spline->Knot(i));
}

Knots knots_of(const Handle(Geom_Surface) & surface) {
  Knots knots;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull()) {
    for (int i = 1; i <= spline->NbUKnots(); ++i) knots.u.push_back(spline->UKnot(i));
    for (int i = 1; i <= spline->NbVKnots(); ++i) knots.v.push_back(spline->VKnot(i));
  } else if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
             !extrusion.IsNull()) {
    add_curve_knots(extrusion->BasisCurve(), knots.u);
  } else if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !turned.IsNull()) {
    add_curve_knots(turned->BasisCurve(), knots.v);
  } else if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface); !offset.IsNull()) {
    return knots_of(offset->BasisSurface());
  } else if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
             !trimmed.IsNull()) {
    return knots_of(trimmed->BasisSurface());
  }
  return knots;
}

/// Ends of [lo, hi] and the knots between, periods repeated.
std::vector<double> breaks_of(const std::vector<double>& knots, double lo, double hi, double period) {
  std::vector<double> breaks = {lo, hi};
  const double nearly = 1e-9 * (hi - lo);
  for (const double knot : knots) {
    if (period <= 0.0) {
      if (knot > lo + nearly && knot < hi - nearly) breaks.push_back(knot);
      continue;
    }
    for (double k = knot + period * std::ceil((lo - knot) / period); k < hi - nearly; k += period)
      if (k > lo + nearly) breaks.push_back(k);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end(), [&](double a, double b) { return b - a < nearly; }),
               breaks.end());
  breaks.back() = hi;
  return breaks;
}

const char* kind_of(const Handle(Geom_Surface) & surface) {
  if (surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface))) return "b-spline";
  if (surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))) return "bezier";
  if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion))) return "extrusion";
  if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return "revolution";
  if (surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) return "offset";
  return "other";
}

class OcctSurface final : public Surface {
 public:
  OcctSurface(const Handle(Geom_Surface) & surface, const UvCell& face_cell)
      : surface_(surface), spans_(SplineSpans::make(surface)) {
    set_range(face_cell);
    const Knots knots = knots_of(surface);
    const double u_period = surface->IsUPeriodic() ? surface->UPeriod() : 0.0;
    const double v_period = surface->IsVPeriodic() ? surface->VPeriod() : 0.0;
    const auto evaluate_here = [this](const Vec2& uv, int n) { return evaluate(uv, n); };
    tree_ =
        std::make_unique<PatchTree>(evaluate_here, breaks_of(knots.u, range_.lo.x(), range_.hi.x(), u_period),
                                    breaks_of(knots.v, range_.lo.y(), range_.hi.y(), v_period));
  }

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    return spans_ ? spans_->evaluate(uv, derivatives) : jet_of(*surface_, uv, derivatives);
  }

  void intersect(const Vec3& p, const Vec3& q, std::span<const Vec2>,
                 std::vector<SurfaceRoot>& roots) const override {
    tree_->intersect(p, q, roots);
  }

  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override;
  Vec3 normal(const Vec2& uv) const override;
  const char* kind() const override { return kind_of(surface_); }

 private:
  void set_range(const UvCell& face_cell);
  [[nodiscard]] bool is_collapsed(int axis, double value) const;
  [[nodiscard]] Vec2 into_range(Vec2 uv) const;
  [[nodiscard]] bool is_foot(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double small) const;
  [[nodiscard]] SurfaceFoot descend(const Vec3& p, const Vec2& start, double small) const;
  [[nodiscard]] Vec2 newton_step(const SurfaceJet& jet, const Vec3& r, const Vec2& uv, double damping) const;

  Handle(Geom_Surface) surface_;
  std::unique_ptr<const SplineSpans> spans_;
  UvCell range_;
  bool closed_[2] = {false, false};  ///< the range is one whole turn
  std::unique_ptr<PatchTree> tree_;
};

/// The face's box, somewhat grown so that hits just across an edge are seen, within the surface's own bounds.
void OcctSurface::set_range(const UvCell& face_cell) {
  constexpr double kMargin = 1e-3;
  double lo[2], hi[2];
  surface_->Bounds(lo[0], hi[0], lo[1], hi[1]);
  const bool periodic[2] = {surface_->IsUPeriodic() != 0, surface_->IsVPeriodic() != 0};
  const bool closed[2] = {surface_->IsUClosed() != 0, surface_->IsVClosed() != 0};
  range_ = face_cell;
  for (int i = 0; i < 2; ++i) {
    const double own = hi[i] - lo[i], asked = face_cell.hi[i] - face_cell.lo[i];
    closed_[i] = closed[i] && asked > own * (1.0 - 1e-6);
    if (closed_[i]) continue;
    range_.lo[i] -= kMargin * asked;
    range_.hi[i] += kMargin * asked;
    if (periodic[i]) continue;
    // Loops may run somewhat beyond a spline's own bounds: its polynomials go on there, but not across a
    // pole.
    if (!spans_ || is_collapsed(i, lo[i]))
      range_.lo[i] = std::max(range_.lo[i], std::min(lo[i], face_cell.lo[i]));
    if (!spans_ || is_collapsed(i, hi[i]))
      range_.hi[i] = std::min(range_.hi[i], std::max(hi[i], face_cell.hi[i]));
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
  const double small = 1e-14 * (tree_->box().diagonal() + p.cwiseAbs().maxCoeff());
  const SurfaceFoot foot = descend(p, seed, small);
  if (foot.converged) return foot;
  // Stuck at a crease or a pole: once more from the nearest patch.
  const SurfaceFoot other = descend(p, tree_->near(p), small);
  const bool nearer = (other.point - p).squaredNorm() < (foot.point - p).squaredNorm();
  return nearer ? other : foot;
}

Vec3 OcctSurface::normal(const Vec2& uv) const {
  SurfaceJet jet = evaluate(uv, 1);
  Vec3 n = jet.du.cross(jet.dv);
  const double size = tree_->box().diagonal();
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

std::shared_ptr<const Surface> make_free_form(const Handle(Geom_Surface) & surface, const UvCell& cell) {
  return std::make_shared<OcctSurface>(surface, cell);
}

}  // namespace octet
