// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra around a vertex, each as the base opposite to it, measured four at once.
#include "finalize/star_bases.h"

#include <algorithm>
#include <cmath>

#include "finalize/shape.h"

namespace octet {
namespace {

template <class LaneVec>
LaneVec minus(const Vec3& p, const LaneVec& q) {
  return {p.x() - q[0], p.y() - q[1], p.z() - q[2]};
}

template <class LaneVec>
auto dot(const LaneVec& p, const LaneVec& q) {
  return (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]).eval();
}

template <class LaneVec>
LaneVec cross(const LaneVec& p, const LaneVec& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// Squared length of the cross product.
template <class LaneVec>
auto cross_squared(const LaneVec& p, const LaneVec& q) {
  const LaneVec c = cross(p, q);
  return dot(c, c);
}

template <class Lanes>
double sum_of(const Lanes& p) {
  return (p[0] + p[1]) + (p[2] + p[3]);
}

}  // namespace

void StarBases::clear() { count_ = 0; }

void StarBases::add(const Vec3& x, const Vec3& y, const Vec3& z) {
  const std::size_t number = count_ / kLanes;
  const Eigen::Index lane = static_cast<Eigen::Index>(count_ % kLanes);
  ++count_;
  if (number == blocks_.size()) {
    blocks_.emplace_back();
    shapes_.resize(kLanes * blocks_.size());
  }
  Block& block = blocks_[number];
  for (std::size_t i = 0; i < 3; ++i) {
    block.x[i][lane] = x[static_cast<Eigen::Index>(i)];
    block.y[i][lane] = y[static_cast<Eigen::Index>(i)];
    block.z[i][lane] = z[static_cast<Eigen::Index>(i)];
  }
}

void StarBases::close() {
  for (std::size_t i = 0; kLanes * i < count_; ++i) {
    Block& b = blocks_[i];
    const Eigen::Index used = static_cast<Eigen::Index>(std::min(kLanes, count_ - kLanes * i));
    b.weight.setOnes();
    for (Eigen::Index lane = used; lane < static_cast<Eigen::Index>(kLanes); ++lane) {
      b.weight[lane] = 0.0;
      for (LaneVec* corner : {&b.x, &b.y, &b.z}) {
        for (Lanes& row : *corner) row[lane] = row[0];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      b.xy[k] = b.y[k] - b.x[k];
      b.xz[k] = b.z[k] - b.x[k];
      b.yz[k] = b.z[k] - b.y[k];
    }
    b.normal = cross(b.xy, b.xz);
    b.lxy = dot(b.xy, b.xy);
    b.lxz = dot(b.xz, b.xz);
    b.lyz = dot(b.yz, b.yz);
    b.normal2 = dot(b.normal, b.normal);
  }
}

std::array<Vec3, 3> StarBases::operator[](std::size_t i) const {
  const Block& block = blocks_[i / kLanes];
  const Eigen::Index lane = static_cast<Eigen::Index>(i % kLanes);
  const auto of = [&](const LaneVec& v) -> Vec3 { return {v[0][lane], v[1][lane], v[2][lane]}; };
  return {of(block.x), of(block.y), of(block.z)};
}

StarMeasure StarBases::measure(const Vec3& place, double floor) {
  // The same as `shape` and `distortion`, with one quotient for the angles: the sine at an edge is
  // 6 V |e| / (|n| |m|), so over the common denominator of all four faces each edge has its other two faces.
  constexpr double kTiny = std::numeric_limits<double>::min();  // where faces have no area, nor volume
  constexpr double kRatio = kRatioWeight * 432.0;
  StarMeasure result;
  Lanes total = Lanes::Zero();
  for (std::size_t i = 0; kLanes * i < count_; ++i) {
    const Block& b = blocks_[i];
    const LaneVec px = minus(place, b.x), py = minus(place, b.y), pz = minus(place, b.z);
    const Lanes lpx = dot(px, px), lpy = dot(py, py), lpz = dot(pz, pz), volume = dot(b.normal, px);
    const Lanes nx = cross_squared(b.yz, py), ny = cross_squared(b.xz, px), nz = cross_squared(b.xy, px);
    const Lanes xy = nx * ny, pz_faces = nz * b.normal2;
    const Lanes at_px = (b.lyz * ny).min(b.lxz * nx), at_py = (lpx * nx).min(lpy * ny);
    const Lanes least = ((b.lxy * xy).min(lpz * pz_faces)).min((at_px * nz).min(at_py * b.normal2));
    const Lanes squares = b.lxy + b.lxz + b.lyz + lpx + lpy + lpz, cube = squares * squares * squares;
    const Lanes merit = (least / (xy * pz_faces + kTiny)).min(kRatio / (cube + kTiny));
    const Lanes shape = volume * volume.abs() * merit;
    Eigen::Map<Lanes>(shapes_.data() + kLanes * i) = shape;
    result.worst =
        std::min(result.worst, std::min(std::min(shape[0], shape[1]), std::min(shape[2], shape[3])));
    if (result.worst <= floor) return result;
    total += b.weight * (cube.sqrt() / volume);
  }
  result.distortion = kDistortionUnit * sum_of(total);
  return result;
}

bool StarBases::differentiate(const Vec3& place, Distortion& sum) const {
  LaneVec gradient{Lanes::Zero(), Lanes::Zero(), Lanes::Zero()};
  std::array<Lanes, 6> hessian;
  hessian.fill(Lanes::Zero());
  Lanes total = Lanes::Zero();
  for (std::size_t i = 0; kLanes * i < count_; ++i) {
    const Block& b = blocks_[i];
    const LaneVec px = minus(place, b.x), py = minus(place, b.y), pz = minus(place, b.z);
    const Lanes volume = dot(b.normal, px);
    if (!(volume.minCoeff() > 0.0)) return false;
    const Lanes squares = b.lxy + b.lxz + b.lyz + dot(px, px) + dot(py, py) + dot(pz, pz);
    const Lanes value = b.weight * (squares * squares.sqrt() / volume);
    // As in add_distortion: with s the squares and v the volume, the logarithm's slope is 1.5 s'/s - v'/v.
    const Lanes over_squares = 1.0 / squares, over_volume = 1.0 / volume;
    LaneVec s, v, slope;
    for (std::size_t k = 0; k < 3; ++k) {
      s[k] = (2.0 * over_squares) * (px[k] + py[k] + pz[k]);
      v[k] = b.normal[k] * over_volume;
      slope[k] = 1.5 * s[k] - v[k];
      gradient[k] += value * slope[k];
    }
    total += value;
    std::size_t entry = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Lanes c = value * slope[k], d = -1.5 * value * s[k], e = value * v[k];
      hessian[entry] += 9.0 * over_squares * value;
      for (std::size_t l = k; l < 3; ++l) hessian[entry++] += c * slope[l] + d * s[l] + e * v[l];
    }
  }
  sum.value += kDistortionUnit * sum_of(total);
  int entry = 0;
  for (int k = 0; k < 3; ++k) {
    sum.gradient[k] += kDistortionUnit * sum_of(gradient[static_cast<std::size_t>(k)]);
    for (int l = k; l < 3; ++l) {
      sum.hessian(k, l) += kDistortionUnit * sum_of(hessian[static_cast<std::size_t>(entry++)]);
    }
  }
  return true;
}

double StarBases::mean_length(const Vec3& place) const {
  Lanes total = Lanes::Zero();
  for (std::size_t i = 0; kLanes * i < count_; ++i) {
    const Block& b = blocks_[i];
    const LaneVec px = minus(place, b.x), py = minus(place, b.y), pz = minus(place, b.z);
    total += b.weight * (dot(px, px) + dot(py, py) + dot(pz, pz));
  }
  return std::sqrt(sum_of(total) / (3.0 * static_cast<double>(count_)));
}

}  // namespace octet
