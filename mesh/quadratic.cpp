// SPDX-License-Identifier: BSD-3-Clause
// Bernstein polynomials of degree two (the map) and three (its determinant) over a tetrahedron.
#include "mesh/quadratic.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "mesh/edges.h"
#include "mesh/quality.h"
#include "mesh/tet_mesh.h"

namespace octet {
namespace {

/// The powers of the four barycentric coordinates in each term of degree three; corners first.
using Powers = std::array<std::uint8_t, 4>;

constexpr std::array<Powers, 20> make_powers() {
  std::array<Powers, 20> powers{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) powers[n++][i] = 3;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i != j) {
        powers[n][i] = 2;
        powers[n++][j] = 1;
      }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) powers[n][j] = i == j ? 0 : 1;
    ++n;
  }
  return powers;
}
constexpr std::array<Powers, 20> kPowers = make_powers();

constexpr std::size_t term_of(const Powers& powers) {
  for (std::size_t n = 0; n < kPowers.size(); ++n)
    if (kPowers[n] == powers) return n;
  return kPowers.size();
}

/// The term of the product of three coordinates.
constexpr std::array<std::uint8_t, 64> make_terms() {
  std::array<std::uint8_t, 64> terms{};
  for (std::size_t i = 0; i < 64; ++i) {
    Powers powers{};
    for (const std::size_t of : {i / 16, i / 4 % 4, i % 4}) ++powers[of];
    terms[i] = static_cast<std::uint8_t>(term_of(powers));
  }
  return terms;
}
constexpr std::array<std::uint8_t, 64> kTerms = make_terms();

/// How many ordered products give a term: a corner's one, three of two coordinates, six of three.
constexpr double kOrders[3] = {1.0, 3.0, 6.0};
constexpr double orders(std::size_t term) {
  return term < 4 ? kOrders[0] : term < 16 ? kOrders[1] : kOrders[2];
}

/// Control points of the map, by pairs of corners.
using ControlPoints = std::array<std::array<Vec3, 4>, 4>;

ControlPoints control_points(const QuadraticTet& tet) {
  ControlPoints points;
  for (std::size_t i = 0; i < 4; ++i) points[i][i] = tet[i];
  for (std::size_t e = 0; e < 6; ++e) {
    const auto i = static_cast<std::size_t>(kTetEdge[e][0]), j = static_cast<std::size_t>(kTetEdge[e][1]);
    points[i][j] = points[j][i] = 2.0 * tet[4 + e] - 0.5 * (tet[i] + tet[j]);
  }
  return points;
}

/// The two halves of a form, cut at the middle of the edge i-j: `near_i` has the middle in the place of
/// corner j. De Casteljau's rule along each row of terms that differ in these two powers alone.
struct Halves {
  JacobianForm near_i, near_j;
};

Halves halves(const JacobianForm& form, std::size_t i, std::size_t j) {
  Halves result{form, form};
  for (const Powers& first : kPowers) {
    if (first[j] != 0) continue;  // a row begins where corner j has no power
    const std::size_t degree = first[i];
    std::array<std::size_t, 4> row{};
    std::array<double, 4> value{};
    Powers powers = first;
    for (std::size_t k = 0; k <= degree; ++k) {
      powers[i] = static_cast<std::uint8_t>(degree - k);
      powers[j] = static_cast<std::uint8_t>(k);
      row[k] = term_of(powers);
      value[k] = form.coefficient[row[k]];
    }
    for (std::size_t step = 0; step <= degree; ++step) {
      result.near_i.coefficient[row[step]] = value[0];
      result.near_j.coefficient[row[degree - step]] = value[degree - step];
      for (std::size_t k = 0; k + step < degree; ++k) value[k] = 0.5 * (value[k] + value[k + 1]);
    }
  }
  return result;
}

double least_at_corners(const JacobianForm& form) {
  return *std::min_element(form.coefficient.begin(), form.coefficient.begin() + 4);
}

/// Bounds of one form after another; `known` is a value that the determinant takes.
class LeastSearch {
 public:
  LeastSearch(double known, double accuracy) : known_(known), accuracy_(accuracy) {}

  void visit(const JacobianForm& form, int depth) {
    known_ = std::min(known_, least_at_corners(form));
    const double bound = form.least();
    if (bound >= known_ - accuracy_ || depth == kDeepest) {
      bound_ = std::min(bound_, bound);
      return;
    }
    const auto& edge = kTetEdge[static_cast<std::size_t>(depth) % 6];
    const Halves half = halves(form, static_cast<std::size_t>(edge[0]), static_cast<std::size_t>(edge[1]));
    visit(half.near_i, depth + 1);
    visit(half.near_j, depth + 1);
  }
  [[nodiscard]] double bound() const { return std::min(bound_, known_); }

 private:
  static constexpr int kDeepest = 24;
  double known_, accuracy_;
  double bound_ = std::numeric_limits<double>::infinity();
};

}  // namespace

QuadraticTet quadratic_tet(const Mesh& mesh, std::size_t t) {
  QuadraticTet tet;
  for (std::size_t i = 0; i < 4; ++i) tet[i] = mesh.points[mesh.tets[t][i]];
  for (std::size_t e = 0; e < 6; ++e) tet[4 + e] = mesh.mid.points[mesh.mid.of_tets[t][e]];
  return tet;
}

bool has_straight_edges(const Mesh& mesh, std::size_t t) {
  for (std::size_t e = 0; e < 6; ++e)
    if (mesh.mid.points[mesh.mid.of_tets[t][e]] != middle_of(mesh, tet_edge(mesh, t, e))) return false;
  return true;
}

double quadratic_volume(const Mesh& mesh, std::size_t t) {
  if (!has_straight_edges(mesh, t)) return jacobian_form(quadratic_tet(mesh, t)).volume();
  const auto& v = mesh.tets[t];
  return signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
}

double JacobianForm::least() const { return *std::min_element(coefficient.begin(), coefficient.end()); }
double JacobianForm::largest() const { return *std::max_element(coefficient.begin(), coefficient.end()); }
double JacobianForm::volume() const {
  return std::accumulate(coefficient.begin(), coefficient.end(), 0.0) / 120.0;
}

JacobianForm jacobian_form(const QuadraticTet& tet) {
  const ControlPoints points = control_points(tet);
  std::array<std::array<Vec3, 4>, 3> way;  // derivatives along the edges from corner 0, halved
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 4; ++j) way[k][j] = points[k + 1][j] - points[0][j];
  JacobianForm form;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      const Vec3 normal = way[0][a].cross(way[1][b]);
      for (std::size_t c = 0; c < 4; ++c)
        form.coefficient[kTerms[16 * a + 4 * b + c]] += 8.0 * normal.dot(way[2][c]);
    }
  for (std::size_t n = 0; n < form.coefficient.size(); ++n) form.coefficient[n] /= orders(n);
  return form;
}

double least_jacobian(const JacobianForm& form, double accuracy) {
  LeastSearch search(least_at_corners(form), accuracy);
  search.visit(form, 0);
  return search.bound();
}

double quadratic_area(const Mesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  const auto& m = mesh.mid.of_triangles[t];
  // Seven points: the centre, and three each on the medians. [Dunavant 1985, degree 5]
  constexpr double kRoot15 = 3.872983346207417;
  constexpr double kShare[3] = {1.0 / 3.0, (6.0 - kRoot15) / 21.0, (6.0 + kRoot15) / 21.0};
  constexpr double kWeight[3] = {9.0 / 40.0, (155.0 - kRoot15) / 1200.0, (155.0 + kRoot15) / 1200.0};
  const auto element = [&](double r, double s) {
    const double q = 1.0 - r - s;
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]];
    const Vec3 &ab = mesh.mid.points[m[0]], &bc = mesh.mid.points[m[1]], &ca = mesh.mid.points[m[2]];
    const Vec3 along_r = (1.0 - 4.0 * q) * a + (4.0 * r - 1.0) * b + 4.0 * ((q - r) * ab + s * (bc - ca));
    const Vec3 along_s = (1.0 - 4.0 * q) * a + (4.0 * s - 1.0) * c + 4.0 * ((q - s) * ca + r * (bc - ab));
    return 0.5 * along_r.cross(along_s).norm();
  };
  double area = kWeight[0] * element(kShare[0], kShare[0]);
  for (std::size_t k = 1; k < 3; ++k) {
    const double share = kShare[k], rest = 1.0 - 2.0 * share;
    area += kWeight[k] * (element(share, share) + element(rest, share) + element(share, rest));
  }
  return area;
}

double scaled_jacobian(const JacobianForm& form) {
  const double largest = form.largest();
  return largest > 0.0 ? form.least() / largest : form.least() < 0.0 ? -1.0 : 0.0;
}

}  // namespace octet
