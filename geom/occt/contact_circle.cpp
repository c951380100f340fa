// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of revolution about one axis touch where their sections in a half-plane do: a line and a circle,
// or two circles.
#include "geom/occt/contact_circle.h"

#include <Adaptor3d_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <cmath>
#include <optional>

#include "geom/occt/canonical.h"

namespace octet {
namespace {

constexpr double kParallel = 1e-9;  ///< sine of the angle between directions that are one

struct Axis {
  Vec3 origin, along;
};

Axis axis_of(const gp_Ax1& axis) { return {to_vec(axis.Location().XYZ()), to_vec(axis.Direction().XYZ())}; }

/// The section of a surface of revolution: coordinates are the distance from the axis, and along it.
struct Section {
  bool is_circle = false;
  Vec2 centre = Vec2::Zero();  ///< of the circle, or a point of the line
  double radius = 0.0;
  Vec2 along = Vec2::Zero();  ///< of the line
};

std::optional<Axis> own_axis(const BRepAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return axis_of(surface.Cylinder().Axis());
    case GeomAbs_Cone:
      return axis_of(surface.Cone().Axis());
    case GeomAbs_Torus:
      return axis_of(surface.Torus().Axis());
    case GeomAbs_SurfaceOfRevolution:
      return axis_of(surface.AxeOfRevolution());
    default:
      return std::nullopt;
  }
}

class Sectioner {
 public:
  Sectioner(const Axis& axis, double tolerance) : axis_(axis), tolerance_(tolerance) {}

  /// Nothing where the surface is not one of revolution about the axis.
  [[nodiscard]] std::optional<Section> of(const BRepAdaptor_Surface& surface) const {
    switch (surface.GetType()) {
      case GeomAbs_Plane: {
        const gp_Ax1 normal = surface.Plane().Axis();
        if (!is_parallel(to_vec(normal.Direction().XYZ()))) return std::nullopt;
        return line({0.0, height(to_vec(normal.Location().XYZ()))}, {1.0, 0.0});
      }
      case GeomAbs_Cylinder:
        if (!is_same(axis_of(surface.Cylinder().Axis()))) return std::nullopt;
        return line({surface.Cylinder().Radius(), 0.0}, {0.0, 1.0});
      case GeomAbs_Cone: {
        const gp_Cone cone = surface.Cone();
        if (!is_same(axis_of(cone.Axis()))) return std::nullopt;
        const double way = axis_.along.dot(axis_of(cone.Axis()).along) > 0.0 ? 1.0 : -1.0;
        return line({cone.RefRadius(), height(to_vec(cone.Location().XYZ()))},
                    {std::sin(cone.SemiAngle()), way * std::cos(cone.SemiAngle())});
      }
      case GeomAbs_Sphere: {
        const Vec3 centre = to_vec(surface.Sphere().Location().XYZ());
        if (distance(centre) > tolerance_) return std::nullopt;
        return circle({0.0, height(centre)}, surface.Sphere().Radius());
      }
      case GeomAbs_Torus: {
        const gp_Torus torus = surface.Torus();
        if (!is_same(axis_of(torus.Axis()))) return std::nullopt;
        return circle({torus.MajorRadius(), height(to_vec(torus.Location().XYZ()))}, torus.MinorRadius());
      }
      case GeomAbs_SurfaceOfRevolution: {
        if (!is_same(axis_of(surface.AxeOfRevolution()))) return std::nullopt;
        const Handle(Adaptor3d_Curve) profile = surface.BasisCurve();
        return profile->GetType() == GeomAbs_Circle ? of(profile->Circle()) : std::nullopt;
      }
      default:
        return std::nullopt;
    }
  }

 private:
  /// Of the torus that a circle in a plane through the axis makes.
  [[nodiscard]] std::optional<Section> of(const gp_Circ& profile) const {
    const Vec3 centre = to_vec(profile.Location().XYZ()), normal = to_vec(profile.Axis().Direction().XYZ());
    const bool in_plane = std::abs(normal.dot(axis_.along)) < kParallel &&
                          std::abs(normal.dot(centre - axis_.origin)) <= tolerance_;
    if (!in_plane) return std::nullopt;
    return circle({distance(centre), height(centre)}, profile.Radius());
  }

  static Section line(const Vec2& through, const Vec2& along) { return {false, through, 0.0, along}; }
  static Section circle(const Vec2& centre, double radius) { return {true, centre, radius, Vec2::Zero()}; }

  [[nodiscard]] bool is_parallel(const Vec3& way) const { return way.cross(axis_.along).norm() < kParallel; }
  [[nodiscard]] double height(const Vec3& p) const { return (p - axis_.origin).dot(axis_.along); }
  [[nodiscard]] double distance(const Vec3& p) const { return (p - axis_.origin).cross(axis_.along).norm(); }
  [[nodiscard]] bool is_same(const Axis& other) const {
    return is_parallel(other.along) && distance(other.origin) <= tolerance_;
  }

  Axis axis_;
  double tolerance_;
};

/// Where two sections touch: on the perpendicular from the one's centre to the other.
std::vector<Vec2> touches(const Section& circle, const Section& other, double tolerance) {
  std::vector<Vec2> places;
  if (!other.is_circle) {
    const Vec2 foot = other.centre + (circle.centre - other.centre).dot(other.along) * other.along;
    places.push_back(foot);
  } else {
    const Vec2 way = circle.centre - other.centre;
    if (way.norm() <= tolerance) return {};
    for (const double side : {1.0, -1.0})
      places.push_back(other.centre + side * other.radius * way.normalized());
  }
  std::erase_if(places, [&](const Vec2& p) {
    return std::abs((p - circle.centre).norm() - circle.radius) > tolerance || p.x() <= tolerance;
  });
  return places;
}

gp_Circ circle_of(const Vec3& centre, const Vec3& axis, double radius) {
  return {gp_Ax2(gp_Pnt(centre.x(), centre.y(), centre.z()), gp_Dir(axis.x(), axis.y(), axis.z())), radius};
}

/// Whether an edge of the face runs along the circle, but for what files leave between the two.
bool has_edge_along(const TopoDS_Face& face, const gp_Circ& circle) {
  constexpr double kBeside = 1e-3;  // of the radius
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0.0, last = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(it.Current()), first, last);
    if (curve.IsNull()) continue;
    const auto is_beside = [&](double share) {
      return circle.Distance(curve->Value(first + share * (last - first))) <= kBeside * circle.Radius();
    };
    if (is_beside(0.1) && is_beside(0.5) && is_beside(0.8)) return true;
  }
  return false;
}

/// A sphere in a torus of its own radius touches it along the tube's circle around its centre.
std::optional<gp_Circ> circle_in_tube(const BRepAdaptor_Surface& sphere, const BRepAdaptor_Surface& tube,
                                      double tolerance) {
  if (sphere.GetType() != GeomAbs_Sphere || tube.GetType() != GeomAbs_Torus) return std::nullopt;
  const gp_Torus torus = tube.Torus();
  const Axis axis = axis_of(torus.Axis());
  const Vec3 centre = to_vec(sphere.Sphere().Location().XYZ()), way = centre - axis.origin;
  const Vec3 out = way - way.dot(axis.along) * axis.along;
  const bool on_middle =
      std::abs(way.dot(axis.along)) <= tolerance && std::abs(out.norm() - torus.MajorRadius()) <= tolerance;
  if (!on_middle || std::abs(sphere.Sphere().Radius() - torus.MinorRadius()) > tolerance) return std::nullopt;
  return circle_of(centre, axis.along.cross(out).normalized(), torus.MinorRadius());
}

std::vector<gp_Circ> surface_contacts(const BRepAdaptor_Surface& f, const BRepAdaptor_Surface& g,
                                      double tolerance) {
  if (const auto circle = circle_in_tube(f, g, tolerance)) return {*circle};
  if (const auto circle = circle_in_tube(g, f, tolerance)) return {*circle};
  std::optional<Axis> axis = own_axis(f);
  if (!axis) axis = own_axis(g);
  if (!axis) return {};
  const Sectioner sectioner(*axis, tolerance);
  const std::optional<Section> s = sectioner.of(f), t = sectioner.of(g);
  if (!s || !t || (!s->is_circle && !t->is_circle)) return {};
  std::vector<gp_Circ> circles;
  for (const Vec2& p : s->is_circle ? touches(*s, *t, tolerance) : touches(*t, *s, tolerance))
    circles.push_back(circle_of(axis->origin + p.y() * axis->along, axis->along, p.x()));
  return circles;
}

}  // namespace

std::vector<TopoDS_Edge> contact_circles(const TopoDS_Face& a, const TopoDS_Face& b, double tolerance) {
  std::vector<TopoDS_Edge> edges;
  // Whole surfaces: to ask a face for its bounds goes through all of its edges.
  const BRepAdaptor_Surface of_a(a, false), of_b(b, false);
  for (const gp_Circ& circle : surface_contacts(of_a, of_b, tolerance))
    if (!has_edge_along(a, circle) && !has_edge_along(b, circle))
      edges.push_back(BRepBuilderAPI_MakeEdge(circle).Edge());
  return edges;
}

}  // namespace octet
