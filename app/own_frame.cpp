// SPDX-License-Identifier: BSD-3-Clause
// Turns what has a place.
#include "app/own_frame.h"

#include <algorithm>

#include "app/apart.h"
#include "geom/own_axes.h"
#include "geom/turned_model.h"

namespace octet {
namespace {

bool asks_over_space(const MeshOptions& options) {
  using Where = SizeAttribute::Where;
  return options.background ||
         std::any_of(options.attributes.begin(), options.attributes.end(), [](const SizeAttribute& a) {
           return a.where == Where::kBox || a.where == Where::kBall || a.where == Where::kCylinder;
         });
}

}  // namespace

OwnFrame::OwnFrame(const Model& part, const MeshOptions& options) : part_(part), options_(options) {
  if (is_meshed_apart(part) || asks_over_space(options)) return;
  axes_ = own_axes(part);
  if (axes_ == Eigen::Matrix3d::Identity()) return;
  turned_ = turned_model(part, axes_);
  for (SizeAttribute& attribute : options_.attributes) attribute.a = to_model(attribute.a);
}

void OwnFrame::to_part(std::vector<Vec3>& points) const {
  if (!turned_) return;
  for (Vec3& p : points) p = to_part(p);
}

}  // namespace octet
