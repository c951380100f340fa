// SPDX-License-Identifier: BSD-3-Clause
// Trims of simple shape.
#include "geom/uv_trims.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace octet {
namespace {

/// `depth`: distance inside the border, negative outside.
TrimSide by_depth(double depth, double tolerance) {
  if (depth > tolerance) return TrimSide::kIn;
  return depth < -tolerance ? TrimSide::kOut : TrimSide::kOn;
}

class WholeTrim final : public Trim {
 public:
  TrimSide side(const Vec2&) const override { return TrimSide::kIn; }
};

class BandTrim final : public Trim {
 public:
  BandTrim(double v0, double v1, double tolerance) : v0_(v0), v1_(v1), tolerance_(tolerance) {}
  TrimSide side(const Vec2& uv) const override {
    return by_depth(std::min(uv.y() - v0_, v1_ - uv.y()), tolerance_);
  }

 private:
  double v0_, v1_, tolerance_;
};

class DiscTrim final : public Trim {
 public:
  DiscTrim(const Vec2& centre, double radius, double tolerance)
      : centre_(centre), radius_(radius), tolerance_(tolerance) {}
  TrimSide side(const Vec2& uv) const override {
    return by_depth(radius_ - (uv - centre_).norm(), tolerance_);
  }

 private:
  Vec2 centre_;
  double radius_, tolerance_;
};

class PolygonTrim final : public Trim {
 public:
  PolygonTrim(std::vector<Vec2> corners, double tolerance)
      : corners_(std::move(corners)), tolerance_(tolerance) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2 d = (corners_[(i + 1) % corners_.size()] - corners_[i]).normalized();
      inward_.emplace_back(-d.y(), d.x());
    }
  }
  TrimSide side(const Vec2& uv) const override {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      depth = std::min(depth, (uv - corners_[i]).dot(inward_[i]));
    return by_depth(depth, tolerance_);
  }

 private:
  std::vector<Vec2> corners_, inward_;
  double tolerance_;
};

}  // namespace

std::shared_ptr<const Trim> make_whole_trim() { return std::make_shared<WholeTrim>(); }

std::shared_ptr<const Trim> make_band_trim(double v0, double v1, double tolerance) {
  return std::make_shared<BandTrim>(v0, v1, tolerance);
}

std::shared_ptr<const Trim> make_disc_trim(const Vec2& centre, double radius, double tolerance) {
  return std::make_shared<DiscTrim>(centre, radius, tolerance);
}

std::shared_ptr<const Trim> make_polygon_trim(std::vector<Vec2> corners, double tolerance) {
  return std::make_shared<PolygonTrim>(std::move(corners), tolerance);
}

}  // namespace octet
