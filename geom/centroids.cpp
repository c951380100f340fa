// SPDX-License-Identifier: BSD-3-Clause
// Moments of faces, from which those of regions follow by the divergence theorem.
#include "geom/centroids.h"

#include <array>
#include <cmath>

namespace octet {
namespace {

/// Integrals over a face, places taken from the middle of the model's box.
struct Moments {
  double area = 0.0;
  Vec3 first = Vec3::Zero();   ///< of x
  Vec3 second = Vec3::Zero();  ///< of x_i^2 n_i / 2, whose sum over a closed boundary is that of x_i inside
};

constexpr std::array<double, 4> kGaussPoint{0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                            0.93056815579702629};
constexpr std::array<double, 4> kGaussWeight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                             0.17392742256872693};
/// Places in a triangle by their shares of its corners, each of three turns of them: exact for polynomials of
/// degree 6 [Dunavant 1985].
struct FacetPoint {
  double weight;
  std::array<double, 3> of;
};
constexpr std::array<FacetPoint, 4> kFacetPoints{
    {{0.116786275726379, {0.501426509658179, 0.249286745170910, 0.249286745170911}},
     {0.050844906370207, {0.873821971016996, 0.063089014491502, 0.063089014491502}},
     {0.082851075618374, {0.053145049844817, 0.310352451033784, 0.636502499121399}},
     {0.082851075618374, {0.053145049844817, 0.636502499121399, 0.310352451033784}}}};
constexpr double kPole = 1e-9;  // of the one step the other, at a pole of the surface
constexpr int kPieces = 24;     // of a curve between breaks

class FaceMoments {
 public:
  FaceMoments(const Model& model, int face, const Vec3& middle)
      : model_(model), face_(face), middle_(middle) {}

  /// Triangles from one place of the plane to the pieces of its edges.
  [[nodiscard]] Moments of_plane() {
    const ModelFace& face = model_.face(face_);
    normal_ = model_.face_normal(face_, Vec2::Zero());
    from_ = model_.face_jet(face_, Vec2::Zero(), 0).p - middle_;
    for (const FaceBoundary& side : face.boundary) along(side);
    return sum_;
  }

  void add_facet(const std::array<Vec2, 3>& uv) {
    for (std::size_t k = 0; k < 3; ++k) {
      // A pole or apex is a side of the (u,v) plane, of which a facet's corner there is but one point.
      const Vec2 &pole = uv[k], &a = uv[(k + 1) % 3], &b = uv[(k + 2) % 3];
      const SurfaceJet jet = model_.face_jet(face_, pole, 1);
      const Vec2 span = (a - pole).cwiseAbs().cwiseMax((b - pole).cwiseAbs());
      const double along_u = jet.du.norm() * span.x(), along_v = jet.dv.norm() * span.y();
      if (along_u <= kPole * along_v) return add_between(a, b, Vec2(b.x(), pole.y()), Vec2(a.x(), pole.y()));
      if (along_v <= kPole * along_u) return add_between(a, b, Vec2(pole.x(), b.y()), Vec2(pole.x(), a.y()));
    }
    add_triangle(uv);
  }

  [[nodiscard]] const Moments& sum() const { return sum_; }

 private:
  void along(const FaceBoundary& side) {
    const ModelEdge& edge = model_.edge(side.edge);
    if (edge.use == EdgeUse::kDegenerate) return;
    std::vector<double> breaks = model_.curve(side.edge).breaks();
    if (breaks.size() < 2) breaks = {edge.t0, edge.t1};
    for (std::size_t i = 1; i < breaks.size(); ++i)
      for (int piece = 0; piece < kPieces; ++piece) {
        const double step = (breaks[i] - breaks[i - 1]) / kPieces;
        for (std::size_t g = 0; g < kGaussPoint.size(); ++g) {
          const double t = breaks[i - 1] + (piece + kGaussPoint[g]) * step;
          add_sliver(model_.edge_point(side.edge, t) - middle_,
                     model_.edge_derivative(side.edge, t) * (side.sense * step * kGaussWeight[g]));
        }
      }
  }

  void add_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    add_triangle({a, b, c});
    add_triangle({a, c, d});
  }

  void add_triangle(const std::array<Vec2, 3>& uv) {
    const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    const double half = 0.5 * (a.x() * b.y() - a.y() * b.x());
    for (const FacetPoint& at : kFacetPoints)
      for (std::size_t k = 0; k < 3; ++k)
        add_piece(at.of[0] * uv[k] + at.of[1] * uv[(k + 1) % 3] + at.of[2] * uv[(k + 2) % 3],
                  half * at.weight);
  }

  /// A piece of so much (u,v), turned as the face.
  void add_piece(const Vec2& uv, double extent) {
    const SurfaceJet jet = model_.face_jet(face_, uv, 1);
    const Vec3 piece = jet.du.cross(jet.dv) * extent;
    const Vec3 x = jet.p - middle_;
    const double area = piece.norm();
    sum_.area += area;
    sum_.first += area * x;
    sum_.second += 0.5 * x.cwiseAbs2().cwiseProduct(piece);
  }

  /// The triangle from `from_` to x and x + dx.
  void add_sliver(const Vec3& x, const Vec3& dx) {
    const Vec3 y = x - from_;
    const double area = 0.5 * normal_.dot(y.cross(dx));
    sum_.area += area;
    sum_.first += area * (from_ + 2.0 / 3.0 * y);
    const Vec3 squares = from_.cwiseAbs2() + 4.0 / 3.0 * from_.cwiseProduct(y) + 0.5 * y.cwiseAbs2();
    sum_.second += 0.5 * area * squares.cwiseProduct(normal_);
  }

  const Model& model_;
  int face_;
  Vec3 middle_, from_ = Vec3::Zero(), normal_ = Vec3::Zero();
  Moments sum_;
};

std::vector<Moments> face_moments(const Model& model, const Vec3& middle) {
  std::vector<Moments> moments(static_cast<std::size_t>(model.count(2)) + 1);
  std::vector<FaceMoments> faces;
  for (int f = 0; f <= model.count(2); ++f) faces.emplace_back(model, f, middle);
  const Facets& facets = model.facets();
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    if (!model.is_plane(facets.face[t]))
      faces[static_cast<std::size_t>(facets.face[t])].add_facet(facets.uv[t]);
  for (std::size_t f = 1; f < moments.size(); ++f)
    moments[f] = model.is_plane(static_cast<int>(f)) ? faces[f].of_plane() : faces[f].sum();
  return moments;
}

}  // namespace

Centroids centroids(const Model& model) {
  const Vec3 middle = model.box().centre();
  const std::vector<Moments> moments = face_moments(model, middle);
  Centroids result;
  result.face.assign(moments.size(), Vec3::Zero());
  for (std::size_t f = 1; f < moments.size(); ++f)
    if (moments[f].area > 0.0) result.face[f] = middle + moments[f].first / moments[f].area;
  result.region.assign(static_cast<std::size_t>(model.count(3)) + 1, Vec3::Zero());
  for (int r = 1; r <= model.count(3); ++r) {
    Vec3 sum = Vec3::Zero();
    for (const int f : model.region(r).faces) {
      const auto& sides = model.face(f).region;
      if (sides[0] != sides[1])
        sum += (sides[0] == r ? 1.0 : -1.0) * moments[static_cast<std::size_t>(f)].second;
    }
    if (model.region(r).volume > 0.0)
      result.region[static_cast<std::size_t>(r)] = middle + sum / model.region(r).volume;
  }
  return result;
}

}  // namespace octet
