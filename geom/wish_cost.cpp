// SPDX-License-Identifier: BSD-3-Clause
// Lengths over sizes, areas over their squares, volumes over their cubes.
#include "geom/wish_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "base/vertex_order.h"

namespace octet {
namespace {

using Where = SizeAttribute::Where;

/// Tetrahedra on a piece of an edge, on a square of a face and in a cube as long as the size: measured on a
/// box whose other sizes are 20 to 200 times larger (51 and 89; 12 and 19), and 12 in an octant.
constexpr std::array<double, 4> kTets{0.0, 65.0, 15.0, 9.5};

/// Octants are up to half an octave longer than the size, two faces may share them in a wall and edges that
/// run close by likewise: a mesh has no less than this share.
constexpr double kSure = 0.25;

/// What is asked for as advice has room for everything else.
constexpr double kAdvised = 0.6;

/// Digits that a reader takes in.
std::string two_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

/// No smaller number of two digits.
double rounded_up(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return unit * std::ceil(value / unit - 1e-9);
}

/// Sums over an attribute's entities of their measures over the powers of their sizes.
struct WishPieces {
  std::array<double, 4> of{};

  void add(int dim, double measure, double size) {
    of[static_cast<std::size_t>(dim)] += measure / std::pow(size, dim);
  }
  /// With all sizes so many times larger.
  [[nodiscard]] double elements(double scale) const {
    double sum = 0.0;
    for (std::size_t dim = 1; dim < of.size(); ++dim)
      sum += kTets[dim] * of[dim] / std::pow(scale, static_cast<double>(dim));
    return sum;
  }
};

double shape_volume(const SizeAttribute& shape) {
  switch (shape.where) {
    case Where::kBox:
      return (shape.b - shape.a).cwiseMax(0.0).prod();
    case Where::kBall:
      return 4.0 / 3.0 * M_PI * std::pow(shape.radius, 3);
    case Where::kCylinder:
      return M_PI * shape.radius * shape.radius * (shape.b - shape.a).norm();
    default:
      return 0.0;
  }
}

Box3 box_of(const SizeAttribute& shape) {
  Box3 box;
  box.add(shape.a);
  if (shape.where != Where::kBall) box.add(shape.b);
  return shape.where == Where::kBox ? box : box.grown(shape.radius);
}

/// The volume of the part within the shape: by samples of the box that both have in common.
double volume_within(const Model& model, const SizeAttribute& shape) {
  constexpr int kSamples = 16;  // along each axis
  const Box3 around = box_of(shape);
  const Vec3 lo = around.lo.cwiseMax(model.box().lo), hi = around.hi.cwiseMin(model.box().hi);
  if ((hi - lo).minCoeff() <= 0.0) return 0.0;
  const Vec3 step = (hi - lo) / kSamples;
  int within = 0;
  for (int i = 0; i < kSamples * kSamples * kSamples; ++i) {
    const Vec3 cell(i % kSamples + 0.5, i / kSamples % kSamples + 0.5, i / (kSamples * kSamples) + 0.5);
    const Vec3 p = lo + cell.cwiseProduct(step);
    if (shape_meets(shape, {p, p}) && model.region_at(p) != 0) ++within;
  }
  return step.prod() * within;
}

WishPieces pieces_of(const Model& model, const SizeAttribute& attribute, const SizedEntities& sized,
                     double coarsest, double most) {
  WishPieces pieces;
  for (const auto& [entity, size] : sized) {
    if (size >= coarsest) continue;
    if (entity.dim == 1) pieces.add(1, model.edge(entity.tag).length, size);
    if (entity.dim == 2) pieces.add(2, std::abs(model.face(entity.tag).area), size);
    if (entity.dim == 3) pieces.add(3, std::abs(model.region(entity.tag).volume), size);
  }
  if (!sized.empty() || attribute.size >= coarsest) return pieces;
  WishPieces whole;
  whole.add(3, shape_volume(attribute), attribute.size);
  if (whole.elements(1.0) <= most) return whole;
  pieces.add(3, volume_within(model, attribute), attribute.size);
  return pieces;
}

/// As the user wrote it, or who is asked for what where a program made it.
std::string words_of(const Model& model, const SizeAttribute& attribute, const SizedEntities& sized) {
  if (!attribute.text.empty()) return attribute.text;
  std::string words = sized.empty() ? "a shape=" : model.describe(sized.front().first) + "=";
  if (attribute.elements > 0) return words.append("/").append(std::to_string(attribute.elements));
  return words.append(two_digits(attribute.size / attribute.unit));
}

std::string advice_for(const SizeAttribute& attribute, double size, double scale) {
  if (attribute.elements > 0)
    return std::string("/").append(std::to_string(std::max(1, static_cast<int>(attribute.elements / scale))));
  return two_digits(rounded_up(scale * size / attribute.unit));
}

}  // namespace

WishCost wish_cost(const Model& model, const SizeAttribute& attribute, const SizedEntities& sized,
                   double coarsest, std::size_t max_elements) {
  constexpr double kStep = 1.05;
  const auto most = static_cast<double>(max_elements);
  const WishPieces pieces = pieces_of(model, attribute, sized, coarsest, most);
  const double elements = pieces.elements(1.0);
  double scale = 1.0;
  if (std::isfinite(elements))
    while (scale < 1e12 && pieces.elements(scale) > kAdvised * most) scale *= kStep;
  const double size = sized.empty() ? attribute.size : sized.front().second;
  return {words_of(model, attribute, sized), elements, advice_for(attribute, size, scale)};
}

void check_wish(const Model& model, const SizeAttribute& attribute, const SizedEntities& sized,
                const WishCost& cost, std::size_t max_elements) {
  if (kSure * cost.elements > static_cast<double>(max_elements))
    throw LimitError(too_costly(cost, max_elements));
  // No octree is less wide than the part, and none has more levels. Octants are half an octave and the edges'
  // share of their length above a size at most.
  constexpr int kLevels = kLatticeLevels - 1;
  constexpr double kLongest = 1.6, kWidest = 2.1;
  const double finest = std::ldexp(model.box().size().maxCoeff(), -kLevels);
  double least = sized.empty() ? kNoSize : sized.front().second;
  for (const auto& [entity, size] : sized) least = std::min(least, size);
  if (kLongest * least < finest)
    throw LimitError(cost.wish + " is too small for a part of its extent: octrees have " +
                     std::to_string(kLevels) + " levels, ask for at least " +
                     two_digits(rounded_up(kWidest * finest / attribute.unit)));
}

std::string too_costly(const WishCost& cost, std::size_t max_elements) {
  return cost.wish + " asks for about " + two_digits(cost.elements) + " elements, more than the limit of " +
         two_digits(static_cast<double>(max_elements)) + ": ask for about " + cost.advice + " there" +
         or_raise(max_elements);
}

}  // namespace octet
