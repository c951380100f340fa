// SPDX-License-Identifier: BSD-3-Clause
// Feet of samples, by OCCT.
#include "geom/occt/edge_distance.h"

#include <BRepAdaptor_Curve.hxx>
#include <Extrema_ExtPC.hxx>
#include <Standard_Failure.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace octet {
namespace {

constexpr int kEdgeSamples = 16;  // along an edge

double distance_to(const gp_Pnt& point, const BRepAdaptor_Curve& curve) {
  double nearest = std::min(point.Distance(curve.Value(curve.FirstParameter())),
                            point.Distance(curve.Value(curve.LastParameter())));
  const Extrema_ExtPC feet(point, curve);
  if (!feet.IsDone()) return nearest;
  for (int i = 1; i <= feet.NbExt(); ++i) nearest = std::min(nearest, std::sqrt(feet.SquareDistance(i)));
  return nearest;
}

}  // namespace

double edge_distance(const TopoDS_Edge& one, const TopoDS_Edge& other, double enough) {
  double far = 0.0;
  try {
    const BRepAdaptor_Curve a(one), b(other);
    const double first = a.FirstParameter(), last = a.LastParameter();
    for (int i = 1; i < kEdgeSamples && far <= enough; ++i)
      far = std::max(far, distance_to(a.Value(first + (last - first) * i / kEdgeSamples), b));
  } catch (const Standard_Failure&) {
    return std::numeric_limits<double>::infinity();
  }
  return far;
}

}  // namespace octet
