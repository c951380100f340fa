// SPDX-License-Identifier: BSD-3-Clause
// Edges get the number of the place they run along; a body ends where each number has been met in pairs.
#include "geom/occt/loose_bodies.h"

#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "geom/occt/canonical.h"

namespace octet {

LooseBodies::LooseBodies(const std::vector<TopoDS_Shape>& faces) : faces_(faces) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (TopExp_Explorer it(faces[f], TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      TopoDS_Vertex a, b;
      TopExp::Vertices(edge, a, b);
      GProp_GProps properties;
      BRepGProp::LinearProperties(edge, properties);
      Course& course = courses_.emplace_back();
      course.face = f;
      course.middle = to_vec(properties.CentreOfMass());
      course.length = properties.Mass();
      course.from = a.IsNull() ? course.middle : to_vec(BRep_Tool::Pnt(a));
      course.to = b.IsNull() ? course.middle : to_vec(BRep_Tool::Pnt(b));
    }
}

bool LooseBodies::Course::is(const Course& other, double tolerance) const {
  const auto near = [tolerance](const Vec3& a, const Vec3& b) { return (a - b).norm() <= tolerance; };
  const bool ends =
      (near(from, other.from) && near(to, other.to)) || (near(from, other.to) && near(to, other.from));
  return ends && near(middle, other.middle) && std::abs(length - other.length) <= tolerance;
}

std::vector<std::size_t> LooseBodies::numbered(double tolerance) const {
  std::vector<std::size_t> order(courses_.size()), number(courses_.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(number.begin(), number.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return courses_[a].middle.x() < courses_[b].middle.x();
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const Course &a = courses_[order[i]], &b = courses_[order[j]];
      if (a.middle.x() - b.middle.x() > tolerance) break;
      if (!a.is(b, tolerance)) continue;
      number[order[i]] = number[order[j]];
      break;
    }
  return number;
}

std::vector<std::vector<TopoDS_Shape>> LooseBodies::in_order(double tolerance) const {
  const std::vector<std::size_t> number = numbered(tolerance);
  std::vector<std::vector<TopoDS_Shape>> bodies;
  std::set<std::size_t> single;  // numbers met an odd number of times in the body so far
  std::vector<TopoDS_Shape> body;
  for (std::size_t f = 0, e = 0; f < faces_.size(); ++f) {
    body.push_back(faces_[f]);
    for (; e < courses_.size() && courses_[e].face == f; ++e)
      if (!single.insert(number[e]).second) single.erase(number[e]);
    if (single.empty()) bodies.push_back(std::exchange(body, {}));
  }
  if (!body.empty() || bodies.size() < 2) return {};
  return bodies;
}

}  // namespace octet
