// SPDX-License-Identifier: BSD-3-Clause
// Types that most files use, made once: parsed before every file (cmake/Room.cmake). An expression of vectors
// is a type of its own in Eigen, and so is each kind of container; making them anew was a fifth of the time
// that a file took. Nothing here is for others to use.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace octet::common_types {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

template <class... Types>
constexpr bool made = (... && (sizeof(Types) > 0));

// Never defined: what they appear in has a type and no value.
const Vec3& a();
const Vec2& b();
Vec3& changed();
const double& s();

static_assert(
    made<decltype(a() + a()), decltype(a() - a()), decltype(s() * a()), decltype(a() * s()),
         decltype(a() / s()), decltype(-a()), decltype(a() + s() * a()), decltype(a() - s() * a()),
         decltype(s() * (a() + a())), decltype((a() + a()) / s()), decltype(a() + s() * (a() - a())),
         decltype(Vec3(a() + a())), decltype(Vec3(a() - a())), decltype(Vec3(s() * a()))>);
static_assert(
    made<decltype(a().dot(a())), decltype(a().cross(a())), decltype((a() - a()).norm()),
         decltype((a() - a()).squaredNorm()), decltype((a() - a()).dot(a() - a())),
         decltype((a() - a()).cross(a() - a()).norm()), decltype((a() - a()).cross(a() - a()).dot(a() - a())),
         decltype(a().normalized()), decltype((a() - a()).normalized()), decltype(a().cwiseMin(a())),
         decltype(a().cwiseMax(a())), decltype(a().cwiseProduct(a())), decltype(a().cwiseAbs().maxCoeff()),
         decltype((a().array() <= a().array()).all()), decltype((a().array() >= a().array()).all()),
         decltype(Vec3::Zero()), decltype(Vec3::Constant(s())), decltype(changed() += a()),
         decltype(changed() += s() * a()), decltype(changed() -= a() - a()),
         decltype(std::declval<const Eigen::Matrix3d&>() * a())>);
static_assert(made<decltype(b() + s() * b()), decltype((b() - b()).norm()), decltype(s() * b())>);
static_assert(made<std::vector<Vec3>, std::vector<Vec2>, std::vector<int>, std::vector<double>,
                   std::vector<char>, std::vector<std::string>, std::vector<std::vector<int>>,
                   std::vector<std::array<int, 3>>, std::array<Vec3, 3>, std::array<int, 3>,
                   std::function<void()>, std::optional<Vec3>, std::map<int, int>, std::set<int>>);

}  // namespace octet::common_types
