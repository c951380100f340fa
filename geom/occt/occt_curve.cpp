// SPDX-License-Identifier: BSD-3-Clause
// A curve without closed form: B-spline, Bezier, hyperbola, parabola, offset.
#include "geom/occt/occt_curve.h"

#include <algorithm>
#include <cmath>

#include "base/segment.h"
#include "base/sort_unique.h"
#include "geom/occt/curve_jets.h"

namespace octet {
namespace {

constexpr double kChordTurnMost = 0.15;  // sample chords turn less than this, radians
constexpr int kMinPieces = 8;            // per knot span
constexpr int kMaxPieceBisections = 10;  // of a piece
constexpr int kRootIterations = 60;      // bisections halve to the last bit
constexpr double kNoExtent = 1e-13;      // of the coordinates: a planar curve's rounding
constexpr std::size_t kBlock = 8;        // pieces that share a box

class OcctCurve final : public Curve {
 public:
  OcctCurve(CurveJets jets, double t0, double t1) : jets_(std::move(jets)), t0_(t0), t1_(t1) {
    const std::vector<double> breaks = this->breaks();
    sample_t_.push_back(t0);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      for (int k = 0; k < kMinPieces; ++k) {
        const double step = (breaks[i + 1] - breaks[i]) / kMinPieces;
        const double a = breaks[i] + k * step;
        sample(a, k + 1 == kMinPieces ? breaks[i + 1] : a + step, 0);
      }
    for (const double t : sample_t_) sample_.push_back(point(t));
    for (const Vec3& p : sample_) box_.add(p);
    scale_ = box_.lo.cwiseAbs().cwiseMax(box_.hi.cwiseAbs()).maxCoeff();
    for (std::size_t begin = 0; begin + 1 < sample_.size(); begin += kBlock) {
      Block block;
      for (std::size_t i = begin; i <= end_of(begin); ++i) {
        block.samples.add(sample_[i]);
        if (i > begin)
          block.bulge = std::max(block.bulge, kChordTurnMost * (sample_[i] - sample_[i - 1]).norm());
      }
      blocks_.push_back(block);
    }
  }

  Vec3 point(double t) const override { return jets_.evaluate(t, 0).p; }
  Vec3 derivative(double t) const override { return jets_.evaluate(t, 1).d1; }
  double project(const Vec3& p, double hint) const override;
  void cut(const Vec3& normal, double offset, std::vector<double>& parameters) const override;
  std::vector<double> breaks() const override;
  const char* kind() const override { return "free"; }

 private:
  /// Pieces kBlock k to kBlock (k + 1); neighbours share a sample.
  struct Block {
    Box3 samples;
    double bulge = 0.0;  ///< of the curve beyond the box
  };

  [[nodiscard]] std::size_t end_of(std::size_t begin) const {
    return std::min(begin + kBlock, sample_.size() - 1);
  }
  void sample(double a, double b, int depth);
  struct Nearest {
    double distance, t;
  };
  [[nodiscard]] Nearest refine_piece(std::size_t piece, const Vec3& p, double hint) const;
  [[nodiscard]] double refine(const Vec3& p, double t, double lo, double hi) const;
  [[nodiscard]] bool lies_in_plane(const Vec3& normal) const;
  [[nodiscard]] double root(const Vec3& normal, double offset, double a, double b) const;
  void cut_piece(const Vec3& normal, double offset, double a, double b,
                 std::vector<double>& parameters) const;

  CurveJets jets_;
  double t0_, t1_;
  Box3 box_;
  double scale_ = 0.0;
  std::vector<double> sample_t_;
  std::vector<Vec3> sample_;
  std::vector<Block> blocks_;
};

std::vector<double> OcctCurve::breaks() const {
  std::vector<double> breaks = {t0_, t1_};
  const double period = jets_.period(), nearly = 1e-9 * (t1_ - t0_);
  for (const double knot : jets_.knots()) {
    double k = period > 0.0 ? knot + period * std::ceil((t0_ - knot) / period) : knot;
    for (; k < t1_ - nearly; k += period) {
      if (k > t0_ + nearly) breaks.push_back(k);
      if (period <= 0.0) break;
    }
  }
  sort_unique(breaks);
  return breaks;
}

void OcctCurve::sample(double a, double b, int depth) {
  const Vec3 da = derivative(a), db = derivative(b);
  const double turn = std::atan2(da.cross(db).norm(), da.dot(db));
  if (turn > kChordTurnMost && depth < kMaxPieceBisections) {
    sample(a, 0.5 * (a + b), depth + 1);
    sample(0.5 * (a + b), b, depth + 1);
    return;
  }
  sample_t_.push_back(b);
}

/// Nearest point of the curve on [lo, hi]: Newton on the derivative of the distance, safeguarded by
/// bisection.
double OcctCurve::refine(const Vec3& p, double t, double lo, double hi) const {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const CurveJet at = jets_.evaluate(t, 2);
    const Vec3 r = at.p - p, &d = at.d1;
    const double slope = r.dot(d), bend = d.squaredNorm() + r.dot(at.d2);
    if (slope > 0.0) {
      hi = t;
    } else {
      lo = t;
    }
    double next = bend > 0.0 ? t - slope / bend : 0.5 * (lo + hi);
    if (!(next >= lo && next <= hi)) next = 0.5 * (lo + hi);
    const double moved = std::abs(next - t);
    t = next;
    if (moved * d.norm() <= 1e-15 * scale_ || hi - lo <= 1e-16 * std::abs(t)) break;
  }
  return t;
}

// Samples are no measure: a branch that bends has them close together, one that runs straight has few, and
// the nearest may be of the wrong one.
double OcctCurve::project(const Vec3& p, double hint) const {
  const auto chord_distance = [&](std::size_t i) {
    return distance_to_segment(p, sample_[i], sample_[i + 1]);
  };
  const auto bulge = [&](std::size_t i) { return kChordTurnMost * (sample_[i + 1] - sample_[i]).norm(); };
  const auto above = std::upper_bound(sample_t_.begin() + 1, sample_t_.end() - 1, hint);
  const std::size_t own =
      std::min(static_cast<std::size_t>(above - sample_t_.begin()) - 1, sample_.size() - 2);
  std::size_t first = own;
  double least = chord_distance(own);
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    if (blocks_[block].samples.squared_distance(p) >= least * least) continue;
    for (std::size_t i = kBlock * block; i < end_of(kBlock * block); ++i) {
      const double distance = chord_distance(i);
      if (distance >= least) continue;
      least = distance;
      first = i;
    }
  }
  Nearest nearest = refine_piece(first, p, hint);
  const auto reaches = [&](std::size_t i) { return chord_distance(i) <= nearest.distance + bulge(i); };
  // The hint's own piece wins ties on the curve, so that equal branches keep the caller's. Off the curve a
  // distance to rounding leaves the foot much room, and the nearer one counts.
  const double rounding = 1e-13 * scale_;
  if (own != first && reaches(own)) {
    const Nearest other = refine_piece(own, p, hint);
    if (other.distance <= std::max(nearest.distance, rounding)) nearest = other;
  }
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const double reach = nearest.distance + blocks_[block].bulge;
    if (blocks_[block].samples.squared_distance(p) > reach * reach) continue;
    for (std::size_t i = kBlock * block; i < end_of(kBlock * block); ++i) {
      if (i == first || i == own || !reaches(i)) continue;
      const Nearest other = refine_piece(i, p, hint);
      if (other.distance < nearest.distance && nearest.distance > rounding) nearest = other;
    }
  }
  return nearest.t;
}

/// The nearest point between a sample and the next.
OcctCurve::Nearest OcctCurve::refine_piece(std::size_t piece, const Vec3& p, double hint) const {
  const double lo = sample_t_[piece], hi = sample_t_[piece + 1];
  const Vec3 chord = sample_[piece + 1] - sample_[piece];
  const double squared = chord.squaredNorm();
  const double share = squared > 0.0 ? (p - sample_[piece]).dot(chord) / squared : 0.5;
  const bool hint_inside = hint >= lo && hint <= hi;
  const double start = hint_inside ? hint : lo + std::clamp(share, 0.0, 1.0) * (hi - lo);
  const double t = std::clamp(refine(p, start, lo, hi), lo, hi);
  Nearest nearest{(point(t) - p).norm(), t};
  for (const std::size_t end : {piece, piece + 1}) {
    const double distance = (sample_[end] - p).norm();
    if (distance < nearest.distance) nearest = {distance, sample_t_[end]};
  }
  return nearest;
}

double OcctCurve::root(const Vec3& normal, double offset, double a, double b) const {
  double fa = point(a).dot(normal) - offset;
  double t = 0.5 * (a + b);
  for (int iteration = 0; iteration < kRootIterations; ++iteration) {
    const CurveJet at = jets_.evaluate(t, 1);
    const double f = at.p.dot(normal) - offset, slope = at.d1.dot(normal);
    if (f == 0.0) return t;
    if ((f > 0.0) == (fa > 0.0)) {
      a = t;
      fa = f;
    } else {
      b = t;
    }
    double next = slope != 0.0 ? t - f / slope : 0.5 * (a + b);
    if (!(next > std::min(a, b) && next < std::max(a, b))) next = 0.5 * (a + b);
    if (next == t) return t;
    t = next;
  }
  return t;
}

/// Or in a parallel one.
bool OcctCurve::lies_in_plane(const Vec3& normal) const {
  const double height = sample_.front().dot(normal);
  return std::all_of(sample_.begin(), sample_.end(),
                     [&](const Vec3& p) { return std::abs(p.dot(normal) - height) <= kNoExtent * scale_; });
}

/// A piece turns little: at most one extremum of the height, found where its derivative changes sign.
void OcctCurve::cut_piece(const Vec3& normal, double offset, double a, double b,
                          std::vector<double>& parameters) const {
  const double fa = point(a).dot(normal) - offset, fb = point(b).dot(normal) - offset;
  if (fa == 0.0) parameters.push_back(a);
  if (fb == 0.0 && b == t1_) parameters.push_back(b);
  if (fa == 0.0 || fb == 0.0) return;
  if ((fa > 0.0) != (fb > 0.0)) {
    parameters.push_back(root(normal, offset, a, b));
    return;
  }
  double lo = a, hi = b;
  const double slope_a = derivative(a).dot(normal);
  if (slope_a * derivative(b).dot(normal) >= 0.0 || slope_a * fa >= 0.0) return;
  for (int iteration = 0; iteration < kRootIterations; ++iteration) {
    const double middle = 0.5 * (lo + hi);
    const double f = point(middle).dot(normal) - offset;
    if ((f > 0.0) != (fa > 0.0)) {
      parameters.push_back(root(normal, offset, a, middle));
      parameters.push_back(root(normal, offset, middle, b));
      return;
    }
    if (derivative(middle).dot(normal) * slope_a > 0.0) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
}

void OcctCurve::cut(const Vec3& normal, double offset, std::vector<double>& parameters) const {
  if (lies_in_plane(normal)) return;
  const std::size_t first = parameters.size();
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    const Block& b = blocks_[block];
    const double reach = 0.5 * b.samples.size().dot(normal.cwiseAbs()) + b.bulge;
    if (std::abs(b.samples.centre().dot(normal) - offset) > reach) continue;
    for (std::size_t i = kBlock * block; i < end_of(kBlock * block); ++i) {
      const auto [lo, hi] = std::minmax({sample_[i].dot(normal), sample_[i + 1].dot(normal)});
      const double bulge = kChordTurnMost * (sample_[i + 1] - sample_[i]).norm();
      if (offset < lo - bulge || offset > hi + bulge) continue;
      cut_piece(normal, offset, sample_t_[i], sample_t_[i + 1], parameters);
    }
  }
  std::sort(parameters.begin() + static_cast<std::ptrdiff_t>(first), parameters.end());
}

}  // namespace

std::shared_ptr<const Curve> make_free_curve(CurveJets jets, double t0, double t1) {
  return std::make_shared<OcctCurve>(std::move(jets), t0, t1);
}

}  // namespace octet
