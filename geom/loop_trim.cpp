// SPDX-License-Identifier: BSD-3-Clause
// In or out of a face's loops in (u,v), by the parity of a ray.
//
// Law: let R be a convex set that holds a piece of a curve, and p a point outside of R. A ray from p crosses
// the piece as often as it crosses the chord, modulo 2. (Piece and chord are homotopic in R, ends fixed.)
// R is the chord swept by the rectangle +-h^2/8 max|C''|, which holds the piece by Taylor's theorem.
#include "geom/loop_trim.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace octet {
namespace {

constexpr double kInflate = 1.5;  // sampled second differences to bounds
constexpr double kFlat = 5e-4;    // bend of a piece, of the extent of the loops
constexpr int kMaxSplits = 8;     // of a span while pieces are made
constexpr int kFirstPieces = 4;   // of a curve's only span; of many spans each is one
constexpr int kMaxHalvings = 60;  // of a piece during a query
constexpr std::size_t kMostStrips = 1024;

struct Piece {
  Vec2 a, b;
  Vec2 bend = Vec2::Zero();
  double ta = 0.0, tb = 0.0;
  std::int32_t curve = -1;  ///< -1: a straight piece
};

enum class Crossing { kNo, kYes, kOn };

/// One end of a curve, to be joined with another one at the same vertex.
struct End {
  int vertex, edge;
  Vec2 at;
};

class LoopTrim final : public Trim {
 public:
  LoopTrim(std::vector<TrimCurve> curves, const LoopTrimOptions& options)
      : curves_(std::move(curves)), tolerance_(options.tolerance), period_(options.period) {}

  /// False where loops stay open.
  bool build() {
    measure_box();
    for (std::size_t i = 0; i < curves_.size(); ++i) add_curve(static_cast<std::int32_t>(i));
    if (!join_ends()) return false;
    make_strips();
    return true;
  }

  /// In where any shift by periods is in. With loops around a period each loop is crossed once among all
  /// shifts, wherever it starts, so there the parities add up.
  TrimSide side(const Vec2& uv) const override {
    bool on = false, any = false, odd = false;
    for_each_shift(0, uv.x(), [&](double u) {
      for_each_shift(1, uv.y(), [&](double v) {
        const TrimSide here = side_here({u, v});
        on |= here == TrimSide::kOn;
        any |= here == TrimSide::kIn;
        odd ^= here == TrimSide::kIn;
      });
    });
    if (around_ ? odd && !on : any) return TrimSide::kIn;
    return on ? TrimSide::kOn : TrimSide::kOut;
  }

 private:
  void measure_box() {
    lo_ = Vec2::Constant(std::numeric_limits<double>::infinity());
    hi_ = -lo_;
    for (const TrimCurve& curve : curves_) {
      const int samples = 4 * pieces_of(curve);
      for (std::size_t i = 0; i + 1 < curve.breaks.size(); ++i)
        for (int k = 0; k <= samples; ++k)
          grow_box(curve.at(curve.breaks[i] + k * (curve.breaks[i + 1] - curve.breaks[i]) / samples));
    }
  }

  [[nodiscard]] static int pieces_of(const TrimCurve& curve) {
    if (curve.straight) return 1;
    return std::max(1, kFirstPieces / static_cast<int>(curve.breaks.size() - 1));
  }

  void grow_box(const Vec2& p) {
    lo_ = lo_.cwiseMin(p);
    hi_ = hi_.cwiseMax(p);
  }

  void add_curve(std::int32_t index) {
    const TrimCurve& curve = curves_[index];
    Vec2 a = curve.at(curve.breaks.front());
    for (std::size_t i = 0; i + 1 < curve.breaks.size(); ++i) {
      const double t0 = curve.breaks[i], t1 = curve.breaks[i + 1];
      const int pieces = pieces_of(curve);
      for (int k = 1; k <= pieces; ++k) {
        const double ta = t0 + (k - 1) * (t1 - t0) / pieces,
                     tb = k == pieces ? t1 : t0 + k * (t1 - t0) / pieces;
        const Vec2 b = curve.at(tb);
        if (curve.straight)
          pieces_.push_back({a, b, Vec2::Zero(), ta, tb, -1});
        else
          split(index, {a, b, Vec2::Zero(), ta, tb, index}, 0);
        a = b;
      }
    }
    ends_.push_back({curve.vertex[0], curve.edge, curve.at(curve.breaks.front())});
    ends_.push_back({curve.vertex[1], curve.edge, a});
  }

  /// h^2/8 |C''| by second differences of the piece and of its halves.
  [[nodiscard]] Vec2 bend_of(const Piece& piece, const Vec2& middle) const {
    const TrimCurve& curve = curves_[piece.curve];
    const double h = piece.tb - piece.ta;
    const Vec2 p = curve.at(piece.ta + 0.25 * h), q = curve.at(piece.ta + 0.75 * h);
    const auto second = [](const Vec2& x, const Vec2& y, const Vec2& z) -> Vec2 {
      return 0.5 * (x - 2.0 * y + z).cwiseAbs();
    };
    Vec2 bend = second(piece.a, middle, piece.b);
    bend = bend.cwiseMax(4.0 * second(piece.a, p, middle));
    bend = bend.cwiseMax(4.0 * second(p, middle, q));
    bend = bend.cwiseMax(4.0 * second(middle, q, piece.b));
    return kInflate * bend;
  }

  void split(std::int32_t index, Piece piece, int depth) {
    const double tm = 0.5 * (piece.ta + piece.tb);
    const Vec2 middle = curves_[index].at(tm);
    piece.bend = bend_of(piece, middle);
    if (depth < kMaxSplits && (piece.bend.array() > kFlat * (hi_ - lo_).array()).any()) {
      split(index, {piece.a, middle, piece.bend, piece.ta, tm, index}, depth + 1);
      split(index, {middle, piece.b, piece.bend, tm, piece.tb, index}, depth + 1);
      return;
    }
    grow_box(piece.a.cwiseMin(piece.b) - piece.bend);
    grow_box(piece.a.cwiseMax(piece.b) + piece.bend);
    pieces_.push_back(piece);
  }

  [[nodiscard]] double apart(const End& x, const End& y) const {
    return ((x.at - y.at).array() / (hi_ - lo_).cwiseMax(1e-300).array()).matrix().norm();
  }

  /// Pairs the ends at each vertex, nearest first.
  bool join_ends() {
    std::map<int, std::vector<End>> at_vertex;
    for (const End& end : ends_) at_vertex[end.vertex].push_back(end);
    ends_.clear();
    for (auto& [vertex, ends] : at_vertex) {
      if (ends.size() % 2 != 0) return false;
      while (!ends.empty()) {
        std::size_t i = 0, j = 1;
        for (std::size_t a = 0; a < ends.size(); ++a)
          for (std::size_t b = a + 1; b < ends.size(); ++b)
            if (apart(ends[a], ends[b]) < apart(ends[i], ends[j])) {
              i = a;
              j = b;
            }
        if (!join(ends[i], ends[j])) return false;
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(j));
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    return true;
  }

  /// A closed edge whose ends are a period apart goes around the surface: rays then run across it.
  bool join(const End& x, const End& y) {
    const Vec2 gap = (x.at - y.at).cwiseAbs();
    for (int k = 0; k < 2 && x.edge == y.edge; ++k) {
      if (period_[k] == 0.0 || std::abs(gap[k] - period_[k]) > 1e-3 * period_[k]) continue;
      if (around_ && *around_ != k) return false;
      around_ = k;
      return true;
    }
    if (gap.maxCoeff() > 0.0) pieces_.push_back({x.at, y.at, Vec2::Zero(), 0.0, 0.0, -1});
    return true;
  }

  /// Strips across the rays; in each the pieces that reach farthest along the ray come first.
  void make_strips() {
    along_ = around_ ? 1 - *around_ : 0;
    const int across = 1 - along_;
    const std::size_t count = std::clamp<std::size_t>(2 * pieces_.size(), 1, kMostStrips);
    strips_.resize(count);
    strip_width_ = (hi_[across] - lo_[across]) / static_cast<double>(count);
    if (!(strip_width_ > 0.0)) strip_width_ = 1.0;
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [&](const Piece& x, const Piece& y) { return reach(x) > reach(y); });
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      const double margin = piece.bend[across] + 2.0 * tolerance_[across];
      const std::size_t first = strip(std::min(piece.a[across], piece.b[across]) - margin);
      const std::size_t last = strip(std::max(piece.a[across], piece.b[across]) + margin);
      for (std::size_t s = first; s <= last; ++s) strips_[s].push_back(static_cast<std::uint32_t>(i));
    }
  }

  /// Largest coordinate along the ray at which the piece or its band of tolerance may be.
  [[nodiscard]] double reach(const Piece& piece) const {
    return std::max(piece.a[along_], piece.b[along_]) + piece.bend[along_] + tolerance_[along_];
  }

  [[nodiscard]] std::size_t strip(double x) const {
    const double s = (x - lo_[1 - along_]) / strip_width_;
    return s > 0.0 ? std::min(static_cast<std::size_t>(s), strips_.size() - 1) : 0;
  }

  template <class Visit>
  void for_each_shift(int axis, double x, const Visit& visit) const {
    const double period = period_[axis];
    if (period == 0.0) {
      visit(x);
      return;
    }
    const double lo = lo_[axis] - tolerance_[axis], hi = hi_[axis] + tolerance_[axis];
    for (double y = x - period * std::floor((x - lo) / period); y <= hi; y += period) visit(y);
  }

  [[nodiscard]] TrimSide side_here(const Vec2& p) const {
    const int across = 1 - along_;
    if (p[across] < lo_[across] - tolerance_[across] || p[across] > hi_[across] + tolerance_[across])
      return TrimSide::kOut;
    bool in = false;
    for (const std::uint32_t i : strips_[strip(p[across])]) {
      if (reach(pieces_[i]) < p[along_]) break;
      const Crossing crossing = cross(pieces_[i], p, 0);
      if (crossing == Crossing::kOn) return TrimSide::kOn;
      in ^= crossing == Crossing::kYes;
    }
    return in ? TrimSide::kIn : TrimSide::kOut;
  }

  /// Whether p lies in the chord swept by the rectangle +-half.
  [[nodiscard]] static bool in_band(const Piece& piece, const Vec2& p, const Vec2& half) {
    const Vec2 lo = piece.a.cwiseMin(piece.b) - half, hi = piece.a.cwiseMax(piece.b) + half;
    if ((p.array() < lo.array()).any() || (p.array() > hi.array()).any()) return false;
    const Vec2 d = piece.b - piece.a, r = p - piece.a;
    const double slack = std::abs(d.y()) * half.x() + std::abs(d.x()) * half.y();
    return std::abs(d.x() * r.y() - d.y() * r.x()) <= slack;
  }

  /// Whether the ray from p crosses the chord. Half-open across the ray, so that neighbours share no end.
  [[nodiscard]] Crossing cross_chord(const Piece& piece, const Vec2& p) const {
    const int across = 1 - along_;
    const bool above_a = piece.a[across] > p[across], above_b = piece.b[across] > p[across];
    if (above_a == above_b) return Crossing::kNo;
    const double share = (p[across] - piece.a[across]) / (piece.b[across] - piece.a[across]);
    const double at = piece.a[along_] + share * (piece.b[along_] - piece.a[along_]);
    return at > p[along_] ? Crossing::kYes : Crossing::kNo;
  }

  [[nodiscard]] Crossing cross(const Piece& piece, const Vec2& p, int depth) const {
    if (!in_band(piece, p, piece.bend + tolerance_)) return cross_chord(piece, p);
    const bool fine = (piece.bend.array() <= 0.25 * tolerance_.array()).all();
    if (fine || depth >= kMaxHalvings) return Crossing::kOn;
    const double tm = 0.5 * (piece.ta + piece.tb);
    const Vec2 middle = curves_[piece.curve].at(tm), bend = 0.25 * piece.bend;
    const Crossing first = cross({piece.a, middle, bend, piece.ta, tm, piece.curve}, p, depth + 1);
    if (first == Crossing::kOn) return first;
    const Crossing second = cross({middle, piece.b, bend, tm, piece.tb, piece.curve}, p, depth + 1);
    if (second == Crossing::kOn) return second;
    return first == second ? Crossing::kNo : Crossing::kYes;
  }

  std::vector<TrimCurve> curves_;
  Vec2 tolerance_, period_;
  std::vector<Piece> pieces_;
  std::vector<End> ends_;
  std::optional<int> around_;  ///< the parameter around which a loop without seam goes
  int along_ = 0;              ///< the parameter along which rays run
  Vec2 lo_, hi_;
  double strip_width_ = 1.0;
  std::vector<std::vector<std::uint32_t>> strips_;
};

}  // namespace

std::shared_ptr<const Trim> make_loop_trim(std::vector<TrimCurve> curves, const LoopTrimOptions& options) {
  auto trim = std::make_shared<LoopTrim>(std::move(curves), options);
  return trim->build() ? trim : nullptr;
}

}  // namespace octet
