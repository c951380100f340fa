// SPDX-License-Identifier: BSD-3-Clause
// A mesh size wanted over space, as the octree asks for it: box by box.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "base/vec.h"

namespace octet {

/// The smallest size wanted anywhere in the box (model units), infinite where nothing is wanted. Called from
/// one thread. An empty function wants nothing anywhere.
using SizeField = std::function<double(const Box3&)>;

inline constexpr double kNoSize = std::numeric_limits<double>::infinity();

/// The smaller of two fields.
[[nodiscard]] inline SizeField smaller_of(SizeField a, SizeField b) {
  if (!a) return b;
  if (!b) return a;
  return [a = std::move(a), b = std::move(b)](const Box3& box) { return std::min(a(box), b(box)); };
}

/// A size as a function of the place, read at the corners and the centre of each box: what is finer than the
/// octants asked for elsewhere may be missed. Values that are not positive want nothing.
[[nodiscard]] inline SizeField sampled_field(std::function<double(const Vec3&)> size_at) {
  return [size_at = std::move(size_at)](const Box3& box) {
    const auto read = [&](const Vec3& p) {
      const double size = size_at(p);
      return size > 0.0 ? size : kNoSize;
    };
    double least = read(box.centre());
    for (int c = 0; c < 8; ++c)
      least = std::min(
          least, read(Vec3((c & 1) != 0 ? box.hi.x() : box.lo.x(), (c & 2) != 0 ? box.hi.y() : box.lo.y(),
                           (c & 4) != 0 ? box.hi.z() : box.lo.z())));
    return least;
  };
}

}  // namespace octet
