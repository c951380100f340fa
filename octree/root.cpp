// SPDX-License-Identifier: BSD-3-Clause
// Scale, shift and rounding of the root cube.
#include "octree/root.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace octet {
namespace {

/// Root edge minus box edge, in sizes: 3 to 4 below the box, and at least 3 above it, whatever the shift.
constexpr double kSlack = 8.0;

int level_of_size(const Box3& box, double size) {
  const double cells = box.size().maxCoeff() / size + kSlack;
  int level = 0;
  while (level <= kDeepestLevel && std::ldexp(1.0, level) < cells) ++level;
  if (level > kDeepestLevel) {
    throw LimitError(
        fmt::format("a size of {:g} is too small for a part of extent {:g}: the octree has {} levels, ask "
                    "for at least {:g}",
                    size, box.size().maxCoeff(), kDeepestLevel,
                    box.size().maxCoeff() / (std::ldexp(1.0, kDeepestLevel) - kSlack)));
  }
  return level;
}

/// The largest multiple of quantum not above x.
double rounded_down(double x, double quantum) { return std::floor(x / quantum) * quantum; }

}  // namespace

Lattice Root::cell_of(const Vec3& p) const {
  const double cell = length(kLatticeLevels);
  Lattice at{};
  for (int axis = 0; axis < 3; ++axis) {
    const double offset = (p[axis] - origin[axis]) / cell;
    double i = static_cast<std::uint32_t>(std::clamp(offset, 0.0, static_cast<double>(kLatticeExtent - 1)));
    // The division rounds; the lattice points do not, and they decide.
    if (i > 0.0 && origin[axis] + cell * i > p[axis]) i -= 1.0;
    if (i < kLatticeExtent - 1 && origin[axis] + cell * (i + 1.0) <= p[axis]) i += 1.0;
    at[axis] = static_cast<std::uint32_t>(i);
  }
  return at;
}

PlacedRoot place_root(const Box3& box, double size, const std::array<double, 3>& shift) {
  if (!(size > 0.0) || !std::isfinite(size)) throw InputError("the size asked for must be a positive number");
  if (box.empty() || !std::isfinite(box.diagonal())) throw InputError("the part has no extent");
  PlacedRoot placed;
  placed.level = level_of_size(box, size);
  const double wanted = std::ldexp(size, placed.level);
  // All coordinates become multiples of one power of two, 52 bits below the largest: sums with lattice
  // multiples are then exact, and so are centres.
  const double reach = std::max(box.lo.cwiseAbs().maxCoeff(), box.hi.cwiseAbs().maxCoeff()) + wanted;
  int exponent = 0;
  std::frexp(reach, &exponent);
  const double quantum = std::ldexp(1.0, exponent - 52);
  const double cell = rounded_down(std::ldexp(wanted, -kLatticeLevels), 2.0 * quantum);
  if (!(cell > 0.0)) throw InputError("the part lies too far from the origin for the size asked for");
  placed.root.size = std::ldexp(cell, kLatticeLevels);
  const double h = placed.root.length(placed.level);
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = placed.root.size / h - box.size()[axis] / h;
    const double below = std::floor((slack - shift[axis]) / 2.0) + shift[axis];
    placed.root.origin[axis] = rounded_down(box.lo[axis] - below * h, quantum);
  }
  return placed;
}

}  // namespace octet
