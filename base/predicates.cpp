// SPDX-License-Identifier: BSD-3-Clause
// Exact geometric signs: a filter in doubles, then integers as wide as the input needs.
//
// Differences of doubles are integers times a common power of two, so the determinants are exact in integers
// of five times their width. Points of ordinary parts differ by less than 2^62 units of their last place and
// need one limb a difference (some 0.1 microseconds); the widest case holds every finite double. Expansion
// arithmetic [Shewchuk 1997] was the other choice: it is slower for the cospherical points that octrees and
// mirrored sheets are full of, and it fails on underflow.
#include "base/predicates.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>

#include "base/exact_difference.h"
#include "base/vertex_order.h"

namespace octet {
namespace {

constexpr double kUnit = 0x1p-53;  // half an ulp of 1

// First-order error of orient_determinant(): 6 products of three differences, each with 8 roundings.
constexpr double kOrientError = 52 * kUnit;
// Of insphere_determinant(): 72 products of five differences, each with 17 roundings.
constexpr double kInsphereError = 1300 * kUnit;
// Differences in this range make no product that over- or underflows.
constexpr double kSmallest = 1e-55, kLargest = 1e60;

struct Extents {
  double x, y, z;
};

template <class T>
auto orient_determinant(const Difference<T>& b, const Difference<T>& c, const Difference<T>& d) {
  const auto bc = b.x * c.y - b.y * c.x;
  const auto cd = c.x * d.y - c.y * d.x;
  const auto bd = b.x * d.y - b.y * d.x;
  return (bc * d.z - bd * c.z) + cd * b.z;
}

// Determinants of three of the rows a, b, c, d.
template <class T>
struct Minors {
  T abc, abd, acd, bcd;
};

template <class T>
auto minors(const Difference<T>& a, const Difference<T>& b, const Difference<T>& c, const Difference<T>& d) {
  const auto ab = a.x * b.y - a.y * b.x;
  const auto ac = a.x * c.y - a.y * c.x;
  const auto ad = a.x * d.y - a.y * d.x;
  const auto bc = b.x * c.y - b.y * c.x;
  const auto bd = b.x * d.y - b.y * d.x;
  const auto cd = c.x * d.y - c.y * d.x;
  const auto abc = (bc * a.z - ac * b.z) + ab * c.z;
  const auto abd = (bd * a.z - ad * b.z) + ab * d.z;
  const auto acd = (cd * a.z - ad * c.z) + ac * d.z;
  const auto bcd = (cd * b.z - bd * c.z) + bc * d.z;
  return Minors<std::remove_const_t<decltype(abc)>>{abc, abd, acd, bcd};
}

// Determinant of the rows (a, |a|^2) .. (d, |d|^2) with its sign changed, expanded along the last column.
template <class T, class M>
auto insphere_determinant(const Difference<T>& a, const Difference<T>& b, const Difference<T>& c,
                          const Difference<T>& d, const M& m) {
  const auto lift = [](const Difference<T>& p) { return (p.x * p.x + p.y * p.y) + p.z * p.z; };
  return (lift(a) * m.bcd - lift(b) * m.acd) + (lift(c) * m.abd - lift(d) * m.abc);
}

template <class T>
auto insphere_determinant(const Difference<T>& a, const Difference<T>& b, const Difference<T>& c,
                          const Difference<T>& d) {
  return insphere_determinant(a, b, c, d, minors(a, b, c, d));
}

Difference<double> minus(const Vec3& a, const Vec3& b) {
  return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}

template <std::size_t N>
double largest(const std::array<Difference<double>, N>& rows, double Difference<double>::*axis) {
  double m = 0;
  for (const auto& r : rows) m = std::max(m, std::abs(r.*axis));
  return m;
}

// Extents of the differences along the axes: what the filters measure errors by.
template <std::size_t N>
Extents extents(const std::array<Difference<double>, N>& rows) {
  return {largest(rows, &Difference<double>::x), largest(rows, &Difference<double>::y),
          largest(rows, &Difference<double>::z)};
}

bool flat(const Extents& m) { return m.x == 0 || m.y == 0 || m.z == 0; }

bool in_range(const Extents& m) {
  return std::min({m.x, m.y, m.z}) > kSmallest && std::max({m.x, m.y, m.z}) < kLargest;
}

int sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return with_exact_width({&a, &b, &c, &d}, [&]<int N>(WideInt<N>, int lowest) {
    return orient_determinant(exact_minus<N>(b, a, lowest), exact_minus<N>(c, a, lowest),
                              exact_minus<N>(d, a, lowest))
        .sign();
  });
}

int insphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return with_exact_width({&a, &b, &c, &d, &e}, [&]<int N>(WideInt<N>, int lowest) {
    return insphere_determinant(exact_minus<N>(a, e, lowest), exact_minus<N>(b, e, lowest),
                                exact_minus<N>(c, e, lowest), exact_minus<N>(d, e, lowest))
        .sign();
  });
}

using Four = std::array<const Vec3*, 4>;
using Five = std::array<const Vec3*, 5>;

// The insphere determinant is linear in the weights of its five points. The coefficient of e's weight is
// orient3d(a,b,c,d): a heavier e is deeper inside. The determinant changes sign when two of the five points
// are exchanged, which gives the other four coefficients: minus that orient3d with e in the place of point i.
Four without(const Five& p, int i) {
  Four q{p[0], p[1], p[2], p[3]};
  if (i < 4) q[i] = p[4];
  return q;
}

// Sign of the coefficient of point i's weight.
int weight_sign(const Five& p, int i) {
  const Four q = without(p, i);
  const int sign = orient3d(*q[0], *q[1], *q[2], *q[3]);
  return i < 4 ? -sign : sign;
}

// Sign of the sum of the coefficients of points i and j.
int weight_sign(const Five& p, int i, int j) {
  const Four q = without(p, i), r = without(p, j);
  double sum = 0, size = 0;
  bool filtered = true;
  for (const auto& [f, negative] : {std::pair{q, i < 4}, std::pair{r, j < 4}}) {
    const std::array<Difference<double>, 3> rows{minus(*f[1], *f[0]), minus(*f[2], *f[0]),
                                                 minus(*f[3], *f[0])};
    const Extents m = extents(rows);
    const double det = orient_determinant(rows[0], rows[1], rows[2]);
    sum += negative ? -det : det;
    size += m.x * m.y * m.z;
    filtered = filtered && (flat(m) || in_range(m));
  }
  if (filtered && std::abs(sum) > 1.1 * kOrientError * size) return sign_of(sum);
  return with_exact_width({p[0], p[1], p[2], p[3], p[4]}, [&]<int N>(WideInt<N>, int lowest) {
    const auto exact = [&](const Four& f, bool negative) {
      const auto b = exact_minus<N>(*f[1], *f[0], lowest), c = exact_minus<N>(*f[2], *f[0], lowest),
                 d = exact_minus<N>(*f[3], *f[0], lowest);
      return negative ? orient_determinant(c, b, d) : orient_determinant(b, c, d);
    };
    return (exact(q, i < 4) + exact(r, j < 4)).sign();
  });
}

// Sign of the sum of the coefficients of points order[first..end). All five sum to zero: equal weights change
// nothing, and three or four points are minus the others.
int class_sign(const Five& p, const std::array<int, 5>& order, int first, int end) {
  int rest[5], n = 0;
  for (int k = 0; k < 5; ++k) {
    if (k < first || k >= end) rest[n++] = order[k];
  }
  switch (end - first) {
    case 1:
      return weight_sign(p, order[first]);
    case 2:
      return weight_sign(p, order[first], order[first + 1]);
    case 3:
      return -weight_sign(p, rest[0], rest[1]);
    case 4:
      return -weight_sign(p, rest[0]);
    default:
      return 0;
  }
}

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<Difference<double>, 3> rows{minus(b, a), minus(c, a), minus(d, a)};
  const Extents m = extents(rows);
  if (flat(m)) return 0;
  if (in_range(m)) {
    const double det = orient_determinant(rows[0], rows[1], rows[2]);
    if (std::abs(det) > kOrientError * (m.x * m.y * m.z)) return sign_of(det);
  }
  return orient3d_exact(a, b, c, d);
}

int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const std::array<Difference<double>, 4> rows{minus(a, e), minus(b, e), minus(c, e), minus(d, e)};
  const Extents m = extents(rows);
  if (flat(m)) return 0;
  if (in_range(m)) {
    const double det = insphere_determinant(rows[0], rows[1], rows[2], rows[3]);
    const double top = std::max({m.x, m.y, m.z});
    if (std::abs(det) > kInsphereError * (m.x * m.y * m.z) * (top * top)) return sign_of(det);
  }
  return insphere_exact(a, b, c, d, e);
}

int insphere_by_rank(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                     const std::uint64_t rank[5]) {
  const Five points{&a, &b, &c, &d, &e};
  std::array<int, 5> order{0, 1, 2, 3, 4};  // the heaviest first
  std::sort(order.begin(), order.end(), [&](int i, int j) { return rank[i] > rank[j]; });
  const auto class_of = [&](int k) { return rank[order[k]] >> kRankClassShift; };
  for (int first = 0, end; first < 5; first = end) {
    for (end = first + 1; end < 5 && class_of(end) == class_of(first);) ++end;
    const int sign = class_sign(points, order, first, end);
    if (sign != 0) return sign;
  }
  for (const int i : order) {
    const int sign = weight_sign(points, i);
    if (sign != 0) return sign;
  }
  return 0;
}

int insphere_on_lattice(const std::uint64_t rank[5]) {
  constexpr std::int64_t kFarthest = 1 << 11;  // determinants stay below 2^62
  if ((rank[0] & rank[1] & rank[2] & rank[3] & rank[4]) >> 63 == 0) return 0;
  std::array<Difference<std::int64_t>, 4> rows;
  const auto e = octree_vertex_lattice(rank[4]);
  std::int64_t any = 0;
  for (int i = 0; i < 4; ++i) {
    const auto p = octree_vertex_lattice(rank[i]);
    rows[i] = {std::int64_t{p[0]} - e[0], std::int64_t{p[1]} - e[1], std::int64_t{p[2]} - e[2]};
    any |= rows[i].x | rows[i].y | rows[i].z;
  }
  const int shift = std::countr_zero(static_cast<std::uint64_t>(any));
  std::int64_t farthest = 0;
  for (auto& r : rows) {
    for (std::int64_t* x : {&r.x, &r.y, &r.z}) {
      *x >>= shift;
      farthest = std::max(farthest, *x < 0 ? -*x : *x);
    }
  }
  if (farthest >= kFarthest) return 0;
  const auto& [a, b, c, d] = rows;
  const auto m = minors(a, b, c, d);
  const std::int64_t sphere = insphere_determinant(a, b, c, d, m);
  if (sphere != 0) return sphere > 0 ? 1 : -1;
  // The coefficients of the five weights, as in weight_sign(): orient3d(a,b,c,e) is -abc.
  const std::array<std::int64_t, 5> weight{-m.bcd, m.acd, -m.abd, m.abc, m.bcd - m.acd + m.abd - m.abc};
  std::array<int, 5> order{0, 1, 2, 3, 4};  // the heaviest first
  std::sort(order.begin(), order.end(), [&](int i, int j) { return rank[i] > rank[j]; });
  for (int first = 0, end; first < 5; first = end) {
    std::int64_t sum = 0;
    for (end = first;
         end < 5 && rank[order[end]] >> kRankClassShift == rank[order[first]] >> kRankClassShift;)
      sum += weight[order[end++]];
    if (sum != 0) return sum > 0 ? 1 : -1;
  }
  for (const int i : order) {
    if (weight[i] != 0) return weight[i] > 0 ? 1 : -1;
  }
  return 0;
}

int insphere_ranked(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                    const std::uint64_t rank[5]) {
  const int sign = insphere(a, b, c, d, e);
  return sign != 0 ? sign : insphere_by_rank(a, b, c, d, e, rank);
}

}  // namespace octet
