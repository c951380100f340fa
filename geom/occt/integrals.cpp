// SPDX-License-Identifier: BSD-3-Clause
// Area of a face and its share of a solid's volume, integrated on the exact surface.
#include "geom/occt/integrals.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "geom/occt/canonical.h"

namespace octet {
namespace {

// Of the rules of degree 2 and 5 on one triangle. With 1e-5 a twisted patch with straight sides is off by
// 4e-7, with this by 3e-9.
constexpr double kAgree = 1e-6;
// Of the rule of degree 5 on a triangle and on its quarters, which are then nearer by far: a patch of a
// sphere took all splits until the rules agreed, a thousand pieces a triangle.
constexpr double kFineAgree = 1e-7;
constexpr int kMaxSplits = 5;

struct Sum {
  double area = 0.0, moment = 0.0;
  Vec3 vector = Vec3::Zero();
  void add(const Sum& other, double weight) {
    area += weight * other.area;
    moment += weight * other.moment;
    vector += weight * other.vector;
  }
};

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

using Corners = std::array<Vec2, 3>;

/// The triangle on both sides of the line where its coordinate `axis` is `at`, which is within its own: three
/// triangles, of which some may have no area.
std::array<Corners, 3> cut(const Corners& t, Eigen::Index axis, double at) {
  const auto is_below = [&](std::size_t i) { return t[i][axis] < at; };
  std::size_t lone = 0;
  while (is_below(lone) == is_below((lone + 1) % 3) || is_below(lone) == is_below((lone + 2) % 3)) ++lone;
  const Vec2 &a = t[lone], &b = t[(lone + 1) % 3], &c = t[(lone + 2) % 3];
  const auto on_line = [&](const Vec2& end) {
    Vec2 p = a + (at - a[axis]) / (end[axis] - a[axis]) * (end - a);
    p[axis] = at;
    return p;
  };
  const Vec2 p = on_line(b), q = on_line(c);
  return {{{a, p, q}, {p, b, c}, {p, c, q}}};
}

class Integrator {
 public:
  /// `breaks`: in u and in v, ascending, where the surface's first or second derivatives may jump.
  Integrator(const Surface& surface, const Vec2& uv, std::array<std::vector<double>, 2> breaks)
      : breaks_(std::move(breaks)),
        jets_(occt_jets(surface)),
        origin_(jets_(uv, 0).p),
        linear_(std::string_view(surface.kind()) == "plane" && !is_recognised(surface)) {}

  [[nodiscard]] const Vec3& origin() const { return origin_; }

  [[nodiscard]] Sum triangle(const Corners& t) const {
    Sum total;
    if (linear_) {
      total.add(value((t[0] + t[1] + t[2]) / 3.0), half_of(t));
    } else if (const std::optional<Break> found = break_in(t)) {
      // First of all: a corner beyond it, where no rule has a place, would go unseen.
      for (const Corners& side : cut(t, found->axis, found->at)) total.add(triangle(side), 1.0);
    } else {
      total = split_unless_told(t, fine(t), 0);
    }
    return total;
  }

  /// What lies between the chord a-b and the loop's curve from a to b, to the left of the curve's way from
  /// the chord: negative where the curve lies left of the chord. Of the stretch between two shares of the
  /// way alone, in which the curve is smooth.
  template <class CurveAt>
  [[nodiscard]] Sum sliver(const Vec2& a, const Vec2& b, const CurveAt& curve, double from, double to) const {
    static constexpr std::array<double, 4> kNode = {0.069431844202974, 0.330009478207572, 0.669990521792428,
                                                    0.930568155797026};
    static constexpr std::array<double, 4> kWeight = {0.173927422568727, 0.326072577431273, 0.326072577431273,
                                                      0.173927422568727};
    Sum total;
    for (int i = 0; i < 4; ++i) {
      const double share = from + kNode[i] * (to - from);
      const Vec2 chord = a + share * (b - a);
      const auto [at, way] = curve(share);
      const Vec2 across = at - chord;
      for (int j = 0; j < 4; ++j) {
        const Vec2 along = (b - a) + kNode[j] * (way - (b - a));
        total.add(value(chord + kNode[j] * across),
                  -kWeight[i] * kWeight[j] * (to - from) * cross2(along, across));
      }
    }
    return total;
  }

 private:
  static double half_of(const Corners& t) { return 0.5 * cross2(t[1] - t[0], t[2] - t[0]); }

  /// By the finer rule.
  [[nodiscard]] Sum fine(const Corners& t) const {
    Sum sum;
    sum.add(degree_5(t[0], t[1], t[2]), half_of(t));
    return sum;
  }

  struct Break {
    Eigen::Index axis = 0;
    double at = 0.0;
  };

  /// The middle one of those that the triangle crosses most of; none where it crosses none.
  [[nodiscard]] std::optional<Break> break_in(const Corners& t) const {
    std::optional<Break> found;
    std::ptrdiff_t most = 0;
    for (const Eigen::Index axis : {0, 1}) {
      const std::vector<double>& breaks = breaks_[static_cast<std::size_t>(axis)];
      const auto [lo, hi] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
      const auto first = std::upper_bound(breaks.begin(), breaks.end(), lo);
      const auto count = std::lower_bound(first, breaks.end(), hi) - first;
      if (count <= most) continue;
      most = count;
      found = Break{axis, first[count / 2]};
    }
    return found;
  }

  /// `whole`: what the finer rule makes of the triangle. Where the rules do not agree about it, and neither
  /// does the finer one about its quarters, these are taken one by one.
  [[nodiscard]] Sum split_unless_told(const Corners& t, const Sum& whole, int depth) const {
    const auto agree = [&](double area, double share) {
      return std::abs(whole.area - area) <= share * std::abs(whole.area);
    };
    if (depth == kMaxSplits || agree(half_of(t) * degree_2(t[0], t[1], t[2]).area, kAgree)) return whole;
    const auto& [a, b, c] = t;
    const Vec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
    const std::array<Corners, 4> quarters{{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
    std::array<Sum, 4> parts;
    Sum all;
    for (std::size_t i = 0; i < 4; ++i) {
      parts[i] = fine(quarters[i]);
      all.add(parts[i], 1.0);
    }
    if (agree(all.area, kFineAgree)) return all;
    Sum total;
    for (std::size_t i = 0; i < 4; ++i) total.add(split_unless_told(quarters[i], parts[i], depth + 1), 1.0);
    return total;
  }

  [[nodiscard]] Sum value(const Vec2& uv) const {
    const SurfaceJet jet = jets_(uv, 1);
    const Vec3 n = jet.du.cross(jet.dv);
    return {n.norm(), (jet.p - origin_).dot(n) / 3.0, n};
  }

  [[nodiscard]] Sum degree_2(const Vec2& a, const Vec2& b, const Vec2& c) const {
    Sum sum;
    for (const Vec2& p :
         {Vec2((4.0 * a + b + c) / 6.0), Vec2((a + 4.0 * b + c) / 6.0), Vec2((a + b + 4.0 * c) / 6.0)})
      sum.add(value(p), 1.0 / 3.0);
    return sum;
  }

  /// Radon's rule of seven points.
  [[nodiscard]] Sum degree_5(const Vec2& a, const Vec2& b, const Vec2& c) const {
    static const double root = std::sqrt(15.0);
    Sum sum;
    sum.add(value((a + b + c) / 3.0), 9.0 / 40.0);
    for (const double sign : {-1.0, 1.0}) {
      const double w = (6.0 + sign * root) / 21.0, weight = (155.0 + sign * root) / 1200.0;
      for (const Vec2& p : {Vec2(w * (a + b) + (1.0 - 2.0 * w) * c), Vec2(w * (b + c) + (1.0 - 2.0 * w) * a),
                            Vec2(w * (c + a) + (1.0 - 2.0 * w) * b)})
        sum.add(value(p), weight);
    }
    return sum;
  }

  std::array<std::vector<double>, 2> breaks_;
  std::function<SurfaceJet(const Vec2&, int)> jets_;
  Vec3 origin_;
  bool linear_;  ///< in (u,v): one place in the middle is exact
};

Vec2 uv_node(const Poly_Triangulation& triangulation, int i) {
  const gp_Pnt2d uv = triangulation.UVNode(i);
  return {uv.X(), uv.Y()};
}

/// The polygon of `edge` that runs along this pcurve: at a seam there are two, and their order is not told.
Handle(Poly_PolygonOnTriangulation)
    polygon_along(const Geom2d_Curve& pcurve, const TopoDS_Edge& edge,
                  const Handle(Poly_Triangulation) & triangulation, const TopLoc_Location& place) {
  Handle(Poly_PolygonOnTriangulation) best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const TopAbs_Orientation way : {TopAbs_FORWARD, TopAbs_REVERSED}) {
    const auto polygon =
        BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(edge.Oriented(way)), triangulation, place);
    if (polygon.IsNull() || !polygon->HasParameters()) continue;
    const int middle = (1 + polygon->NbNodes()) / 2;
    const gp_Pnt2d at = pcurve.Value(polygon->Parameter(middle));
    const double distance =
        (uv_node(*triangulation, polygon->Node(middle)) - Vec2(at.X(), at.Y())).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = polygon;
  }
  return best;
}

/// Where one polynomial or conic gives way to the next, ends included: a rule for smooth functions is off by
/// 1e-6 of a face where it goes across such places.
std::vector<double> smooth_stretches(const Handle(Geom2d_Curve) & pcurve, double first, double last) {
  const Geom2dAdaptor_Curve curve(pcurve, first, last);
  TColStd_Array1OfReal ends(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(ends, GeomAbs_CN);
  return {ends.begin(), ends.end()};
}

/// Where the surface is less than twice differentiable in u and in v, ends included.
std::array<std::vector<double>, 2> breaks_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  std::array<std::vector<double>, 2> breaks;
  TColStd_Array1OfReal in_u(1, surface.NbUIntervals(GeomAbs_C2) + 1),
      in_v(1, surface.NbVIntervals(GeomAbs_C2) + 1);
  surface.UIntervals(in_u, GeomAbs_C2);
  surface.VIntervals(in_v, GeomAbs_C2);
  breaks[0].assign(in_u.begin(), in_u.end());
  breaks[1].assign(in_v.begin(), in_v.end());
  return breaks;
}

void add_slivers(const TopoDS_Edge& edge, const TopoDS_Face& face,
                 const Handle(Poly_Triangulation) & triangulation, const TopLoc_Location& place,
                 const Integrator& integrator, Sum& total) {
  if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) return;
  double first = 0.0, last = 0.0;
  const auto pcurve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (pcurve.IsNull()) return;
  const auto polygon = polygon_along(*pcurve, edge, triangulation, place);
  if (polygon.IsNull()) return;
  const double sign = edge.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
  const std::vector<double> ends = smooth_stretches(pcurve, first, last);
  for (int k = 1; k < polygon->NbNodes(); ++k) {
    const double t0 = polygon->Parameter(k), t1 = polygon->Parameter(k + 1), step = t1 - t0;
    const auto at = [&](double share) {
      gp_Pnt2d p;
      gp_Vec2d d;
      pcurve->D1(t0 + share * step, p, d);
      return std::make_pair(Vec2(p.X(), p.Y()), Vec2(step * d.X(), step * d.Y()));
    };
    const Vec2 a = uv_node(*triangulation, polygon->Node(k)),
               b = uv_node(*triangulation, polygon->Node(k + 1));
    auto end = std::upper_bound(ends.begin(), ends.end(), t0);
    for (double from = 0.0, to = 0.0; from < 1.0; from = to) {
      to = end != ends.end() && *end < t1 ? (*end++ - t0) / step : 1.0;
      total.add(integrator.sliver(a, b, at, from, to), sign);
    }
  }
}

}  // namespace

FaceIntegrals integrate_face(const TopoDS_Face& face, const Surface& surface) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(forward, place);
  if (triangulation.IsNull()) return {};
  const Integrator integrator(surface, uv_node(*triangulation, 1), breaks_of(forward));
  Sum total;
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    total.add(integrator.triangle(
                  {uv_node(*triangulation, a), uv_node(*triangulation, b), uv_node(*triangulation, c)}),
              1.0);
  }
  for (TopExp_Explorer it(forward, TopAbs_EDGE); it.More(); it.Next())
    add_slivers(TopoDS::Edge(it.Current()), forward, triangulation, place, integrator, total);
  const double side = face.Orientation() == TopAbs_REVERSED ? -1.0 : 1.0;
  const bool plane = std::string_view(surface.kind()) == "plane";
  const double area = plane ? total.vector.norm() : std::abs(total.area);
  return {area, side * total.vector, integrator.origin(), side * total.moment};
}

}  // namespace octet
