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

template <class T>
auto lift(const Difference<T>& p) {
  return (p.x * p.x + p.y * p.y) + p.z * p.z;
}

// Determinant of the rows (a, |a|^2) .. (d, |d|^2) with its sign changed, expanded along the last column.
template <class T, class M>
auto insphere_determinant(const Difference<T>& a, const Difference<T>& b, const Difference<T>& c,
                          const Difference<T>& d, const M& m) {
  return (lift(a) * m.bcd - lift(b) * m.acd) + (lift(c) * m.abd - lift(d) * m.abc);
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

/// The insphere determinant is linear in the weights of its five points. The coefficient of e's weight is
/// orient3d(a,b,c,d): a heavier e is deeper inside. The determinant changes sign when two of the five points
/// are exchanged, which gives the other coefficients: all five are determinants of differences to e.
template <class T>
std::array<T, 5> weight_coefficients(const Minors<T>& m) {
  const T zero{};
  return {zero - m.bcd, m.acd, zero - m.abd, m.abc, (m.bcd - m.acd) + (m.abd - m.abc)};
}

int sign_of(const std::int64_t& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

template <int N>
int sign_of(const WideInt<N>& x) {
  return x.sign();
}

/// The sign that vanishing weights give (see insphere_ranked). `form_sign` is what the form gives.
template <class T, class FormSign>
int sign_by_rank(const std::array<T, 5>& coefficient, const std::uint64_t rank[5],
                 const FormSign& form_sign) {
  std::array<int, 5> order{0, 1, 2, 3, 4};
  for (int i = 1; i < 5; ++i)
    for (int j = i; j > 0 && rank[order[j]] > rank[order[j - 1]]; --j) std::swap(order[j], order[j - 1]);
  const auto class_of = [&](int k) { return rank[order[k]] >> kRankClassShift; };
  for (int first = 0, end; first < 5; first = end) {
    T sum = coefficient[order[first]];
    for (end = first + 1; end < 5 && class_of(end) == class_of(first); ++end)
      sum = sum + coefficient[order[end]];
    if (const int sign = sign_of(sum); sign != 0) return sign;
  }
  bool free_points = false;
  for (const int i : order) {
    if (!free_points && !is_octree_vertex_rank(rank[i])) {
      free_points = true;
      if (const int sign = form_sign(); sign != 0) return sign;
    }
    if (const int sign = sign_of(coefficient[i]); sign != 0) return sign;
  }
  return 0;
}

/// xy + 2 yz + 3 zx + 2 xx + yy, of which a vanishing multiple is added to the lifts of points that are no
/// octree vertices: no tie on boxes along the axes, nor on such as stand on an edge. Where it decides, octree
/// vertices have no part in it (their coefficients are 0), so that it may be taken from any origin.
template <class T>
auto tie_form(const Difference<T>& p) {
  const auto xy = p.x * p.y, yz = p.y * p.z, zx = p.z * p.x, xx = p.x * p.x, yy = p.y * p.y;
  return ((xy + yz) + (yz + zx)) + ((zx + zx) + (xx + xx)) + yy;
}

/// Exact; ties broken by rank where there are ranks.
int insphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                   const std::uint64_t* rank) {
  return with_exact_width({&a, &b, &c, &d, &e}, [&]<int N>(WideInt<N>, int lowest) {
    const auto origin = exact<N>(e, lowest);
    const auto pa = exact<N>(a, lowest) - origin, pb = exact<N>(b, lowest) - origin,
               pc = exact<N>(c, lowest) - origin, pd = exact<N>(d, lowest) - origin;
    const auto m = minors(pa, pb, pc, pd);
    const int sign = insphere_determinant(pa, pb, pc, pd, m).sign();
    if (sign != 0 || rank == nullptr) return sign;
    return sign_by_rank(weight_coefficients(m), rank, [&] {
      return ((tie_form(pa) * m.bcd - tie_form(pb) * m.acd) + (tie_form(pc) * m.abd - tie_form(pd) * m.abc))
          .sign();
    });
  });
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

// No difference is longer than the longest of the four, which the lifts tell.
int insphere_filtered(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Difference<double> pa = minus(a, e), pb = minus(b, e), pc = minus(c, e), pd = minus(d, e);
  const double det = insphere_determinant(pa, pb, pc, pd, minors(pa, pb, pc, pd));
  const double square = std::max(std::max(lift(pa), lift(pb)), std::max(lift(pc), lift(pd)));
  if (!(square > kSmallest * kSmallest && square < kLargest * kLargest)) return 0;
  if (std::abs(det) <= kInsphereError * (square * square) * std::sqrt(square)) return 0;
  return sign_of(det);
}

int insphere_ranked_exactly(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                            const std::uint64_t rank[5]) {
  return insphere_exact(a, b, c, d, e, rank);
}

int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const int sign = insphere_filtered(a, b, c, d, e);
  return sign != 0 ? sign : insphere_exact(a, b, c, d, e, nullptr);
}

int insphere_ranked(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                    const std::uint64_t rank[5]) {
  const int sign = insphere_filtered(a, b, c, d, e);
  return sign != 0 ? sign : insphere_exact(a, b, c, d, e, rank);
}

int insphere_on_lattice(const std::uint64_t rank[5]) {
  constexpr std::int64_t kFarthest = 1 << 11;  // determinants stay below 2^62
  if (!is_octree_vertex_rank(rank[0] & rank[1] & rank[2] & rank[3] & rank[4])) return 0;
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
  return sign_by_rank(weight_coefficients(m), rank, [] { return 0; });
}

}  // namespace octet
