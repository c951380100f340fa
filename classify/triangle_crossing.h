// SPDX-License-Identifier: BSD-3-Clause
// Whether a segment meets a triangle, by exact signs.
#pragma once

#include "base/vec.h"

namespace octet {

/// Whether the closed segment pq meets the closed triangle abc. Exact, the coplanar case included.
/// Requires that the triangle is not degenerate.
[[nodiscard]] bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                                          const Vec3& c);

/// For a segment aq that starts at corner a of the triangle abc: whether it meets the triangle elsewhere.
[[nodiscard]] bool segment_enters_triangle(const Vec3& a, const Vec3& q, const Vec3& b, const Vec3& c);

}  // namespace octet
