// SPDX-License-Identifier: BSD-3-Clause
// The ways are cut by a plane across them, and an ellipse is laid through the places where they meet it.
#include "octree/tip_section.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace octet {
namespace {

/// Tips are sharp up to these tapers, the lesser one and the other.
constexpr double kSharp = 0.35, kWidest = 1.0;
/// So much narrower one may be than it is wide: flatter ones are no tips, but where faces run out.
constexpr double kFlattest = 0.1;
/// The sides in the plane at the distance 1 from the pole across `along`.
struct Trace {
  Vec3 x, y;
  std::vector<Vec2> places;
  double size = 0.0;  ///< that of the farthest

  Trace(const std::vector<Vec3>& sides, const Vec3& along) : x(along.unitOrthogonal()), y(along.cross(x)) {
    for (const Vec3& side : sides) {
      places.emplace_back(Vec2(side.dot(x), side.dot(y)) / side.dot(along));
      size = std::max(size, places.back().norm());
    }
  }
};

struct Ellipse {
  Vec2 centre, wide;  ///< `wide`: unit
  double a = 0.0, b = 0.0;
};

/// The ellipse on which the places lie: through part of it as well. None where they lie on no ellipse.
std::optional<Ellipse> ellipse_through(const Trace& trace) {
  constexpr double kOff = 0.3;  // of the ellipse
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(trace.places.size()), 6);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Vec2 p = trace.places[static_cast<std::size_t>(i)] / trace.size;
    rows.row(i) << p.x() * p.x(), p.x() * p.y(), p.y() * p.y(), p.x(), p.y(), 1.0;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  const Eigen::VectorXd c = svd.matrixV().col(5);
  Eigen::Matrix2d square;
  square << c[0], 0.5 * c[1], 0.5 * c[1], c[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(square);
  const Vec2 values = solver.eigenvalues();
  if (!(values[0] * values[1] > std::pow(kFlattest, 4) * values.squaredNorm())) return std::nullopt;
  const Vec2 centre = -0.5 * square.inverse() * Vec2(c[3], c[4]);
  const double level = -(c[5] + 0.5 * Vec2(c[3], c[4]).dot(centre));
  if (!(level * values[0] > 0.0)) return std::nullopt;
  const int widest = std::abs(values[0]) < std::abs(values[1]) ? 0 : 1;
  for (const Vec2& place : trace.places) {
    const Vec2 p = place / trace.size - centre;
    if (std::abs(std::sqrt(std::max(0.0, p.dot(square * p) / level)) - 1.0) > kOff) return std::nullopt;
  }
  return Ellipse{trace.size * centre, solver.eigenvectors().col(widest),
                 trace.size * std::sqrt(level / values[widest]),
                 trace.size * std::sqrt(level / values[1 - widest])};
}

/// Whether places go around half of the ellipse. Those of a quarter of a cone do not, nor those of fillets
/// that run out in a point, which gain nothing from a ring.
bool go_around(const Trace& trace, const Ellipse& ellipse) {
  constexpr double kMostGap = 200.0 / 180.0 * std::numbers::pi;
  std::vector<double> angles;
  for (const Vec2& place : trace.places) {
    const Vec2 p = place - ellipse.centre;
    const double x = p.dot(ellipse.wide) / ellipse.a;
    const double y = p.dot(Vec2(-ellipse.wide.y(), ellipse.wide.x())) / ellipse.b;
    angles.push_back(std::atan2(y, x));
  }
  std::sort(angles.begin(), angles.end());
  double most = angles.front() + 2.0 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) most = std::max(most, angles[i] - angles[i - 1]);
  return most <= kMostGap;
}

/// In the box of the places along their principal directions.
Ellipse ellipse_about(const Trace& trace) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : trace.places) mean += p / static_cast<double>(trace.places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& p : trace.places) spread += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix2d ways = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors();
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec2& p : trace.places) {
    low = low.cwiseMin(ways.transpose() * p);
    high = high.cwiseMax(ways.transpose() * p);
  }
  return {ways * (0.5 * (low + high)), ways.col(1), 0.5 * (high - low).y(), 0.5 * (high - low).x()};
}

}  // namespace

void TipSides::add(const Model& model, std::size_t facet, const Vec3& pole) {
  const Facets& facets = model.facets();
  const int face = facets.face[facet];
  const double none = model.tolerance() + model.tolerance_of(model_face(face));
  const std::array<Vec3, 3> corner = facet_corners(facets, facet);
  std::array<double, 3> distance;
  for (int i = 0; i < 3; ++i) distance[i] = (corner[i] - pole).norm();
  length = std::max(length, *std::max_element(distance.begin(), distance.end()));
  const auto nearest = std::min_element(distance.begin(), distance.end()) - distance.begin();
  if (distance[nearest] > none) return;
  const std::array<Vec2, 3>& uv = facets.uv[facet];
  const SurfaceJet jet = model.face_jet(face, uv[nearest], 1);
  const int inwards = jet.du.norm() < jet.dv.norm() ? 1 : 0;
  const Vec2 a = uv[(nearest + 1) % 3], b = uv[(nearest + 2) % 3];
  constexpr int kSteps = 4;
  for (int k = 0; k <= kSteps; ++k) {
    constexpr double kNear = 1.0 / 16.0;  // of a facet's length
    Vec2 at = a + (b - a) * k / kSteps;
    at[inwards] = uv[nearest][inwards] + kNear * (at[inwards] - uv[nearest][inwards]);
    const Vec3 way = model.face_jet(face, at, 0).p - pole;
    if (way.norm() > none) sides.push_back(way.normalized());
  }
}

void TipSides::add(const TipSides& other) {
  length = std::min(length, other.length);
  sides.insert(sides.end(), other.sides.begin(), other.sides.end());
}

Vec3 TipSides::mean() const {
  return std::accumulate(sides.begin(), sides.end(), Vec3(Vec3::Zero())).normalized();
}

bool TipSides::point_as(const TipSides& other) const {
  const auto width = [](const TipSides& of) {
    double most = 0.0;
    for (const Vec3& side : of.sides) most = std::max(most, side.cross(of.mean()).norm());
    return most;
  };
  return mean().dot(other.mean()) > 0.0 &&
         mean().cross(other.mean()).norm() <= 2.0 * std::max(width(*this), width(other));
}

std::optional<TipSection> section_of(const TipSides& sides) {
  constexpr double kRound = 0.9;  // b / a of an ellipse that is taken for a circle
  constexpr int kSteps = 3;  // the middle of a cone's section is on its axis where the plane is across that
  constexpr double kBlunt = 1.5;
  if (sides.sides.empty()) return std::nullopt;
  TipSection section;
  section.along = sides.mean();
  for (int step = 0; step < kSteps; ++step) {
    for (const Vec3& side : sides.sides)
      if (!(side.cross(section.along).norm() < kBlunt * side.dot(section.along))) return std::nullopt;
    const Trace trace(sides.sides, section.along);
    const std::optional<Ellipse> fitted = ellipse_through(trace);
    const Ellipse ellipse = fitted ? *fitted : ellipse_about(trace);
    section.along =
        (section.along + ellipse.centre.x() * trace.x + ellipse.centre.y() * trace.y).normalized();
    const Vec3 wide = ellipse.wide.x() * trace.x + ellipse.wide.y() * trace.y;
    section.across = (wide - wide.dot(section.along) * section.along).normalized();
    section.winds = go_around(trace, ellipse) && ellipse.b >= kFlattest * ellipse.a;
    section.taper = ellipse.a;
    section.lesser_taper = ellipse.b;
  }
  if (section.lesser_taper > kSharp || section.taper > kWidest) return std::nullopt;
  if (section.lesser_taper >= kRound * section.taper) {
    section.across = section.along.unitOrthogonal();
    section.lesser_taper = section.taper;
  }
  return section;
}

}  // namespace octet
