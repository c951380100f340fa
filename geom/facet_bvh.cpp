// SPDX-License-Identifier: BSD-3-Clause
// Questions to the hierarchy over the facets.
#include "geom/facet_bvh.h"

#include <algorithm>
#include <cmath>

namespace octet {

FacetFoot closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto at = [&](double u, double v, double w) {
    FacetFoot foot;
    foot.point = u * a + v * b + w * c;
    foot.weights = Vec3(u, v, w);
    foot.distance = (p - foot.point).norm();
    return foot;
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return at(1, 0, 0);
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return at(0, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return at(1.0 - v, v, 0);
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return at(0, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return at(1.0 - w, 0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(0, 1.0 - w, w);
  }
  const double sum = va + vb + vc;
  return at(va / sum, vb / sum, vc / sum);
}

FacetBvh::Probe::Probe(const Vec3& from, const Vec3& to)
    : p(from), q(to), box(FloatBox::around({from.cwiseMin(to), from.cwiseMax(to)})) {
  straight = (from.array() != to.array()).count() <= 1;
}

/// Separating axes of a segment and a box that meets the segment's box: the cross products of the segment
/// with the axes [Ericson 2005, 5.3.3].
bool FacetBvh::Probe::crosses(const FloatBox& b) const {
  const Vec3 middle = 0.5 * (p + q), half = 0.5 * (q - p);
  Vec3 c, e;
  for (int k = 0; k < 3; ++k) {
    const double l = b.lo[k], h = b.hi[k];
    e[k] = 0.5 * (h - l);
    c[k] = middle[k] - 0.5 * (l + h);
  }
  const Vec3 a = half.cwiseAbs();
  const double slack = 1e-15 * (a.sum() * (c.cwiseAbs().sum() + e.sum()));
  if (std::abs(c.y() * half.z() - c.z() * half.y()) > e.y() * a.z() + e.z() * a.y() + slack) return false;
  if (std::abs(c.z() * half.x() - c.x() * half.z()) > e.z() * a.x() + e.x() * a.z() + slack) return false;
  return std::abs(c.x() * half.y() - c.y() * half.x()) <= e.x() * a.y() + e.y() * a.x() + slack;
}

/// Separating axes of the segment and the triangle, which has `grow` around it: the normal and, the boxes
/// having told of the axes of space, the cross products of the segment with the sides [Ericson 2005, 5.2.1].
/// The last tell on which side of each side it passes: without them most triangles of a plane with holes are
/// candidates, for these are long and thin, and their boxes cover one another.
bool FacetBvh::meets(const Item& item, const Vec3& p, const Vec3& q) {
  const double hp = item.normal.dot(p - item.a), hq = item.normal.dot(q - item.a);
  if ((hp > item.grow && hq > item.grow) || (hp < -item.grow && hq < -item.grow)) return false;
  const Vec3 d = q - p;
  const auto passes = [&](const Vec3& from, const Vec3& to, const Vec3& opposite) {
    const Vec3 n = d.cross(to - from);
    const double inward = n.dot(opposite - from), at = n.dot(p - from);
    const double side = inward < 0.0 ? -at : at;
    return side < 0.0 && side * side > item.grow * item.grow * n.squaredNorm();
  };
  return !passes(item.a, item.b, item.c) && !passes(item.b, item.c, item.a) &&
         !passes(item.c, item.a, item.b);
}

void FacetBvh::near(const Vec3& p, double max_distance, int face, std::vector<FacetFoot>& feet) const {
  const std::int32_t root = root_of(face);
  if (root < 0) return;
  const std::size_t first = feet.size();
  double reach = max_distance;
  NearStack stack;
  stack.entry[stack.size++] = {root, nodes_[root].squared_distance(p)};
  while (stack.size > 0) {
    const auto [index, d2] = stack.entry[--stack.size];
    if (d2 > reach * reach) continue;
    const Node& node = nodes_[index];
    if (node.second >= 0) {
      stack.push(*this, node, p, reach * reach);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first - node.second; ++i) {
      const Item& item = items_[i];
      if (item.squared_distance(p) > reach * reach || item.height(p) > reach + item.grow) continue;
      const FacetFoot near = foot(item, p);
      if (near.distance > reach + item.grow) continue;
      feet.push_back(near);
      reach = std::min(reach, near.distance + item.grow);
    }
  }
  const auto too_far = [&](const FacetFoot& f) { return f.distance > reach + grow_[f.triangle]; };
  feet.erase(std::remove_if(feet.begin() + static_cast<std::ptrdiff_t>(first), feet.end(), too_far),
             feet.end());
}

FacetFoot FacetBvh::foot(const Item& item, const Vec3& p) {
  FacetFoot near = closest_on_triangle(p, item.a, item.b, item.c);
  near.triangle = item.triangle;
  return near;
}

}  // namespace octet
