// SPDX-License-Identifier: BSD-3-Clause
// Areas by triangles about one direction, frames by trial of many directions.
#include "geom/occt/sphere_loops.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.h"

namespace octet {
namespace {

constexpr double kSphere = 4.0 * kPi;
constexpr int kBins = 720;  // of azimuth

using Bins = std::array<bool, kBins>;

int bin_of(double azimuth) {
  const double turns = azimuth / (2.0 * kPi);
  return static_cast<int>(kBins * (turns - std::floor(turns))) % kBins;
}

/// Two directions that make a right-handed frame with `up`.
struct Azimuths {
  Vec3 x, y;
  explicit Azimuths(const Vec3& up) {
    x = up.unitOrthogonal();
    y = up.cross(x);
  }
  [[nodiscard]] double of(const Vec3& d) const { return std::atan2(d.dot(y), d.dot(x)); }
};

/// By how far the azimuth goes on, the shorter way.
double turn(double from, double to) { return std::remainder(to - from, 2.0 * kPi); }

template <class Visit>
void for_pieces(const SphereLoop& loop, const Visit& visit) {
  for (const SphereSide& side : loop)
    for (std::size_t i = 1; i < side.at.size(); ++i) visit(side.at[i - 1], side.at[i]);
}

int winding(const SphereLoop& loop, const Azimuths& azimuths) {
  double all = 0.0;
  for_pieces(loop, [&](const Vec3& a, const Vec3& b) { all += turn(azimuths.of(a), azimuths.of(b)); });
  return static_cast<int>(std::lround(all / (2.0 * kPi)));
}

/// Whether a place off the loops lies to the left of the nearest of them.
bool is_left(const std::vector<SphereLoop>& loops, const Vec3& place) {
  double nearest = -2.0;
  Vec3 left = Vec3::Zero();
  for (const SphereLoop& loop : loops) {
    std::vector<Vec3> points;
    for (const SphereSide& side : loop) points.insert(points.end(), side.at.begin(), side.at.end() - 1);
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& p = points[i];
      if (p.dot(place) <= nearest) continue;
      nearest = p.dot(place);
      const Vec3& before = points[(i + n - 1) % n];
      const Vec3& after = points[(i + 1) % n];
      left = p.cross(p - before).normalized() + p.cross(after - p).normalized();
    }
  }
  return left.dot(place) > 0.0;
}

void cover(const SphereLoop& loop, const Azimuths& azimuths, Bins& covered) {
  for_pieces(loop, [&](const Vec3& a, const Vec3& b) {
    const double from = azimuths.of(a), way = turn(from, azimuths.of(b));
    const int steps = 1 + static_cast<int>(std::abs(way) * kBins / kPi);
    for (int i = 0; i <= steps; ++i) covered[bin_of(from + way * i / steps)] = true;
  });
}

/// Middle of the widest range of azimuths that nothing covers, and half its width.
std::pair<double, double> widest_gap(const Bins& covered) {
  int best = 0, best_end = 0, run = 0;
  for (int i = 0; i < 2 * kBins; ++i) {
    run = covered[i % kBins] ? 0 : std::min(run + 1, kBins);
    if (run > best) {
      best = run;
      best_end = i;
    }
  }
  const double width = 2.0 * kPi / kBins;
  return {(best_end + 1 - 0.5 * best) * width, 0.5 * best * width};
}

/// Whether the meridian from the start of a side of the ring down to the pole meets no other place of it.
bool is_clear_below(const SphereLoop& ring, std::size_t side, const Vec3& up, const Azimuths& azimuths) {
  constexpr double kSame = 1e-6;
  const Vec3& start = ring[side].at.front();
  const double azimuth = azimuths.of(start), height = start.dot(up);
  bool clear = true;
  for_pieces(ring, [&](const Vec3& a, const Vec3& b) {
    if ((a - start).norm() < kSame || (b - start).norm() < kSame) return;
    const double to_a = turn(azimuth, azimuths.of(a)), to_b = turn(azimuth, azimuths.of(b));
    const bool passes = to_a * to_b <= 0.0 && std::abs(to_a) + std::abs(to_b) < kPi;
    if (passes && std::min(a.dot(up), b.dot(up)) < height + kSame) clear = false;
  });
  return clear;
}

/// Sets the meridian to cut along; false where there is none.
bool find_cut(const std::vector<SphereLoop>& loops, const Azimuths& azimuths, SphereFrame& frame) {
  Bins covered{};
  for (std::size_t j = 0; j < loops.size(); ++j)
    if (static_cast<int>(j) != frame.ring) cover(loops[j], azimuths, covered);
  if (frame.ring < 0) {
    const auto [middle, half] = widest_gap(covered);
    frame.across = std::cos(middle) * azimuths.x + std::sin(middle) * azimuths.y;
    frame.clearance = std::min(frame.clearance, half);
    return true;
  }
  const SphereLoop& ring = loops[static_cast<std::size_t>(frame.ring)];
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double azimuth = azimuths.of(ring[k].at.front());
    const int bin = bin_of(azimuth);
    if (covered[bin] || covered[(bin + 1) % kBins] || covered[(bin + kBins - 1) % kBins]) continue;
    if (!is_clear_below(ring, k, frame.up, azimuths)) continue;
    frame.start = k;
    frame.across = std::cos(azimuth) * azimuths.x + std::sin(azimuth) * azimuths.y;
    return true;
  }
  return false;
}

/// The frame with this direction up, if there is a clearer one than `least` about it.
std::optional<SphereFrame> frame_about(const std::vector<SphereLoop>& loops, const Vec3& up, double least) {
  double nearest = 0.0;
  for (const SphereLoop& loop : loops)
    for (const SphereSide& side : loop)
      for (const Vec3& p : side.at) nearest = std::max(nearest, std::abs(up.dot(p)));
  SphereFrame frame{up, Vec3::Zero(), -1, 0, std::acos(std::min(nearest, 1.0))};
  if (frame.clearance <= least) return {};
  const Azimuths azimuths(up);
  for (std::size_t j = 0; j < loops.size(); ++j) {
    const int turns = winding(loops[j], azimuths);
    if (turns == 0) continue;
    if (turns != -1 || frame.ring >= 0) return {};
    frame.ring = static_cast<int>(j);
  }
  if (!is_left(loops, -up) || (frame.ring < 0 && !is_left(loops, up))) return {};
  if (!find_cut(loops, azimuths, frame) || frame.clearance <= least) return {};
  return frame;
}

}  // namespace

double left_area(const SphereLoop& loop) {
  Vec3 about = Vec3::Zero();
  for_pieces(loop, [&](const Vec3& a, const Vec3& b) { about += a.cross(b); });
  about = about.norm() > 1e-12 ? Vec3(about.normalized()) : Vec3(Vec3::UnitZ());
  double area = 0.0;  // of triangles, by the tangent of half of it
  for_pieces(loop, [&](const Vec3& a, const Vec3& b) {
    area += 2.0 * std::atan2(about.dot(a.cross(b)), 1.0 + about.dot(a) + a.dot(b) + b.dot(about));
  });
  return area - kSphere * std::floor(area / kSphere);
}

double area_between(const std::vector<SphereLoop>& loops) {
  double area = kSphere;
  for (const SphereLoop& loop : loops) area -= kSphere - left_area(loop);
  return area;
}

std::optional<SphereFrame> clear_frame(const std::vector<SphereLoop>& loops) {
  constexpr int kTried = 1500;
  constexpr double kLeast = 0.01;
  const double golden = kPi * (3.0 - std::sqrt(5.0));
  std::optional<SphereFrame> best;
  for (int i = 0; i < kTried; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kTried, r = std::sqrt(1.0 - z * z);
    const Vec3 up(r * std::cos(golden * i), r * std::sin(golden * i), z);
    const auto frame = frame_about(loops, up, best ? best->clearance : kLeast);
    if (frame) best = frame;
  }
  return best;
}

}  // namespace octet
