// SPDX-License-Identifier: BSD-3-Clause
// OCCT surfaces, curves and loops to ours: closed forms where there are any.
#include "geom/occt/canonical.h"

#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "geom/conics.h"
#include "geom/occt/curve_jets.h"
#include "geom/occt/occt_curve.h"
#include "geom/occt/occt_surface.h"
#include "geom/quadrics.h"
#include "geom/recognise.h"
#include "geom/torus.h"

namespace octet {
namespace {

Axes3 axes_of(const gp_Ax3& a) {
  return {to_vec(a.Location()), to_vec(a.XDirection().XYZ()), to_vec(a.YDirection().XYZ()),
          to_vec(a.Direction().XYZ())};
}

/// Deviation up to which a surface is taken for a closed form: OCCT's own precision, less on small faces.
constexpr double kSameSurface = 1e-7, kSameShare = 1e-8;

/// Start of a period that holds [lo, hi] in its middle: rounding across an end of a partial range then stays
/// near that end.
double period_start(double lo, double hi) { return lo - 0.5 * std::max(0.0, kTwoPi - (hi - lo)); }

Handle(Geom_Surface) basis_of(Handle(Geom_Surface) surface) {
  while (true) {
    const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    if (trimmed.IsNull()) return surface;
    surface = trimmed->BasisSurface();
  }
}

std::shared_ptr<const Surface> make_closed_form(const Handle(Geom_Surface) & surface, const UvCell& cell) {
  const double u0 = period_start(cell.lo.x(), cell.hi.x());
  if (const auto s = Handle(Geom_Plane)::DownCast(surface); !s.IsNull())
    return make_plane(axes_of(s->Position()));
  if (const auto s = Handle(Geom_CylindricalSurface)::DownCast(surface); !s.IsNull())
    return make_cylinder(axes_of(s->Position()), s->Radius(), u0);
  if (const auto s = Handle(Geom_ConicalSurface)::DownCast(surface); !s.IsNull())
    return make_cone(axes_of(s->Position()), s->SemiAngle(), s->RefRadius(), u0);
  if (const auto s = Handle(Geom_SphericalSurface)::DownCast(surface); !s.IsNull())
    return make_sphere(axes_of(s->Position()), s->Radius(), u0);
  if (const auto s = Handle(Geom_ToroidalSurface)::DownCast(surface); !s.IsNull())
    return make_torus(axes_of(s->Position()), s->MajorRadius(), s->MinorRadius(), u0,
                      period_start(cell.lo.y(), cell.hi.y()));
  return nullptr;
}

/// A closed form whose (u,v) are not those of OCCT's surface.
class RecognisedSurface final : public Surface {
 public:
  RecognisedSurface(SurfaceJets source, std::unique_ptr<const CanonicalForm> form)
      : source_(std::move(source)), form_(std::move(form)) {}

  [[nodiscard]] Vec2 from_occt(const Vec2& uv) const { return form_->map(source_.evaluate(uv, 0).p, uv); }

  [[nodiscard]] const SurfaceJets& source() const { return source_; }

  SurfaceJet evaluate(const Vec2& uv, int derivatives) const override {
    return form_->surface().evaluate(uv, derivatives);
  }
  void intersect(const Vec3& p, const Vec3& q, std::vector<SurfaceRoot>& roots) const override {
    form_->surface().intersect(p, q, roots);
  }
  SurfaceFoot project(const Vec3& p, const Vec2& seed) const override {
    return form_->surface().project(p, seed);
  }
  Vec3 normal(const Vec2& uv) const override { return form_->surface().normal(uv); }
  const char* kind() const override { return form_->surface().kind(); }

 private:
  SurfaceJets source_;
  std::unique_ptr<const CanonicalForm> form_;
};

std::unique_ptr<const CanonicalForm> closed_form_of(const SurfaceJets& jets, const UvCell& cell) {
  Box3 box;
  constexpr int kSamples = 8;
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; j <= kSamples; ++j)
      box.add(jets.evaluate(cell.lo + Vec2(i, j).cwiseProduct(cell.size()) / kSamples, 0).p);
  return recognise([&](const Vec2& uv, int n) { return jets.evaluate(uv, n); }, jets.u_breaks(cell),
                   jets.v_breaks(cell), std::min(kSameSurface, kSameShare * box.diagonal()));
}

/// The curve as a line at the same parameters, where it is one to rounding.
std::shared_ptr<const Curve> line_of(const CurveJets& jets, double t0, double t1) {
  const Vec3 a = jets.evaluate(t0, 0).p, b = jets.evaluate(t1, 0).p;
  const Vec3 direction = (b - a) / (t1 - t0);
  const double rounding = 1e-13 * (b - a).norm() + 1e-15 * a.cwiseAbs().cwiseMax(b.cwiseAbs()).maxCoeff();
  const auto samples = static_cast<int>(8 * std::max<std::size_t>(1, jets.knots().size()));
  for (int i = 1; i < samples; ++i) {
    const double t = t0 + i * (t1 - t0) / samples;
    if (!((jets.evaluate(t, 0).p - a - (t - t0) * direction).norm() <= rounding)) return nullptr;
  }
  return direction.norm() > 0.0 ? make_line(a - t0 * direction, direction, t0, t1) : nullptr;
}

UvCell cell_of(const TopoDS_Face& face) {
  UvCell cell;
  BRepTools::UVBounds(face, cell.lo.x(), cell.hi.x(), cell.lo.y(), cell.hi.y());
  return cell;
}

}  // namespace

std::shared_ptr<const Surface> make_surface(const TopoDS_Face& face, int tag) {
  const Handle(Geom_Surface) surface = basis_of(BRep_Tool::Surface(face));
  if (surface.IsNull()) throw ModelError(fmt::format("Face {} has no surface", tag), model_face(tag));
  const UvCell cell = cell_of(TopoDS::Face(face.Oriented(TopAbs_FORWARD)));
  if (auto closed = make_closed_form(surface, cell)) return closed;
  const bool bounded = cell.lo.allFinite() && cell.hi.allFinite() &&
                       cell.lo.cwiseAbs().maxCoeff() < Precision::Infinite() &&
                       cell.hi.cwiseAbs().maxCoeff() < Precision::Infinite() && cell.size().minCoeff() > 0.0;
  if (!bounded) throw ModelError(fmt::format("Face {} has no bounded range", tag), model_face(tag));
  SurfaceJets jets(surface);
  if (auto form = closed_form_of(jets, cell))
    return std::make_shared<RecognisedSurface>(std::move(jets), std::move(form));
  return make_free_form(std::move(jets), cell);
}

bool is_recognised(const Surface& surface) {
  return dynamic_cast<const RecognisedSurface*>(&surface) != nullptr;
}

std::function<Vec2(const Vec2&)> from_occt_uv(const Surface& surface) {
  const auto* const recognised = dynamic_cast<const RecognisedSurface*>(&surface);
  if (recognised == nullptr) return [](const Vec2& uv) { return uv; };
  return [recognised](const Vec2& uv) { return recognised->from_occt(uv); };
}

std::function<SurfaceJet(const Vec2&, int)> occt_jets(const Surface& surface) {
  if (const auto* const recognised = dynamic_cast<const RecognisedSurface*>(&surface))
    return [recognised](const Vec2& uv, int n) { return recognised->source().evaluate(uv, n); };
  return [&surface](const Vec2& uv, int n) { return surface.evaluate(uv, n); };
}

std::shared_ptr<const Curve> make_curve(const TopoDS_Edge& edge) {
  double t0 = 0.0, t1 = 0.0;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, t0, t1);
  while (true) {
    const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve);
    if (trimmed.IsNull()) break;
    curve = trimmed->BasisCurve();
  }
  if (const auto c = Handle(Geom_Line)::DownCast(curve); !c.IsNull())
    return make_line(to_vec(c->Position().Location()), to_vec(c->Position().Direction().XYZ()), t0, t1);
  if (const auto c = Handle(Geom_Circle)::DownCast(curve); !c.IsNull())
    return make_circle(axes_of(gp_Ax3(c->Position())), c->Radius(), t0, t1);
  if (const auto c = Handle(Geom_Ellipse)::DownCast(curve); !c.IsNull())
    return make_ellipse(axes_of(gp_Ax3(c->Position())), c->MajorRadius(), c->MinorRadius(), t0, t1);
  CurveJets jets(curve);
  if (auto line = line_of(jets, t0, t1)) return line;
  return make_free_curve(std::move(jets), t0, t1);
}

}  // namespace octet
