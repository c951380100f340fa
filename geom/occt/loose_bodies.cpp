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
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include "base/vec.h"
#include "geom/occt/canonical.h"

namespace octet {
namespace {

/// The course of an edge, as far as it tells edges apart.
struct Course {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Vec3 middle = Vec3::Zero();  ///< centre of mass
  double length = 0.0;

  [[nodiscard]] bool is(const Course& other, double tolerance) const {
    const auto near = [tolerance](const Vec3& a, const Vec3& b) { return (a - b).norm() <= tolerance; };
    const bool ends =
        (near(from, other.from) && near(to, other.to)) || (near(from, other.to) && near(to, other.from));
    return ends && near(middle, other.middle) && std::abs(length - other.length) <= tolerance;
  }
};

Course course_of(const TopoDS_Edge& edge) {
  TopoDS_Vertex a, b;
  TopExp::Vertices(edge, a, b);
  GProp_GProps properties;
  BRepGProp::LinearProperties(edge, properties);
  Course course;
  course.middle = to_vec(properties.CentreOfMass());
  course.length = properties.Mass();
  course.from = a.IsNull() ? course.middle : to_vec(BRep_Tool::Pnt(a));
  course.to = b.IsNull() ? course.middle : to_vec(BRep_Tool::Pnt(b));
  return course;
}

/// By edge: those along one course have the same number.
std::vector<std::size_t> numbered(const std::vector<Course>& courses, double tolerance) {
  std::vector<std::size_t> order(courses.size()), number(courses.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(number.begin(), number.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return courses[a].middle.x() < courses[b].middle.x();
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i; j-- > 0;) {
      const Course &a = courses[order[i]], &b = courses[order[j]];
      if (a.middle.x() - b.middle.x() > tolerance) break;
      if (!a.is(b, tolerance)) continue;
      number[order[i]] = number[order[j]];
      break;
    }
  return number;
}

}  // namespace

std::vector<std::vector<TopoDS_Shape>> bodies_in_order(const std::vector<TopoDS_Shape>& faces,
                                                       double tolerance) {
  std::vector<Course> courses;
  std::vector<std::size_t> face_of;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (TopExp_Explorer it(faces[f], TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::Degenerated(edge)) continue;
      courses.push_back(course_of(edge));
      face_of.push_back(f);
    }
  const std::vector<std::size_t> number = numbered(courses, tolerance);
  std::vector<std::vector<TopoDS_Shape>> bodies;
  std::set<std::size_t> single;  // numbers met an odd number of times in the body so far
  std::vector<TopoDS_Shape> body;
  for (std::size_t f = 0, e = 0; f < faces.size(); ++f) {
    body.push_back(faces[f]);
    for (; e < courses.size() && face_of[e] == f; ++e)
      if (!single.insert(number[e]).second) single.erase(number[e]);
    if (single.empty()) bodies.push_back(std::exchange(body, {}));
  }
  if (!body.empty() || bodies.size() < 2) return {};
  return bodies;
}

}  // namespace octet
